#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ashimpact {

/// Quantity that a column of a table of impacts holds.
enum class MeasuredQuantity { velocity, rebound, restitution };

struct MeasuredColumn {
    std::size_t position;
    std::string name;  ///< as in the file, without its unit
    double to_si;      ///< factor
    bool unit_given;
};

/// The columns of a heading.
struct MeasurementHeading {
    std::array<std::optional<MeasuredColumn>, 3> value;        ///< by MeasuredQuantity
    std::array<std::optional<MeasuredColumn>, 3> uncertainty;  ///< by MeasuredQuantity
    std::optional<std::size_t> outcome;                        ///< position of the column of outcomes
    std::optional<std::size_t> correlation;  ///< of the column of the correlation of the two velocities
    std::vector<std::string> unused;
    std::size_t columns;

    [[nodiscard]] const std::optional<MeasuredColumn>& of(MeasuredQuantity quantity) const {
        return value[static_cast<std::size_t>(quantity)];
    }
    [[nodiscard]] const std::optional<MeasuredColumn>& uncertainty_of(MeasuredQuantity quantity) const {
        return uncertainty[static_cast<std::size_t>(quantity)];
    }
};

/// Whether a line may be the heading: one of its cells names the incident velocity.
[[nodiscard]] bool names_incident_velocity(const std::vector<std::string>& cells);

/// Errors: InputError for a unit of another dimension, a column twice, v_in missing, or both v_r and e_n.
[[nodiscard]] MeasurementHeading read_measurement_heading(const std::vector<std::string>& cells);

}  // namespace ashimpact
