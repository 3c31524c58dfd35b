// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/sized_damping.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

double SizedDamping::size_factor(double diameter) const {
    return exponent == 0 ? 1.0 : std::pow(diameter / reference_diameter, exponent);
}

double SizedDamping::coefficient(double diameter, double velocity) const {
    const double factor = size_factor(diameter);
    const auto above = std::ranges::lower_bound(nodes, velocity, {}, &DampingNode::velocity);
    if (above == nodes.begin()) return factor * nodes.front().coefficient;
    if (above == nodes.end()) return factor * nodes.back().coefficient;
    const DampingNode& below = *std::prev(above);
    const double share = (velocity - below.velocity) / (above->velocity - below.velocity);
    return factor * (below.coefficient + share * (above->coefficient - below.coefficient));
}

bool SizedDamping::is_zero() const {
    return std::ranges::all_of(nodes, [](const DampingNode& node) { return node.coefficient == 0; });
}

}  // namespace ashimpact
