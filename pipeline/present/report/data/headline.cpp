// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/data/headline.hpp"

#include <fmt/format.h>

namespace ashimpact::report {

namespace {

void read_interval(const Json& interval, Headline& headline) {
    if (!interval.is_object()) return;
    headline.with_interval = true;
    headline.lower = number_in(interval, "lower");
    headline.upper = number_in(interval, "upper");
}

}  // namespace

std::optional<double> number_in(const Json& object, const char* key) {
    if (!object.is_object() || !object.contains(key)) return std::nullopt;
    const Json& member = object.at(key);
    if (member.is_number()) return member.get<double>();
    if (!member.is_object() || !member.contains("value") || !member.at("value").is_number())
        return std::nullopt;
    return member.at("value").get<double>();
}

Headline headline_of(const Json& entry) {
    Headline headline;
    headline.value = number_in(entry, "critical_velocity");
    if (!headline.value) return headline;
    const Json& velocity = entry.at("critical_velocity");
    if (velocity.contains("interval"))
        read_interval(velocity.at("interval"), headline);
    else if (entry.contains("interval"))
        read_interval(entry.at("interval"), headline);
    if (velocity.contains("method")) headline.method = velocity.at("method").get<std::string>();
    return headline;
}

std::string interval_text(const std::optional<double>& lower, const std::optional<double>& upper) {
    const auto end = [](const std::optional<double>& value) {
        return value ? fmt::format("{:#.3g}", *value) : std::string("open");
    };
    return end(lower) + " to " + end(upper);
}

std::string text_of(const Headline& headline) {
    if (!headline.value) return "no finite value";
    std::string text = fmt::format("{:#.3g} m/s", *headline.value);
    if (headline.with_interval)
        text += fmt::format(" (95 %: {} m/s)", interval_text(headline.lower, headline.upper));
    return text;
}

}  // namespace ashimpact::report
