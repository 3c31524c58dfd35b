#include "solver/regime.hpp"

#include "materials/separation_energy.hpp"
#include "solver/scale.hpp"
#include "solver/velocity_scales.hpp"

#include <cmath>
#include <sstream>

namespace ashimpact {

namespace {

constexpr double widest_contact = 0.3;  ///< a/R* beyond which the parabolic geometry of every law here is off

/// yield_number/adhesion^(2/3) below which adhesion alone yields the contact at first touch.
constexpr double yields_at_touch = 0.5;

std::string text(double value) {
    std::ostringstream stream;
    stream.precision(3);
    stream << value;
    return stream.str();
}

void warn_of_tabor(Law law, Regime& regime) {
    const double mu = regime.tabor_parameter;
    const bool hard_law = law == Law::of<Dmt>();
    const bool soft_law = law == Law::of<Jkr>() || law == Law::of<ThorntonNing>();
    if (hard_law && mu > jkr_limit) {
        regime.warnings.emplace_back("Tabor parameter " + text(mu) +
                                     " > 5: soft contact, JKR applies rather than DMT");
    }
    if (soft_law && mu > 0.0 && mu < dmt_limit) {
        regime.warnings.emplace_back("Tabor parameter " + text(mu) +
                                     " < 0.1: hard contact, DMT applies rather than JKR");
    }
}

void warn_of_yield_by_adhesion(const Impact& impact, double length, Regime& regime) {
    if (impact.law != Law::of<ThorntonNing>() || !(regime.adhesion_number > 0.0)) return;
    const double ratio = ThorntonNing<double>::yield_number(impact.contact, length) /
                         std::pow(regime.adhesion_number, 2.0 / 3.0);
    if (ratio < yields_at_touch) {
        regime.warnings.emplace_back(
            "adhesion alone yields the contact at first touch: outside the range of the plastic closure");
    }
}

}  // namespace

Regime regime_of(const Impact& impact, double maximum_overlap) {
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const ContactPair& contact = impact.contact;
    Regime regime{};
    regime.tabor_parameter = tabor_parameter({.work_of_adhesion = contact.work_of_adhesion,
                                              .effective_radius = contact.effective_radius,
                                              .contact_modulus = contact.contact_modulus},
                                             equilibrium_separation);
    regime.damping_number = scale.damping_number(impact.damping);
    regime.adhesion_number = impact.law.visit<double>(
        [&]<template <class> class L>() { return L<double>::adhesion_number(contact, scale.length); });
    regime.yield_velocity = yield_velocity(contact);
    warn_of_yield_by_adhesion(impact, scale.length, regime);
    regime.relative_contact_radius = std::sqrt(std::max(0.0, maximum_overlap) / contact.effective_radius);

    warn_of_tabor(impact.law, regime);
    if (impact.velocity > regime.yield_velocity && impact.law != Law::of<ThorntonNing>()) {
        regime.warnings.emplace_back("velocity " + text(impact.velocity) +
                                     " m/s is above the yield velocity " + text(regime.yield_velocity) +
                                     " m/s: the contact yields, law thornton-ning applies");
    }
    if (maximum_overlap > contact.effective_radius) {
        regime.warnings.emplace_back("overlap exceeds the radius: outside the theory");
    } else if (regime.relative_contact_radius > widest_contact) {
        regime.warnings.emplace_back("contact radius is " + text(regime.relative_contact_radius) +
                                     " of the radius: contact laws assume it small");
    }
    return regime;
}

}  // namespace ashimpact
