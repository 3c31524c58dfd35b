// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/regime.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "materials/contact_properties.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

namespace {

/// yield_number/adhesion^(2/3) below which adhesion alone yields the contact at first touch.
constexpr double yields_at_touch = 0.5;

AdhesionRegime adhesion_regime(double tabor_parameter) {
    if (!(tabor_parameter > 0.0)) return AdhesionRegime::none;
    if (tabor_parameter < dmt_limit) return AdhesionRegime::dmt;
    return tabor_parameter > jkr_limit ? AdhesionRegime::jkr : AdhesionRegime::between;
}

/// Laws with JKR's pressure in the contact, adhesion included, by which they yield.
bool is_jkr(Law law) {
    return law.limit() == AdhesionRegime::jkr;
}

/// The static law of an impact, in its scale; that of Hertz where a cohesive zone has one of its own.
Motion<double> static_law(Impact impact, const Scale& scale) {
    impact.damping = {};
    return scaled_motion<double>(impact, scale);
}

/// State u = sqrt(contact radius) of greatest overlap, at or beyond first touch.
double greatest_root(const Motion<double>& motion, double overlap) {
    const double touch = motion.root_radius(motion.touch);
    const auto excess = [&](double root) { return motion.overlap(motion.coordinate(root)) - overlap; };
    const double width = std::max(touch, std::sqrt(std::sqrt(std::max(0.0, overlap))));
    if (width == 0.0 || excess(touch) >= 0.0) return touch;
    return root_beyond<double>(excess, touch, width);
}

/// Whether the pair says how far its cohesion reaches.
bool states_cohesion(const ContactPair& contact) {
    const ParameterValues<double>& given = contact.parameters;
    return given.has(stated_tabor) || given.has(cohesive_stress) || given.has(cohesion_range);
}

AdhesiveContact numbers_of(const ContactPair& contact) {
    return {.work_of_adhesion = contact.work_of_adhesion,
            .effective_radius = contact.effective_radius,
            .contact_modulus = contact.contact_modulus};
}

/// Equilibrium separation z0 that the pair says, else the usual one [m]; mu goes with 1/z0.
double separation_of(const ContactPair& contact) {
    if (contact.parameters.has(cohesion_range)) return contact.parameters[cohesion_range];
    if (!states_cohesion(contact) || contact.work_of_adhesion == 0.0) return usual_separation;
    const double tabor = transition_parameter_of(contact) / transition_per_tabor();
    return usual_separation * tabor_parameter(numbers_of(contact), usual_separation) / tabor;
}

/// Judges one impact.
class Judge {
  public:
    Judge(const Impact& impact, double maximum_overlap)
        : impact_(impact),
          contact_(impact.contact),
          scale_(Scale::of(impact.contact, impact.velocity)),
          motion_(static_law(impact, scale_)),
          greatest_(greatest_root(motion_, maximum_overlap / scale_.length)) {
        if (is_cohesive(impact.law, contact_)) greatest_ = cohesive_root(maximum_overlap);
        regime_.tabor_parameter = tabor_parameter_of(contact_);
        regime_.equilibrium_separation = separation_of(contact_);
        regime_.adhesion = adhesion_regime(regime_.tabor_parameter);
        regime_.damping_number = scale_.damping_number(impact.damping);
        regime_.adhesion_number = impact.law.visit<double>(
            [&]<template <class> class L>() { return L<double>::adhesion_number(contact_, scale_.length); });
        regime_.contact_radius = greatest_ * greatest_ * scale_.radius_length;
        regime_.relative_contact_radius = regime_.contact_radius / contact_.effective_radius;
        regime_.relative_overlap = maximum_overlap / contact_.effective_radius;
        regime_.transition_parameter = transition_parameter_of(contact_);
        if (std::isfinite(contact_.yield_pressure)) {
            regime_.yield_pressure = contact_.yield_pressure;
            judge_yield();
        }
        regime_.greatest_pressure = greatest_pressure();
    }

    [[nodiscard]] Regime judged() {
        warn_of_tabor();
        warn_of_left_out_adhesion();
        warn_of_yield();
        warn_of_geometry();
        return regime_;
    }

  private:
    /// State u = sqrt(contact radius) of a cohesive zone at greatest overlap.
    [[nodiscard]] double cohesive_root(double maximum_overlap) const {
        const MaugisUnits units = maugis_units(contact_);
        const CohesiveZone zone(transition_parameter(contact_));
        const CohesiveState state = zone.at_overlap(maximum_overlap / units.overlap);
        const auto radius = static_cast<double>(state.contact_radius()) * units.radius;
        return std::sqrt(radius / scale_.radius_length);
    }

