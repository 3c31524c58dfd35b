// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/batch/lanes/number_task.hpp"
#include "solver/batch/tables/number_span.hpp"

namespace ashimpact {

enum class DampingLaw;
enum class Detachment;

namespace batch {

/// Spans of the transition parameter lambda; next to the least lambda whose first touch is in touch, z is
/// linear in the root of the distance to it.
struct ZoneSpans {
    static constexpr std::size_t count = 140;
    static constexpr ImpactPart part = ImpactPart::whole;  ///< that a table of a span contains

    /// The span of a parameter within the range that the law computes.
    [[nodiscard]] static NumberSpan of(double lambda);
    /// Its place among all of them.
    [[nodiscard]] static std::size_t index(double lambda);
};

/// The static laws of cohesive zones (CohesiveZone) over a band of transition parameters, in units of Maugis:
/// polynomials of u = sqrt(contact radius) on pieces that overlap one another, so that a step of an impact
/// finds one that holds it whole. Their coefficients are polynomials in x, which goes from -1 to 1 over the
/// band.
class ZoneBand {
  public:
    static constexpr std::size_t terms = 14;  ///< powers of t, which goes from -1 to 1 over a piece
    static constexpr std::size_t orders = 9;  ///< powers of x
    /// Functions of u: d(delta)/du, F, the integral of the damping's shape over the overlap, U, delta.
    enum Function : std::size_t { slope, force, impulse, potential, overlap, functions };
    static constexpr std::size_t padded = 72;                        ///< coefficients of all functions
    static constexpr std::size_t step_functions = overlap;           ///< those that every step needs
    static constexpr std::size_t of_steps = terms * step_functions;  ///< their coefficients
    static_assert(padded % 8 == 0 && of_steps % 8 == 0, "multiples of any register");
    static_assert(padded >= terms * functions);

    struct Piece {
        double lower;
        double upper;
        std::array<std::array<double, padded>, orders> by_order;  ///< at [power of x][index()]
    };
    /// Places of the touching branch and numbers of them, each a polynomial in x.
    enum Number : std::size_t {
        rest_radius,  ///< of equilibrium; contact radius
        rest_overlap,
        rest_potential,
        rest_slope,        ///< d(delta)/du
        rest_force_slope,  ///< dF/du
        zero_radius,       ///< of zero overlap
        zero_potential,
        fold_radius,  ///< of pull-off in touch
        fold_overlap,
        fold_potential,
        tension_radius,  ///< of the greatest tension
        tension_overlap,
        tension_potential,
        touch_radius,  ///< of first touch in touch; in the root of lambda above the least that has it
        touch_potential,
        spare,  ///< so that registers are full
        numbers,
    };

    /// Place of a coefficient among those of a piece; the overlap, which hardly any step needs, is the last.
    [[nodiscard]] static constexpr std::size_t index(Function function, std::size_t term) {
        return function == overlap ? of_steps + term : term * step_functions + function;
    }

    /// The band that contains a transition parameter, made when it is first needed. Thread-safe.
    /// @param lambda within the range that the law computes
    [[nodiscard]] static const ZoneBand& of(double lambda, DampingLaw damping_law);

    /// The static laws alone. @param lower, upper ends of the band
    ZoneBand(double lower, double upper);
    /// The same with the integral of a damping law's shape.
    ZoneBand(const ZoneBand& statics, DampingLaw damping_law);

    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
    [[nodiscard]] double place(double lambda) const;
    /// All numbers at a transition parameter.
    [[nodiscard]] std::array<double, numbers> values(double lambda) const;

  private:
    double middle_;
    double stretch_;
    double root_middle_ = 0.0;
    double root_stretch_ = 0.0;
    std::vector<Piece> pieces_;
    std::array<std::array<double, numbers>, orders> numbers_{};  ///< by power of x
};

/// The static law of one transition parameter, for kernels.
class ZoneCurve {
  public:
    /// A state of the touching branch.
    struct Place {
        double position;  ///< u
        double overlap;
        double potential;
    };
    /// Where an impact begins or ends: in touch, or across the gap beyond the place where the surfaces part.
    struct Border {
        Place touching;
        bool in_gap;
        double potential;  ///< beyond the gap; that of touching without one
    };
    struct Rest {
        Place place;
        double slope;        ///< d(delta)/du
        double force_slope;  ///< dF/du
    };

    ZoneCurve() = default;
    /// @param lambda within the range that the law computes
    ZoneCurve(double lambda, DampingLaw damping_law, Detachment detachment);
    /// @param band that contains lambda
    ZoneCurve(double lambda, const ZoneBand& band, Detachment detachment);

    [[nodiscard]] double lambda() const { return lambda_; }
    [[nodiscard]] double place() const { return place_; }  ///< x in the band
    [[nodiscard]] const ZoneBand& band() const { return *band_; }
    [[nodiscard]] double gap_fold() const { return gap_fold_; }        ///< c at the least overlap in the gap
    [[nodiscard]] double join_radius() const { return join_radius_; }  ///< c where the surfaces part
    [[nodiscard]] const Rest& rest() const { return rest_; }
    [[nodiscard]] const Border& begin() const { return begin_; }
    [[nodiscard]] const Border& end() const { return end_; }
    /// Whether an impact of this transition parameter may end so, see cohesive_refusal().
    [[nodiscard]] bool admissible() const { return admissible_; }

    /// From now on keeps the coefficients of its pieces, which pays where many lanes follow one curve. Such a
    /// curve is one thread's.
    void keep_pieces() {
        kept_.resize(band_->pieces().size() * ZoneBand::of_steps);
        is_kept_.assign(band_->pieces().size(), 0);
    }
    /// Coefficients of a piece, without the overlap; none if they are not kept, or not yet.
    [[nodiscard]] const double* kept(std::size_t piece) const {
        return is_kept_.empty() || is_kept_[piece] == 0 ? nullptr : kept_.data() + piece * ZoneBand::of_steps;
    }
    /// Where they are to be kept, if they are.
    [[nodiscard]] double* room(std::size_t piece) const {
        return is_kept_.empty() ? nullptr : kept_.data() + piece * ZoneBand::of_steps;
    }
    void keep(std::size_t piece) const {
        if (!is_kept_.empty()) is_kept_[piece] = 1;
    }

  private:
    double lambda_ = 0.0;
    double place_ = 0.0;
    const ZoneBand* band_ = nullptr;
    double gap_fold_ = 0.0;
    double join_radius_ = 0.0;
    Rest rest_{};
    Border begin_{};
    Border end_{};
    bool admissible_ = false;
    mutable std::vector<double> kept_{};
    mutable std::vector<char> is_kept_{};
};

}  // namespace batch

}  // namespace ashimpact
