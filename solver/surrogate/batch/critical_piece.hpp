// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "solver/surrogate/batch/settled.hpp"

namespace ashimpact::batch {

enum class CriticalState : std::uint8_t {
    unknown,
    finite,           ///< the polynomial gives v_c
    always_captured,  ///< everywhere on the piece
    halved,
    undecided,  ///< next to the damping from which on everything is captured: integrate
};

/// An interval of damping numbers of a table of critical velocities.
class CriticalPiece : public Settled<CriticalState> {
  public:
    using State = CriticalState;
    static constexpr std::size_t terms = 16;  ///< a multiple of the lanes of any register
    using Coefficients = std::array<double, terms>;

    [[nodiscard]] double lower() const { return lower_; }
    [[nodiscard]] double upper() const { return lower_ + 2.0 / stretch_; }
    /// From -1 to 1 over the piece.
    [[nodiscard]] double t(double beta) const { return (beta - lower_) * stretch_ - 1.0; }

    /// ln(work of damping/(beta m V_a^2)) by powers of t; only in state finite.
    [[nodiscard]] const Coefficients& polynomial() const { return polynomial_; }
    /// In units of m V_a^2; only in state finite.
    [[nodiscard]] double detachment_energy() const { return detachment_energy_; }
    /// The half that contains @p beta; only in state halved.
    [[nodiscard]] CriticalPiece& half(double beta) const {
        return (*halves_)[beta >= (*halves_)[1].lower_ ? 1U : 0U];
    }

    void place(double lower, double upper) {
        lower_ = lower;
        stretch_ = 2.0 / (upper - lower);
    }
    /// Before the state is finite.
    void set(const Coefficients& polynomial, double detachment_energy) {
        polynomial_ = polynomial;
        detachment_energy_ = detachment_energy;
    }
    /// Before the state is halved.
    void halve() {
        halves_ = std::make_unique<std::array<CriticalPiece, 2>>();
        const double middle = lower_ + 1.0 / stretch_;
        (*halves_)[0].place(lower_, middle);
        (*halves_)[1].place(middle, upper());
    }

  private:
    double lower_ = 0.0;
    double stretch_ = 0.0;
    Coefficients polynomial_{};
    double detachment_energy_ = 0.0;
    std::unique_ptr<std::array<CriticalPiece, 2>> halves_{};
};

}  // namespace ashimpact::batch
