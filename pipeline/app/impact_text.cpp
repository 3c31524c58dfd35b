// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/impact_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/view.hpp"
#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/table.hpp"

namespace ashimpact {

namespace {

Json energy_json(const EnergyLedger& energy) {
    const auto joule = [](double value) { return quantity_json(value, Dimension::energy); };
    return {{"incident", joule(energy.incident)},     {"at_touch", joule(energy.at_touch)},
            {"remaining", joule(energy.remaining)},   {"potential", joule(energy.potential)},
            {"dissipated", joule(energy.dissipated)}, {"plastic", joule(energy.plastic)},
            {"jumps", joule(energy.jumps)},           {"residual", joule(energy.residual)},
            {"minimum", joule(energy.minimum)}};
}

/// A unit in which an energy shows four digits.
struct EnergyUnit {
    std::string name;
    int decimals;
    double step;  ///< the last digit [J]
};

EnergyUnit unit_for(double energy) {
    constexpr std::array prefixes{"a", "f", "p", "n", "u", "m", "", "k", "M"};
    const int power = energy > 0 ? static_cast<int>(std::floor(std::log10(energy))) : 0;
    const int prefix = std::clamp((power + 18) / 3, 0, static_cast<int>(prefixes.size()) - 1);
    const int unit_power = 3 * prefix - 18;
    const int decimals = std::clamp(3 - (power - unit_power), 0, 9);
    return {std::string(prefixes.at(static_cast<std::size_t>(prefix))) + "J", decimals,
            std::pow(10.0, unit_power - decimals)};
}

/// The energy before an impact and the terms after it, without those of zero. The greatest term after takes
/// what rounding leaves, so that the printed terms add up.
void add_energy(TextList& list, const EnergyLedger& energy) {
    const EnergyUnit unit = unit_for(energy.incident);
    const auto steps = [&](double joule) { return std::llround(joule / unit.step); };
    const auto add = [&](const char* name, long long count) {
        list.add(name, fmt::format("{:.{}f} {}", static_cast<double>(count) / std::pow(10.0, unit.decimals),
                                   unit.decimals, unit.name));
    };
    std::array after{std::pair{"  dissipated", steps(energy.dissipated)},
                     std::pair{"  spent in yielding", steps(energy.plastic)},
                     std::pair{"  lost in jumps", steps(energy.jumps)},
                     std::pair{"  left in motion", steps(energy.remaining)},
                     std::pair{"  left in the contact", steps(energy.potential)}};
    long long rounding = steps(energy.incident) + steps(energy.at_touch);
    for (const auto& term : after) rounding -= term.second;
    std::max_element(after.begin(), after.end(), [](const auto& x, const auto& y) {
        return x.second < y.second;
    })->second += rounding;
    add("incident energy", steps(energy.incident));
    if (steps(energy.at_touch) != 0) add("  at first touch", steps(energy.at_touch));
    for (const auto& [name, count] : after)
        if (count != 0) add(name, count);
}

std::string_view adhesion_words(AdhesionRegime regime) {
    switch (regime) {
        case AdhesionRegime::dmt:
            return "hard contact, the limit of DMT";
        case AdhesionRegime::jkr:
            return "soft contact, the limit of JKR";
        case AdhesionRegime::between:
            return "between the limits of DMT and JKR";
        case AdhesionRegime::none:
            break;
    }
    return "no work of adhesion";
}

}  // namespace

Json impact_json(const Impact& impact, const ImpactResult& result) {
    return {{"law", impact.law.name()},
            {"detachment", name_of(impact.detachment)},
            {"damping_law", name_of(impact.damping.law)},
            {"damping", quantity_json(impact.damping.coefficient, unit_of(impact.damping.law))},
            {"outcome", name_of(result.outcome)},
            {"restitution", quantity_json(result.restitution, Dimension::fraction)},
            {"contact_time", quantity_json(result.contact_time, Dimension::time)},
            {"approach_time", quantity_json(result.approach_time, Dimension::time)},
            {"maximum_overlap", quantity_json(result.maximum_overlap, Dimension::length)},
            {"rebound_velocity", quantity_json(result.rebound_velocity, Dimension::velocity)},
            {"energy", energy_json(result.energy)},
            {"regime", regime_json(regime_of(impact, result.maximum_overlap))}};
}

std::string regime_text(const Regime& regime) {
    const auto velocity = [](const std::optional<double>& value) {
        return value ? readable(*value, "m/s") : std::string("no yield pressure given");
    };
    TextList list;
    list.add("damping number", fmt::format("beta = {}", readable_number(regime.damping_number)));
    list.add("Tabor parameter", regime.tabor_parameter > 0
                                    ? fmt::format("{} ({})", readable_number(regime.tabor_parameter),
                                                  adhesion_words(regime.adhesion))
                                    : "none: no work of adhesion");
    list.add(
        "greatest pressure",
        regime.yield_pressure
            ? fmt::format("{}, {} times the yield pressure of {}", readable(regime.greatest_pressure, "Pa"),
                          readable_number(regime.greatest_pressure / *regime.yield_pressure),
                          readable(*regime.yield_pressure, "Pa"))
            : readable(regime.greatest_pressure, "Pa"));
    list.add("yield velocity", velocity(regime.yield_velocity));
    list.add("contact radius", fmt::format("at most {}, {} of R*", readable(regime.contact_radius, "m"),
                                           readable_number(regime.relative_contact_radius)));
    return list.text(0);
}

void warn_of_regime(const Regime& regime) {
    for (const Finding& warning : regime.warnings) spdlog::warn("warning: {}", warning.text);
}

std::string impact_text(const Impact& impact, const ImpactResult& result) {
    const auto time = [](const std::optional<double>& value, const char* none) {
        return value ? readable(*value, "s") : std::string(none);
    };
    TextList list;
    list.add("law", fmt::format("{}, contact ends at {}", impact.law.name(), name_of(impact.detachment)));
    list.add("damping",
             fmt::format("{} ({})", readable(impact.damping.coefficient, unit_of(impact.damping.law)),
                         name_of(impact.damping.law)));
    list.add("velocity", readable(impact.velocity, "m/s"));
    list.add("outcome", std::string(name_of(result.outcome)));
    list.add("restitution", readable_number(result.restitution));
    list.add("rebound velocity", readable(result.rebound_velocity, "m/s"));
    list.add("contact time", time(result.contact_time, "none: the particle stays"));
    list.add("approach time", time(result.approach_time, "none: the approach never turns"));
    list.add("maximum overlap", readable(result.maximum_overlap, "m"));
    add_energy(list, result.energy);
    return list.text(0) + regime_text(regime_of(impact, result.maximum_overlap));
}

}  // namespace ashimpact
