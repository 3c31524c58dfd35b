#pragma once

#include "solver/batch/kernel.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ashimpact::batch {

/// An order of the impacts of a task in which like ones are neighbours. It has no influence on results, only
/// on how long the lanes of a block wait for each other.
class Order {
  public:
    void sort(const double* adhesion, const double* damping, std::size_t count);
    [[nodiscard]] std::size_t operator[](std::size_t position) const { return place_[position]; }

  private:
    std::array<std::uint16_t, most_impacts> place_;
};

}  // namespace ashimpact::batch
