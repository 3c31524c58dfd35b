// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/subject.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "solver/dem/softening.hpp"

namespace ashimpact {

namespace {

const AshSize* known_size(const ExportSubject& subject, double diameter) {
    const auto found = std::ranges::find(subject.sizes, diameter, &AshSize::diameter);
    return found == subject.sizes.end() ? nullptr : &*found;
}

/// The contact of a sphere of that diameter and ash.
ContactPair contact_of(const ExportSubject& subject, double diameter, const AshBetween& ash) {
    ContactPair contact = ash.materials();
    contact.effective_radius = diameter / 2;
    contact.mass = sphere_mass(diameter / 2, ash.density());
    if (subject.partner) {
        contact.effective_radius = effective_radius(contact.effective_radius, subject.partner->radius);
        contact.mass = effective_mass(contact.mass, subject.partner->mass);
    }
    return contact;
}

CriticalVelocity threshold_of(const ExportSubject& subject, double diameter, const AshBetween& ash,
                              const ContactPair& contact) {
    CriticalVelocity critical = critical_velocity({.law = subject.law,
                                                   .detachment = subject.detachment,
                                                   .damping = {subject.damping_law, ash.damping(0)},
                                                   .contact = contact});
    if (critical.crossings.size() > 1) refuse_several(diameter);
    return critical;
}

}  // namespace

void refuse_several(double diameter) {
    throw InputError(
        fmt::format("capture and rebound of {} change places more than once", readable(diameter, "m")),
        "a subject with one critical velocity a size");
}

bool ExportSubject::depends_on_velocity() const {
    return std::ranges::any_of(sizes, [](const AshSize& size) { return size.damping.depends_on_velocity(); });
}

bool ExportSubject::is_undamped() const {
    return std::ranges::all_of(sizes, [](const AshSize& size) { return size.damping.is_zero(); });
}

ExportSubject softened(ExportSubject subject, double factor) {
    at_place("--soften", [&] { require_softening(factor); });
    subject.stiff = StiffContact{factor, subject.sizes};
    for (AshSize& size : subject.sizes) {
        const double damping = softening_of(subject.damping_law, size.contact, factor);
        for (DampingNode& node : size.damping.nodes) node.coefficient *= damping;
        size.contact = softened(size.contact, factor);
    }
    return subject;
}

ExportSubject stiffened(ExportSubject subject) {
    if (!subject.stiff) return subject;
    subject.sizes = subject.stiff->sizes;
    subject.stiff.reset();
    return subject;
}

ExportSubject with_damping_at(ExportSubject subject, double velocity) {
    std::vector<AshSize> sizes = subject.sizes;
    for (AshSize& size : sizes)
        size.damping.nodes = {{0, impact_at(subject, size.diameter, velocity).damping.coefficient}};
    subject.sizes = sizes;
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

AshBetween ash_at(const ExportSubject& subject, double diameter, std::size_t piece) {
    return ash_between(subject.sizes, subject.exponent, diameter, piece);
}

AshBetween ash_at(const ExportSubject& subject, double diameter) {
    return ash_at(subject, diameter, piece_of(subject.sizes, diameter));
}

double particle_mass(const ExportSubject& subject, double diameter) {
    const AshSize* known = known_size(subject, diameter);
    if (known != nullptr && !subject.partner) return known->contact.mass;
    return sphere_mass(diameter / 2, ash_at(subject, diameter).density());
}

ContactPair contact_at(const ExportSubject& subject, double diameter) {
    if (const AshSize* known = known_size(subject, diameter)) return known->contact;
    return contact_of(subject, diameter, ash_at(subject, diameter));
}

Impact impact_above(const ExportSubject& subject, double diameter, double velocity, double critical) {
    const double t = subject.depends_on_velocity() ? place_above(velocity, critical) : 0;
    return {.law = subject.law,
            .detachment = subject.detachment,
            .damping = {subject.damping_law, ash_at(subject, diameter).damping(t)},
            .contact = contact_at(subject, diameter),
            .velocity = velocity};
}

Impact impact_at(const ExportSubject& subject, double diameter, double velocity) {
    if (!subject.depends_on_velocity()) return impact_above(subject, diameter, velocity, velocity);
    const auto critical = threshold_at(subject, diameter).value;
    if (!critical)
        throw InputError(fmt::format("spheres of {} have no finite critical velocity above which the damping "
                                     "could follow the measured one",
                                     readable(diameter, "m")),
                         "sizes that have one; --at for one damping at every velocity");
    return impact_above(subject, diameter, velocity, *critical);
}

CriticalVelocity threshold_at(const ExportSubject& subject, double diameter) {
    return threshold_of(subject, diameter, ash_at(subject, diameter), contact_at(subject, diameter));
}

CriticalVelocity threshold_at(const ExportSubject& subject, double diameter, std::size_t piece) {
    const AshBetween ash = ash_at(subject, diameter, piece);
    return threshold_of(subject, diameter, ash, contact_of(subject, diameter, ash));
}

}  // namespace ashimpact
