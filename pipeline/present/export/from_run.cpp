// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/from_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/run_json.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/inference/calibration/reconstruction.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

constexpr int curve_nodes = 24;

/// A sample's name as text: nothing in it may end a line or look like code to a reader of Markdown.
std::string as_text(const std::string& name) {
    std::string text = in_quotes(name);
    std::ranges::replace(text, '`', '\'');
    return text;
}

template <class Entry>
const Entry& sample_named(const std::vector<Entry>& entries, const RunChoice& choice) {
    std::vector<std::string> names;
    for (const Entry& entry : entries) {
        if (entry.name == choice.sample) return entry;
        names.push_back(in_quotes(entry.name));
    }
    throw InputError(choice.sample.empty() ? "is missing" : "no sample is called " + in_quotes(choice.sample),
                     joined(names))
        .at("--sample");
}

LawChoice law_of(const Case& data, const RunChoice& choice) {
    if (choice.law.empty()) {
        if (data.laws.size() > 1)
            spdlog::warn("warning: the run has several laws; {} is exported, --law chooses another",
                         data.laws.front().law.name());
        return data.laws.front();
    }
    std::vector<std::string> names;
    for (const LawChoice& each : data.laws) {
        if (each.law.name() == choice.law) return each;
        names.emplace_back(each.law.name());
    }
    throw InputError("the run has no law " + in_quotes(choice.law), joined(names)).at("--law");
}

const LawFit& fit_of(const SampleFit& sample, const LawChoice& law) {
    if (const LawFit* fit = sample.laws.find(law.law)) return *fit;
    throw InputError(
        fmt::format("there is no fit of the damping by {} for {}", law.law.name(), in_quotes(sample.name)),
        "a law with a fit in 6-fit.json")
        .at("--law");
}

/// Largest restitution of the rising branch.
double greatest_restitution(const DampingSeries& series) {
    double greatest = 0;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        if (!series.rising || series.velocity[i] <= series.rising->to)
            greatest = std::max(greatest, series.restitution[i]);
    return greatest;
}

/// The damping at which the run's critical velocity is one.
struct CriticalDamping {
    double coefficient;              ///< [unit of the damping law]
    std::optional<double> velocity;  ///< v_c; none where the verdict of the run is not finite [m/s]
    bool of_headline = false;        ///< solved for the headline; else the fit's own eta(e = 0)
};

/// The headline of 7-critical-velocity.json need not be that of the fit's eta(e = 0): it may be read from
/// the data directly, or edited. The exported damping is then the smallest that captures at the headline.
CriticalDamping critical_damping(const LawFit& fit, const LawChoice& law, DampingLaw damping_law,
                                 const ContactPair& contact, const LawCriticalVelocity& headline) {
    constexpr double same = 1e-9;  // relative; the headline is written with as many digits
    const CriticalVelocity of_fit = critical_velocity({.law = law.law,
                                                       .detachment = law.detachment,
                                                       .damping = {damping_law, fit.critical_damping},
                                                       .contact = contact});
    if (!headline.velocity) return {fit.critical_damping, of_fit.value};
    const double velocity = headline.velocity->value;
    if (of_fit.value && std::abs(velocity / *of_fit.value - 1) <= same)
        return {fit.critical_damping, of_fit.value};
    const DampingInversion inversion = damping_from_restitution({.law = law.law,
                                                                 .detachment = law.detachment,
                                                                 .damping_law = damping_law,
                                                                 .contact = contact,
                                                                 .velocity = velocity,
                                                                 .restitution = 0});
    return {inversion.damping.coefficient, velocity, true};
}

