// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand impacts of anything: each ends in a rebound, a capture or a typed refusal, and its ledger
// closes.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// An impact by a law with any damping law and detachment, admissible or not, over the whole range that fly
/// ash and its neighbours span.
Impact random_impact(Law law, Random& random) {
    ContactCase c{.law = law,
                  .damping_law = all_values<DampingLaw>[random.below(all_values<DampingLaw>.size())],
                  .detachment = all_values<Detachment>[random.below(all_values<Detachment>.size())]};
    const double radius = random.log_uniform(1e-7, 1e-3);
    const double density = random.log_uniform(500.0, 2e4);
    ContactPair pair{.mass = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density,
                     .effective_radius = radius,
                     .contact_modulus = random.log_uniform(1e8, 1e12),
                     .work_of_adhesion = random.log_uniform(1e-4, 10.0)};
    pair.parameters = parameters_like(pair.work_of_adhesion);
    if (random.below(2) == 0) c.yield_pressure = pair.contact_modulus * random.log_uniform(1e-3, 1.0);
    const double velocity = random.log_uniform(1e-4, 1e3);
    return impact_of(c, pair, random.uniform(0.0, 2.0), velocity);
}

struct Tally {
    int rebounds = 0;
    int captures = 0;
    int refusals = 0;
    int beyond_theory = 0;   ///< overlap larger than the radius
    int beyond_closure = 0;  ///< flattened by adhesion alone, and refused
};

/// The result, or nothing where a contact yields beyond what its law can say.
std::optional<ImpactResult> solved_or_refused(const Impact& impact) {
    try {
        return solved(impact);
    } catch (const InputError& error) {
        if (error.problem().find("outside the range of the plastic closure") == std::string::npos) throw;
        return std::nullopt;
    }
}

/// What a number of impacts did.
struct Findings {
    Tally tally;
    Worst ledger;
    Worst in_double;
};

void check_impact(const Impact& impact, Findings& findings) {
    CAPTURE(describe(impact));
    if (refusal(impact.law, impact.detachment)) {
        CHECK_THROWS_AS(static_cast<void>(solve_impact(impact)), InputError);
        ++findings.tally.refusals;
        return;
    }
    const std::optional<ImpactResult> found = solved_or_refused(impact);
    if (!found) {
        ++findings.tally.beyond_closure;
        return;
    }
    const ImpactResult& result = *found;
    const bool rebound = result.outcome == Outcome::rebound;
    (rebound ? findings.tally.rebounds : findings.tally.captures) += 1;
    const EnergyLedger& energy = result.energy;
    const double size = std::max(energy.incident, std::abs(energy.minimum));
    findings.ledger.see(std::abs(energy.residual) / size, describe(impact));

    const bool consistent =
        std::isfinite(result.maximum_overlap) && result.maximum_overlap > 0.0 &&
        result.contact_time.has_value() == rebound &&
        (rebound ? result.restitution > 0.0 && result.restitution <= 1.0 : result.restitution == 0.0) &&
        (!result.approach_time || *result.approach_time > 0.0) &&
        (!rebound || *result.contact_time > result.approach_time.value());
    CHECK(consistent);

    findings.tally.beyond_theory += result.maximum_overlap > impact.contact.effective_radius ? 1 : 0;
    const double conditioning = size / energy.incident / std::max(result.restitution, 1e-8);
    if (conditioning < 1e3)
        findings.in_double.see(std::abs(restitution_of(impact) - result.restitution), describe(impact));
}

}  // namespace

TEST_CASE("random impacts end in a rebound, a capture or a refusal, and their energy is accounted for") {
    Findings findings;
    const int times = repetitions(10'000);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        Random random = random_of(Law::at(i).name(), 3);
        const int enough = times * (static_cast<int>(i) + 1) / static_cast<int>(Law::count());
        while (findings.tally.rebounds + findings.tally.captures < enough)
            check_impact(random_impact(Law::at(i), random), findings);
    }
    const auto& [tally, ledger, in_double] = findings;
    MESSAGE(tally.rebounds << " rebounds, " << tally.captures << " captures, " << tally.refusals
                           << " refusals; " << tally.beyond_theory
                           << " with an overlap beyond the radius, outside the theory");
    CHECK(tally.rebounds > times / 4);
    CHECK(tally.captures > times / 4);
    CHECK(tally.refusals > times / 10);
    CHECK(tally.beyond_theory > 0);
    CHECK(tally.beyond_closure < times / 100);
    CHECK_MESSAGE(ledger.deviation() < 1e-10, ledger.where());
    CHECK_MESSAGE(in_double.deviation() < 1e-10, in_double.where());
}
