// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/impact_case.hpp"

#include <array>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace ashimpact::oracles {

namespace {

constexpr std::array law_names{std::pair{Law::hertz, "hertz"}, std::pair{Law::dmt, "dmt"},
                               std::pair{Law::brach_dunn, "brach-dunn"}, std::pair{Law::jkr, "jkr"}};

constexpr std::array detachment_names{
    std::pair{Detachment::zero_overlap, "zero-overlap"}, std::pair{Detachment::zero_force, "zero-force"},
    std::pair{Detachment::pull_off, "pull-off"}, std::pair{Detachment::load_controlled, "load-controlled"}};

template <class Names, class Key>
std::string name_of(const Names& names, Key key) {
    for (const auto& [candidate, text] : names)
        if (candidate == key) return text;
    throw std::logic_error("no name for this value");
}

template <class Names>
auto key_of(const Names& names, const std::string& text) {
    for (const auto& [key, candidate] : names)
        if (text == candidate) return key;
    throw std::invalid_argument("unknown name " + text);
}

}  // namespace

std::string name(Law law) {
    return name_of(law_names, law);
}
std::string name(Detachment detachment) {
    return name_of(detachment_names, detachment);
}
Law law_from(const std::string& name) {
    return key_of(law_names, name);
}
Detachment detachment_from(const std::string& name) {
    return key_of(detachment_names, name);
}

double sphere_mass(double radius, double density) {
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
}

ImpactCase at_velocity(ImpactCase impact, double velocity) {
    impact.velocity = velocity;
    return impact;
}

}  // namespace ashimpact::oracles
