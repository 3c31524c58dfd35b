// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/readable.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace ashimpact {

namespace {

struct ReadingUnit {
    std::string_view si;
    std::string_view shown;
    double scale;  ///< of one shown unit [SI unit]
};

/// Largest first within each SI unit; a unit that is not here is shown as it is.
constexpr std::array<ReadingUnit, 36> reading_units{{
    {"Pa", "GPa", 1e9},  {"Pa", "MPa", 1e6},    {"Pa", "Pa", 1},       {"m", "m", 1},
    {"m", "mm", 1e-3},   {"m", "um", 1e-6},     {"m", "nm", 1e-9},     {"m", "pm", 1e-12},
    {"s", "s", 1},       {"s", "ms", 1e-3},     {"s", "us", 1e-6},     {"s", "ns", 1e-9},
    {"kg", "kg", 1},     {"kg", "g", 1e-3},     {"kg", "mg", 1e-6},    {"kg", "ug", 1e-9},
    {"kg", "ng", 1e-12}, {"kg", "pg", 1e-15},   {"J", "J", 1},         {"J", "mJ", 1e-3},
    {"J", "uJ", 1e-6},   {"J", "nJ", 1e-9},     {"J", "pJ", 1e-12},    {"J", "fJ", 1e-15},
    {"J", "aJ", 1e-18},  {"N", "N", 1},         {"N", "mN", 1e-3},     {"N", "uN", 1e-6},
    {"N", "nN", 1e-9},   {"m/s", "m/s", 1},     {"m/s", "mm/s", 1e-3}, {"m/s", "um/s", 1e-6},
    {"N s", "N s", 1},   {"N s", "uN s", 1e-6}, {"N s", "nN s", 1e-9}, {"N s", "pN s", 1e-12},
}};

/// The shown unit in which the number is at least 1 (a little less for velocities, which read well below it).
const ReadingUnit* unit_for(double value, std::string_view si) {
    const double least = si == "m/s" ? 1e-2 : 1.0;
    const ReadingUnit* chosen = nullptr;
    for (const ReadingUnit& unit : reading_units) {
        if (unit.si != si) continue;
        chosen = &unit;
        if (std::abs(value) >= least * unit.scale) break;
    }
    return chosen;
}

}  // namespace

std::string readable_number(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

std::string readable(double value, std::string_view unit) {
    if (unit == "1") return readable_number(value);
    const ReadingUnit* shown = value == 0 ? nullptr : unit_for(value, unit);
    if (shown == nullptr) return fmt::format("{} {}", readable_number(value), unit);
    return fmt::format("{} {}", readable_number(value / shown->scale), shown->shown);
}

std::string readable(const Quantity& quantity) {
    constexpr double least_share = 1e-4;
    if (!quantity.standard_uncertainty ||
        !(std::abs(*quantity.standard_uncertainty) > least_share * std::abs(quantity.value)))
        return readable(quantity.value, quantity.unit);
    const ReadingUnit* shown = quantity.value == 0 ? nullptr : unit_for(quantity.value, quantity.unit);
    const double scale = shown == nullptr ? 1 : shown->scale;
    const std::string unit = shown == nullptr ? quantity.unit : std::string(shown->shown);
    const double uncertainty = *quantity.standard_uncertainty / scale;
    // The decimal of the second digit of the uncertainty, as it will be rounded.
    const std::string rounded = fmt::format("{:.1e}", uncertainty);
    const int decimals = 1 - std::stoi(rounded.substr(rounded.find('e') + 1));
    constexpr int most_decimals = 6;
    if (decimals > most_decimals || decimals < -3)
        return fmt::format("{} +- {}{}", readable_number(quantity.value / scale),
                           readable_number(uncertainty, 2), unit == "1" ? "" : " " + unit);
    const double step = std::pow(10.0, std::max(-decimals, 0));  // of the last digit before the point
    const auto text = [&](double number) {
        return decimals > 0 ? fmt::format("{:.{}f}", number, decimals)
                            : fmt::format("{:.0f}", step * std::round(number / step));
    };
    return fmt::format("{} +- {}{}", text(quantity.value / scale), text(uncertainty),
                       unit == "1" ? "" : " " + unit);
}

std::string uncertainty_legend(std::string_view text) {
    return text.find("+-") == std::string_view::npos ? "" : "+-: standard uncertainty.\n";
}

}  // namespace ashimpact
