// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <utility>

namespace ashimpact::test {

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

}  // namespace ashimpact::test
