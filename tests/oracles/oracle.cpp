#include "tests/oracles/oracle.hpp"

#include "tests/oracles/dem_code.hpp"
#include "tests/oracles/dem_impact.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::oracles {

namespace {

Oracle dem_oracle(const DemCode& code) {
    return {.name = code.name,
            .covers = code.covers,
            .impacts = [code](std::span<const ImpactCase> impacts) { return dem_impacts(code, impacts); },
            .rebounds = [code](std::span<const ImpactCase> impacts) { return dem_rebounds(code, impacts); }};
}

}  // namespace

Oracle time_domain_oracle() {
    return {.name = "GSL",
            .covers = [](const ImpactCase&) { return true; },
            .impacts =
                [](std::span<const ImpactCase> impacts) {
                    std::vector<ImpactResult> results;
                    for (const ImpactCase& impact : impacts) results.push_back(time_domain_impact(impact));
                    return results;
                },
            .rebounds =
                [](std::span<const ImpactCase> impacts) {
                    std::vector<bool> results;
                    for (const ImpactCase& impact : impacts)
                        results.push_back(time_domain_impact(impact).rebound);
                    return results;
                }};
}

Oracle lammps_oracle() {
    return dem_oracle(lammps());
}
Oracle liggghts_oracle() {
    return dem_oracle(liggghts());
}

std::vector<Oracle> oracles() {
    return {time_domain_oracle(), lammps_oracle(), liggghts_oracle()};
}

bool rebounds(const Oracle& oracle, const ImpactCase& impact, double velocity) {
    const ImpactCase moved = at_velocity(impact, velocity);
    return oracle.rebounds(std::span(&moved, 1)).front();
}

}  // namespace ashimpact::oracles
