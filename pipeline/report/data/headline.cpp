#include "pipeline/report/data/headline.hpp"

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
    if (entry.contains("headline")) {
        const Json& stated = entry.at("headline");
        headline.value = number_in(entry, "headline");
        if (stated.contains("interval")) read_interval(stated.at("interval"), headline);
        if (stated.contains("method")) headline.method = stated.at("method").get<std::string>();
        return headline;
    }
    headline.value = number_in(entry, "critical_velocity");
    if (entry.contains("interval")) read_interval(entry.at("interval"), headline);
    return headline;
}

std::string text_of(const Headline& headline) {
    if (!headline.value) return "no finite value";
    std::string text = fmt::format("{:#.3g} m/s", *headline.value);
    if (!headline.with_interval) return text;
    const auto end = [](const std::optional<double>& value) {
        return value ? fmt::format("{:#.3g}", *value) : "open";
    };
    return text + fmt::format(" (95 %: {} to {} m/s)", end(headline.lower), end(headline.upper));
}

}  // namespace ashimpact::report