    [[nodiscard]] double greatest_pressure() const {
        if (impact_.law.is_plastic() && regime_.yields) return contact_.yield_pressure;
        return impact_.law.pressure(contact_, regime_.contact_radius).central();
    }

    /// As judge_yield() for a cohesive zone, whose own pressure in the centre decides.
    void judge_cohesive_yield() {
        const MaugisUnits units = maugis_units(contact_);
        const double lambda = transition_parameter(contact_);
        const CohesiveZone zone(lambda);
        const auto margin = [&](double a) {
            return maugis_dugdale_pressure(contact_, lambda, a).central() - contact_.yield_pressure;
        };
        // Hertz reaches p_y at this radius; the cohesion only delays it.
        const double hertz = std::numbers::pi * contact_.effective_radius * contact_.yield_pressure /
                             (2.0 * contact_.contact_modulus);
        const double a = root_beyond<double>(margin, hertz, hertz);
        const CohesiveState at_yield = zone.at_contact_radius(a / units.radius);
        const CohesiveState begin =
            impact_.detachment == Detachment::zero_overlap ? zone.at_overlap(0) : zone.touch();
        const auto energy = static_cast<double>(zone.potential(at_yield) - zone.potential(begin));
        const bool at_touch = zone.overlap(at_yield) <= zone.overlap(begin);
        regime_.yield_velocity = ashimpact::yield_velocity(contact_);
        regime_.law_yield_velocity =
            at_touch ? 0.0 : std::sqrt(2.0 * std::max(0.0, energy) * units.energy() / contact_.mass);
        regime_.yields = regime_.contact_radius > a;
    }

    void judge_yield() {
        if (is_cohesive(impact_.law, contact_)) return judge_cohesive_yield();
        // An even tension adds to the Hertz pressure that the centre bears before it yields.
        const double tension = impact_.law.pressure(contact_, 0.0).even_tension;
        const double yield_number = ThorntonNing<double>::yield_number(contact_, scale_.length) *
                                    (1.0 + tension / contact_.yield_pressure);
        const double adhesion = is_jkr(impact_.law) ? regime_.adhesion_number : 0.0;
        const double at_yield = YieldedContact<double>{adhesion, yield_number}.yield_point();
        const double energy =
            motion_.potential(motion_.coordinate(at_yield)) - motion_.potential(motion_.touch);
        const bool at_touch = at_yield <= motion_.root_radius(motion_.touch);
        regime_.yield_velocity = ashimpact::yield_velocity(contact_);
        regime_.law_yield_velocity =
            at_touch ? 0.0 : std::sqrt(2.0 * std::max(0.0, energy)) * scale_.velocity;
        regime_.yields = greatest_ > at_yield;
        const double ratio = yield_number / std::pow(regime_.adhesion_number, 2.0 / 3.0);
        beyond_closure_ = impact_.law.is_plastic() && ratio < yields_at_touch;
    }

    void warn(const std::string& warning, Severity severity = Severity::remark) {
        regime_.warnings.push_back({regime_code, severity, warning});
    }

    void warn_of_tabor() {
        const bool hard_law = impact_.law.limit() == AdhesionRegime::dmt;
        const bool soft_law = is_jkr(impact_.law);
        if (!hard_law && !soft_law) return;
        const auto warn_of_mu = [&](const std::string& range) {
            warn(fmt::format("Tabor parameter {:.3g} {}", regime_.tabor_parameter, range),
                 Severity::background);
        };
        if (regime_.adhesion == AdhesionRegime::between)
            warn_of_mu(
                fmt::format("is between DMT (< 0.1) and JKR (> 5) (Johnson & Greenwood 1997): neither "
                            "limit holds for law {}",
                            impact_.law.name()));
        if (hard_law && regime_.adhesion == AdhesionRegime::jkr)
            warn_of_mu("> 5: soft contact, JKR applies rather than DMT (Johnson & Greenwood 1997)");
        if (soft_law && regime_.adhesion == AdhesionRegime::dmt)
            warn_of_mu("< 0.1: hard contact, DMT applies rather than JKR (Johnson & Greenwood 1997)");
    }

