// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/json/document.hpp"

namespace ashimpact::report {

/// The critical velocity that stands for a law: what a reader is to take, with its interval.
struct Headline {
    std::optional<double> value{};           ///< [m/s]
    std::optional<double> lower{}, upper{};  ///< of the 95 % interval [m/s]
    bool with_interval = false;              ///< an end that is missing then is open
    std::string method{};                    ///< how it was found, as the artifact says it; may be empty
};

/// The headline of one law's entry in 7-critical-velocity.json.
[[nodiscard]] Headline headline_of(const Json& entry);

/// The ends of an interval of velocities [m/s]: "1.68 to 2.21"; an end that is missing is open.
[[nodiscard]] std::string interval_text(const std::optional<double>& lower,
                                        const std::optional<double>& upper);

/// "1.93 m/s (95 %: 1.68 to 2.21 m/s)".
[[nodiscard]] std::string text_of(const Headline& headline);

/// The number of a quantity {"value", "unit"}; none for null or a missing member.
[[nodiscard]] std::optional<double> number_in(const Json& object, const char* key);

}  // namespace ashimpact::report
