// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_GROUPS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_GROUPS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_GROUPS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_GROUPS_INL_HPP
#endif

#include <array>
#include <cstddef>

#include "solver/batch/lanes/equation-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Number of registers advanced together, so that the arithmetic of one hides the latency of another.
inline constexpr std::size_t group_count = 4;
template <class T>
using Groups = std::array<T, group_count>;

/// The change of a state in one step, with an estimate of its error.
struct LaneStep {
    LaneState change;
    Lanes position_error;
    Lanes momentum_error;
    Lanes end_stiffness;  ///< h(q) at the end, to second order
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
