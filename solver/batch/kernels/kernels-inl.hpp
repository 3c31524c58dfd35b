// SPDX-License-Identifier: GPL-3.0-or-later
// Included once for each instruction set, so with no include guard but this.
#if defined(ASHIMPACT_SOLVER_BATCH_KERNELS_KERNELS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef ASHIMPACT_SOLVER_BATCH_KERNELS_KERNELS_INL_HPP
#undef ASHIMPACT_SOLVER_BATCH_KERNELS_KERNELS_INL_HPP
#else
#define ASHIMPACT_SOLVER_BATCH_KERNELS_KERNELS_INL_HPP
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <hwy/contrib/math/math-inl.h>

#include "solver/batch/kernels/damping_search.hpp"
#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/kernels/scaled_task-inl.hpp"
#include "solver/batch/kernels/yield_lookup-inl.hpp"
#include "solver/batch/lanes/follow-inl.hpp"
#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/lookup-inl.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/scale.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// Writes the end of an impact into the results of its task.
inline void write_end(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i,
                      const Block& block, std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const bool rebounds = block.rebounds(lane);
    task.end[i] = block.end(lane);
    task.restitution[i] = rebounds ? std::min(block.speed[lane], 1.0) : 0.0;
    task.contact_time[i] = rebounds ? block.time[lane] * scaled.time[i] : nothing;
}

/// Writes the turning point of an impact; a greatest overlap of NaN if it is in doubt.
inline void write_turn(const batch::ImpactTask& task, const ScaledTask& scaled, std::size_t i,
                       const Block& block, std::size_t lane) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    task.approach_time[i] = block.turn_time[lane] * scaled.time[i];
    task.maximum_overlap[i] = block.turns(lane) ? block.turn_overlap[lane] * scaled.length[i] : nothing;
}

/// Coordinates in a table for a column of numbers.
inline void place_all(const double* numbers, std::size_t count, double* places) {
    for (std::size_t i = 0; i < count; i += lane_count) place_of(Lanes::load(numbers + i)).store(places + i);
}

/// The places of the impacts of a task in a table of their law.
template <class F>
class TablePlaces {
  public:
    static constexpr bool layered = std::is_same_v<F, ZoneForm>;

    TablePlaces(const ScaledTask& scaled, std::size_t count) : scaled_(scaled) {
        place_all(scaled.damping, count, y_);
        if constexpr (!layered) {
            place_all(scaled.adhesion, count, x_);
        } else {
            const Lanes scale(1.0 / batch::RestitutionTable::zone_powers);
            const Lanes first(batch::RestitutionTable::zone_least_power);
            for (std::size_t i = 0; i < count; i += lane_count) {
                const Lanes power(hn::Log2(Tag(), max(Lanes::load(scaled.adhesion + i), 1e-300).v));
                ((power - first) * scale).store(x_ + i);
            }
        }
    }
    [[nodiscard]] HWY_INLINE batch::RestitutionTable& table(batch::RestitutionTable& law, std::size_t i) {
        if constexpr (!layered) return law;
        const double lambda = scaled_.zones.lambda(i);
        if (of_lambda_ == nullptr || lambda != lambda_) {  // one size has one
            of_lambda_ = &law.at_number<batch::ZoneSpans>(lambda);
            lambda_ = lambda;
            z_ = of_lambda_->z(lambda);
        }
        return *of_lambda_;
    }
    /// In the table that was asked for last.
    [[nodiscard]] HWY_INLINE TablePlace at(std::size_t i) const { return {x_[i], y_[i], z_}; }

  private:
    const ScaledTask& scaled_;
    batch::RestitutionTable* of_lambda_ = nullptr;
    double lambda_ = 0.0;
    double z_ = 0.0;
    HWY_ALIGN double x_[ScaledTask::capacity];
    HWY_ALIGN double y_[ScaledTask::capacity];
};

/// Reads the results of impacts of one branch from the table of a task.
/// @param open gets impacts that have to be integrated
template <bool with_time, class F>
HWY_NOINLINE void look_up_whole(const batch::ImpactTask& task, const ScaledTask& scaled, const PlaceList& all,
                                PlaceList& open) {
    TablePlaces<F> places(scaled, task.count);
    const batch::RestitutionPiece* pieces[batch::most_impacts];
    TablePlace at[batch::most_impacts];
    for (const std::size_t i : all.places()) {
        batch::RestitutionTable& table = places.table(*task.table, i);
        at[i] = places.at(i);
        pieces[i] = table.at(at[i].x, at[i].y);
    }
    for (const std::size_t i : all.places()) {
        const TableEntry impact = entry_at<with_time, TablePlaces<F>::layered>(pieces[i], at[i]);
        if (impact.end == batch::LaneEnd::undecided) open.add(i);
        task.end[i] = impact.end;
        task.restitution[i] = impact.speed;
        task.contact_time[i] = impact.time * scaled.time[i];
    }
}

