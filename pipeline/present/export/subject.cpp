// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/subject.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/dem/softening.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

CriticalVelocity critical_at(const ExportSubject& subject, double diameter, double coefficient) {
    return critical_velocity({.law = subject.law,
                              .detachment = subject.detachment,
                              .damping = {subject.damping.law, coefficient},
                              .contact = contact_at(subject, diameter)});
}

/// v_c of the damping that belongs to a velocity, less that velocity [m/s]; above 0: captured.
double excess(const ExportSubject& subject, double diameter, double velocity) {
    const CriticalVelocity critical =
        critical_at(subject, diameter, subject.damping.coefficient(diameter, velocity));
    if (critical.verdict == CaptureVerdict::always_captured) return velocity;
    return critical.value.value_or(0) - velocity;
}

/// Where the excess changes its sign, between two velocities, to rounding.
double sign_change(const ExportSubject& subject, double diameter, double captured, double rebound) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (captured + rebound);
        if (middle == captured || middle == rebound) break;
        (excess(subject, diameter, middle) > 0 ? captured : rebound) = middle;
    }
    return rebound;
}

[[noreturn]] void refuse_several(double diameter) {
    throw InputError(
        fmt::format("capture and rebound of {} change places more than once", readable(diameter, "m")),
        "a subject with one critical velocity a size");
}

/// Captured impacts lie below one velocity: the signs at the nodes and between them change once.
CriticalVelocity with_velocity(const ExportSubject& subject, double diameter) {
    const auto& nodes = subject.damping.nodes;
    std::vector<double> velocities{0.0};
    for (const DampingNode& node : nodes) {
        velocities.push_back(0.5 * (velocities.back() + node.velocity));
        velocities.push_back(node.velocity);
    }
    CriticalVelocity above =
        critical_at(subject, diameter, subject.damping.coefficient(diameter, nodes.back().velocity));
    if (above.verdict != CaptureVerdict::finite) return above;
    velocities.push_back(2 * std::max(*above.value, velocities.back()));
    std::optional<double> found;
    for (std::size_t i = 1; i + 1 < velocities.size(); ++i) {
        const bool captured = excess(subject, diameter, velocities[i]) > 0;
        const bool captured_next = excess(subject, diameter, velocities[i + 1]) > 0;
        if (captured == captured_next) continue;
        if (found || !captured) refuse_several(diameter);
        found = sign_change(subject, diameter, velocities[i], velocities[i + 1]);
    }
    // Below the first node the damping is that of the first node.
    CriticalVelocity below = critical_at(subject, diameter, subject.damping.coefficient(diameter, 0));
    if (below.value && *below.value < velocities[1]) {
        if (found) refuse_several(diameter);
        return below;
    }
    above.value = found;
    return above;
}

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
    if (choice.law.empty() && data.laws.size() > 1)
        spdlog::warn("warning: the run has several laws; {} is exported, --law chooses another",
                     data.laws.front().law.name());
    std::vector<std::string> names;
    for (const LawChoice& each : data.laws) {
        if (choice.law.empty() || each.law.name() == choice.law) return each;
        names.emplace_back(each.law.name());
    }
    throw InputError("the run has no law " + in_quotes(choice.law), joined(names)).at("--law");
}

