// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "solver/deposition/tube_flow.hpp"
#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact {

/// How a particle passes a tube or meets it.
struct TubePassage {
    bool arrives = false;
    double angle = 0;    ///< of the place from the front, where it arrives or passes closest [rad]
    double normal = 0;   ///< velocity into the wall [U]; 0 if it passes
    double tangent = 0;  ///< velocity along the wall, away from the front [U]
    double gap = 0;      ///< to the wall at its closest, if it passes [radii]
};

/// The path of a particle in the potential flow across a tube (Boost.odeint, Fehlberg 7(8), relative error
/// 1e-10). It begins so far upstream that the asymptotic solution there is good to 1e-7 of the offset. @param
/// offset from the axis, far upstream [radii]
/// @throws ConvergenceError
[[nodiscard]] TubePassage tube_passage(const TubeParticle& particle, double offset);

/// Ends of an interval of offsets [radii].
struct OffsetRange {
    double from = 0, to = 0;
};

/// Where, how fast and at which angle particles of one size meet a tube: 33 paths up to that which grazes it,
/// the critical offset by a bracketed search, and monotone curves between them. The curves run over
/// asin(offset/critical offset), because velocity and place change with the root of the distance to the
/// critical offset.
class TubeImpaction {
  public:
    /// @throws ConvergenceError
    explicit TubeImpaction(const TubeParticle& particle);

    /// Share of the particles flying at the tube that meet it: the critical offset [1].
    [[nodiscard]] double efficiency() const { return critical_offset_; }
    [[nodiscard]] bool any() const { return critical_offset_ > 0; }
    /// What a particle of that offset does. @pre any() and 0 <= offset <= efficiency()
    [[nodiscard]] TubePassage at_offset(double offset) const;
    /// The offset whose particles arrive at an angle from the front; the critical one beyond the last.
    [[nodiscard]] double offset_of_angle(double angle) const;
    /// Offsets whose particles arrive with a normal velocity below that [U], rising and apart.
    [[nodiscard]] std::vector<OffsetRange> slower_than(double normal) const;

  private:
    double critical_offset_ = 0;
    std::vector<double> places_{}, normals_{}, angles_{};
    std::optional<MeasuredCurve> normal_{}, tangent_{}, angle_{};
};

}  // namespace ashimpact
