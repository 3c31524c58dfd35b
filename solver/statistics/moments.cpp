#include "solver/statistics/moments.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

Moments Moments::of(std::span<const double> values) {
    Moments moments;
    if (values.empty()) return moments;
    const auto sum = [&](auto function) { return pairwise_sum(0, values.size(), function); };
    const auto count = static_cast<double>(values.size());
    const double guess = sum([&](std::size_t i) { return values[i]; }) / count;
    const double mean = guess + sum([&](std::size_t i) { return values[i] - guess; }) / count;
    const auto power = [&](std::size_t i) { return (values[i] - mean) * (values[i] - mean); };
    moments.count = values.size();
    moments.mean = mean;
    moments.second = sum(power);
    moments.third = sum([&](std::size_t i) { return power(i) * (values[i] - mean); });
    moments.fourth = sum([&](std::size_t i) { return power(i) * power(i); });
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    moments.minimum = *least;
    moments.maximum = *greatest;
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
