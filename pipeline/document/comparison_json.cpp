// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/fields.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/sizes_fields.hpp"

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
    io.lenient("basis", reported.basis);
    io.unless_empty("lower_bound", reported.lower_bound);
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

void glass_pair(auto& io, std::string_view key, auto& pair, Dimension dimension) {
    io.object(key, [&](auto& inner) {
        inner("catalogue", pair.catalogue, dimension);
        inner("from_chemistry", pair.from_chemistry, dimension);
    });
}

template <class Io>
void fields(Io& io, Is<GlassEffect> auto& effect) {
    io("used", effect.used);
    glass_pair(io, "young_modulus", effect.young_modulus, Dimension::pressure);
    glass_pair(io, "contact_modulus", effect.contact_modulus, Dimension::pressure);
    glass_pair(io, "analytic_critical_velocity", effect.analytic_velocity, Dimension::velocity);
    if constexpr (Io::reads)
        if (io.node().has("dynamic_critical_velocity")) effect.dynamic_velocity.emplace();
    if (effect.dynamic_velocity)
        glass_pair(io, "dynamic_critical_velocity", *effect.dynamic_velocity, Dimension::velocity);
}

void fields(auto& io, Is<GlassTemperatures> auto& temperatures) {
    io("elastic_up_to", temperatures.elastic_up_to, Dimension::temperature);
    io("relaxation_equals_contact", temperatures.relaxation_equals_contact, Dimension::temperature);
    io("liquid_from", temperatures.liquid_from, Dimension::temperature);
    if (io.reads || temperatures.regime) io("relaxation_over_contact", temperatures.relaxation_over_contact);
    io.unless_empty("regime", temperatures.regime);
}

void contact_temperature_fields(auto& io, auto& contact) {
    io("contact_time", contact.contact_time, Dimension::time);
    io("giordano2008", contact.giordano2008);
    io("urbain1981", contact.urbain1981);
}

void fields(auto& io, Is<ContactTemperatures> auto& contact) {
    contact_temperature_fields(io, contact);
}

void fields(auto& io, Is<SizeTemperatures> auto& size) {
    io("diameter", size.diameter, Dimension::length);
    contact_temperature_fields(io, size.contact);
}

void fields(auto& io, Is<TemperatureLimits> auto& limits) {
    io.unless_empty("particle", limits.particle, Dimension::temperature);
    io.unless_empty("wall", limits.wall, Dimension::temperature);
    io.unless_empty("shear_modulus", limits.shear_modulus, Dimension::pressure);
    io.unless_empty("glass_transition", limits.glass_transition, Dimension::temperature);
    io.unless_empty("laws", limits.laws);
    io.unless_empty("velocity", limits.velocity, Dimension::velocity);
    io.unless_empty("by_size", limits.by_size);
}

constexpr FieldColumn<ObliqueRebound> oblique_columns[]{
    {"angle", &ObliqueRebound::angle, Dimension::angle},
    {"restitution", &ObliqueRebound::restitution, Dimension::fraction},
    {"tangential_restitution", &ObliqueRebound::tangential_restitution, Dimension::fraction},
    {"rebound_angle", &ObliqueRebound::rebound_angle, Dimension::angle}};

void fields(auto& io, Is<ObliqueCurve> auto& curve) {
    io("multiple", curve.multiple);
    io("velocity", curve.velocity, Dimension::velocity);
    io("captured_from", curve.captured_from, Dimension::angle);
    io.object("rebounds", [&](auto& inner) { inner.columns(curve.rebounds, oblique_columns, false); });
}

void fields(auto& io, Is<ObliqueCurves> auto& oblique) {
    io("law", oblique.law);
    io("friction", oblique.friction);
    io("curves", oblique.curves);
}

void fields(auto& io, Is<DampingAndVelocity> auto& of) {
    if constexpr (std::remove_cvref_t<decltype(io)>::reads)
        of.damping = DampingPolynomial::quadratic(0, 0, 0);
    for (Eigen::Index power = 2; power >= 0; --power)
        io(std::string_view("cba").substr(static_cast<std::size_t>(power), 1), of.damping.coefficients[power],
           Dimension::damping);
    io("critical_velocity", of.critical_velocity, Dimension::velocity);
}