/// Reads the results of a task from its table. @return impacts that have to be integrated
template <bool with_time, class F>
[[nodiscard]] HWY_INLINE PlaceList look_up(const batch::ImpactTask& task, const ScaledTask& scaled,
                                           const PlaceList& all) {
    PlaceList open;
    if constexpr (F::yields) {
        PlaceList elastic;
        open = look_up_yielding<with_time, F>(task, scaled, all, elastic);
        look_up_whole<with_time, F>(task, scaled, elastic, open);
    } else {
        look_up_whole<with_time, F>(task, scaled, all, open);
    }
    return open;
}

/// Impacts on their way through a block, group by group.
template <class F, class Write>
class Queue {
  public:
    /// @param write called with (place of the impact, block, lane) for each impact integrated
    Queue(const batch::NumberColumns& numbers, std::span<const std::uint16_t> impacts, const Write& write)
        : numbers_(numbers), order_(numbers, impacts), size_(impacts.size()), write_(write) {}

    [[nodiscard]] bool empty() const { return next_ == size_; }

    /// Loads the next impacts into a group; without any left the last one again, of which nothing is written.
    HWY_INLINE void load(Block& block, std::size_t group) {
        first_[group] = next_;
        used_[group] = std::min(lane_count, size_ - next_);
        next_ += used_[group];
        for (std::size_t k = 0; k < lane_count; ++k) {
            const std::size_t i = order_[std::min(first_[group] + k, size_ - 1)];
            const std::size_t lane = group * lane_count + k;
            block.adhesion[lane] = numbers_.adhesion[i];
            block.damping[lane] = numbers_.damping[i];
            if constexpr (std::is_same_v<F, ZoneForm>) block.curve[lane] = numbers_.curve[i];
            if constexpr (F::yields)
                block.yield_number[lane] = numbers_.yield_number != nullptr
                                               ? numbers_.yield_number[i]
                                               : std::numeric_limits<double>::infinity();
        }
    }
    /// Writes the results of a group.
    HWY_INLINE void write(const Block& block, std::size_t group) const {
        for (std::size_t k = 0; k < used_[group]; ++k)
            write_(order_[first_[group] + k], block, group * lane_count + k);
    }
    [[nodiscard]] Supply supply() {
        return {[](void* context, Block& block, std::size_t group) HWY_ATTR {
                    Queue& queue = *static_cast<Queue*>(context);
                    if (queue.empty()) return false;
                    queue.write(block, group);
                    queue.load(block, group);
                    return true;
                },
                this};
    }

  private:
    const batch::NumberColumns& numbers_;
    batch::Order order_;
    std::size_t size_;
    const Write& write_;
    std::size_t next_ = 0;
    std::size_t first_[group_count];
    std::size_t used_[group_count];
};

/// Integrates impacts, given by their numbers. Neighbours in a block are similar, so that its lanes end
/// together.
/// @param write called with (place of the impact, block, lane) for each impact integrated
template <class F, class Write>
HWY_INLINE void follow_all(const batch::NumberColumns& numbers, std::span<const std::uint16_t> impacts,
                           Detachment detachment, Goal goal, const Write& write) {
    Queue<F, Write> queue(numbers, impacts, write);
    const ZoneDamping law(numbers.damping_law);
    while (!queue.empty()) {
        Block block;
        block.law = &law;
        for (std::size_t group = 0; group < group_count; ++group) queue.load(block, group);
        follow<F>(block, detachment, goal, queue.supply());
        for (std::size_t group = 0; group < group_count; ++group) queue.write(block, group);
    }
}

/// Whether the lanes follow an impact: the contact does not yield by adhesion alone, nor at next to nothing.
[[nodiscard]] inline bool yields_as_followed(double adhesion, double yield_number) {
    constexpr double least_ratio = 0.51;  // of the third root of its square; yields at touch below 0.5
    constexpr double least = 1e-6;
    const double least_cube = power<3>(least_ratio) * adhesion * adhesion;
    return yield_number > least && power<3>(yield_number) > least_cube;
}

