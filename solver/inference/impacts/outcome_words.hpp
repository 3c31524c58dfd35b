// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// The outcome that a text in a table of impacts states.
enum class OutcomeWord { none, capture, rebound, unknown };

template <>
struct Names<OutcomeWord> {
    static constexpr std::string_view kind = "word for an outcome";
    static constexpr std::array<std::string_view, 4> all{"none", "capture", "rebound", "unknown"};
};

/// The meaning of a cell that holds exactly one word for an outcome, such as "haftet", "stick", "rebound",
/// "?", or the letters c and r; an empty cell is unknown.
[[nodiscard]] OutcomeWord outcome_word(std::string_view cell);

/// The meaning of a remark. Here a full stop, an exclamation mark or brackets around the word do not count,
/// and single letters and words for an unknown outcome mean nothing. A longer text means nothing either: it
/// may mean the contrary ("haftet nicht").
[[nodiscard]] OutcomeWord outcome_of_remark(std::string_view remark);

/// Whether the heading of a column announces remarks: "Bemerkung", "Befund", "Status", "comment" ...
[[nodiscard]] bool announces_remarks(std::string_view heading);

}  // namespace ashimpact
