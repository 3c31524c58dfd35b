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
#include "core/tables/coverage.hpp"

namespace ashimpact {

/// Quantity that a column of a table of impacts holds.
enum class MeasuredQuantity { velocity, rebound, restitution };

template <>
struct Names<MeasuredQuantity> {
    static constexpr std::string_view kind = "measured quantity";
    static constexpr std::array<std::string_view, 3> all{"velocity", "rebound", "restitution"};
};

struct MeasuredColumn {
    std::size_t position;
    std::string name;  ///< as in the file, without its unit
    double to_si;      ///< factor
    bool unit_given;
    double coverage = 1;  ///< its uncertainties over standard ones; 0: they cannot be read
};

struct TextColumn {
    std::size_t position;
    std::string name;
};

/// The columns of a heading.
struct MeasurementHeading {
    std::array<std::optional<MeasuredColumn>, 3> value;        ///< by MeasuredQuantity
    std::array<std::optional<MeasuredColumn>, 3> uncertainty;  ///< by MeasuredQuantity
    std::optional<std::size_t> outcome;                        ///< position of the column of outcomes
    std::optional<std::size_t> correlation;  ///< of the column of the correlation of the two velocities
    std::vector<TextColumn> remarks;         ///< columns of remarks, in which a word may state the outcome
    std::vector<TextColumn> unused;
    std::vector<std::pair<std::string, StatedCoverage>> coverages;  ///< of the columns that hold quantities
    std::vector<std::string> notes;                                 ///< remarks on the columns
    std::size_t columns;

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

/// Whether a line may be the heading: one of its cells names the incident velocity.
[[nodiscard]] bool names_incident_velocity(const std::vector<std::string>& cells);

/// An uncertainty that names no quantity is that of the column before it. Numbers of uncertainties are taken
/// as multiples of standard ones if the heading states it (`read_coverage`). Errors: InputError for a unit
/// of another dimension, a column twice, v_in missing, or both v_r and e_n.
[[nodiscard]] MeasurementHeading read_measurement_heading(const std::vector<std::string>& cells);

}  // namespace ashimpact
