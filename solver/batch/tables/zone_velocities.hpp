// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "solver/batch/tables/piece_tree.hpp"
#include "solver/batch/tables/zone_curve.hpp"
#include "solver/contact/cohesive_zone.hpp"

namespace ashimpact {

enum class DampingLaw;
enum class Detachment;

namespace batch {

/// What a table contains of an interval of ln(beta), by powers of the place z in the span of transition
/// parameters.
struct ZoneVelocityPolynomials {
    static constexpr std::size_t terms = 16;   ///< powers of the place in the interval
    static constexpr std::size_t layers = 10;  ///< powers of z

    std::array<std::array<double, terms>, layers> log_work;  ///< ln(work of damping/beta)
    std::array<double, layers> detachment_energy;            ///< U(end) - U(first touch)
};

using ZoneVelocityContent = std::unique_ptr<ZoneVelocityPolynomials>;
using ZoneVelocityPiece = Piece<1, ZoneVelocityContent>;
using ZoneVelocityTree = PieceTree<ZoneVelocityPiece, 16, 2, 7>;
extern template class PieceTree<ZoneVelocityPiece, 16, 2, 7>;

/// What a table gives for one contact.
struct ZoneVelocity {
    PieceState state;  ///< of its piece
    double value;      ///< v_c, where tabulated, in units of Maugis
};

/// Critical velocities of law maugis-dugdale with one detachment and damping law, over one of the ZoneSpans.
/// In units of Maugis they depend on two numbers, the damping number beta and the transition parameter
/// lambda. The table contains the work of damping at v_c over beta as polynomials of ln(beta), whose
/// coefficients are polynomials in the place of lambda in the span, through backward orbits
/// (critical_impacts()). Intervals of four octaves of beta are halved until the last coefficients are below
/// 1e-10; at the edge of beta from which on everything is captured the table has no value. The relative error
/// of v_c is below 1e-9.
class ZoneVelocityTable final : public ZoneVelocityTree {
  public:
    ZoneVelocityTable(const NumberSpan& span, Detachment detachment, DampingLaw damping_law);

    /// @param lambda within the span; @param beta >= 0
    [[nodiscard]] ZoneVelocity at(double lambda, double beta);

  private:
    static constexpr int terms = ZoneVelocityPolynomials::terms;
    static constexpr int layers = ZoneVelocityPolynomials::layers;
    static constexpr int middle = layers / 2;
    static constexpr double tolerance = 1e-10;       ///< of ln(work/beta), in its last coefficients
    static constexpr double layer_tolerance = 1e-9;  ///< the same along the span, which is not divided
    static constexpr double within = 0.9999;  ///< z of the last nodes: at the ends pull-off meets the gap
    static constexpr double lowest = -40.0;   ///< log2(beta); below it the work over beta is the same
    static constexpr double octaves = 64.0;

    [[nodiscard]] PieceState judge(const ZoneVelocityPiece& piece, int depth,
                                   ZoneVelocityContent& content) const override;

    NumberSpan span_;
    Detachment detachment_;
    DampingLaw damping_law_;
    std::vector<CohesiveZone> zones_;  ///< at Chebyshev nodes of the span; none that may not end so
};

/// The tables of all spans for one detachment and damping law, each made when it is first needed, and kept.
/// Thread-safe.
class ZoneVelocities {
  public:
    /// One for the process.
    [[nodiscard]] static ZoneVelocities& of(Detachment detachment, DampingLaw damping_law);

    ZoneVelocities(Detachment detachment, DampingLaw damping_law)
        : detachment_(detachment), damping_law_(damping_law) {}

    /// @param lambda within the range that the law computes; @param beta >= 0, in units of Maugis
    [[nodiscard]] ZoneVelocity at(double lambda, double beta);

  private:
    struct Span {
        std::once_flag made;
        std::unique_ptr<ZoneVelocityTable> table;
    };

    Detachment detachment_;
    DampingLaw damping_law_;
    std::array<Span, ZoneSpans::count> spans_{};
};

}  // namespace batch

}  // namespace ashimpact
