// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ashimpact {

namespace {

/// Sums over a part of the values, formed in turns in several places, so that one addition need not wait for
/// the one before.
struct PowerSums : DeviationSums {
    static constexpr std::size_t places = 4;
    static constexpr std::size_t longest = 128;  ///< part that is summed without halving it

    void add(double value, double centre) {
        const double deviation = value - centre;
        const double square = deviation * deviation;
        first += deviation;
        second += square;
        third += square * deviation;
        fourth += square * square;
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
    }
    void merge(const PowerSums& other) {
        first += other.first;
        second += other.second;
        third += other.third;
        fourth += other.fourth;
        minimum = std::min(minimum, other.minimum);
        maximum = std::max(maximum, other.maximum);
    }

    /// By halves: rounding grows with the logarithm of the number of values.
    [[nodiscard]] static PowerSums of(std::span<const double> values, double centre) {
        if (values.size() > longest) {
            PowerSums sums = of(values.first(values.size() / 2), centre);
            sums.merge(of(values.subspan(values.size() / 2), centre));
            return sums;
        }
        std::array<PowerSums, places> parts;
        std::size_t i = 0;
        for (; i + places <= values.size(); i += places)
            for (std::size_t k = 0; k < places; ++k) parts[k].add(values[i + k], centre);
        for (std::size_t k = 0; i < values.size(); ++i, ++k) parts[k].add(values[i], centre);
        for (std::size_t k = 1; k < places; ++k) parts[0].merge(parts[k]);
        return parts[0];
    }
};

double sum_of(std::span<const double> values) {
    constexpr std::size_t places = PowerSums::places;
    if (values.size() > PowerSums::longest)
        return sum_of(values.first(values.size() / 2)) + sum_of(values.subspan(values.size() / 2));
    std::array<double, places> parts{};
    std::size_t i = 0;
    for (; i + places <= values.size(); i += places)
        for (std::size_t k = 0; k < places; ++k) parts[k] += values[i + k];
    for (std::size_t k = 0; i < values.size(); ++i, ++k) parts[k] += values[i];
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
}

}  // namespace

Moments Moments::of(std::span<const double> values) {
    if (values.empty()) return {};
    const auto count = static_cast<double>(values.size());
    const double guess = sum_of(values) / count;
    PowerSums sums = PowerSums::of(values, guess);
    sums.count = count;
    sums.guess = guess;
    return of(sums);
}

Moments Moments::of(const DeviationSums& sums) {
    Moments moments;
    if (sums.count == 0) return moments;
    const double shift = sums.first / sums.count;  // of the mean from its guess: a rounding
    moments.count = static_cast<std::uint64_t>(sums.count);
    moments.mean = sums.guess + shift;
    moments.second = sums.second - shift * sums.first;
    moments.third = sums.third - shift * (3 * sums.second - 2 * shift * sums.first);
    moments.fourth =
        sums.fourth - shift * (4 * sums.third - shift * (6 * sums.second - 3 * shift * sums.first));
    moments.minimum = sums.minimum;
    moments.maximum = sums.maximum;
    return moments;
}

void Moments::merge(const Moments& other) {
    if (other.count == 0) return;
    if (count == 0) {
        *this = other;
        return;
    }
    const auto na = static_cast<double>(count);
    const auto nb = static_cast<double>(other.count);
    const double n = na + nb;
    const double delta = other.mean - mean;
    const double a = na / n;
    const double b = nb / n;
    const double square = delta * delta;
    fourth += other.fourth + square * square * na * b * (a * a - a * b + b * b) +
              6 * square * (a * a * other.second + b * b * second) +
              4 * delta * (a * other.third - b * third);
    third += other.third + square * delta * na * b * (a - b) + 3 * delta * (a * other.second - b * second);
    second += other.second + square * na * b;
    mean += delta * b;
    count += other.count;
    minimum = std::min(minimum, other.minimum);
    maximum = std::max(maximum, other.maximum);
}

double Moments::variance() const {
    return second / static_cast<double>(count - 1);
}

double Moments::skewness() const {
    return std::sqrt(static_cast<double>(count)) * third / (second * std::sqrt(second));
}

double Moments::excess_kurtosis() const {
    return static_cast<double>(count) * fourth / (second * second) - 3;
}

}  // namespace ashimpact
