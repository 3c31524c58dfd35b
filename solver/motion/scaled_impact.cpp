// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/scaled_impact.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "solver/contact/mechanics.hpp"

namespace ashimpact {

namespace {

/// The zone of a transition parameter; the last one of each thread is kept, since searches use it again.
const CohesiveZone& zone_of(double lambda) {
    thread_local CohesiveZone last(1);
    if (last.lambda() != static_cast<Extended>(lambda)) last = CohesiveZone(lambda);
    return last;
}

}  // namespace

std::optional<std::string> cohesive_refusal(const ContactPair& contact, Detachment detachment) {
    return cohesive_refusal(zone_of(transition_parameter(contact)), detachment);
}

CohesiveMotion scaled_cohesive_motion(const Impact& impact, Precision precision) {
    const Scale scale = Scale::of(impact.contact, maugis_velocity(impact.contact));
    return {zone_of(transition_parameter(impact.contact)), scaled_damping<Extended>(impact, scale),
            impact.detachment, precision};
}

template <class Real>
ScaledImpact<Real> scaled_impact(const Impact& impact, Precision precision) {
    if (is_cohesive(impact.law, impact.contact)) {
        const double unit = maugis_velocity(impact.contact);
        return {Scale::of(impact.contact, unit),
                static_cast<Extended>(impact.velocity) / static_cast<Extended>(unit),
                scaled_cohesive_motion(impact, precision)};
    }
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    if (!can_yield(impact.law, impact.contact)) return {scale, 1, scaled_motion<Real>(impact, scale)};
    using Plastic = ThorntonNing<double>;
    const YieldedContact<Real> contact{Real(Plastic::adhesion_number(impact.contact, scale.length)),
                                       Real(Plastic::yield_number(impact.contact, scale.length))};
    return {scale, 1, PlasticMotion<Real>(contact, scaled_damping<Real>(impact, scale), impact.detachment)};
}

template <class Real>
Real scaled_restitution(const Impact& impact) {
    constexpr auto precision = std::is_same_v<Real, double> ? Precision::standard : Precision::extended;
    const auto scaled = scaled_impact<Real>(impact, precision);
    return std::visit(
        [&]<class Branches>(const Branches& branches) {
            const auto velocity = static_cast<typename Branches::Number>(scaled.velocity);
            return static_cast<Real>(follow(branches, velocity).restitution(velocity));
        },
        scaled.branches);
}

double undamped_restitution(Impact impact) {
    impact.damping.coefficient = 0.0;
    if (can_yield(impact.law, impact.contact) || is_damped(impact.damping, impact.contact.parameters))
        return static_cast<double>(scaled_restitution<Extended>(impact));
    const auto scaled = scaled_impact<Extended>(impact, Precision::standard);
    const Extended cost = std::visit(
        []<class Branches>(const Branches& branches) -> Extended {
            if constexpr (std::is_same_v<Branches, CohesiveMotion>)
                return branches.potential_at_end() - branches.potential_at_begin();
            else if constexpr (std::is_same_v<Branches, Motion<Extended>>)
                return branches.potential(*branches.end) - branches.potential(branches.touch);
            else
                return 0;
        },
        scaled.branches);
    return static_cast<double>(
        std::sqrt(std::clamp(1 - 2 * cost / (scaled.velocity * scaled.velocity), 0.0_ext, 1.0_ext)));
}

template ScaledImpact<double> scaled_impact(const Impact&, Precision);
template ScaledImpact<long double> scaled_impact(const Impact&, Precision);
template double scaled_restitution(const Impact&);
template long double scaled_restitution(const Impact&);

}  // namespace ashimpact
