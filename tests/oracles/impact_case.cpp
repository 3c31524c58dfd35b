// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/impact_case.hpp"

#include "materials/contact_properties.hpp"

namespace ashimpact::oracles {

Impact at_velocity(Impact impact, double velocity) {
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

constexpr Law hertz = Law::of<Hertz>();
constexpr Law dmt = Law::of<Dmt>();
constexpr Law jkr = Law::of<Jkr>();

constexpr GridPoint rows[] = {
    {hertz, 4.4e-05, 2600, 9e+10, 0, 0, 2},         {hertz, 4.4e-05, 2600, 9e+10, 0, 0.00538, 2},
    {hertz, 4.4e-05, 2600, 9e+10, 0, 0.0161, 2},    {hertz, 4.4e-05, 2600, 9e+10, 0, 0.00613, 0.3},
    {hertz, 4.8e-05, 2300, 7.5e+10, 0, 0.0178, 10}, {hertz, 5.2e-05, 2200, 1e+11, 0, 0.00374, 20},
    {hertz, 5e-06, 1000, 1e+09, 0, 5.9e-06, 0.3},   {hertz, 5e-06, 2650, 7e+10, 0, 0.000216, 5},
    {hertz, 1e-05, 8000, 2e+11, 0, 0.000793, 20},   {hertz, 0.0001, 8000, 2e+11, 0, 0.154, 0.3},
    {hertz, 0.0001, 8000, 2e+11, 0, 0.238, 20},     {hertz, 0.0001, 1000, 1e+09, 0, 0.00375, 1},
    {hertz, 2e-05, 4000, 2e+10, 0, 0, 3},           {hertz, 2e-05, 4000, 2e+10, 0, 0.00228, 3},
    {dmt, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {dmt, 4.4e-05, 2600, 9e+10, 0.05, 0.00533, 2},
    {dmt, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {dmt, 4.4e-05, 2600, 9e+10, 0.3, 0.00496, 0.3},
    {dmt, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {dmt, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {dmt, 5e-06, 1000, 1e+09, 0.02, 8.39e-06, 3},   {dmt, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {dmt, 1e-05, 8000, 2e+11, 0.3, 0.000788, 20},   {dmt, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {dmt, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {dmt, 0.0001, 1000, 1e+09, 0.05, 0.00353, 1},
    {dmt, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {dmt, 2e-05, 4000, 2e+10, 0.3, 0.00214, 3},
    {dmt, 5e-06, 1000, 1e+09, 0.05, 8.02e-06, 2},   {dmt, 5e-06, 1000, 1e+09, 0.05, 1.12e-05, 1.5},
    {jkr, 4.4e-05, 2600, 9e+10, 0.05, 0, 2},        {jkr, 4.4e-05, 2600, 9e+10, 0.05, 0.00531, 2},
    {jkr, 4.4e-05, 2600, 9e+10, 1, 0.0146, 2},      {jkr, 4.4e-05, 2600, 9e+10, 0.3, 0.00498, 0.3},
    {jkr, 4.8e-05, 2300, 7.5e+10, 0.3, 0.0176, 10}, {jkr, 5.2e-05, 2200, 1e+11, 0.05, 0.00374, 20},
    {jkr, 5e-06, 1000, 1e+09, 0.02, 8.36e-06, 3},   {jkr, 5e-06, 2650, 7e+10, 1, 0.000173, 5},
    {jkr, 1e-05, 8000, 2e+11, 0.3, 0.000786, 20},   {jkr, 0.0001, 8000, 2e+11, 1, 0.134, 0.3},
    {jkr, 0.0001, 8000, 2e+11, 0.05, 0.238, 20},    {jkr, 0.0001, 1000, 1e+09, 0.05, 0.00351, 1},
    {jkr, 2e-05, 4000, 2e+10, 0.3, 0, 3},           {jkr, 2e-05, 4000, 2e+10, 0.3, 0.00213, 3},
    {jkr, 5e-06, 1000, 1e+09, 0.05, 0, 3.3},        {jkr, 5e-06, 1000, 1e+09, 0.05, 1.13e-05, 5},
};

}  // namespace

std::vector<Impact> grid() {
    std::vector<Impact> impacts;
    for (const GridPoint& row : rows)
        impacts.push_back(
            {.law = row.law,
             .detachment = row.law == jkr ? Detachment::load_controlled : Detachment::zero_overlap,
             .damping = {DampingLaw::constant, row.damping},
             .contact = {.mass = sphere_mass(row.radius, row.density),
                         .effective_radius = row.radius,
                         .contact_modulus = row.contact_modulus,
                         .work_of_adhesion = row.work_of_adhesion},
             .velocity = row.velocity});
    return impacts;
}

std::vector<Impact> grid_beyond_dem_codes() {
    std::vector<Impact> impacts;
    for (Impact impact : grid()) {
        const auto add = [&](Law law, Detachment detachment) {
            impact.law = law;
            impact.detachment = detachment;
            impacts.push_back(impact);
        };
        if (impact.law == hertz) {
            add(hertz, Detachment::zero_force);
        } else if (impact.law == jkr) {
            add(jkr, Detachment::pull_off);
            add(jkr, Detachment::zero_overlap);
        } else {
            add(Law::of<BrachDunn>(), Detachment::zero_overlap);
        }
    }
    return impacts;
}

}  // namespace ashimpact::oracles
