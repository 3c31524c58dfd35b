// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/static_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

namespace {

void require_at_least(const char* quantity, double value, double least) {
    if (std::isfinite(value) && value >= least) return;
    throw InputError(std::string(quantity) + " is " + shortest(value) + " m",
                     shortest(least) + " m, where the contact breaks, or more");
}

}  // namespace

// Any unit of length would do, for the laws are homogeneous; with R* contact radius and overlap share it.
StaticCurve::StaticCurve(Law law, const ContactPair& contact) : law_(law), length_(contact.effective_radius) {
    require_positive("effective_radius", contact.effective_radius, Dimension::length);
    require_positive("contact_modulus", contact.contact_modulus, Dimension::pressure);
    require_not_negative("work_of_adhesion", contact.work_of_adhesion, Dimension::energy_per_area);
    require_parameters(law.parameters(), contact.parameters);
    if (can_yield(law, contact))
        throw InputError(
            "a contact of law '" + std::string(law.name()) + "' that can yield has no static curve",
            "an infinite yield_pressure");
    if (is_cohesive(law, contact)) {
        zone_ = CohesiveZone(transition_parameter(contact));
        units_ = maugis_units(contact);
        return;
    }
    if (law.has_cohesive_zone()) law_ = Law::without_attraction();  // there is no work of adhesion
    force_unit_ = hertz_stiffness(contact) * length_ * std::sqrt(length_);
    law_.visit<void>([&]<template <class> class L>() {
        if constexpr (has_polynomials<L>) {
            adhesion_ = L<double>::adhesion_number(contact, length_);
            least_root_ = *L<double>{adhesion_}.detachment_point(L<double>::default_detachment);
        }
    });
}

StaticCurve StaticCurve::normalised(Law law) {
    if (!law.parameters().empty())
        throw InputError("the units of Eq. 21 leave no number of the pair in a law, but law '" +
                             std::string(law.name()) + "' has parameters of its own",
                         "a law that has none");
    // A pair with K = 1 and pi w R* = 1, whose SI units are those of Eq. 21.
    const ContactPair unit{.mass = 1.0,
                           .effective_radius = 1.0,
                           .contact_modulus = 0.75,
                           .work_of_adhesion = 1.0 / std::numbers::pi};
    return {law, unit};
}

double StaticCurve::touch_overlap(Detachment detachment) const {
    if (!zone_ || detachment == Detachment::zero_overlap) return 0.0;
    return static_cast<double>(-zone_->reach()) * units_.overlap;
}

double StaticCurve::end_overlap(Detachment detachment) const {
    if (zone_) {
        if (detachment == Detachment::zero_overlap) return 0.0;
        const CohesiveState end =
            detachment == Detachment::load_controlled ? zone_->greatest_tension() : zone_->pull_off();
        return static_cast<double>(zone_->overlap(end)) * units_.overlap;
    }
    return law_.visit<double>([&]<template <class> class L>() {
        if constexpr (has_polynomials<L>) {
            const L<double> law{adhesion_};
            return law.overlap(*law.detachment_point(detachment)) * length_;
        }
        return 0.0;
    });
}

StaticPoint StaticCurve::point(double root) const {
    return law_.visit<StaticPoint>([&]<template <class> class L>() -> StaticPoint {
        if constexpr (has_polynomials<L>) {
            const L<double> numeric{adhesion_};
            const double attraction = attractive_force(numeric, root);
            return {.contact_radius = root * root * length_,
                    .overlap = numeric.overlap(root) * length_,
                    .repulsive_force = std::max(0.0, numeric.force(root) - attraction) * force_unit_,
                    .attractive_force = attraction * force_unit_};
        } else {
            return {};
        }
    });
}

/// Hertz repulsion a^3, and all else attraction.
StaticPoint StaticCurve::cohesive_point(const CohesiveState& state) const {
    const auto a = static_cast<double>(state.contact_radius());
    const double repulsion = a * a * a;
    return {.contact_radius = a * units_.radius,
            .overlap = static_cast<double>(zone_->overlap(state)) * units_.overlap,
            .repulsive_force = repulsion * units_.force,
            .attractive_force = (static_cast<double>(zone_->force(state)) - repulsion) * units_.force};
}

StaticPoint StaticCurve::at_contact_radius(double a) const {
    require_at_least("contact_radius", a, first().contact_radius);
    if (zone_) return cohesive_point(zone_->at_contact_radius(a / units_.radius));
    return point(std::sqrt(a / length_));
}

StaticPoint StaticCurve::at_overlap(double delta) const {
    require_at_least("overlap", delta, first().overlap);
    if (delta == first().overlap) return first();
    if (zone_) return cohesive_point(zone_->at_overlap(delta / units_.overlap));
    const auto excess = [&](double root) { return point(root).overlap - delta; };
    const double width = std::max(least_root_, std::sqrt(std::sqrt(std::abs(delta) / length_)));
    return point(root_beyond<double>(excess, least_root_, width));
}

std::vector<StaticPoint> StaticCurve::sampled(double delta, int count) const {
    if (count < 2) throw InputError("a curve has " + std::to_string(count) + " points", "at least 2");
    const double from = first().contact_radius;
    const double to = at_overlap(delta).contact_radius;
    std::vector<StaticPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(at_contact_radius(from + (to - from) * i / (count - 1)));
    return points;
}

}  // namespace ashimpact
