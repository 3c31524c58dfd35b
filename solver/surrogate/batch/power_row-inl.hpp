// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_POWER_ROW_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_POWER_ROW_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_POWER_ROW_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_POWER_ROW_INL_HPP
#endif

#include <array>
#include <cstddef>

#include "solver/batch/lanes/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The powers of one number, consecutive ones in the lanes of a register.
class PowerRow {
  public:
    HWY_INLINE explicit PowerRow(double u) : powers_(1.0), next_(u) {
        const hn::RebindToUnsigned<Tag> integers;
        const auto lane = hn::Iota(integers, 0);
        for (std::size_t bit = 1; bit < lane_count; bit *= 2) {
            const Mask has_bit = hn::RebindMask(Tag(), hn::TestBit(lane, hn::Set(integers, bit)));
            powers_ = select(has_bit, powers_ * next_, powers_);
            next_ = next_ * next_;
        }
    }

    /// The sum of coefficients times powers.
    template <std::size_t registers>
    [[nodiscard]] HWY_INLINE double sum(const std::array<Lanes, registers>& coefficients) const {
        Lanes sum = coefficients[registers - 1];
        for (std::size_t k = registers - 1; k-- > 0;) sum = multiply_add(sum, next_, coefficients[k]);
        return hn::GetLane(hn::SumOfLanes(Tag(), (sum * powers_).v));
    }

  private:
    Lanes powers_;  ///< 1, u, u^2, ...
    Lanes next_;    ///< u to the number of lanes
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
