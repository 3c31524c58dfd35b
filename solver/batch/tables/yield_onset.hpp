// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/number_span.hpp"

namespace ashimpact {

enum class DampingLaw;

namespace batch {

/// Spans of the third number c of a law that yields, ThorntonNing::yield_adhesion().
struct YieldSpans {
    static constexpr std::size_t count = 16;
    static constexpr ImpactPart part = ImpactPart::approach;  ///< that a table of a span contains
    /// No spans beyond: from 0.949 on adhesion alone pulls an undamped contact through yield.
    static constexpr double greatest = 0.92;

    [[nodiscard]] static bool hold(double c) { return c >= 0.0 && c < greatest; }
    /// The place of the span of a number that they hold.
    [[nodiscard]] static std::size_t index(double c) {
        return static_cast<std::size_t>(c * (static_cast<double>(count) / greatest));
    }
    [[nodiscard]] static NumberSpan of(double c) {
        constexpr double width = greatest / static_cast<double>(count);
        const auto place = static_cast<double>(index(c));
        return {width * place, width * (place + 1.0)};
    }
};

/// An impact that may yield in units of the length at which the yield number is 1: square of its velocity and
/// damping number there, and c.
struct YieldNumbers {
    double velocity_squared;
    double damping;
    double yield_adhesion;
};

/// Numbers of the same impact in units of its velocity.
struct ImpactNumbers {
    double adhesion;
    double damping;
    double yield_number;
};
[[nodiscard]] ImpactNumbers impact_numbers(const YieldNumbers& impact, DampingLaw damping_law);

/// The velocity from which on contacts yield, over a span of c and places y = b/(1 + b) of the damping number
/// b, and a coordinate x of the velocities above it in which the turn is smooth. Impacts below follow another
/// branch.
class YieldOnset {
  public:
    static constexpr std::size_t terms = 16;        ///< powers of the place
    static constexpr std::size_t layers = 8;        ///< powers of z in the span
    static constexpr double greatest_place = 0.75;  ///< y; hardly anything rebounds beyond
    /// Distance of v^2 from the onset at x = 0. Nearer to it turns are hard to integrate; the table's
    /// polynomials continue there, as the turn has three derivatives at the onset.
    static constexpr double margin = 0x1p-13;
    /// x of the distance d beyond that is log2(1 + d/unit)/powers, from 0 to 1: the square is 0.2 to 0.8 at
    /// the onset of undamped impacts.
    static constexpr double unit = 0.5;
    static constexpr double powers = 24.0;

    YieldOnset() = default;
    /// @param kernel of a law that yields
    YieldOnset(NumberKernel kernel, DampingLaw damping_law, const NumberSpan& span);

    /// Whether the search has converged everywhere.
    [[nodiscard]] bool known() const { return known_; }
    /// Square of the velocity at the onset, by powers of z, each by powers of local().
    [[nodiscard]] const std::array<std::array<double, terms>, layers>& velocity_squared() const {
        return velocity_squared_;
    }
    /// From -1 to 1 over the places.
    [[nodiscard]] static double local(double y) { return y * (2.0 / greatest_place) - 1.0; }
    /// The square of the velocity at coordinates.
    [[nodiscard]] double velocity_squared_at(double x, double y, double z) const;

  private:
    std::array<std::array<double, terms>, layers> velocity_squared_{};
    bool known_ = false;
};

}  // namespace batch

}  // namespace ashimpact
