// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace ashimpact {

enum class UnitProblem { none, unknown, other_dimension };

/// Factor from one unit to another, or the reason why there is none.
struct UnitScale {
    double scale = 0;
    UnitProblem problem = UnitProblem::none;
};

/// Factor that turns a value in `unit` into one in `target` [target/unit]. Units with an offset or a
/// logarithm have no factor and count as of another dimension. Looks the unit up in a small table of our own
/// first, which takes microseconds, and in the UDUNITS-2 database (milliseconds, once) only if that does not
/// know it.
[[nodiscard]] UnitScale scale_to(std::string_view unit, std::string_view target);

/// Like scale_to(), but always from the UDUNITS-2 database; for the test that the small table agrees with it.
[[nodiscard]] UnitScale database_scale_to(std::string_view unit, std::string_view target);

/// Rewrites `µ`, `μ`, `·`, `−`, superscript digits, no-break spaces, `Å` and `**` in the ASCII of the
/// UDUNITS-2 grammar.
[[nodiscard]] std::string ascii(std::string_view text);

}  // namespace ashimpact
