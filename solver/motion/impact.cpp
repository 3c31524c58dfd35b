// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/impact_result.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Refuses results outside the closure of the elastic-plastic law: numbers that are not finite, a ledger that
/// does not close, or, inside the closure's range, a flattened sphere that gains more by adhesion than the
/// work spent on it (docs/decisions/0003-plastic-closure.md).
void require_within_closure(const Impact& impact, const Scale& scale, const ImpactResult& result) {
    constexpr double least_ratio = 0.5;  // below it adhesion alone yields the contact at first touch
    const double ratio =
        ThorntonNing<double>::yield_number(impact.contact, scale.length) /
        std::pow(ThorntonNing<double>::adhesion_number(impact.contact, scale.length), 2.0 / 3.0);
    const EnergyLedger& energy = result.energy;
    const double size = std::max({energy.incident, std::abs(energy.minimum), std::abs(energy.at_touch)});
    const bool closed = std::isfinite(size) && std::abs(energy.residual) <= 1e-9 * size;
    const bool finite = std::isfinite(result.restitution) && std::isfinite(result.maximum_overlap) &&
                        std::isfinite(energy.plastic) && std::isfinite(energy.dissipated) &&
                        std::isfinite(result.contact_time.value_or(0.0)) &&
                        std::isfinite(result.approach_time.value_or(0.0));
    const bool spends = energy.plastic >= -1e-12 * size || ratio < least_ratio;
    if (closed && finite && spends) return;
    throw InputError(
        fmt::format(
            "yield_pressure is {:g} Pa: adhesion alone flattens this contact, outside the range of the "
            "plastic closure",
            impact.contact.yield_pressure),
        fmt::format("some multiple of {:g} Pa, at which adhesion alone yields the contact, or the law jkr",
                    least_ratio * impact.contact.yield_pressure / ratio));
}

/// refusal() of a law, found by its potentials.
std::optional<std::string> found_refusal(Law law, Detachment detachment) {
    return law.visit<std::optional<std::string>>(
        [&]<template <class> class L>() -> std::optional<std::string> {
            if constexpr (!has_polynomials<L>) {
                // Any zone of short reach; refusal() of a contact takes its own.
                static const CohesiveZone zone(2);
                return cohesive_refusal(zone, detachment);
            } else {
                const L<Extended> numeric{1.0_ext};  // whether it is admissible depends on no number
                const auto point = numeric.detachment_point(detachment);
                const std::string subject = std::string(name_of(detachment)) +
                                            " does not end a contact of law " + std::string(law.name());
                if (!point) return subject + ": the law has no such point";
                const Motion<Extended> motion =
                    make_motion<L, Extended>(numeric.adhesion, ScaledDamping<Extended>::none(), detachment);
                if (motion.potential(*motion.end) < motion.potential(motion.touch))
                    return subject +
                           ": its potential there is below that at first touch, an undamped impact would "
                           "gain energy";
                return std::nullopt;
            }
        });
}

}  // namespace

const std::optional<std::string>& refusal(Law law, Detachment detachment) {
    constexpr std::size_t ends = all_values<Detachment>.size();
    static const auto all = [] {
        std::array<std::optional<std::string>, Law::count() * ends> refusals;
        for (std::size_t i = 0; i < refusals.size(); ++i)
            refusals[i] = found_refusal(Law::at(i / ends), static_cast<Detachment>(i % ends));
        return refusals;
    }();
    return all[law.index() * ends + static_cast<std::size_t>(detachment)];
}

std::optional<std::string> refusal(Law law, const ContactPair& contact, Detachment detachment) {
    if (const auto& reason = refusal(law, detachment)) return reason;
    // Of a cohesive zone one end alone depends on the contact. A draw of an interval costs less than a zone.
    const bool depends = is_cohesive(law, contact) && detachment == Detachment::load_controlled;
    return depends ? cohesive_refusal(contact, detachment) : std::nullopt;
}

namespace {

template <class Refusal>
std::string not_refused(Refusal&& refusal) {
    std::vector<std::string> names;
    for (const Detachment detachment : all_values<Detachment>)
        if (!refusal(detachment)) names.emplace_back(name_of(detachment));
    return joined(names);
}

}  // namespace

std::string admissible_detachments(Law law) {
    return not_refused([&](Detachment detachment) { return refusal(law, detachment); });
}

void validate(const ContactPair& contact) {
    require_positive("mass", contact.mass, Dimension::mass);
    require_positive("effective_radius", contact.effective_radius, Dimension::length);
    require_positive("contact_modulus", contact.contact_modulus, Dimension::pressure);
    require_not_negative("work_of_adhesion", contact.work_of_adhesion, Dimension::energy_per_area);
    require_positive_or_infinite("yield_pressure", contact.yield_pressure, Dimension::pressure);
}

void validate(const Impact& impact) {
    validate(impact.contact);
    require_parameters(parameters_of(impact.law, impact.damping.law), impact.contact.parameters);
    require_positive("velocity", impact.velocity, Dimension::velocity);
    require_not_negative("damping", impact.damping.coefficient, dimension_of(impact.damping.law));
    if (const auto reason = refusal(impact.law, impact.contact, impact.detachment)) {
        throw InputError(*reason, not_refused([&](Detachment other) {
            return refusal(impact.law, impact.contact, other);
        }));
    }
}

FollowedImpact::FollowedImpact(const Impact& impact, Precision precision)
    : scaled_(scaled_impact<Extended>(impact, precision)), orbit_(follow(scaled_)) {}

ImpactResult FollowedImpact::result(const Impact& impact) const {
    const ImpactResult result = impact_result(orbit_, scaled_.velocity, scaled_.scale, impact.velocity);
    if (result.yielded) require_within_closure(impact, scaled_.scale, result);
    return result;
}

ImpactResult solve_impact(const Impact& impact, Precision precision) {
    validate(impact);
    return FollowedImpact(impact, precision).result(impact);
}

double restitution_of(const Impact& impact) {
    const double restitution = scaled_restitution<double>(impact);
    if (std::isfinite(restitution)) return restitution;
    return static_cast<double>(scaled_restitution<Extended>(impact));  // beyond the range of double
}

}  // namespace ashimpact