/// Scales the problems of a task. @return those that the kernels solve
template <class F, class Task>
[[nodiscard]] PlaceList scaled_places(const Task& task, ScaledTask& scaled) {
    scale_task<F>(task.inputs, task.count, task.damping_law, scaled);
    PlaceList places;
    if constexpr (F::yields) {
        for (std::size_t i = 0; i < task.count; ++i)
            if (yields_as_followed(scaled.adhesion[i], scaled.yield_number[i])) places.add(i);
        return places;
    }
    if constexpr (!std::is_same_v<F, ZoneForm>) return PlaceList::all(task.count);
    scaled.zones.find(task.inputs, task.count);
    for (std::size_t i = 0; i < task.count; ++i)
        if (!std::isnan(scaled.zones.lambda(i)) && scaled.adhesion[i] > least_zone_adhesion &&
            scaled.adhesion[i] < most_zone_adhesion)
            places.add(i);
    return places;
}

/// Those of the problems that can be integrated.
template <class F, class Task>
[[nodiscard]] PlaceList to_integrate(const Task& task, ScaledTask& scaled, const PlaceList& places) {
    if constexpr (!std::is_same_v<F, ZoneForm>) return places;
    return scaled.zones.fill(places, task.damping_law, task.detachment);
}

/// Solves the impacts of a task: scales them, reads results from the table if there is one, and integrates
/// the others. A table has no turning points: they are integrated in a second pass.
template <class F>
HWY_NOINLINE void solve_task(const batch::ImpactTask& task) {
    ScaledTask scaled;
    const PlaceList all = scaled_places<F>(task, scaled);
    const auto follow_to = [&](Goal goal, const PlaceList& places) HWY_ATTR {
        const PlaceList impacts = to_integrate<F>(task, scaled, places);
        follow_all<F>(scaled.numbers<F>(task.damping_law), impacts.places(), task.detachment, goal,
                      [&](std::size_t i, const Block& block, std::size_t lane) HWY_ATTR {
                          if (goal != Goal::turn) write_end(task, scaled, i, block, lane);
                          if (goal != Goal::end) write_turn(task, scaled, i, block, lane);
                      });
    };
    if constexpr (std::is_same_v<F, ZoneForm> || F::yields) {  // what the kernels do not follow
        std::fill_n(task.end, task.count, batch::LaneEnd::undecided);
        if (task.turning_point)
            std::fill_n(task.maximum_overlap, task.count, std::numeric_limits<double>::quiet_NaN());
    }
    if (task.table == nullptr) {
        follow_to(task.turning_point ? Goal::end_and_turn : Goal::end, all);
        return;
    }
    const PlaceList open =
        task.with_contact_time ? look_up<true, F>(task, scaled, all) : look_up<false, F>(task, scaled, all);
    follow_to(Goal::end, open);
    if (task.turning_point) follow_to(Goal::turn, all);
}

/// Solves the returns of contacts at rest, given by their numbers.
template <class F>
HWY_NOINLINE void release_numbers(const batch::NumberTask& task) {
    for (std::size_t first = 0; first < task.count; first += block_size) {
        Block block;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t i = std::min(first + lane, task.count - 1);
            block.adhesion[lane] = task.adhesion[i];
            block.damping[lane] = task.damping[i];
        }
        follow_release<F>(block, task.detachment);
        for (std::size_t i = first; i < std::min(first + block_size, task.count); ++i) {
            task.end[i] = block.end(i - first);
            task.speed[i] = block.speed[i - first];
            task.time[i] = block.time[i - first];
        }
    }
}

/// Solves impacts, or a part of them, given by their numbers.
template <class F>
HWY_NOINLINE void solve_numbers(const batch::NumberTask& task) {
    if constexpr (F::yields)
        if (task.part == batch::ImpactPart::release) return release_numbers<F>(task);
    const PlaceList all = PlaceList::all(task.count);
    batch::ZoneCurve own;  // of this thread
    if (task.curve != nullptr) {
        own = *task.curve;
        own.keep_pieces();
    }
    const std::vector<const batch::ZoneCurve*> curves(task.curve != nullptr ? task.count : 0, &own);
    const bool whole = task.part == batch::ImpactPart::whole;
    follow_all<F>({task.adhesion, task.damping, task.damping_law, curves.data(), task.yield_number},
                  all.places(), task.detachment, whole ? Goal::end : Goal::turn,
                  [&](std::size_t i, const Block& block, std::size_t lane) HWY_ATTR {
                      const bool turns = block.turns(lane) && !std::isnan(block.turn_time[lane]);
                      const batch::LaneEnd turn = turns ? batch::LaneEnd::rebound : batch::LaneEnd::undecided;
                      task.end[i] = whole ? block.end(lane) : turn;
                      task.speed[i] = whole ? block.speed[lane] : block.turn_place[lane];
                      task.time[i] = whole ? block.time[lane] : block.turn_time[lane];
                  });
}

