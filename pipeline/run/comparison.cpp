// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/run/comparison/glass.hpp"
#include "pipeline/run/comparison/oblique.hpp"
#include "pipeline/run/comparison/paper_scheme.hpp"
#include "pipeline/run/comparison/reported_velocity.hpp"
#include "pipeline/run/comparison/reproduction.hpp"
#include "pipeline/run/comparison/temperature.hpp"
#include "pipeline/run/comparison/velocities.hpp"
#include "pipeline/run/dampings.hpp"
#include "pipeline/run/laws_by_size.hpp"
#include "pipeline/run/reported_law.hpp"
#include "pipeline/run/sizes.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

/// Results of one sample.
struct ComparedSample {
    const Sample& sample;
    const SampleModulus& modulus;
    const SampleContact& contact;
    const SampleAnalytic& analytic;
    const LawMap<LawFit>& fits;
    const SampleCriticalVelocity& velocities;
    const SampleHistories& histories;
    const RestitutionSeries* series;  ///< null: none was given
};

/// Range of the ratio of dynamic to analytic velocities, over all samples and laws.
struct Gap {
    double least_ratio = std::numeric_limits<double>::infinity();
    double greatest_ratio = 0;
    double least_share = std::numeric_limits<double>::infinity();  ///< of damping in the energy lost at v_c
    double greatest_share = 0;

    void take(const LawCriticalVelocity& dynamic, double analytic) {
        if (!dynamic.velocity || !(analytic > 0)) return;
        const double ratio = dynamic.velocity->value / analytic;
        least_ratio = std::min(least_ratio, ratio);
        greatest_ratio = std::max(greatest_ratio, ratio);
        const double share = dynamic.dissipated / (dynamic.dissipated + dynamic.plastic +
                                                   std::max(0.0, dynamic.detachment_energy));
        least_share = std::min(least_share, share);
        greatest_share = std::max(greatest_share, share);
    }

    [[nodiscard]] bool known() const { return greatest_ratio > 0; }

    /// "least to greatest", or the one number that both are.
    [[nodiscard]] static std::string range(const std::string& least, const std::string& greatest) {
        return least == greatest ? least : least + " to " + greatest;
    }

    [[nodiscard]] std::string sentence() const {
        if (!known())
            return "No sample has both a dynamic critical velocity and one of adhesion alone (Eq. 30), so "
                   "there is none to compare.";
        const std::string ratios =
            fmt::format("The dynamic critical velocities are {} times the analytic ones of Eq. 30",
                        range(readable_number(least_ratio, 3), readable_number(greatest_ratio, 3)));
        const std::string share =
            range(readable_number(100 * least_share, 4), readable_number(100 * greatest_share, 4)) + " %";
        if (least_ratio > 2)
            return fmt::format(
                "{}: the first-contact adhesive loss W_s does not explain capture here, viscous "
                "dissipation does, which takes {} of the energy lost at v_c.",
                ratios, share);
        return fmt::format(
            "{}; viscous dissipation takes {} of the energy lost at v_c, breaking the contact the rest.",
            ratios, share);
    }
};

Beside beside(double ours, const Quantity& published) {
    return {ours, published, ours / published.value - 1};
}

/// Our values beside the published ones, for every law that has both.
template <class Ours, class Value>
LawMap<Beside> beside_by_law(const LawMap<Quantity>& published, const LawMap<Ours>& ours, Value&& value) {
    LawMap<Beside> values;
    for (const auto& [law, printed] : published) {
        const Ours* own = ours.find(law);
        if (own == nullptr) continue;
        if (const std::optional<double> number = value(*own)) values.set(law, beside(*number, printed));
    }
    return values;
}

