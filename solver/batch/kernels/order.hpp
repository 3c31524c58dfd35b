// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/batch/lanes/number_task.hpp"

namespace ashimpact::batch {

/// Adhesion and damping numbers of scaled impacts.
struct NumberColumns {
    const double* adhesion;
    const double* damping;
};

/// An order of the impacts of a task in which similar ones are neighbours. It changes no result, only how
/// long the lanes of a block wait for each other.
class Order {
  public:
    /// @param impacts their places in the columns
    void sort(const NumberColumns& numbers, std::span<const std::uint16_t> impacts);
    [[nodiscard]] std::size_t operator[](std::size_t position) const { return place_[position]; }

  private:
    std::array<std::uint16_t, most_impacts> place_;
};

}  // namespace ashimpact::batch
