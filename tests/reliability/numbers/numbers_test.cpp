// Random parameter sets over twelve decades. ASHIMPACT_WHOLE: a million of them, or as many as it says.
#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

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

}  // namespace

TEST_CASE("random parameter sets: scalar, double, batch and table agree, or a typed refusal") {
    const char* seed = std::getenv("ASHIMPACT_SEED");
    Random random(seed != nullptr ? std::strtoull(seed, nullptr, 10) : 1);
    NumbersReport report;
    const std::vector<ContactCase> cases = contact_cases();
    const std::size_t each = wanted_sets() / cases.size() + 1;
    for (const ContactCase& c : cases) check_random_impacts(c, each, random, report);
    for (const auto& [what, found] : report.findings)
        MESSAGE(found.first << " x " << what << "; " << found.second);
    for (const auto& [what, count] : report.refusals) MESSAGE(count << " x " << what);
    MESSAGE(report.impacts << " impacts: " << report.rebounds << " rebounds, " << report.captures
                           << " captures, " << report.wrong << " wrong");
    CHECK(report.wrong == 0);
    CHECK(report.rebounds > report.impacts / 5);
    CHECK(report.captures > report.impacts / 10);
}