PublishedBeside published_beside(const PublishedSample& published, const ComparedSample& of) {
    PublishedBeside found{.source = published.source};
    if (published.young_modulus)
        found.young_modulus = beside(of.modulus.young_modulus.value, *published.young_modulus);
    for (const auto& [name, printed] : published.volume_fractions)
        for (const PhaseShare& share : of.modulus.phases)
            if (share.name == name)
                found.volume_fractions.emplace_back(name, beside(share.volume_fraction, printed));
    found.critical_damping = beside_by_law(published.critical_damping, of.fits, [](const LawFit& fit) {
        return std::optional(fit.critical_damping);
    });
    const LawMap<LawCriticalVelocity>& velocities = of.velocities.laws;
    found.critical_velocity =
        beside_by_law(published.critical_velocity, velocities, [](const LawCriticalVelocity& velocity) {
            return velocity.velocity ? std::optional(velocity.velocity->value) : std::nullopt;
        });
    found.critical_contact_times =
        beside_by_law(published.critical_contact_times, velocities,
                      [](const LawCriticalVelocity& velocity) { return velocity.contact_time; });
    for (const auto& printed : published.contact_times)
        for (const ContactTimeAt& own : of.histories.contact_times)
            if (own.contact_time && own.law == printed.law && own.velocity == printed.velocity.value)
                found.contact_times.push_back(
                    {own.law, printed.velocity, beside(*own.contact_time, printed.contact_time)});
    return found;
}

/// Dynamic critical velocities with their intervals and verdicts.
LawMap<LawComparison> compare_laws(const ComparedSample& of, const std::vector<LawChoice>& laws) {
    LawMap<LawComparison> all;
    for (const LawChoice& choice : laws) {
        LawComparison entry;
        const LawCriticalVelocity* velocity = of.velocities.laws.find(choice.law);
        if (velocity == nullptr)
            entry.verdict = of.sample.restitution ? LawVerdict::no_fit : LawVerdict::no_damping_data;
        else
            entry.verdict = static_cast<LawVerdict>(velocity->verdict);
        if (velocity != nullptr && velocity->velocity) {
            entry.velocity = velocity->velocity;
            if (velocity->extrapolated) entry.extrapolated = velocity->extrapolated->velocity;
            entry.interval_note = velocity->interval_note;
            entry.check = velocity->check;
        }
        all.set(choice.law, std::move(entry));
    }
    return all;
}

/// The measured critical velocity: reported, or else as the outcomes of the impacts show it.
std::optional<Stated> measured_of(const Sample& sample,
                                  const std::optional<MeasuredCriticalVelocity>& measured) {
    if (sample.measured_critical_velocity) return sample.measured_critical_velocity;
    if (!measured || !measured->value) return std::nullopt;
    const VelocityEstimate estimate = estimate_of(*measured);
    return Stated{make_quantity(estimate.value, Dimension::velocity, estimate.standard_uncertainty),
                  Origin::measured, measured->note};
}