/// What a stage has of a law. @throws InputError with @p problem and @p allowed where there is none
template <class Laws>
const auto& found_in(const Laws& laws, const LawChoice& law, const std::string& problem,
                     const char* allowed) {
    if (const auto* found = laws.find(law.law)) return *found;
    throw InputError(problem, allowed).at("--law");
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

/// The headline may be read from data or edited: then the smallest damping that captures at it.
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

double SizedDamping::coefficient(double diameter, double velocity) const {
    const double factor = exponent == 0 ? 1.0 : std::pow(diameter / reference_diameter, exponent);
    const auto above = std::ranges::lower_bound(nodes, velocity, {}, &DampingNode::velocity);
    if (above == nodes.begin()) return factor * nodes.front().coefficient;
    if (above == nodes.end()) return factor * nodes.back().coefficient;
    const DampingNode& below = *std::prev(above);
    const double share = (velocity - below.velocity) / (above->velocity - below.velocity);
    return factor * (below.coefficient + share * (above->coefficient - below.coefficient));
}

bool SizedDamping::is_zero() const {
    return std::ranges::all_of(nodes, [](const DampingNode& node) { return node.coefficient == 0; });
}

ExportSubject softened(ExportSubject subject, double factor) {
    at_place("--soften", [&] { require_softening(factor); });
    subject.stiff = StiffContact{factor, subject.contact, subject.damping.nodes};
    const double damping = softening_of(subject.damping.law, subject.contact, factor);
    for (DampingNode& node : subject.damping.nodes) node.coefficient *= damping;
    subject.contact = softened(subject.contact, factor);
    return subject;
}

ExportSubject stiffened(ExportSubject subject) {
    if (!subject.stiff) return subject;
    subject.contact = subject.stiff->contact;
    subject.damping.nodes = subject.stiff->nodes;
    subject.stiff.reset();
    return subject;
}

double stretch_of(const ExportSubject& subject) {
    return subject.stiff ? stretch_of(subject.stiff->factor) : 1;
}

void require_wall(const ExportSubject& subject, const std::string& reason) {
    if (subject.partner)
        throw InputError(reason, "a wall; lammps, liggghts, yade and table take two spheres")
            .at("--partner-radius, or the partner of the run");
}

double particle_mass(const ExportSubject& subject, double diameter) {
    if (!subject.partner && diameter == subject.reference_diameter()) return subject.contact.mass;
    return sphere_mass(diameter / 2, subject.density);
}

ContactPair contact_at(const ExportSubject& subject, double diameter) {
    ContactPair contact = subject.contact;
    if (diameter == subject.reference_diameter()) return contact;
    contact.effective_radius = diameter / 2;
    contact.mass = particle_mass(subject, diameter);
    if (subject.partner) {
        contact.effective_radius = effective_radius(contact.effective_radius, subject.partner->radius);
        contact.mass = effective_mass(contact.mass, subject.partner->mass);
    }
    return contact;
}

Impact impact_at(const ExportSubject& subject, double diameter, double velocity) {
    return {.law = subject.law,
            .detachment = subject.detachment,
            .damping = {subject.damping.law, subject.damping.coefficient(diameter, velocity)},
            .contact = contact_at(subject, diameter),
            .velocity = velocity};
}

CriticalVelocity threshold_at(const ExportSubject& subject, double diameter) {
    if (subject.damping.depends_on_velocity()) return with_velocity(subject, diameter);
    CriticalVelocity critical = critical_at(subject, diameter, subject.damping.coefficient(diameter, 0));
    if (critical.crossings.size() > 1) refuse_several(diameter);
    return critical;
}

ExportSubject subject_of_run(const RunChoice& choice) {
    const Run run = read_run(load_artifacts(choice.folder, {case_artifact, contact_artifact, damping_artifact,
                                                            fit_artifact, critical_velocity_artifact}));
    const Case& data = run.data;
    const LawChoice law = law_of(data, choice);
    const SampleContact& contact = sample_named(run.contact.samples, choice);
    const LawFit& fit = found_in(
        sample_named(run.fit.samples, choice).laws, law,
        fmt::format("there is no fit of the damping by {} for {}", law.law.name(), in_quotes(choice.sample)),
        "a law with a fit in 6-fit.json");
    const LawCriticalVelocity& headline =
        found_in(sample_named(run.critical_velocity.samples, choice).laws, law,
                 fmt::format("7-critical-velocity.json has no critical velocity by {}", law.law.name()),
                 "a law with one");
    const CriticalDamping critical = critical_damping(fit, law, data.damping_law, contact.pair, headline);
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
    const DampingSeries& series = found_in(sample_named(run.damping.samples, choice).laws, law,
                                           "5-damping.json has no impacts by this law", "a law with impacts");
    subject.damping.nodes = followed(fit, law, contact.pair, critical, greatest_restitution(series));
    subject.to_velocity = subject.damping.nodes.back().velocity;
    subject.origins.push_back(fmt::format(
        "damping: the fit eta(e) of 6-fit.json along the velocity, {} nodes over the rising branch, "
        "from v_c to {}",
        subject.damping.nodes.size(), readable(*subject.to_velocity, "m/s")));
    return subject;
}

}  // namespace ashimpact