void fields(auto& io, Is<SchemeBesideExact> auto& of) {
    io("scheme", of.scheme);
    io("exact", of.exact);
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
    io.unless_empty("measured_by_outcomes", sample.measured_by_outcomes);
    io.unless_empty("measured_interval", sample.measured_interval, Dimension::velocity);
    io.unless_empty("extrapolated_critical_velocity", laws.extrapolated);
    io.unless_empty("interval_note", laws.interval_note);
    io.unless_empty("published", sample.published);
    io.unless_empty("glass", sample.glass);
    io.unless_empty("temperature_limits", sample.temperature);
    io.unless_empty("oblique", sample.oblique);
    io.unless_empty("paper_explicit", sample.paper_explicit);
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

/// A sample in the list of the run's own answer; all of it follows from the sample's `reported`.
struct ReportedSample {
    const SampleComparison& sample;
};

void fields(auto& io, Is<ReportedSample> auto& of) {
    const ReportedVelocity& reported = *of.sample.reported;
    io.derived("name", of.sample.name);
    io.derived("critical_velocity", reported.velocity, WithoutInterval{});
    io.derived("interval", reported.interval, Dimension::velocity);
    io.derived("basis", reported.basis);
    if (reported.lower_bound) io.derived("lower_bound", reported.lower_bound);
}

void fields(auto& io, Is<ReportedLaw> auto& reported) {
    io("law", reported.law);
    io.lenient("reason", reported.reason);
    io.lenient("admissible", reported.admissible);
}

void fields(auto& io, Is<VelocitySpan> auto& span) {
    io("least", span.least, Dimension::velocity);
    io("greatest", span.greatest, Dimension::velocity);
}

void fields(auto& io, Is<ReproducedSample> auto& sample) {
    io("name", sample.name);
    io("laws", sample.laws);
    io("ranges_and_orders", sample.fits);
    io("diameter", sample.diameter);
}

void fields(auto& io, Is<JointTest> auto& test) {
    io("sum_of_squares", test.sum_of_squares);
    io("samples", test.samples);
}

void fields(auto& io, Is<Reproduction> auto& reproduction) {
    io("diameter_change", reproduction.diameter_change, Dimension::length);
    io("restitution_from", reproduction.from, Dimension::fraction);
    io("restitution_to", reproduction.to, Dimension::fraction);
    io("orders", reproduction.orders, Dimension::fraction);
    io("samples", reproduction.samples);
    io("joint_tests", reproduction.joint_tests);
}

template <class Io>
void fields(Io& io, Is<ComparisonResult> auto& result) {
    io.lenient("case", result.name);
    if constexpr (Io::reads) {
        io.unless_empty("reported", result.reported);
    } else if (result.reported) {
        io.object("reported", [&](auto& inner) {
            fields(inner, *result.reported);
            std::vector<ReportedSample> samples;
            for (const SampleComparison& sample : result.samples)
                if (sample.reported) samples.push_back({sample});
            inner.derived("samples", samples);
        });
    }
    io("samples", result.samples);
    io.unless_empty("reproduction", result.reproduction);
    io.unless_empty("equal_velocities", result.equal_velocities);
    io.unless_empty("dynamic_over_analytic", result.dynamic_over_analytic);
    io.unless_empty("dampings", result.dampings);
    io.unless_empty("by_size", result.by_size);
    io.unless_empty("sizes", result.sizes);
    io.unless_empty("laws_by_size", result.laws_by_size);
    io.lenient("conclusion", result.conclusion);
}

template Json to_json(const ComparisonResult& result, DampingLaw law);
template ComparisonResult from_json(const View& result, DampingLaw law);

Json dampings_json(const DampingComparison& comparison) {
    return to_json(comparison, DampingLaw::constant);
}

void fields(auto& io, Is<StageMomentum> auto& stage) {
    io("duration", stage.duration, Dimension::time);
    io("static_impulse", stage.static_impulse, Dimension::impulse);
    io("damping_impulse", stage.damping_impulse, Dimension::impulse);
    io("mean_force", stage.mean_force, Dimension::force);
    io("residual", stage.residual, Dimension::impulse);
}

template <Dimension D>
void sides(auto& io, auto& both) {
    io("left", both.left, D);
    io("right", both.right, D);
}
void fields(auto& io, Is<Sides<Dimension::impulse>> auto& both) {
    sides<Dimension::impulse>(io, both);
}
void fields(auto& io, Is<Sides<Dimension::energy>> auto& both) {
    sides<Dimension::energy>(io, both);
}

void fields(auto& io, Is<HistoryMomentum> auto& momentum) {
    io("approach", momentum.approach);
    io("rebound", momentum.rebound);
    io("mean_force_ratio", momentum.mean_force_ratio);
    io.unless_empty("equation_41", momentum.equation_41);
    io.unless_empty("equation_42", momentum.equation_42);
    io.unless_empty("equation_43", momentum.equation_43);
    io.object("equation_44", [&](auto& inner) {
        inner("damping_impulse", momentum.damping_impulse, Dimension::impulse);
        inner("momentum_lost", momentum.momentum_lost, Dimension::impulse);
        inner("holds", momentum.damping_exceeds_loss);
    });
    io.object("equation_45", [&](auto& inner) {
        inner.derived("approach_time", momentum.approach.duration, Dimension::time);
        inner.derived("rebound_time", momentum.rebound.duration, Dimension::time);
        inner("holds", momentum.rebound_is_longer);
    });
    io("verdict", momentum.verdict);
}

void fields(auto& io, Is<EnergyLedger> auto& energy) {
    io("incident", energy.incident, Dimension::energy);
    io("at_touch", energy.at_touch, Dimension::energy);
    io("remaining", energy.remaining, Dimension::energy);
    io("potential", energy.potential, Dimension::energy);
    io("dissipated", energy.dissipated, Dimension::energy);
    io("plastic", energy.plastic, Dimension::energy);
    io("jumps", energy.jumps, Dimension::energy);
    io("residual", energy.residual, Dimension::energy);
    io("minimum", energy.minimum, Dimension::energy);
}

constexpr FieldColumn<TrajectoryPoint> trajectory_columns[]{
    {"time", &TrajectoryPoint::time, Dimension::time},
    {"overlap", &TrajectoryPoint::overlap, Dimension::length},
    {"velocity", &TrajectoryPoint::velocity, Dimension::velocity},
    {"contact_radius", &TrajectoryPoint::contact_radius, Dimension::length},
    {"repulsive_force", &TrajectoryPoint::repulsive_force, Dimension::force},
    {"attractive_force", &TrajectoryPoint::attractive_force, Dimension::force},
    {"damping_force", &TrajectoryPoint::damping_force, Dimension::force}};

void fields(auto& io, Is<History> auto& history) {
    io("part", history.part);
    io("velocity", history.velocity, Dimension::velocity);
    io.lenient("damping", history.damping, dimension_of(io.damping_law()));
    if (!is_of_a_curve(history.part)) {
        io.lenient("outcome", history.outcome);
        io.lenient("restitution", history.restitution, Dimension::fraction);
        io("contact_time", history.contact_time, Dimension::time);
        io.lenient("maximum_overlap", history.maximum_overlap, Dimension::length);
        io.lenient("greatest_pressure", history.greatest_pressure, Dimension::pressure);
        io("yield_pressure", history.yield_pressure, Dimension::pressure);
        io.unless_empty("energy", history.energy);
        io.unless_empty("momentum", history.momentum);
    }
    io.object("trajectory",
              [&](auto& inner) { inner.columns(history.trajectory, trajectory_columns, false); });
}

void fields(auto& io, Is<ContactTimeAt> auto& time) {
    io("law", time.law);
    io("velocity", time.velocity, Dimension::velocity);
    io("restitution", time.restitution, Dimension::fraction);
    io("contact_time", time.contact_time, Dimension::time);
}

constexpr FieldColumn<CurveImpact> curve_columns[]{
    {"velocity", &CurveImpact::velocity, Dimension::velocity},
    {"lower_velocity", &CurveImpact::lower, Dimension::velocity},
    {"upper_velocity", &CurveImpact::upper, Dimension::velocity},
    {"restitution", &CurveImpact::restitution, Dimension::fraction},
    {"damping", &CurveImpact::damping, Dimension::damping, true},
    {"contact_time", &CurveImpact::contact_time, Dimension::time},
    {"dissipated", &CurveImpact::dissipated, Dimension::fraction},
    {"adhesion", &CurveImpact::adhesion, Dimension::fraction},
    {"plastic", &CurveImpact::plastic, Dimension::fraction}};

void fields(auto& io, Is<LawCurve> auto& curve) {
    io("start", curve.start, Dimension::velocity);
    io.lenient("histories", curve.histories);
    io.columns(curve.impacts, curve_columns, true);
}

void fields(auto& io, Is<SampleHistories> auto& sample) {
    io("name", sample.name);
    io.lenient("contact_times", sample.contact_times);
    io.under_laws(sample.laws, {"name", "contact_times", "curves"});
    io.lenient("curves", sample.curves);
}

Json energy_json(const EnergyLedger& energy) {
    return to_json(energy, DampingLaw::constant);
}

template Json to_json(const HistoriesResult& result, DampingLaw law);
template HistoriesResult from_json(const View& result, DampingLaw law);

void fields(auto& io, Is<Regime> auto& regime) {
    io.lenient("tabor_parameter", regime.tabor_parameter);
    io.lenient("equilibrium_separation", regime.equilibrium_separation, Dimension::length);
    io.lenient("adhesion", regime.adhesion);
    io.lenient("transition_parameter", regime.transition_parameter);
    io.lenient("greatest_pressure", regime.greatest_pressure, Dimension::pressure);
    io("yield_pressure", regime.yield_pressure, Dimension::pressure);
    io.lenient("damping_number", regime.damping_number);
    io.lenient("adhesion_number", regime.adhesion_number);
    io("yield_velocity", regime.yield_velocity, Dimension::velocity);
    io("law_yield_velocity", regime.law_yield_velocity, Dimension::velocity);
    io.lenient("yields", regime.yields);
    io.lenient("contact_radius", regime.contact_radius, Dimension::length);
    io.lenient("relative_contact_radius", regime.relative_contact_radius);
    io.lenient("relative_overlap", regime.relative_overlap);
    io.by_hand(
        "warnings", regime.warnings,
        [](const std::vector<Finding>& findings) { return Json(texts_of(findings)); },
        [](const View& node) {
            std::vector<Finding> findings;
            for (const std::string& text : node.texts())
                findings.push_back({regime_code, Severity::remark, text});
            return findings;
        });
}

Json regime_json(const Regime& regime) {
    return to_json(regime, DampingLaw::constant);
}

void fields(auto& io, Is<CriticalVelocityCheck> auto& check) {
    io("verdict", check.verdict);
    io("deviation", check.deviation, NullIfNotFinite{});
}

Json check_json(const CriticalVelocityCheck& check) {
    return to_json(check, DampingLaw::constant);
}

template <class Io>
void fields(Io& io, Is<MeasuredCriticalVelocity> auto& measured) {
    std::optional<VelocityEstimate> velocity;
    if (measured.value) velocity = estimate_of(measured);
    Bounds interval{measured.lower, measured.upper};
    io("critical_velocity", velocity, WithoutInterval{});
    io.lenient("interval", interval, Dimension::velocity);
    io("fastest_capture", measured.fastest_capture, Dimension::velocity);
    io("slowest_rebound", measured.slowest_rebound, Dimension::velocity);
    io("transition_width", measured.width, Dimension::velocity);
    io.lenient("note", measured.note);
    if constexpr (Io::reads) {
        if (velocity) measured.value = velocity->value;
        if (velocity) measured.standard_uncertainty = velocity->standard_uncertainty;
        measured.lower = interval.lower;
        measured.upper = interval.upper;
    }
}

Json measured_velocity_json(const MeasuredCriticalVelocity& measured) {
    return to_json(measured, DampingLaw::constant);
}

void fields(auto& io, Is<Influence> auto& influence) {
    io("factor", influence.factor);
    io("first", influence.first.value, NullIfNotFinite{});
    io("first_error", influence.first.standard_error, NullIfNotFinite{});
    io("total", influence.total.value, NullIfNotFinite{});
    io("total_error", influence.total.standard_error, NullIfNotFinite{});
}

void fields(auto& io, Is<CalibrationResponse> auto& response) {
    io.lenient("density", response.density);
    io.lenient("work_of_adhesion", response.work_of_adhesion);
}

void fields(auto& io, Is<VelocityUncertainty> auto& uncertainty) {
    io.derived("method", std::string("Monte Carlo, sobol"));
    io.lenient("evaluations", uncertainty.evaluations);
    io.lenient("undefined", uncertainty.undefined);
    io("mean", uncertainty.mean, Dimension::velocity);
    io("median", uncertainty.median, Dimension::velocity);
    io.unless_empty("lower_error", uncertainty.lower_error, Dimension::velocity);
    io.unless_empty("upper_error", uncertainty.upper_error, Dimension::velocity);
    io.lenient("relative_standard_uncertainties", uncertainty.relative);
    io.lenient("taken_as_exact", uncertainty.taken_as_exact);
    io("influences", uncertainty.influences);
    io.unless_empty("powers_of_contact_modulus", uncertainty.response);
    io.unless_empty("damping", uncertainty.damping);
}

void fields(auto& io, Is<ExtrapolatedVelocity> auto& extrapolated) {
    io("critical_velocity", extrapolated.velocity, WithoutInterval{});
    io("interval", extrapolated.velocity.interval, Dimension::velocity);
    io("uncertainty", extrapolated.uncertainty);
    io.unless_empty("check", extrapolated.check);
}

namespace {

/// Sets the interval of a velocity, which is beside it and within it; either may be open where an edit
/// dropped it.
void set_interval(const View& node, VelocityEstimate& velocity) {
    const Bounds within = velocity.interval.value_or(Bounds{});
    velocity.interval = std::nullopt;
    if (const auto beside = node.find("interval"))
        read_value(*beside, velocity.interval.emplace(), Dimension::velocity);
    if (!node.at("critical_velocity").has("interval")) return;
    const Bounds beside = velocity.interval.value_or(Bounds{});
    if (within == beside) return;
    node.at("interval")
        .fail(std::string(within.lower != beside.lower ? "lower" : "upper") +
                  " is not that of the interval in critical_velocity",
              "the same interval in both places");
}

}  // namespace

template <class Io>
void fields(Io& io, Is<LawCriticalVelocity> auto& velocity) {
    io.lenient("detachment", velocity.detachment);
    io.derived("damping_law", io.damping_law());
    io.lenient("damping", velocity.damping, dimension_of(io.damping_law()));
    io("critical_velocity", velocity.velocity);
    io("verdict", velocity.verdict);
    io("contact_time", velocity.contact_time, Dimension::time);
    io("maximum_overlap", velocity.maximum_overlap, Dimension::length);
    io.lenient("crossings", velocity.crossings, Dimension::velocity);
    io("dissipated", velocity.dissipated, Dimension::energy);
    io.lenient("plastic", velocity.plastic, Dimension::energy);
    io("detachment_energy", velocity.detachment_energy, Dimension::energy);
    io("regime", velocity.regime);
    io.unless_empty("interval_note", velocity.interval_note);
    if (velocity.velocity && velocity.velocity->interval)
        io.derived("interval", *velocity.velocity->interval, Dimension::velocity);
    io.unless_empty("uncertainty", velocity.uncertainty);
    io.unless_empty("check", velocity.check);
    if (Io::reads || velocity.from_impacts) io("extrapolated", velocity.extrapolated);
    if constexpr (Io::reads) {
        velocity.from_impacts = io.node().json().contains("extrapolated");  // null where there is none
        if (velocity.velocity) set_interval(io.node(), *velocity.velocity);
    }
}

Json critical_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law) {
    Json json = to_json(velocity, law);
    if (velocity.velocity) json["critical_velocity"] = value_json(*velocity.velocity, WithoutInterval{});
    return json;
}

void fields(auto& io, Is<SampleCriticalVelocity> auto& sample) {
    io("name", sample.name);
    io("measured", sample.measured);
    io.under_laws(sample.laws, {"name", "measured"});
}

template Json to_json(const CriticalVelocityResult& result, DampingLaw law);
template CriticalVelocityResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
