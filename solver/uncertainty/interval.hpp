#pragma once

#include <optional>

namespace ashimpact {

/// The level of every interval.
inline constexpr double confidence = 0.95;

/// A result with its standard uncertainty and 95 % interval; an end that the data do not bound is missing.
struct Interval {
    double value;
    double standard_uncertainty;
    std::optional<double> lower{};
    std::optional<double> upper{};

    [[nodiscard]] bool contains(double x) const { return !(lower && x < *lower) && !(upper && x > *upper); }
};

/// Whether two results exclude one another: their intervals do not overlap.
[[nodiscard]] inline bool disjoint(const Interval& a, const Interval& b) {
    return (a.upper && b.lower && *a.upper < *b.lower) || (b.upper && a.lower && *b.upper < *a.lower);
}

}  // namespace ashimpact