inline constexpr int most_trials = 16;  ///< impacts after which a search is left to the scalar solver

/// e_0, the restitution without damping: only the energy spent at detachment is lost. 0 if that exceeds the
/// kinetic energy.
template <class F>
HWY_INLINE void undamped_restitutions(const ScaledTask& scaled, Detachment detachment, std::size_t count,
                                      double* out) {
    if constexpr (std::is_same_v<F, ZoneForm>) {
        for (std::size_t i = 0; i < count; ++i) {
            const batch::ZoneCurve* const curve = scaled.zones.curves()[i];
            const double unit = std::pow(0.375 * scaled.adhesion[i] * scaled.adhesion[i], 5.0 / 3.0);
            const double cost =
                curve != nullptr ? unit * (curve->end().potential - curve->begin().potential) : 1.0;
            out[i] = std::sqrt(std::max(1.0 - 2.0 * cost, 0.0));
        }
    } else {
        for (std::size_t i = 0; i < count; i += lane_count) {
            const Equation<F> equation({Lanes::load(scaled.adhesion + i)}, Lanes(0.0));
            const Places places = places_of(equation, detachment);
            const Lanes cost = places.end_potential - equation.potential(places.touch);
            HWY_ALIGN double values[lane_count];
            sqrt(max(subtract_product(Lanes(1.0), Lanes(2.0), cost), 0.0)).store(values);
            for (std::size_t k = 0; k < lane_count && i + k < count; ++k) out[i + k] = values[k];
        }
    }
}

/// Searches the dampings of the impacts of one block, each lane independently.
template <class F>
HWY_INLINE void search(Block& block, Detachment detachment, batch::DampingSearch* searches) {
    for (int trial = 0; trial < most_trials; ++trial) {
        bool all_found = true;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            all_found = all_found && searches[lane].found();
            block.damping[lane] = searches[lane].number();
        }
        if (all_found) return;
        follow<F>(block, detachment, Goal::end);
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            if (searches[lane].found()) continue;
            searches[lane].observe(block.rebounds(lane) ? block.speed[lane] : 0.0);
        }
    }
}

/// Searches the damping of one impact in a table. @return whether it was found there
template <class F>
HWY_INLINE bool search(batch::RestitutionTable& table, TablePlace place, batch::DampingSearch& search) {
    for (int trial = 0; trial < most_trials && !search.found(); ++trial) {
        place.y = search.number() / (1.0 + search.number());
        const TableEntry impact = entry_at<false, TablePlaces<F>::layered>(table.at(place.x, place.y), place);
        if (impact.end == batch::LaneEnd::undecided) return false;
        search.observe(impact.speed);
    }
    return search.found();
}

/// Searches, by integration, the dampings of the impacts that a table left open. @param start first guesses
template <class F>
HWY_INLINE void search_all(const batch::InversionTask& task, const ScaledTask& scaled, const double* start,
                           const PlaceList& open) {
    const std::span<const std::uint16_t> places = open.places();
    const batch::Order order({scaled.adhesion, start, task.damping_law}, places);
    const ZoneDamping law(task.damping_law);
    for (std::size_t first = 0; first < places.size(); first += block_size) {
        const std::size_t used = std::min(places.size() - first, block_size);
        Block block;
        block.law = &law;
        std::array<batch::DampingSearch, block_size> searches;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            const std::size_t i = order[first + (lane < used ? lane : used - 1)];
            block.adhesion[lane] = scaled.adhesion[i];
            if constexpr (std::is_same_v<F, ZoneForm>) block.curve[lane] = scaled.zones.curves()[i];
            searches[lane] =
                batch::DampingSearch(task.damping_law, task.inputs.restitution.at(i), task.undamped[i]);
        }
        search<F>(block, task.detachment, searches.data());
        for (std::size_t lane = 0; lane < used; ++lane) {
            task.number[order[first + lane]] = searches[lane].number();
            task.found[order[first + lane]] = searches[lane].found() ? 1 : 0;
        }
    }
}

