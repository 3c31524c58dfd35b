// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/numeric/interpolation.hpp"

namespace ashimpact::curves {

/// Searches the velocity at which an impact of fixed damping has a wanted restitution. Works on x = ln v.
/// Each step interpolates x through the nearest impacts solved so far (Neville's scheme) and stays inside the
/// bracket that they give; restitution has to rise with velocity.
class VelocitySearch {
  public:
    VelocitySearch() = default;
    /// @param restitution wanted, above 0 [1]
    /// @param guess of x
    /// @param adhesive with adhesion e^2 is nearly linear in v above capture, without it e is
    /// @param enough change of x that ends the search
    VelocitySearch(double restitution, double guess, bool adhesive, double enough);

    /// x to try next, or the answer.
    [[nodiscard]] double place() const { return place_; }
    [[nodiscard]] bool is_open() const { return state_ == State::open; }
    [[nodiscard]] bool is_found() const { return state_ == State::found; }

    /// Records the restitution at place(), 0 for a capture, and chooses the next place.
    void observe(double restitution);

  private:
    enum class State { open, found, failed };
    static constexpr int most_steps = 60;

    /// e, or e^2 with adhesion.
    [[nodiscard]] double height(double restitution) const;
    /// x at the wanted restitution through the points kept.
    [[nodiscard]] double interpolated() const;
    /// The next x, from one outside of the bracket or not known.
    [[nodiscard]] double inside(double next) const;

    bool adhesive_ = false;
    double enough_ = 0;  ///< change of x
    InverseInterpolation<4> place_of_height_;
    double place_ = 0;
    int steps_ = 0;
    State state_ = State::open;
};

}  // namespace ashimpact::curves
