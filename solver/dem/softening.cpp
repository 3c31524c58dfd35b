// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/dem/softening.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

/// Lengths along the surface in a dimension, as a power; none where a length may be one or not.
std::optional<int> surface_lengths(Dimension dimension) {
    switch (dimension) {
        case Dimension::pressure:         // force per area of contact
        case Dimension::energy_per_area:  // of the contact
            return -2;
        case Dimension::viscosity:  // damping per contact radius
            return -1;
        case Dimension::length:
        case Dimension::density:
            return std::nullopt;
        default:
            return 0;
    }
}

double softening_of(Dimension dimension, double factor) {
    return std::pow(stretch_of(factor), length_power(dimension).value());
}

}  // namespace

void require_softening(double factor) {
    if (!(factor > 1 && is_computable(factor)))
        throw InputError("is " + shortest(factor),
                         "a number above 1, by which E* is divided; 1000 makes contacts 16 times longer");
}

double stretch_of(double factor) {
    return std::pow(factor, 0.4);
}

std::optional<double> length_power(Dimension dimension) {
    const auto along_surface = surface_lengths(dimension);
    if (!along_surface) return std::nullopt;
    const auto powers = read_unit(si_unit(dimension)).value().powers;  // of m, kg, s
    return powers[0] + powers[2] - 0.5 * *along_surface;
}

double length_power(const LawParameter& parameter) {
    if (parameter.length_power) return *parameter.length_power;
    if (const auto power = length_power(parameter.dimension)) return *power;
    throw std::logic_error(std::string(parameter.name) + " states no length_power");
}

double softening_of(const LawParameter& parameter, double factor) {
    return std::pow(stretch_of(factor), length_power(parameter));
}

double softening_of(DampingLaw law, const ContactPair& stiff, double factor) {
    constexpr double velocity = 1;  // any: units of damping are powers of the scale
    return Scale::of(softened(stiff, factor), velocity).damping_unit(law) /
           Scale::of(stiff, velocity).damping_unit(law);
}

ContactPair softened(const ContactPair& stiff, double factor) {
    ContactPair soft = stiff;
    soft.contact_modulus /= factor;
    soft.work_of_adhesion *= softening_of(Dimension::energy_per_area, factor);
    soft.yield_pressure *= softening_of(Dimension::pressure, factor);
    for (const LawParameter& parameter : law_parameters())
        if (stiff.parameters.has(parameter))
            soft.parameters.set(parameter.name,
                                stiff.parameters[parameter] * softening_of(parameter, factor));
    return soft;
}

Damping softened(const Damping& damping, const ContactPair& stiff, double factor) {
    return {damping.law, damping.coefficient * softening_of(damping.law, stiff, factor)};
}

double greatest_softened_velocity(const ContactPair& contact) {
    // An undamped Hertz impact overlaps by (5/4)^(2/5) L.
    const double length = greatest_softened_overlap * contact.effective_radius / std::pow(1.25, 0.4);
    return Scale::of_length(contact, length).velocity;
}

}  // namespace ashimpact
