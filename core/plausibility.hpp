// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/document.hpp"
#include "core/units/units.hpp"

namespace ashimpact {

/// What quantities of one kind lie between in this field. A value outside is probably a slip of its unit.
struct PlausibleRange {
    Dimension dimension;
    double least, greatest;                 ///< [SI]
    std::string_view words;                 ///< "10 nm to 5 mm"
    std::array<std::string_view, 3> units;  ///< that people write, the usual one first
    std::string_view names;                 ///< of such quantities, as keys of documents
    bool either_sign = false;               ///< whether a negative value is one of the other direction

    [[nodiscard]] bool holds(double value) const { return value >= least && value <= greatest; }
};

/// The range of a quantity by its key or option: "diameter", "--partner-diameter"; null if it has none.
[[nodiscard]] const PlausibleRange* plausible_range(std::string_view name);

/// Codes of findings on a value outside of its range, and on a v_c above fastest_in_model.
inline constexpr std::string_view implausible_code = "implausible";
inline constexpr std::string_view outside_model_code = "outside-model";

/// How a value was written.
struct Writing {
    double value;                    ///< [SI]
    std::optional<double> number{};  ///< the number alone if no unit was written, which is then SI
};

/// The doubt about a value outside of its range; none if it is inside, or 0.
/// @throws InputError for a number without a unit that is outside, if it is inside with the usual unit or is
/// a thousand times outside; with the unit that was meant
[[nodiscard]] std::optional<Finding> implausible(const PlausibleRange& range, const Writing& written);

/// The same with its place, an option, a key or words, before the text.
[[nodiscard]] std::optional<Finding> implausible_at(const std::string& place, const PlausibleRange& range,
                                                    const Writing& written);

/// The doubts about a quantity as text, "90 um", by its option. A text that is none gets no finding here.
[[nodiscard]] std::vector<Finding> implausible_text(std::string_view option, const std::string& text);

/// The doubts about all quantities of a document, which are found by their keys; the JSON pointer of each is
/// in its text. Of a column the value that is furthest outside counts. @param bare whether numbers without a
/// unit are quantities in SI, as in a case and its artifact; in other artifacts they are not
[[nodiscard]] std::vector<Finding> implausible_values(const Json& document, const std::string& pointer = {},
                                                      bool bare = true);

/// The greatest critical velocity that the models here are meant for [m/s].
inline constexpr double fastest_in_model = 500;

/// A critical velocity beyond it, for a reader.
[[nodiscard]] std::string outside_model_text();

/// A critical velocity for a reader: @p text, or beyond fastest_in_model that it is outside of the model.
[[nodiscard]] std::string critical_velocity_text(double velocity, const std::string& text);

/// The doubt about a critical velocity beyond fastest_in_model.
[[nodiscard]] std::optional<Finding> outside_model(double critical_velocity);

}  // namespace ashimpact
