// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

namespace ashimpact {

enum class DampingLaw;
enum class Detachment;

namespace batch {

/// How the impact of one lane ended.
enum class LaneEnd : std::uint8_t {
    rebound,
    capture,
    undecided,  ///< left to the scalar solver
};

/// Greatest number of problems in a task.
inline constexpr std::size_t most_impacts = 2048;

class ZoneCurve;

/// Part of an impact.
enum class ImpactPart : std::uint8_t {
    whole,
    approach,  ///< up to the turn, on the plastic branch where the contact yields
    release,   ///< from rest at u = 1 on, in units in which Hertz stiffness and mass are 1
};

/// A chunk of scaled impacts for one thread, given by adhesion and damping number; results are scaled.
struct NumberTask {
    DampingLaw damping_law;
    Detachment detachment;
    ImpactPart part;  ///< whole, unless the law yields
    std::size_t count;
    const double* adhesion;
    const double* damping;
    const double* yield_number;  ///< of a law that yields; none: the contacts do not
    const ZoneCurve* curve;      ///< of a law with a cohesive zone
    LaneEnd* end;                ///< of an approach: rebound if its turn is certain, else undecided
    double* speed;  ///< at the end of contact, where it is a rebound; of an approach u at the turn
    double* time;   ///< of the part, where it is a rebound
};

/// Integrates a task: one function for each contact law and instruction set.
using NumberKernel = void (*)(const NumberTask&);

/// Adhesion and damping numbers of scaled impacts.
struct NumberColumns {
    const double* adhesion;
    const double* damping;
    DampingLaw damping_law;
    const ZoneCurve* const* curve = nullptr;  ///< of a law with a cohesive zone
    const double* yield_number = nullptr;     ///< of a law that yields
};

/// An order of the impacts of a task in which similar ones are neighbours. It changes no result, only how
/// long the lanes of a block wait for each other.
class Order {
  public:
    /// @param impacts their places in the columns
    Order(const NumberColumns& numbers, std::span<const std::uint16_t> impacts) {
        if (impacts.size() <= 1) {
            std::ranges::copy(impacts, place_.begin());
            return;
        }
        std::array<std::uint16_t, yield_bins * damping_bins * adhesion_bins + 1> start{};
        std::array<std::uint16_t, most_impacts> bin;  // by impact; filled only for those to be sorted
        for (const std::size_t i : impacts) {
            unsigned own = bin_of(numbers.adhesion[i], numbers.damping[i]);
            if (numbers.yield_number != nullptr)
                own += damping_bins * adhesion_bins * yield_bin_of(numbers.yield_number[i]);
            bin[i] = static_cast<std::uint16_t>(own);
            ++start[bin[i] + 1U];
        }
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (const std::uint16_t i : impacts) place_[start[bin[i]]++] = i;
    }
    [[nodiscard]] std::size_t operator[](std::size_t position) const { return place_[position]; }

  private:
    static constexpr unsigned damping_bins = 64;
    static constexpr unsigned adhesion_bins = 16;
    static constexpr unsigned yield_bins = 4;

    /// Bin of an impact: of beta/(1 + beta) of its damping number, and of its adhesion number, half powers of
    /// two from 1/64 to 4, as impacts change little below and above. Rows of bins are numbered in alternating
    /// directions, so that consecutive bins are neighbours.
    static unsigned bin_of(double adhesion, double damping) {
        const double place = damping_bins * (1.0 - 1.0 / (1.0 + damping));
        const auto row = static_cast<unsigned>(std::clamp(place, 0.0, damping_bins - 1.0));
        const auto halves = static_cast<int>(std::bit_cast<std::uint64_t>(adhesion) >> 51U) - 2 * 1023;
        const auto column =
            static_cast<unsigned>(std::clamp(halves + 12, 0, static_cast<int>(adhesion_bins) - 1));
        return row * adhesion_bins + (row % 2 == 0 ? column : adhesion_bins - 1 - column);
    }

    /// Bin of a yield number: hardly any impact yields above 1.
    static unsigned yield_bin_of(double yield_number) {
        const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(yield_number) >> 52U) - 1023;
        return static_cast<unsigned>(std::clamp(exponent + 3, 0, static_cast<int>(yield_bins) - 1));
    }

    std::array<std::uint16_t, most_impacts> place_;
};

}  // namespace batch

}  // namespace ashimpact
