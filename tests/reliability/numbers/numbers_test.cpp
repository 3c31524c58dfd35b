// SPDX-License-Identifier: GPL-3.0-or-later
// Random parameter sets over twelve decades. ASHIMPACT_WHOLE: a million of them, or its value;
// ASHIMPACT_SEED: others; ASHIMPACT_CASE: only those whose names have this in them, such as "dmt, constant".
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <doctest/doctest.h>

#include "solver/batch/kernels/kernel.hpp"
#include "tests/reliability/numbers/random_sets.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

std::size_t wanted_sets() {
    constexpr std::size_t whole = 1'000'000;
    const char* text = std::getenv("ASHIMPACT_WHOLE");
    if (text == nullptr) return static_cast<std::size_t>(repetitions(3'000));
    const auto number = std::strtoull(text, nullptr, 10);
    return number > 1 ? number : whole;
}

double share_of(const ContactCase& c) {
    return batch::has_kernels(c.law, c.damping_law) ? 1.0 : 0.25;
}

}  // namespace

TEST_CASE("random parameter sets: scalar, double, batch and table agree, or a typed refusal") {
    const char* seed_text = std::getenv("ASHIMPACT_SEED");
    const std::uint64_t seed = seed_text != nullptr ? std::strtoull(seed_text, nullptr, 10) : 1;
    const char* chosen = std::getenv("ASHIMPACT_CASE");
    NumbersReport report;
    const std::vector<ContactCase> cases = contact_cases();
    // Impacts of laws without kernels take hundreds of times as long: a quarter as many of them.
    double shares = 0.0;
    for (const ContactCase& c : cases) shares += share_of(c);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const ContactCase& c = cases[i];
        if (chosen != nullptr && name_of(c).find(chosen) == std::string::npos) continue;
        Random random(seed * cases.size() + i);  // the same sets of a case whatever else is asked for
        const auto sets =
            static_cast<std::size_t>(std::ceil(static_cast<double>(wanted_sets()) * share_of(c) / shares));
        check_random_impacts(c, sets, random, report);
        MESSAGE(name_of(c) << ": " << sets << ", wrong so far: " << report.wrong);
        std::fflush(stdout);  // a whole run takes an hour
    }
    for (const auto& [what, found] : report.findings)
        MESSAGE(found.first << " x " << what << "; " << found.second);
    for (const auto& [what, count] : report.refusals) MESSAGE(count << " x " << what);
    MESSAGE(report.impacts << " impacts: " << report.rebounds << " rebounds, " << report.captures
                           << " captures, " << report.wrong << " wrong");
    CHECK(report.wrong == 0);
    CHECK(report.rebounds > report.impacts / 5);
    CHECK(report.captures > report.impacts / 10);
}
