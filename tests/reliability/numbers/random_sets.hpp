// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::test {

/// What was found among random parameter sets.
struct NumbersReport {
    std::int64_t impacts = 0;
    std::int64_t rebounds = 0;
    std::int64_t captures = 0;
    std::map<std::string, std::int64_t> refusals;  ///< typed errors by their text without numbers
    std::int64_t wrong = 0;
    std::map<std::string, std::pair<std::int64_t, std::string>> findings;  ///< how often, and one such impact

    void find(const std::string& what, const Impact& impact);
};

/// Checks @p count random impacts of a case. Each input varies over twelve decades, damping and adhesion from
/// nothing to far beyond what captures everything. Each impact is solved in extended precision, in double
/// precision, in a batch with and without turning points, and from a table. All have to agree, or the scalar
/// solver refuses with a typed error. Batches of a law without kernels get one impact of eight.
void check_random_impacts(const ContactCase& c, std::size_t count, Random& random, NumbersReport& report);

}  // namespace ashimpact::test
