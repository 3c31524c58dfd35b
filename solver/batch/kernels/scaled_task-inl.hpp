// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_SCALED_TASK_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_SCALED_TASK_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_SCALED_TASK_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_SCALED_TASK_INL_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/lanes/follow-inl.hpp"
#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/zone_curve.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/scale.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// The values of a column from @p i on; past the @p count of them the last one again.
[[nodiscard]] HWY_INLINE Lanes read(const batch::Input& column, std::size_t i, std::size_t count) {
    if (column.size == 1) return column.values[0];
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
                                      .work_of_adhesion = LaneNumber(read(in.work_of_adhesion, i, count)),
                                      .yield_pressure = LaneNumber(read(in.yield_pressure, i, count))};
    for (std::size_t k = 0; k < in.parameter_count; ++k)
        pair.parameters.set(in.parameters[k].parameter->name,
                            LaneNumber(read(in.parameters[k].values, i, count)));
    return pair;
}

/// Adhesion numbers at which a cohesive zone is followed: beyond them adhesion or inertia is lost beside the
/// other, or the turn lies beyond the curve's pieces.
inline constexpr double least_zone_adhesion = 1e-5;
inline constexpr double most_zone_adhesion = 1e2;

/// The transition parameters of the impacts of a task, and the curves of those that are followed.
class ZoneCurves {
  public:
    void find(const batch::Inputs& in, std::size_t count) {
        lambda_.resize(count);
        curve_.assign(count, nullptr);
        batch::find_transition_parameters(in, count, lambda_.data());
    }
    /// @return those of the impacts that a curve admits
    template <class List>
    [[nodiscard]] List fill(const List& impacts, DampingLaw damping_law, Detachment detachment) {
        List admitted;
        const auto places = impacts.places();
        std::array<const batch::ZoneBand*, batch::ZoneSpans::count> bands{};
        const auto band_of = [&](double lambda) -> const batch::ZoneBand& {
            const batch::ZoneBand*& band = bands[batch::ZoneSpans::index(lambda)];
            if (band == nullptr) band = &batch::ZoneBand::of(lambda, damping_law);
            return *band;
        };
        all_.clear();
        all_.reserve(places.size());
        for (std::size_t k = 0; k < places.size(); ++k) {
            const std::size_t i = places[k];
            const auto same = [&](std::size_t other) { return lambda_[places[other]] == lambda_[i]; };
            if (k > 0 && same(k - 1)) {
                curve_[i] = curve_[places[k - 1]];
            } else {
                batch::ZoneCurve& curve = all_.emplace_back(lambda_[i], band_of(lambda_[i]), detachment);
                curve_[i] = curve.admissible() ? &curve : nullptr;
                if (k + many < places.size() && same(k + many)) curve.keep_pieces();
            }
            if (curve_[i] != nullptr) admitted.add(i);
        }
        return admitted;
    }
    [[nodiscard]] double lambda(std::size_t i) const { return lambda_[i]; }  ///< NaN: beyond the law's range
    [[nodiscard]] const batch::ZoneCurve* const* curves() const { return curve_.data(); }

  private:
    static constexpr std::size_t many = 8;  ///< impacts of one curve for which it keeps its pieces

    std::vector<double> lambda_;
    std::vector<batch::ZoneCurve> all_;
    std::vector<const batch::ZoneCurve*> curve_;
};

/// The impacts of a task, scaled.
struct ScaledTask {
    static constexpr std::size_t capacity = batch::most_impacts + lane_count;
    HWY_ALIGN double adhesion[capacity];
    HWY_ALIGN double damping[capacity];
    HWY_ALIGN double length[capacity];          ///< [m]
    HWY_ALIGN double time[capacity];            ///< [s]
    HWY_ALIGN double yield_number[capacity];    ///< of a law that yields
    HWY_ALIGN double yield_adhesion[capacity];  ///< the same
    ZoneCurves zones;                           ///< of a law with a cohesive zone

    template <class F>
    [[nodiscard]] batch::NumberColumns numbers(DampingLaw damping_law) const {
        return {adhesion, damping, damping_law, zones.curves(), F::yields ? yield_number : nullptr};
    }
};

/// The adhesion number of a form's law.
template <class F>
[[nodiscard]] HWY_INLINE LaneNumber adhesion_number_of(const BasicContactPair<LaneNumber>& pair,
                                                       const LaneNumber& length) {
    if constexpr (std::is_same_v<F, ZoneForm>)
        return Jkr<LaneNumber>::adhesion_number(pair, length);
    else
        return F::template ContactLaw<LaneNumber>::adhesion_number(pair, length);
}
/// The coefficient of a damping law whose number is 1.
template <class F>
[[nodiscard]] HWY_INLINE LaneNumber damping_unit_of(const BasicScale<LaneNumber>& scale, DampingLaw law) {
    if constexpr (std::is_same_v<F, ZoneForm>)
        return scale.damping_unit(law);
    else
        return F::Damping::units(scale)[0];
}

template <class F>
HWY_FLATTEN inline void scale_task(const batch::Inputs& in, std::size_t count, DampingLaw damping_law,
                                   ScaledTask& out) {
    for (std::size_t i = 0; i < count; i += lane_count) {
        const BasicContactPair<LaneNumber> pair = read_pair(in, i, count);
        const auto scale = BasicScale<LaneNumber>::of(pair, LaneNumber(read(in.velocity, i, count)));
        adhesion_number_of<F>(pair, scale.length).lanes().store(out.adhesion + i);
        (read(in.damping, i, count) / damping_unit_of<F>(scale, damping_law).lanes()).store(out.damping + i);
        scale.length.lanes().store(out.length + i);
        scale.time().lanes().store(out.time + i);
        if constexpr (F::yields) {
            using Law = typename F::template ContactLaw<LaneNumber>;
            Law::yield_number(pair, scale.length).lanes().store(out.yield_number + i);
            Law::yield_adhesion(pair).lanes().store(out.yield_adhesion + i);
        }
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
