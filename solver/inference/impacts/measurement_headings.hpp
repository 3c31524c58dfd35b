// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/vocabulary.hpp"

namespace ashimpact {

/// The outcome that a text in a table of impacts states.
enum class OutcomeWord { none, capture, rebound, unknown };

template <>
struct Names<OutcomeWord> {
    static constexpr std::string_view kind = "word for an outcome";
    static constexpr std::array<std::string_view, 4> all{"none", "capture", "rebound", "unknown"};
};

/// "0" or "1" of a cell that holds this number, such as "1.0" or "0,00"; other cells as they are.
[[nodiscard]] std::string_view as_flag(std::string_view cell);

/// The meaning of a cell of a column that holds yes for a capture.
[[nodiscard]] OutcomeWord capture_flag(std::string_view cell);

/// The meaning of a cell that holds exactly one word for an outcome, such as "haftet", "stick", "rebound",
/// "?", or the letters c and r; an empty cell is unknown.
[[nodiscard]] OutcomeWord outcome_word(std::string_view cell);

/// The meaning of a remark. Here a full stop, an exclamation mark or brackets around the word do not count,
/// and single letters and words for an unknown outcome mean nothing. A longer text means nothing either: it
/// may mean the contrary ("haftet nicht").
[[nodiscard]] OutcomeWord outcome_of_remark(std::string_view remark);

/// Whether the heading of a column announces remarks: "Bemerkung", "Befund", "Status", "comment" ...
[[nodiscard]] bool announces_remarks(std::string_view heading);

/// Quantity that a column of a table of impacts holds.
enum class MeasuredQuantity { velocity, rebound, restitution };

template <>
struct Names<MeasuredQuantity> {
    static constexpr std::string_view kind = "measured quantity";
    static constexpr std::array<std::string_view, 3> all{"velocity", "rebound", "restitution"};
};

struct TextColumn {
    std::size_t position;
    std::string name;  ///< as in the file, without its unit
};

struct MeasuredColumn : TextColumn {
    double to_si;  ///< factor
    bool unit_given;
    bool is_fraction;  ///< cells may be in per cent
    double coverage;   ///< its uncertainties over standard ones; 0: they cannot be read
    bool unit_in_cells = false;
    bool is_relative = false;  ///< its uncertainties are fractions of the velocities
};

/// The column of the angle of incidence, or of the velocity along the wall.
struct SidewaysColumn : TextColumn {
    bool is_angle;  ///< from the normal
    double to_si;   ///< factor, to rad or m/s
};

/// A column that marks impacts as valid, or as excluded.
struct ValidityColumn {
    std::size_t position;
    bool excludes;  ///< yes in it means that the impact does not count
};

/// The columns of a table that hold no quantity, in which rows may be labelled.
struct LabelColumns {
    std::vector<TextColumn> remarks{};       ///< columns of remarks
    std::vector<TextColumn> unused{};        ///< those without a name have no heading
    std::vector<ValidityColumn> validity{};  ///< those of the unused columns
    std::size_t columns = 0;                 ///< all of the table

    /// Enters a column from which no quantity is read. @param name its heading without a unit
    void take(TextColumn column, std::string_view name);
};

/// The columns of a heading. In a column of remarks a word may state the outcome.
struct MeasurementHeading : LabelColumns {
    std::array<std::optional<MeasuredColumn>, 3> value;        ///< by MeasuredQuantity
    std::array<std::optional<MeasuredColumn>, 3> uncertainty;  ///< by MeasuredQuantity
    std::optional<MeasuredColumn> checked;                     ///< e_n beside v_r, which is used
    std::optional<std::size_t> outcome;                        ///< position of the column of outcomes
    bool outcome_is_capture = false;                           ///< that column holds yes for a capture, or no
    std::optional<std::size_t> correlation;  ///< of the column of the correlation of the two velocities
    std::optional<SidewaysColumn> sideways;  ///< of impacts at an angle
    bool normal_velocity = true;   ///< v_in is that normal to the wall, not that of the sphere at an angle
    UncertainColumns coverages{};  ///< of the columns that hold quantities
    std::vector<Finding> notes;    ///< remarks on the columns

    [[nodiscard]] const std::optional<MeasuredColumn>& of(MeasuredQuantity quantity) const {
        return value[static_cast<std::size_t>(quantity)];
    }
    /// The column of rebound velocities or restitutions.
    [[nodiscard]] const MeasuredColumn& reading() const {
        const auto& rebound = of(MeasuredQuantity::rebound);
        return rebound ? *rebound : *of(MeasuredQuantity::restitution);
    }
    [[nodiscard]] const std::optional<MeasuredColumn>& uncertainty_of(MeasuredQuantity quantity) const {
        return uncertainty[static_cast<std::size_t>(quantity)];
    }
};

/// Whether a text is a unit of velocity: "m/s", "mm s-1".
[[nodiscard]] bool is_velocity_unit(std::string_view text);

/// Refuses a text beside the numbers that states another unit of velocity than the headings, or angles from
/// the wall: "Velocities in mm/s". @throws InputError at the line of the text
void require_agreeing_units(const TextBeside& text, const MeasurementHeading& heading);

/// Refuses a text beside the table that states one angle of all impacts, where no column does.
/// @throws InputError at the line of the text
void require_stated_angle(const TextBeside& text, const MeasurementHeading& heading);

/// Whether a line may be the heading: one of its cells names the incident velocity.
[[nodiscard]] bool names_incident_velocity(const std::vector<std::string>& cells);

/// An uncertainty that names no quantity is that of the column before it. Numbers of uncertainties are taken
/// as multiples of standard ones if the heading states it (`read_coverage`). Errors: InputError for a unit
/// of another dimension, a column twice, v_in missing, or both v_r and e_n.
[[nodiscard]] MeasurementHeading read_measurement_heading(const std::vector<std::string>& cells);

}  // namespace ashimpact
