// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/subject.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"

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

}  // namespace

double SizedDamping::size_factor(double diameter) const {
    return exponent == 0 ? 1.0 : std::pow(diameter / reference_diameter, exponent);
}

double SizedDamping::coefficient(double diameter, double velocity) const {
    const double factor = size_factor(diameter);
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

}  // namespace ashimpact