    void warn_of_left_out_adhesion() {
        if (impact_.law.is_adhesive() || !(contact_.work_of_adhesion > 0.0)) return;
        const double attraction =
            2.0 * std::numbers::pi * contact_.work_of_adhesion * contact_.effective_radius;
        const double repulsion = motion_.force(motion_.coordinate(greatest_)) * scale_.force();
        warn(fmt::format("law hertz leaves out the adhesion of {:.3g} J/m2: 2 pi w R* is {:.3g} % of the "
                         "greatest force",
                         contact_.work_of_adhesion, 100.0 * attraction / repulsion),
             Severity::background);
    }

    void warn_of_yield() {
        if (beyond_closure_)
            warn(
                "adhesion alone yields the contact at first touch: outside the range of the plastic closure");
        if (const auto finding = yield_finding(impact_, regime_)) regime_.warnings.push_back(*finding);
    }

    void warn_of_geometry() {
        if (regime_.relative_overlap > 1.0) {
            warn("overlap exceeds the radius: outside the theory");
        } else if (const auto finding = wide_contact_finding(regime_.relative_contact_radius)) {
            regime_.warnings.push_back(*finding);
        }
    }

    const Impact& impact_;
    const ContactPair& contact_;
    Scale scale_;
    Motion<double> motion_;
    double greatest_;  ///< state u of greatest overlap
    bool beyond_closure_ = false;
    Regime regime_;
};

}  // namespace

std::optional<Finding> wide_contact_finding(double relative_radius) {
    if (!(relative_radius > widest_contact)) return std::nullopt;
    return Finding{
        regime_code, Severity::remark,
        fmt::format("contact radius is {:.3g} of the radius: contact laws assume it small", relative_radius)};
}

double transition_parameter_of(const ContactPair& contact) {
    if (contact.work_of_adhesion == 0.0) return 0.0;
    if (states_cohesion(contact)) return transition_parameter(contact);
    return transition_parameter(contact,
                                cohesive_stress_of_range(contact.work_of_adhesion, usual_separation));
}

double tabor_parameter_of(const ContactPair& contact) {
    if (contact.work_of_adhesion == 0.0) return 0.0;
    const bool by_range = !states_cohesion(contact) || contact.parameters.has(cohesion_range);
    if (by_range) return tabor_parameter(numbers_of(contact), separation_of(contact));
    return transition_parameter_of(contact) / transition_per_tabor();
}

std::optional<Finding> yield_finding(const Impact& impact, const Regime& regime) {
    if (!regime.yields || impact.law.is_plastic()) return std::nullopt;
    return Finding{regime_code, Severity::remark,
                   fmt::format("the contact yields: velocity {:.3g} m/s, yield velocity {:.3g} m/s (adhesion "
                               "included, without damping); law thornton-ning applies",
                               impact.velocity, *regime.law_yield_velocity)};
}

Regime regime_of(const Impact& impact, double maximum_overlap) {
    return Judge(impact, maximum_overlap).judged();
}

double velocity_of_damping(const Damping& damping, const ContactPair& contact) {
    const auto numbers = Scale::of(contact, 1.0).damping_numbers(damping, contact.parameters);
    return RegisteredDampings::visit<double>(damping.law, [&]<class D>() {
        double velocity = 0.0;
        for (std::size_t k = 0; k < terms_of<D>; ++k)
            if (touch_shapes<D>()[k] != 0.0) velocity = std::max(velocity, std::pow(numbers[k], 5));
        return velocity;
    });
}

double velocity_of_adhesion(Law law, const ContactPair& contact) {
    return law.visit<double>([&]<template <class> class L>() {
        // The adhesion number falls with a power of length.
        const double at_one = L<double>::adhesion_number(contact, 1.0);
        if (at_one == 0.0) return 0.0;
        const double exponent = std::log2(L<double>::adhesion_number(contact, 0.5) / at_one);
        const double length = std::pow(at_one, 1.0 / exponent);
        return std::sqrt(hertz_stiffness(contact) * length * length * std::sqrt(length) / contact.mass);
    });
}

double yield_velocity(const ContactPair& contact) {
    const double contact_radius = std::numbers::pi * contact.effective_radius * contact.yield_pressure /
                                  (2.0 * contact.contact_modulus);
    const double overlap = contact_radius * contact_radius / contact.effective_radius;
    const double energy = 0.4 * hertz_stiffness(contact) * overlap * overlap * std::sqrt(overlap);
    return std::sqrt(2.0 * energy / contact.mass);
}

}  // namespace ashimpact
