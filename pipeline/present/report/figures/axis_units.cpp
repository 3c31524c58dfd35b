// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/figures/axis_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ashimpact::report {

namespace {

struct Prefix {
    std::string_view name;
    double scale;
};

constexpr std::array prefixes{Prefix{"T", 1e12},  Prefix{"G", 1e9},   Prefix{"M", 1e6},  Prefix{"k", 1e3},
                              Prefix{"", 1},      Prefix{"m", 1e-3},  Prefix{"µ", 1e-6}, Prefix{"n", 1e-9},
                              Prefix{"p", 1e-12}, Prefix{"f", 1e-15}, Prefix{"a", 1e-18}};

constexpr std::array<std::string_view, 5> prefixed{"Pa", "m", "s", "N", "J"};

}  // namespace

ShownUnit shown_unit(std::string_view si, double greatest) {
    if (si == "1") return {"", 1};
    if (si == "kg/s")
        return greatest < 0.1 && greatest > 0
                   ? (greatest < 1e-4 ? ShownUnit{"mg/s", 1e-6} : ShownUnit{"g/s", 1e-3})
                   : ShownUnit{"kg/s", 1};
    if (!(greatest > 0) || std::find(prefixed.begin(), prefixed.end(), si) == prefixed.end())
        return {std::string(si), 1};
    for (const Prefix& prefix : prefixes)
        if (greatest >= prefix.scale) return {std::string(prefix.name) + std::string(si), prefix.scale};
    return {std::string(si), 1};
}

Axis quantity_axis(std::string label, std::string_view si, double greatest) {
    const ShownUnit unit = shown_unit(si, greatest);
    return {.label = std::move(label), .unit = unit.name, .scale = unit.scale};
}

Axis velocity_axis() {
    return {.label = "v_in", .unit = "m/s", .from_zero = true};
}

Axis restitution_axis() {
    return {.label = "e_n", .from_zero = true};
}

double greatest_of(const std::vector<double>& values) {
    double greatest = 0;
    for (const double value : values)
        if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    return greatest;
}

}  // namespace ashimpact::report
