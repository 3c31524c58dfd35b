// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/answer.hpp"

#include <fmt/format.h>

namespace ashimpact {

std::string velocity_text(double velocity) {
    return fmt::format("{:#.3g}", velocity);
}

std::string bounds_text(const std::optional<Bounds>& bounds) {
    if (!bounds || (!bounds->lower && !bounds->upper)) return {};
    const auto end = [](const std::optional<double>& value) {
        return value ? velocity_text(*value) : std::string("open");
    };
    return end(bounds->lower) + " to " + end(bounds->upper);
}

std::string estimate_text(const std::optional<VelocityEstimate>& velocity) {
    if (!velocity) return "no finite value";
    const std::string bounds = bounds_text(velocity->interval);
    return velocity_text(velocity->value) + " m/s" + (bounds.empty() ? "" : " (95 %: " + bounds + " m/s)");
}

std::string_view verdict_words(const std::optional<CriticalVelocityCheck>& check) {
    if (!check) return {};
    switch (check->verdict) {
        case CriticalVelocityVerdict::agrees:
            return "agrees";
        case CriticalVelocityVerdict::model_too_low:
            return "too low";
        case CriticalVelocityVerdict::model_too_high:
            return "too high";
        case CriticalVelocityVerdict::not_comparable:
            break;
    }
    return {};
}

bool is_extrapolated(const LawComparison& law) {
    return law.velocity && law.extrapolated && law.velocity->method == VelocityMethod::extrapolation;
}

Answer answer_of(const ReportedVelocity& reported) {
    if (reported.velocity) return {Answer::Kind::velocity, reported.velocity->value};
    if (reported.interval && reported.interval->lower)
        return {Answer::Kind::above, *reported.interval->lower};
    if (reported.interval && reported.interval->upper)
        return {Answer::Kind::below, *reported.interval->upper};
    return {};
}

}  // namespace ashimpact
