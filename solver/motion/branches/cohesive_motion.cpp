// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/branches/cohesive_motion.hpp"

#include <cmath>
#include <limits>

#include "solver/contact/transition.hpp"

namespace ashimpact {

namespace {

CohesiveState end_of(const CohesiveZone& zone, Detachment detachment) {
    switch (detachment) {
        case Detachment::zero_overlap:
            return zone.at_overlap(0);
        case Detachment::load_controlled:
            return zone.greatest_tension();
        case Detachment::zero_force:
            return zone.equilibrium();
        case Detachment::pull_off:
            break;
    }
    return zone.pull_off();
}

}  // namespace

CohesiveMotion::CohesiveMotion(const CohesiveZone& zone, const Polynomial<Extended>& damping,
                               Detachment detachment, Precision precision)
    : zone_(zone),
      touching_(zone, damping, precision),
      gap_(zone),
      begin_(zone.touch()),
      end_(end_of(zone, detachment)) {
    if (detachment != Detachment::zero_overlap) return;
    begin_ = end_;
    outside_ = zone.potential(begin_);
}

RestPlace<Extended> CohesiveMotion::rest() const {
    const CohesiveState equilibrium = zone_.equilibrium();
    return {touching_.coordinate(equilibrium), zone_.overlap(equilibrium), zone_.potential(equilibrium)};
}

std::optional<RestPlace<Extended>> CohesiveMotion::creeps_to(const MotionState<Extended>& state) const {
    const RestPlace<Extended> place = rest();
    if (state.position >= place.position) return std::nullopt;
    const Extended damping = touching_.damping(state.position);
    const Extended way = place.overlap - touching_.overlap(state.position);
    const Extended rounding = 64 * std::numeric_limits<Extended>::epsilon() * place.overlap;
    const bool arrived = std::abs(way) <= rounding && state.velocity <= damping * rounding;
    const bool creeps =
        state.velocity <= damping / 2 * way && zone_.stiffness(zone_.equilibrium()) <= damping * damping / 4;
    if (!arrived && !creeps) return std::nullopt;
    return place;
}

std::optional<std::string> cohesive_refusal(const CohesiveZone& zone, Detachment detachment) {
    const std::string subject =
        std::string(name_of(detachment)) + " does not end a contact of law maugis-dugdale";
    if (detachment == Detachment::zero_force) {
        return subject +
               ": its potential there is below that at first touch, an undamped impact would gain energy";
    }
    const bool gains =
        detachment == Detachment::load_controlled && zone.overlap(zone.greatest_tension()) > -zone.reach();
    if (!gains) return std::nullopt;
    return subject + " of so long a reach (lambda " + std::to_string(static_cast<double>(zone.lambda())) +
           "): the tension is greatest within the reach of the cohesion, an undamped impact would gain "
           "energy";
}

double maugis_velocity(const ContactPair& contact) {
    return std::sqrt(maugis_units(contact).energy() / contact.mass);
}

}  // namespace ashimpact
