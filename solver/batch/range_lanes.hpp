// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace ashimpact::batch {

/// Values that a column may have.
struct Range {
    double least;
    double greatest;
    bool or_zero = false;

    [[nodiscard]] bool holds(double value) const {
        return (value >= least && value <= greatest) || (or_zero && value == 0.0);
    }
};

/// How many values are in a range, until the first that is not; at most @p count. Several values are looked
/// at in each instruction.
[[nodiscard]] std::size_t count_within(const Range& range, const double* values, std::size_t count);

}  // namespace ashimpact::batch