/// eta(v_in): where an impact with the fit's eta(e) gives e back, from v_c on.
std::vector<DampingNode> followed(const LawFit& fit, const LawChoice& law, const ContactPair& contact,
                                  const CriticalDamping& critical, double greatest) {
    if (!critical.velocity)
        throw InputError("the critical damping has no finite critical velocity",
                         "damping that is not followed")
            .at("--follow-velocity");
    std::vector<DampingNode> nodes{{*critical.velocity, critical.coefficient}};
    for (int i = 1; i <= curve_nodes; ++i) {
        const double e = greatest * i / curve_nodes;
        const double eta = fit.damping(e);
        const double velocity = velocity_of_restitution({.law = law.law,
                                                         .detachment = law.detachment,
                                                         .damping = {DampingLaw::constant, eta},
                                                         .contact = contact,
                                                         .velocity = *critical.velocity},
                                                        e);
        // Adhesive laws fold back just above v_c, by less than a per cent; see least_rebound().
        if (velocity > 1.001 * nodes.back().velocity) nodes.push_back({velocity, eta});
    }
    return nodes;
}

}  // namespace

ExportSubject subject_of_run(const RunChoice& choice) {
    const Run run = read_run(load_artifacts(choice.folder, {case_artifact, contact_artifact, damping_artifact,
                                                            fit_artifact, critical_velocity_artifact}));
    const Case& data = run.data;
    const LawChoice law = law_of(data, choice);
    const SampleContact& contact = sample_named(run.contact.samples, choice);
    const LawFit& fit = fit_of(sample_named(run.fit.samples, choice), law);
    const LawCriticalVelocity* headline =
        sample_named(run.critical_velocity.samples, choice).laws.find(law.law);
    if (headline == nullptr)
        throw InputError(
            "7-critical-velocity.json has no critical velocity by " + std::string(law.law.name()),
            "a law with one")
            .at("--law");
    const CriticalDamping critical = critical_damping(fit, law, data.damping_law, contact.pair, *headline);
    const double diameter = 2 * contact.radius.value;

    ExportSubject subject{.law = law.law,
                          .detachment = law.detachment,
                          .contact = contact.pair,
                          .density = contact.density.value(),
                          .damping = {.law = data.damping_law,
                                      .nodes = {{0, critical.coefficient}},
                                      .reference_diameter = diameter},
                          .from_diameter = diameter,
                          .to_diameter = diameter};
    if (contact.partner) subject.partner = {contact.partner->radius.value, contact.partner->mass.value};
    subject.origins = {fmt::format("sample {} of a run of ashimpact, diameter {}", as_text(choice.sample),
                                   readable(diameter, "m")),
                       fmt::format("E* = {}, contact modulus of {} together (2-contact.json)",
                                   readable(contact.contact_modulus.quantity),
                                   contact.partner ? "both spheres" : "particle and wall"),
                       fmt::format("w = {}, work of adhesion of the pair of surfaces (2-contact.json)",
                                   readable(contact.work_of_adhesion.quantity)),
                       fmt::format("density {} (2-contact.json)", readable(contact.density.quantity))};
    if (!choice.follow_velocity) {
        subject.origins.push_back(fmt::format(
            "damping: {}, at every velocity: v_c is the run's headline, e above it is that of this damping",
            critical.of_headline ? "the smallest that captures at the critical velocity of "
                                   "7-critical-velocity.json"
                                 : "the critical damping eta(e = 0) of 6-fit.json"));
        return subject;
    }
    if (data.damping_law != DampingLaw::constant)
        throw InputError("the fit of the run is of another damping law", "a run with damping_law constant")
            .at("--follow-velocity");
    const DampingSeries* series = sample_named(run.damping.samples, choice).laws.find(law.law);
    if (series == nullptr)
        throw InputError("5-damping.json has no impacts by this law", "a law with impacts").at("--law");
    subject.damping.nodes = followed(fit, law, contact.pair, critical, greatest_restitution(*series));
    subject.to_velocity = subject.damping.nodes.back().velocity;
    subject.origins.push_back(fmt::format(
        "damping: the fit eta(e) of 6-fit.json along the velocity, {} nodes over the rising branch, "
        "from v_c to {}",
        subject.damping.nodes.size(), readable(*subject.to_velocity, "m/s")));
    return subject;
}

}  // namespace ashimpact
