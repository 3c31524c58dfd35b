// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/short_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

std::string quantity_text(const Json& value) {
    std::string text = readable(shown_quantity(value));
    const std::string origin = value.value("origin", "");
    if (!origin.empty() && origin != "given" && origin != "computed") text += fmt::format("  ({})", origin);
    return text;
}

/// "1.471 to 1.613 m/s (95 %)".
std::string interval_text(const Json& interval) {
    const auto end = [&](const char* key) {
        const Json& value = interval.at(key);
        if (is_quantity(value)) return quantity_text(value);
        return value.is_number() ? cell_number(value.get<double>()) : std::string("open");
    };
    const std::string level = fmt::format(" ({:g} %)", 100 * interval.at("level").get<double>());
    if (interval.at("lower").is_null() && interval.at("upper").is_null()) return "-";
    std::string lower = end("lower");
    const std::string upper = end("upper");
    const auto unit = [](const std::string& text) {
        return text.substr(std::min(text.size(), text.find(' ')));
    };
    if (unit(lower) == unit(upper)) lower.resize(lower.size() - unit(lower).size());
    return lower + " to " + upper + level;
}

/// A string, number, truth value or null.
std::string scalar_text(const Json& value) {
    if (value.is_null()) return "-";
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        return text.empty() ? "\"\"" : text;
    }
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) return cell_number(value.get<double>());
    return value.dump();
}

/// A column of one number.
bool is_single(const Json& value) {
    return value.is_object() && value.contains("values") && value.contains("unit") &&
           value["unit"].is_string() && value["values"].is_array() && value["values"].size() == 1 &&
           value["values"].front().is_number();
}

}  // namespace

bool is_quantity(const Json& value) {
    return value.is_object() && value.contains("value") && value.contains("unit") &&
           value["value"].is_number() && value["unit"].is_string();
}

bool is_column(const Json& value) {
    return value.is_object() && value.contains("values") && value.contains("unit") &&
           value["unit"].is_string() && value["values"].is_array() && value["values"].size() != 1 &&
           std::all_of(value["values"].begin(), value["values"].end(),
                       [](const Json& v) { return v.is_number(); });
}

bool is_interval(const Json& value) {
    if (!value.is_object() || value.size() != 3 || !value.contains("level") || !value.contains("lower") ||
        !value.contains("upper") || !value["level"].is_number())
        return false;
    const auto is_end = [](const Json& end) { return end.is_null() || end.is_number() || is_quantity(end); };
    return is_end(value["lower"]) && is_end(value["upper"]);
}

std::string cell_number(double value, int digits) {
    constexpr double least = 1e-12;
    return std::abs(value) < least ? "0" : readable_number(value, digits);
}

std::optional<std::string> short_text(const Json& value) {
    if (is_quantity(value)) return quantity_text(value);
    if (is_interval(value)) return interval_text(value);
    if (is_single(value))
        return readable(value["values"].front().get<double>(), value["unit"].get<std::string>());
    if (!value.is_structured()) return scalar_text(value);
    if (value.empty()) return "none";
    if (!value.is_array()) return std::nullopt;
    std::vector<std::string> list;
    for (const Json& element : value) {
        if (element.is_structured()) return std::nullopt;
        list.push_back(scalar_text(element));
    }
    return joined(list);
}

}  // namespace ashimpact