/// "cohesion range"
std::string parameter_words(const LawParameter& parameter) {
    std::string words(parameter.name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

bool is_assumed(Origin origin) {
    return origin == Origin::assumed || origin == Origin::inferred || origin == Origin::literature ||
           origin == Origin::computed;
}

/// Properties of the contact of a sample, the wall's among them, that were not measured.
std::vector<AssumedProperty> assumed_properties(const Sample& sample, const SampleContact& contact,
                                                const std::optional<Wall>& wall) {
    std::vector<AssumedProperty> list;
    const auto add = [&](const std::string& name, const Quantity& value, Origin origin,
                         const std::string& why = {}) {
        if (is_assumed(origin)) list.push_back({name, value, origin, why});
    };
    Quantity diameter = contact.radius;
    diameter.value *= 2;
    if (diameter.standard_uncertainty) *diameter.standard_uncertainty *= 2;
    add("diameter", diameter, sample.diameter.origin);
    if (sample.density)
        add("density", contact.density.quantity, sample.density->origin);
    else
        add("density", contact.density.quantity, Origin::computed,
            sample.porosity ? "not given: that of the phases and the porosity"
                            : "not given: that of the phases without any pores");
    const Quantity& adhesion = contact.work_of_adhesion.quantity;
    if (const auto* stated =
            sample.work_of_adhesion ? std::get_if<Stated>(&*sample.work_of_adhesion) : nullptr)
        add("work of adhesion", adhesion, stated->origin);
    else if (sample.work_of_adhesion)
        add("work of adhesion", adhesion, Origin::computed, "from surface energies");
    for (const auto& [parameter, stated] : sample.parameters)
        add(parameter_words(parameter), stated.quantity, stated.origin);
    if (const auto* elastic = wall ? std::get_if<ElasticWall>(&*wall) : nullptr) {
        add("Young's modulus of the wall", elastic->young_modulus.quantity, elastic->young_modulus.origin);
        add("Poisson ratio of the wall", elastic->poisson_ratio.quantity, elastic->poisson_ratio.origin);
    }
    return list;
}

/// Which of diameter, density, work of adhesion and parameters of contact laws state no uncertainty, so that
/// none goes into intervals.
std::vector<std::string> exact_properties(const SampleContact& contact) {
    std::vector<std::string> list;
    const auto add = [&](const std::string& name, const Quantity& quantity) {
        if (!quantity.standard_uncertainty) list.push_back(name);
    };
    add("diameter", contact.radius);
    add("density", contact.density.quantity);
    if (contact.work_of_adhesion.value() > 0) add("work of adhesion", contact.work_of_adhesion.quantity);
    for (const auto& [parameter, value] : contact.parameters) add(parameter_words(parameter), value.quantity);
    return list;
}

/// Why laws have no damping from which a velocity would follow, by sample: the first finding of the fit on a
/// law, or of the reading of its dampings.
std::map<std::string_view, std::string> no_damping_reasons(const Run& run) {
    std::map<std::string_view, std::string> reasons;
    for (const std::string_view file : {fit_artifact, damping_artifact})
        if (const StageRecord* stage = run.record(file))
            for (const Note& note : stage->notes)
                if (note.law) reasons.try_emplace(note.sample, note.text);
    for (const Sample& sample : run.data.samples)
        if (sample.restitution)
            reasons.try_emplace(sample.name, "no damping follows from the impacts");
        else
            reasons[sample.name] = "no impacts were given";
    return reasons;
}

/// The velocity that the outcomes of a sample's impacts show, also where the case states a measured one.
std::optional<MeasuredCriticalVelocity> outcomes_of(const ComparedSample& of, double scale_uncertainty) {
    if (!of.sample.measured_critical_velocity) return of.velocities.measured;
    if (of.series == nullptr || of.series->origin != Origin::measured) return std::nullopt;
    try {
        return measured_critical_velocity(of.series->impacts, scale_uncertainty);
    } catch (const InputError&) {  // as without a stated velocity, for which the stage has a note
        return std::nullopt;
    }
}

/// How the run reports: the law of all samples and the order of the others.
struct Reporting {
    ReportedLaw law;
    std::vector<Law> preference;
    double scale_uncertainty;  ///< that the velocities have in common [1]
};

ReportedVelocity reported_of(const ComparedSample& of, const Reporting& reporting,
                             const std::string& no_damping) {
    const auto outcomes = outcomes_of(of, reporting.scale_uncertainty);
    return reported_velocity({.law = reporting.law,
                              .preference = reporting.preference,
                              .velocities = of.velocities.laws,
                              .outcomes = outcomes,
                              .basis = of.series == nullptr                    ? ReportedBasis::nothing
                                       : of.series->origin == Origin::measured ? ReportedBasis::impacts
                                                                               : ReportedBasis::reproduction,
                              .no_damping = no_damping});
}

SampleComparison comparison_of(const ComparedSample& of, const Case& data) {
    const SampleContact& contact = of.contact;
    SampleComparison entry{.name = of.sample.name,
                           .diameter = 2 * contact.radius.value,
                           .density = contact.density.quantity,
                           .work_of_adhesion = contact.work_of_adhesion.quantity,
                           .assumed = assumed_properties(of.sample, contact, data.wall),
                           .taken_as_exact = exact_properties(contact),
                           .young_modulus = of.modulus.young_modulus,
                           .contact_modulus = contact.pair.contact_modulus,
                           .separation_energy = of.analytic.separation_energy,
                           .analytic_velocity = of.analytic.critical_velocity,
                           .laws = compare_laws(of, data.laws),
                           .measured = measured_of(of.sample, of.velocities.measured)};
    if (entry.measured && !of.sample.measured_critical_velocity) entry.measured_by_outcomes = true;
    if (of.velocities.measured && (of.velocities.measured->lower || of.velocities.measured->upper))
        entry.measured_interval = Bounds{of.velocities.measured->lower, of.velocities.measured->upper};
    if (of.sample.published) entry.published = published_beside(*of.sample.published, of);
    return entry;
}

/// Which damping explains the impacts, and which sizes stick, by the reported law.
void set_other_sizes(const Run& run, ComparisonResult& result, StageRecord& record) {
    if (!result.reported) return;
    const LawChoice choice = *std::ranges::find(run.data.laws, result.reported->law, &LawChoice::law);
    const auto study =
        study_dampings(choice, run.contact, run.restitution, run.data.fit.estimate.scale_uncertainty);
    if (study) result.dampings = study->comparison;
    const auto sizes = velocities_by_size({choice, run.data.damping_law, run.contact, run.critical_velocity,
                                           study ? study->fits : std::vector<FittedDamping>{}});
    if (!sizes) return;
    result.by_size = sizes->rows;
    result.sizes = sizes->summary;
    if (const auto doubt = kept_properties_finding(run.contact)) record.note(*doubt);
}

}  // namespace

ComparisonResult comparison_stage(const Run& run, StageRecord& record) {
    record.citations = {"dong2013, Tables 1, 3 and 4, Eq. 30"};
    const Case& data = run.data;
    ComparisonResult result{.name = data.name};
    Gap gap;
    const auto no_damping = no_damping_reasons(run);
    result.reported = reported_law(data, run.contact);
    std::optional<Reporting> reporting;
    if (result.reported)
        reporting = {*result.reported, laws_by_preference(data, run.contact),
                     data.fit.estimate.scale_uncertainty};
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const ComparedSample of{
            data.samples[i],
            run.modulus.samples[i],
            run.contact.samples[i],
            run.analytic.samples[i],
            run.fit.samples[i].laws,
            run.critical_velocity.samples[i],
            run.histories.samples[i],
            run.restitution.samples[i].series.empty() ? nullptr : &run.restitution.samples[i].series.front()};
        for (const auto& [law, velocity] : of.velocities.laws)
            gap.take(velocity, of.analytic.critical_velocity);
        result.samples.push_back(comparison_of(of, data));
        SampleComparison& sample = result.samples.back();
        if (reporting) sample.reported = reported_of(of, *reporting, no_damping.at(of.sample.name));
        sample.temperature = temperature_limits(
            {data.temperature, of.modulus, of.contact, of.velocities.laws, sample.reported});
        sample.oblique = oblique_curves(
            {data, of.contact, of.velocities.laws, run.histories.samples[i].curves, sample.reported});
        sample.paper_explicit = paper_scheme(data, of.contact, run.damping.samples[i], record);
        const bool bounded =
            sample.reported &&
            (sample.reported->velocity || (sample.reported->interval && sample.reported->interval->lower));
        if (bounded && relaxing_glass(sample)) sample.reported->lower_bound = true;
        if (sample.temperature)
            for (const auto& [law, finding] : temperature_notes(*sample.temperature))
                record.note(finding, sample.name, law);
    }
    if (std::ranges::any_of(run.modulus.samples,
                            [](const SampleModulus& each) { return each.glass.has_value(); }))
        record.citations.insert(record.citations.end(), {"giordano2008, Table 1", "urbain1981"});
    if (data.friction) record.citations.emplace_back("walton1993");
    const auto effects = glass_effects(run, result.samples);
    for (std::size_t i = 0; i < effects.size(); ++i) result.samples[i].glass = effects[i];
    result.reproduction = reproduction_of(run, result.samples);
    result.equal_velocities = equal_velocities(data, run.contact, run.damping);
    if (gap.known()) result.dynamic_over_analytic = RatioRange{gap.least_ratio, gap.greatest_ratio};
    result.conclusion = gap.sentence();
    set_other_sizes(run, result, record);
    result.laws_by_size = laws_by_size(data.laws, run.contact);
    return result;
}

}  // namespace ashimpact
