// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <Eigen/Dense>

#include "core/json/view.hpp"
#include "core/quantities/names.hpp"
#include "pipeline/case/values.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "solver/contact/law.hpp"
#include "solver/statistics/interval.hpp"

/// Single values of results as JSON, and back. Read errors: InputError with the JSON pointer.
namespace ashimpact {

/// Form of a number: null where it is not finite.
struct NullIfNotFinite {};
/// Form of a quantity that keeps its unit.
struct AnyUnit {};
/// Form of a velocity: without its interval and method.
struct WithoutInterval {};

template <class T>
requires std::is_arithmetic_v<T>
[[nodiscard]] Json value_json(T value) {
    return value;
}
[[nodiscard]] inline Json value_json(const std::string& text) {
    return text;
}
[[nodiscard]] inline Json value_json(Law law) {
    return law.name();
}
template <Named Enum>
[[nodiscard]] Json value_json(Enum value) {
    return name_of(value);
}
[[nodiscard]] inline Json value_json(const std::array<double, 2>& range) {
    return range;
}
/// The number, or null where it is not finite.
[[nodiscard]] inline Json finite_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}
[[nodiscard]] inline Json value_json(double value, NullIfNotFinite) {
    return finite_json(value);
}
/// {"value", "unit"}.
[[nodiscard]] inline Json value_json(double value, Dimension dimension) {
    return quantity_json(value, dimension);
}
/// The same with "standard_uncertainty", where it is known.
template <class Form>
[[nodiscard]] Json value_json(const Quantity& quantity, Form /*form*/) {
    return quantity;
}
/// The same with "origin", and with "source" where there is one.
[[nodiscard]] Json value_json(const Stated& stated, Dimension dimension);
/// {"values", "unit"}.
[[nodiscard]] inline Json value_json(const std::vector<double>& values, Dimension dimension) {
    return column_json(values, dimension);
}
/// {"level", "lower", "upper"}; an end that the data do not bound is null.
[[nodiscard]] Json value_json(const Bounds& bounds, Dimension dimension);
/// {"value", "unit", "standard_uncertainty"} of a velocity.
[[nodiscard]] Json value_json(const VelocityEstimate& velocity, WithoutInterval);
/// The same with "interval", and with "method" if it is stated.
[[nodiscard]] Json value_json(const VelocityEstimate& velocity);

inline void read_value(const View& node, double& value, Dimension dimension = Dimension::fraction) {
    value = node.number(dimension);
}
inline void read_value(const View& node, double& value, NullIfNotFinite) {
    read_value(node, value);
}
inline void read_value(const View& node, int& value) {
    value = node.integer();
}
/// A count; 0 for a negative number.
void read_value(const View& node, std::size_t& value);
inline void read_value(const View& node, bool& value) {
    value = node.truth();
}
inline void read_value(const View& node, std::string& value) {
    value = node.text();
}
void read_value(const View& node, Law& value);
template <Named Enum>
void read_value(const View& node, Enum& value) {
    value = at_place(node.pointer(), [&] { return named<Enum>(node.text()); });
}
void read_value(const View& node, std::array<double, 2>& range);
inline void read_value(const View& node, Quantity& value, Dimension dimension) {
    value = node.quantity(dimension);
}
void read_value(const View& node, Quantity& value, AnyUnit);
void read_value(const View& node, Stated& value, Dimension dimension);
inline void read_value(const View& node, std::vector<double>& values, Dimension dimension) {
    values = node.column(dimension);
}
void read_value(const View& node, Bounds& bounds, Dimension dimension);
/// A velocity, which must be positive and in m/s, because its interval is.
void read_value(const View& node, VelocityEstimate& velocity);
inline void read_value(const View& node, VelocityEstimate& velocity, WithoutInterval) {
    read_value(node, velocity);
}

/// The values of a column, NaN where they are null. @param values of {"values", "unit"}
[[nodiscard]] std::vector<double> read_column_with_gaps(const View& values, Dimension dimension);

/// The rows of a matrix.
[[nodiscard]] Json matrix_json(const Eigen::MatrixXd& matrix);
/// {"value", "unit", "standard_uncertainty"} of a result.
[[nodiscard]] Json estimate_json(const Interval& interval, std::string_view unit);
/// {"level", "lower", "upper"} of a result; an end that the data do not bound is null.
[[nodiscard]] Json interval_json(const Interval& interval, std::string_view unit);
/// A result with its interval, which is under its key and "_interval"; 0 without interval if it is missing.
[[nodiscard]] Interval read_estimate(const View& parent, const std::string& key, Dimension dimension);

}  // namespace ashimpact
