// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/shared_fields.hpp"

namespace ashimpact {

namespace {

/// The laws of a sample property by property, as its artifact lists them.
struct LawColumns {
    LawMap<std::optional<VelocityEstimate>> velocity{};
    LawMap<VelocityEstimate> extrapolated{};
    LawMap<std::optional<Bounds>> interval{};
    LawMap<std::string> interval_note{};
    LawMap<LawVerdict> verdict{};
    LawMap<std::optional<CriticalVelocityCheck>> check{};
};

LawColumns columns_of(const LawMap<LawComparison>& laws) {
    LawColumns columns;
    for (const auto& [law, each] : laws) {
        columns.velocity.set(law, each.velocity);
        columns.interval.set(law, each.velocity ? each.velocity->interval : std::nullopt);
        columns.verdict.set(law, each.verdict);
        columns.check.set(law, each.check);
        if (each.extrapolated) columns.extrapolated.set(law, *each.extrapolated);
        if (!each.interval_note.empty()) columns.interval_note.set(law, each.interval_note);
    }
    return columns;
}

LawMap<LawComparison> laws_of(const LawColumns& columns) {
    LawMap<LawComparison> laws;
    for (const auto& [law, velocity] : columns.velocity) {
        LawComparison each{.velocity = velocity};
        if (const auto* interval = columns.interval.find(law); each.velocity && interval && *interval)
            each.velocity->interval = *interval;
        if (const auto* verdict = columns.verdict.find(law)) each.verdict = *verdict;
        if (const auto* extrapolated = columns.extrapolated.find(law)) each.extrapolated = *extrapolated;
        if (const auto* note = columns.interval_note.find(law)) each.interval_note = *note;
        if (const auto* check = columns.check.find(law)) each.check = *check;
        laws.set(law, std::move(each));
    }
    return laws;
}

}  // namespace

template <class Io>
void fields(Io& io, Is<ReportedVelocity> auto& reported) {
    io("law", reported.law);
    if (Io::reads || !reported.velocity || reported.velocity->method)
        io("critical_velocity", reported.velocity);
    else
        io("critical_velocity", reported.velocity, WithoutInterval{});
    io("interval", reported.interval, Dimension::velocity);
    io("reason", reported.reason);
    if constexpr (Io::reads)
        if (reported.velocity) reported.velocity->interval = reported.interval;
}

void fields(auto& io, Is<AssumedProperty> auto& assumed) {
    io("quantity", assumed.quantity);
    io("value", assumed.value, AnyUnit{});
    io("origin", assumed.origin);
    io("why", assumed.why);
}

template <class Io>
void fields(Io& io, Is<Beside> auto& beside) {
    Quantity ours{.value = beside.ours, .unit = beside.published.unit};
    io("ours", ours, AnyUnit{});
    io("published", beside.published, AnyUnit{});
    io("relative_difference", beside.relative_difference);
    if constexpr (Io::reads) beside.ours = ours.value;
}

void fields(auto& io, Is<ContactTimeBeside> auto& time) {
    io("law", time.law);
    io("velocity", time.velocity, Dimension::velocity);
    fields(io, time.contact_time);
}

void fields(auto& io, Is<PublishedBeside> auto& published) {
    io.lenient("source", published.source);
    io.unless_empty("young_modulus", published.young_modulus);
    io.unless_empty("volume_fractions", published.volume_fractions);
    io.unless_empty("critical_damping", published.critical_damping);
    io.unless_empty("critical_velocity", published.critical_velocity);
    io.unless_empty("critical_contact_times", published.critical_contact_times);
    io.unless_empty("contact_times", published.contact_times);
}

template <class Io>
void fields(Io& io, Is<SampleComparison> auto& sample) {
    LawColumns laws = columns_of(sample.laws);
    io("name", sample.name);
    io.unless_empty("reported", sample.reported);
    io.unless_empty("diameter", sample.diameter, Dimension::length);
    io.unless_empty("density", sample.density, Dimension::density);
    io.unless_empty("work_of_adhesion", sample.work_of_adhesion, Dimension::energy_per_area);
    io.lenient("assumed", sample.assumed);
    io.lenient("taken_as_exact", sample.taken_as_exact);
    io.unless_empty("young_modulus", sample.young_modulus, Dimension::pressure);
    io.unless_empty("contact_modulus", sample.contact_modulus, Dimension::pressure);
    io.unless_empty("separation_energy", sample.separation_energy, Dimension::energy);
    io("analytic_critical_velocity", sample.analytic_velocity, Dimension::velocity);
    io("dynamic_critical_velocity", laws.velocity);
    io.lenient("interval", laws.interval, Dimension::velocity);
    io.lenient("verdict", laws.verdict);
    io("measured_critical_velocity", sample.measured, Dimension::velocity);
    io.lenient("check", laws.check);
    io.unless_empty("measured_interval", sample.measured_interval, Dimension::velocity);
    io.unless_empty("extrapolated_critical_velocity", laws.extrapolated);
    io.unless_empty("interval_note", laws.interval_note);
    io.unless_empty("published", sample.published);
    if constexpr (Io::reads) sample.laws = laws_of(laws);
}

void fields(auto& io, Is<ImpactAtVelocity> auto& impact) {
    io("law", impact.law);
    io("sample", impact.sample);
    io("restitution", impact.restitution, Dimension::fraction);
    io("damping", impact.damping, dimension_of(io.damping_law()));
    io("contact_time", impact.contact_time, Dimension::time);
    io("maximum_overlap", impact.maximum_overlap, Dimension::length);
}

void fields(auto& io, Is<EqualVelocity> auto& equal) {
    io("velocity", equal.velocity, Dimension::velocity);
    io("impacts", equal.impacts);
}

void fields(auto& io, Is<RatioRange> auto& range) {
    io("least", range.least);
    io("greatest", range.greatest);
}

void fields(auto& io, Is<ComparisonResult> auto& result) {
    io.lenient("case", result.name);
    io("samples", result.samples);
    io.unless_empty("equal_velocities", result.equal_velocities);
    io.unless_empty("dynamic_over_analytic", result.dynamic_over_analytic);
    io.lenient("conclusion", result.conclusion);
}

template Json to_json(const ComparisonResult& result, DampingLaw law);
template ComparisonResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
