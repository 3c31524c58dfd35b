// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/column.hpp"

#include <algorithm>
#include <iterator>

#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "tests/oracles/dem/dem_code.hpp"
#include "tests/oracles/dem/dem_impact.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::oracles {

namespace {

Column dem_oracle(const DemCode& code) {
    return {.name = code.name,
            .covers = code.covers,
            .impacts = [code](std::span<const ImpactCase> impacts) { return dem_impacts(code, impacts); },
            .rebounds = [code](std::span<const ImpactCase> impacts) { return dem_rebounds(code, impacts); }};
}

// For what computes an impact within the program.
Column one_by_one(const std::string& name, ImpactResult (*compute)(const ImpactCase&)) {
    return {.name = name,
            .covers = [](const ImpactCase&) { return true; },
            .impacts =
                [compute](std::span<const ImpactCase> impacts) {
                    std::vector<ImpactResult> results;
                    std::transform(impacts.begin(), impacts.end(), std::back_inserter(results), compute);
                    return results;
                },
            .rebounds =
                [compute](std::span<const ImpactCase> impacts) {
                    std::vector<bool> results;
                    std::transform(impacts.begin(), impacts.end(), std::back_inserter(results),
                                   [compute](const ImpactCase& impact) { return compute(impact).rebound; });
                    return results;
                }};
}

Impact posed(const ImpactCase& impact) {
    return {.law = ashimpact::Law::named(name(impact.law)),
            .detachment = named<ashimpact::Detachment>(name(impact.detachment)),
            .damping = {.law = DampingLaw::constant, .coefficient = impact.damping},
            .contact = {.mass = impact.mass,
                        .effective_radius = impact.radius,
                        .contact_modulus = impact.contact_modulus,
                        .work_of_adhesion = impact.work_of_adhesion},
            .velocity = impact.velocity};
}

ImpactResult solved_impact(const ImpactCase& impact) {
    constexpr double promised = 1e-10;
    const auto estimate = [](double value) { return Estimate{value, promised * value}; };
    const auto result = solve_impact(posed(impact));
    return {.rebound = result.outcome == Outcome::rebound,
            .restitution = estimate(result.restitution),
            .contact_time = estimate(result.contact_time.value_or(0)),
            .maximum_overlap = estimate(result.maximum_overlap)};
}

}  // namespace

Column time_domain_oracle() {
    return one_by_one("GSL", time_domain_impact);
}
Column lammps_oracle() {
    return dem_oracle(lammps());
}
Column liggghts_oracle() {
    return dem_oracle(liggghts());
}
Column solver_under_test() {
    return one_by_one("ashimpact", solved_impact);
}

double solver_critical_velocity(const ImpactCase& impact) {
    const Impact problem = posed(impact);
    return critical_velocity({.law = problem.law,
                              .detachment = problem.detachment,
                              .damping = problem.damping,
                              .contact = problem.contact})
        .value.value();
}

std::vector<Column> columns() {
    return {time_domain_oracle(), lammps_oracle(), liggghts_oracle(), solver_under_test()};
}

bool rebounds(const Column& column, const ImpactCase& impact, double velocity) {
    const ImpactCase moved = at_velocity(impact, velocity);
    return column.rebounds(std::span(&moved, 1)).front();
}

}  // namespace ashimpact::oracles
