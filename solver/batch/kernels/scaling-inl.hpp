// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_SCALING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_SCALING_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_SCALING_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_SCALING_INL_HPP
#endif

#include <cstdint>
#include <span>

#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/lanes/number-inl.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/scale.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The values of a column from @p i on; past the @p count of them the last one again.
[[nodiscard]] HWY_INLINE Lanes read(const batch::Input& column, std::size_t i, std::size_t count) {
    if (column.single) return column.values[0];
    if (i + lane_count <= count) return Lanes::load(column.values + i);
    HWY_ALIGN double padded[lane_count];
    for (std::size_t k = 0; k < lane_count; ++k) padded[k] = column.values[i + k < count ? i + k : count - 1];
    return Lanes::load(padded);
}

[[nodiscard]] inline BasicContactPair<LaneNumber> read_pair(const batch::Inputs& in, std::size_t i,
                                                            std::size_t count) {
    BasicContactPair<LaneNumber> pair{.mass = LaneNumber(read(in.mass, i, count)),
                                      .effective_radius = LaneNumber(read(in.effective_radius, i, count)),
                                      .contact_modulus = LaneNumber(read(in.contact_modulus, i, count)),
                                      .work_of_adhesion = LaneNumber(read(in.work_of_adhesion, i, count))};
    for (std::size_t k = 0; k < in.parameters.count; ++k)
        pair.parameters.set(in.parameters.parameter[k]->name,
                            LaneNumber(read(in.parameters.values[k], i, count)));
    return pair;
}

/// The impacts of a task, scaled.
struct ScaledTask {
    static constexpr std::size_t capacity = batch::most_impacts + lane_count;
    HWY_ALIGN double adhesion[capacity];
    HWY_ALIGN double damping[capacity];
    HWY_ALIGN double length[capacity];  ///< [m]
    HWY_ALIGN double time[capacity];    ///< [s]
};

template <class F>
HWY_FLATTEN inline void scale_task(const batch::Inputs& in, std::size_t count, ScaledTask& out) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        const BasicContactPair<LaneNumber> pair = read_pair(in, i, count);
        const auto scale = BasicScale<LaneNumber>::of(pair, LaneNumber(read(in.velocity, i, count)));
        const LaneNumber adhesion = F::template ContactLaw<LaneNumber>::adhesion_number(pair, scale.length);
        adhesion.lanes().store(out.adhesion + i);
        (read(in.damping, i, count) / F::Damping::unit(scale).lanes()).store(out.damping + i);
        scale.length.lanes().store(out.length + i);
        scale.time().lanes().store(out.time + i);
    }
}

/// Places of impacts in their task.
class PlaceList {
  public:
    void add(std::size_t place) { place_[count_++] = static_cast<std::uint16_t>(place); }
    [[nodiscard]] std::span<const std::uint16_t> places() const { return {place_, count_}; }

    [[nodiscard]] static PlaceList all(std::size_t count) {
        PlaceList list;
        for (std::size_t i = 0; i < count; ++i) list.add(i);
        return list;
    }

  private:
    std::uint16_t place_[batch::most_impacts];  // the first count_ are filled
    std::size_t count_ = 0;
};

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