template <class F>
HWY_NOINLINE void invert_task(const batch::InversionTask& task) {
    std::fill_n(task.found, task.count, std::uint8_t{0});
    if constexpr (F::yields) return;  // beyond yield e may rise with the damping
    ScaledTask scaled;
    const PlaceList all = to_integrate<F>(task, scaled, scaled_places<F>(task, scaled));
    undamped_restitutions<F>(scaled, task.detachment, task.count, task.undamped);
    TablePlaces<F> places(scaled, task.count);
    const auto found_in_table = [&](std::size_t i, batch::DampingSearch& own) HWY_ATTR {
        if (task.table == nullptr) return false;
        batch::RestitutionTable& table = places.table(*task.table, i);
        return search<F>(table, places.at(i), own);
    };
    double start[batch::most_impacts];  // first damping number of each search
    PlaceList open;
    for (const std::size_t i : all.places()) {
        batch::DampingSearch own(task.damping_law, task.inputs.restitution.at(i), task.undamped[i]);
        start[i] = own.number();
        if (!found_in_table(i, own)) open.add(i);
        task.number_unit[i] = 1.0 / scaled.damping[i];
        task.number[i] = own.number();
        task.found[i] = own.found() ? 1 : 0;
    }
    search_all<F>(task, scaled, start, open);
}

/// Some critical velocities on their way through the table.
struct CriticalBlock {
    static constexpr std::size_t size = 128;
    HWY_ALIGN double unit[size];           ///< V_a, at which the adhesion number is 1 [m/s]
    HWY_ALIGN double number[size];         ///< beta in that scale
    HWY_ALIGN double log_work[size] = {};  ///< ln(work of damping/(beta m V_a^2))
    HWY_ALIGN double energy[size] = {};    ///< of the detachment [m V_a^2]
};

/// Fills in units and numbers, from problem @p first on.
template <class F>
HWY_FLATTEN inline void scale_block(const batch::CriticalTask& task, std::size_t first, std::size_t count,
                                    CriticalBlock& block) {
    const Lanes power(task.table->length_power());
    for (std::size_t i = 0; i < count; i += lane_count) {
        const BasicContactPair<LaneNumber> pair = read_pair(task.inputs, first + i, task.count);
        const Lanes at_one = adhesion_number_of<F>(pair, LaneNumber(1.0)).lanes();
        const Mask adhesive = at_one > Lanes(0.0);
        const Lanes log_length = power * Lanes(hn::Log(Tag(), select(adhesive, at_one, 1.0).v));
        const Lanes length(hn::Exp(Tag(), log_length.v));
        const LaneNumber stiffness = hertz_stiffness(pair);
        const Lanes velocity = length * sqrt(stiffness.lanes() * sqrt(length) / pair.mass.lanes());
        const BasicScale<LaneNumber> scale{
            .mass = pair.mass,
            .stiffness = stiffness,
            .velocity = LaneNumber(velocity),
            .length = LaneNumber(length),
            .radius_length = LaneNumber(sqrt(pair.effective_radius.lanes() * length))};
        const Lanes number = read(task.inputs.damping, first + i, task.count) /
                             damping_unit_of<F>(scale, task.damping_law).lanes();
        velocity.store(block.unit + i);
        select(adhesive, number, 0.0).store(block.number + i);
    }
}

/// Reads critical velocities from their table.
template <class F>
HWY_NOINLINE void read_critical(const batch::CriticalTask& task) {
    CriticalBlock block;
    for (std::size_t first = 0; first < task.count; first += CriticalBlock::size) {
        const std::size_t count = std::min(CriticalBlock::size, task.count - first);
        scale_block<F>(task, first, count, block);
        for (std::size_t i = 0; i < count; ++i)
            task.state[first + i] =
                critical_entry_at(*task.table, block.number[i], block.log_work[i], block.energy[i]);
        for (std::size_t i = 0; i < count; i += lane_count) {
            const Lanes work =
                Lanes::load(block.number + i) * Lanes(hn::Exp(Tag(), Lanes::load(block.log_work + i).v));
            const Lanes half_square = work + Lanes::load(block.energy + i);
            (sqrt(half_square + half_square) * Lanes::load(block.unit + i)).store(block.unit + i);
        }
        std::copy_n(block.unit, count, task.value + first);
    }
}

/// The kernels of a contact law, with an instance for each damping law.
template <template <class> class L>
batch::Kernels kernels_of_law() {
    return {.impacts =
                [](const batch::ImpactTask& task) {
                    with_form<L>(task.damping_law, [&](auto form) { solve_task<decltype(form)>(task); });
                },
            .numbers =
                [](const batch::NumberTask& task) {
                    with_form<L>(task.damping_law, [&](auto form) { solve_numbers<decltype(form)>(task); });
                },
            .inversions =
                [](const batch::InversionTask& task) {
                    with_form<L>(task.damping_law, [&](auto form) { invert_task<decltype(form)>(task); });
                },
            .critical_velocities =
                [](const batch::CriticalTask& task) {
                    with_form<L>(task.damping_law, [&](auto form) { read_critical<decltype(form)>(task); });
                }};
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
