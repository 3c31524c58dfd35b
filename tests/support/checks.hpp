// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/text/error.hpp"

namespace ashimpact::test {

/// |a - b| over the larger magnitude [1]; 0 when both are the same. doctest::Approx adds 1 to the scale, so
/// it lets every number of fly-ash size pass.
[[nodiscard]] inline double relative_difference(double a, double b) {
    if (a == b) return 0;
    return std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

/// The message of the InputError that @p action throws; empty if it throws none.
template <class Action>
[[nodiscard]] std::string input_error_of(Action&& action) {
    try {
        static_cast<void>(action());
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// Whether @p text contains @p part.
[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The largest deviation in a loop and where it was seen, so that one check after the loop names its worst
/// case: CHECK_MESSAGE(worst.deviation() < 1e-12, worst.where()).
class Worst {
  public:
    /// NaN is worse than any number.
    void see(double deviation, std::string where) {
        ++count_;
        if (std::isnan(deviation_) || deviation <= deviation_) return;
        deviation_ = deviation;
        where_ = std::move(where);
    }
    [[nodiscard]] double deviation() const { return deviation_; }
    [[nodiscard]] const std::string& where() const { return where_; }
    /// How many were seen: a loop that ran over nothing shows nothing.
    [[nodiscard]] int count() const { return count_; }

  private:
    double deviation_ = -1.0;
    std::string where_;
    int count_ = 0;
};

/// Whether this is a build with sanitizers, in which a program takes some ten times as long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace ashimpact::test
