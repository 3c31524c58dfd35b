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

namespace {

struct GridPoint {
    Law law;
    double radius;            // [m]
    double density;           // [kg/m3]
    double contact_modulus;   // [Pa]
    double work_of_adhesion;  // [J/m2]
    double damping;           // [kg/s]
    double velocity;          // [m/s]
};

constexpr GridPoint rows[] = {
    {Law::hertz, 4.4e-05, 2600, 9e+10, 0, 0, 2},         {Law::hertz, 4.4e-05, 2600, 9e+10, 0, 0.00538, 2},
    {Law::hertz, 4.4e-05, 2600, 9e+10, 0, 0.0161, 2},    {Law::hertz, 4.4e-05, 2600, 9e+10, 0, 0.00613, 0.3},
    {Law::hertz, 4.8e-05, 2300, 7.5e+10, 0, 0.0178, 10}, {Law::hertz, 5.2e-05, 2200, 1e+11, 0, 0.00374, 20},
    {Law::hertz, 5e-06, 1000, 1e+09, 0, 5.9e-06, 0.3},   {Law::hertz, 5e-06, 2650, 7e+10, 0, 0.000216, 5},
    {Law::hertz, 1e-05, 8000, 2e+11, 0, 0.000793, 20},   {Law::hertz, 0.0001, 8000, 2e+11, 0, 0.154, 0.3},
    {Law::hertz, 0.0001, 8000, 2e+11, 0, 0.238, 20},     {Law::hertz, 0.0001, 1000, 1e+09, 0, 0.00375, 1},
    {Law::hertz, 2e-05, 4000, 2e+10, 0, 0, 3},           {Law::hertz, 2e-05, 4000, 2e+10, 0, 0.00228, 3},
    {Law::dmt, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {Law::dmt, 4.4e-05, 2600, 9e+10, 0.05, 0.00533, 2},
    {Law::dmt, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {Law::dmt, 4.4e-05, 2600, 9e+10, 0.3, 0.00496, 0.3},
    {Law::dmt, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {Law::dmt, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {Law::dmt, 5e-06, 1000, 1e+09, 0.02, 8.39e-06, 3},   {Law::dmt, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {Law::dmt, 1e-05, 8000, 2e+11, 0.3, 0.000788, 20},   {Law::dmt, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {Law::dmt, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {Law::dmt, 0.0001, 1000, 1e+09, 0.05, 0.00353, 1},
    {Law::dmt, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {Law::dmt, 2e-05, 4000, 2e+10, 0.3, 0.00214, 3},
    {Law::dmt, 5e-06, 1000, 1e+09, 0.05, 8.02e-06, 2},   {Law::dmt, 5e-06, 1000, 1e+09, 0.05, 1.12e-05, 1.5},
    {Law::jkr, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {Law::jkr, 4.4e-05, 2600, 9e+10, 0.05, 0.00531, 2},
    {Law::jkr, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {Law::jkr, 4.4e-05, 2600, 9e+10, 0.3, 0.00498, 0.3},
    {Law::jkr, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {Law::jkr, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {Law::jkr, 5e-06, 1000, 1e+09, 0.02, 8.36e-06, 3},   {Law::jkr, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {Law::jkr, 1e-05, 8000, 2e+11, 0.3, 0.000786, 20},   {Law::jkr, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {Law::jkr, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {Law::jkr, 0.0001, 1000, 1e+09, 0.05, 0.00351, 1},
    {Law::jkr, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {Law::jkr, 2e-05, 4000, 2e+10, 0.3, 0.00213, 3},
    {Law::jkr, 5e-06, 1000, 1e+09, 0.05, 0, 3.3},        {Law::jkr, 5e-06, 1000, 1e+09, 0.05, 1.13e-05, 5},
};

}  // namespace

std::vector<ImpactCase> grid() {
    std::vector<ImpactCase> impacts;
    for (const GridPoint& row : rows)
        impacts.push_back(
            {.law = row.law,
             .detachment = row.law == Law::jkr ? Detachment::load_controlled : Detachment::zero_overlap,
             .radius = row.radius,
             .mass = sphere_mass(row.radius, row.density),
             .contact_modulus = row.contact_modulus,
             .work_of_adhesion = row.work_of_adhesion,
             .damping = row.damping,
             .velocity = row.velocity});
    return impacts;
}

std::vector<ImpactCase> grid_beyond_dem_codes() {
    std::vector<ImpactCase> impacts;
    for (ImpactCase impact : grid()) {
        const auto add = [&](Law law, Detachment detachment) {
            impact.law = law;
            impact.detachment = detachment;
            impacts.push_back(impact);
        };
        switch (impact.law) {
            case Law::hertz:
                add(Law::hertz, Detachment::zero_force);
                break;
            case Law::jkr:
                add(Law::jkr, Detachment::pull_off);
                add(Law::jkr, Detachment::zero_overlap);
                break;
            default:
                add(Law::brach_dunn, Detachment::zero_overlap);
        }
    }
    return impacts;
}

}  // namespace ashimpact::oracles
