// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/drawing/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace ashimpact::report {

namespace {

constexpr double rounding = 1e-9;  // relative: a tick on the end of its axis counts

std::vector<double> linear_ticks(Range range, int most) {
    const double width = range.to - range.from;
    const double power = std::pow(10.0, std::floor(std::log10(width / most)));
    double step = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0}) {
        step = factor * power;
        if (std::floor(range.to / step + rounding) - std::ceil(range.from / step - rounding) + 1 <= most)
            break;
    }
    const double first = std::ceil(range.from / step - rounding);
    const auto count = static_cast<int>(std::floor(range.to / step + rounding) - first) + 1;
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(std::max(count, 0)));
    for (int i = 0; i < count; ++i) values.push_back((first + i) * step);
    return values;
}

std::vector<double> decade_ticks(Range range, std::span<const double> digits) {
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(range.from))) - 1;
    const auto last = static_cast<int>(std::ceil(std::log10(range.to)));
    for (int decade = first; decade <= last; ++decade)
        for (const double digit : digits) {
            const double value = digit * std::pow(10.0, decade);
            if (value >= range.from * (1 - rounding) && value <= range.to * (1 + rounding))
                values.push_back(value);
        }
    return values;
}

std::vector<double> logarithmic_ticks(Range range, int most) {
    constexpr std::array all{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
    constexpr std::array some{1.0, 2.0, 5.0};
    constexpr std::array one{1.0};
    for (const std::span<const double> digits :
         {std::span<const double>(all), std::span<const double>(some), std::span<const double>(one)}) {
        auto values = decade_ticks(range, digits);
        if (static_cast<int>(values.size()) <= most && values.size() >= 2) return values;
    }
    auto decades = decade_ticks(range, one);
    if (static_cast<int>(decades.size()) <= most) return linear_ticks(range, most);
    std::vector<double> thinned;
    const std::size_t every = decades.size() / static_cast<std::size_t>(most) + 1;
    for (std::size_t i = 0; i < decades.size(); i += every) thinned.push_back(decades[i]);
    return thinned;
}

}  // namespace

Scale::Scale(Spacing spacing, Range values, Range at) : spacing_(spacing), values_(values), at_(at) {}

double Scale::operator()(double value) const {
    const double share = spacing_ == Spacing::linear
                             ? (value - values_.from) / (values_.to - values_.from)
                             : std::log(value / values_.from) / std::log(values_.to / values_.from);
    return at_.from + share * (at_.to - at_.from);
}

std::vector<Tick> Scale::ticks(int most) const {
    std::vector<Tick> ticks;
    const auto values =
        spacing_ == Spacing::linear ? linear_ticks(values_, most) : logarithmic_ticks(values_, most);
    const double least = 1e-9 * std::max(std::abs(values_.from), std::abs(values_.to));
    for (const double value : values) {
        const double shown = spacing_ == Spacing::linear && std::abs(value) < least ? 0 : value;
        ticks.push_back({shown, number_label(shown)});
    }
    return ticks;
}

Range drawable(Range range, Spacing spacing) {
    if (!std::isfinite(range.from) || !std::isfinite(range.to) || range.from > range.to) range = {1, 2};
    if (spacing == Spacing::logarithmic) {
        if (!(range.to > 0)) return {0.1, 1};
        if (!(range.from > 0)) range.from = range.to * 1e-3;
        if (range.to < 1.05 * range.from) return {range.from / 1.5, range.to * 1.5};
        return range;
    }
    if (range.to - range.from > 1e-9 * std::max(std::abs(range.from), std::abs(range.to))) return range;
    const double half = range.to == 0 ? 1 : 0.1 * std::abs(range.to);
    return {range.from - half, range.to + half};
}

std::string number_label(double value) {
    std::string text = fmt::format("{:.6g}", value);
    const auto e = text.find('e');
    if (e == std::string::npos) return text;
    constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const int exponent = std::stoi(text.substr(e + 1));
    std::string power = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        power += raised[static_cast<std::size_t>(digit - '0')];
    const std::string mantissa = text.substr(0, e);
    return (mantissa == "1" ? "10" : mantissa + "·10") + power;
}

}  // namespace ashimpact::report
