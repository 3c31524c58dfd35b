// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/values_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/json/view.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"
#include "pipeline/case/case_parts.hpp"

namespace ashimpact {

namespace {

std::optional<double> number_if(const View& node, std::string_view key, Dimension dimension) {
    const auto member = node.find(key);
    return member ? std::optional(member->number(dimension)) : std::nullopt;
}

}  // namespace

Json value_json(const Stated& stated, Dimension /*dimension*/) {
    Json json = stated.quantity;
    json["origin"] = name_of(stated.origin);
    if (!stated.source.empty()) json["source"] = stated.source;
    return json;
}

Json value_json(const Bounds& bounds, Dimension dimension) {
    return {{"level", confidence},
            {"lower", quantity_json(bounds.lower, dimension)},
            {"upper", quantity_json(bounds.upper, dimension)}};
}

Json value_json(const VelocityEstimate& velocity, WithoutInterval) {
    return make_quantity(velocity.value, Dimension::velocity, velocity.standard_uncertainty);
}

Json value_json(const VelocityEstimate& velocity) {
    Json json = value_json(velocity, WithoutInterval{});
    json["interval"] =
        velocity.interval ? value_json(*velocity.interval, Dimension::velocity) : Json(nullptr);
    if (velocity.method) json["method"] = name_of(*velocity.method);
    return json;
}

void read_value(const View& node, std::size_t& value) {
    value = static_cast<std::size_t>(std::max(0, node.integer()));
}

void read_value(const View& node, Law& value) {
    value = at_place(node.pointer(), [&] { return Law::named(node.text()); });
}

void read_value(const View& node, std::array<double, 2>& range) {
    const auto values = node.column(Dimension::fraction);
    if (values.size() != 2) node.fail("is not a range", "least and greatest");
    range = {values[0], values[1]};
}

void read_value(const View& node, Quantity& value, AnyUnit) {
    value = {.value = node.at("value").number(Dimension::fraction), .unit = node.at("unit").text()};
    value.standard_uncertainty = number_if(node, "standard_uncertainty", Dimension::fraction);
}

void read_value(const View& node, Stated& value, Dimension dimension) {
    value = read_stated(node, dimension);
}

void read_value(const View& node, Bounds& bounds, Dimension dimension) {
    bounds = {number_if(node, "lower", dimension), number_if(node, "upper", dimension)};
}

void read_value(const View& node, VelocityEstimate& velocity) {
    const View unit = node.at("unit");
    if (unit.text() != si_unit(Dimension::velocity))
        unit.fail("is " + in_quotes(unit.text()), std::string(si_unit(Dimension::velocity)));
    velocity = {.value = positive_quantity(node.at("value"), "critical velocity", Dimension::velocity).value};
    velocity.standard_uncertainty = number_if(node, "standard_uncertainty", Dimension::velocity);
    if (const auto interval = node.find("interval"))
        read_value(*interval, velocity.interval.emplace(), Dimension::velocity);
    if (const auto method = node.find("method")) read_value(*method, velocity.method.emplace());
}

std::vector<double> read_column_with_gaps(const View& values, Dimension dimension) {
    std::vector<double> column;
    for (const View& element : values.elements())
        column.push_back(element.json().is_null() ? std::numeric_limits<double>::quiet_NaN()
                                                  : element.number(dimension));
    return column;
}

Json matrix_json(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (const auto& row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
    return rows;
}

Json estimate_json(const Interval& interval, std::string_view unit) {
    Json json = quantity_json(interval.value, unit);
    if (std::isfinite(interval.standard_uncertainty))
        json["standard_uncertainty"] = interval.standard_uncertainty;
    return json;
}

Json interval_json(const Interval& interval, std::string_view unit) {
    const auto end = [&](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? quantity_json(*value, unit) : Json(nullptr);
    };
    return {{"level", confidence}, {"lower", end(interval.lower)}, {"upper", end(interval.upper)}};
}

Interval read_estimate(const View& parent, const std::string& key, Dimension dimension) {
    Interval result{};
    if (const auto member = parent.find(key)) {
        const Quantity quantity = member->quantity(dimension);
        result = {quantity.value, quantity.standard_uncertainty.value_or(0)};
    }
    if (const auto interval = parent.find(key + "_interval")) {
        result.lower = number_if(*interval, "lower", dimension);
        result.upper = number_if(*interval, "upper", dimension);
    }
    return result;
}

}  // namespace ashimpact
