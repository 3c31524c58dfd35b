#pragma once

#include "solver/calibration/damping_fit.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

/// A particle and law whose measured restitution is known only through a published fit eta(e_n).
struct PublishedDamping {
    Law law;
    Detachment detachment;
    ContactPair contact;
    DampingPolynomial damping;  ///< eta(e_n), constant during an impact [kg/s]
};

/// The incident velocity at which an impact with this damping rebounds with restitution @p restitution [m/s].
/// Restitution rises monotonically with velocity for constant damping.
/// @param impact its velocity is not used
/// @throws InputError for another damping law, a restitution outside (0, 1) or not reached at any velocity
[[nodiscard]] double velocity_of_restitution(const Impact& impact, double restitution);

/// The point of the measured curve e_n(v_in) that a published fit implies at restitution @p e: the velocity
/// at which an impact with eta(e) gives e back [m/s]. Reconstructed, not measured: label it so.
/// A restitution has one velocity, but not the other way round; see least_rebound().
[[nodiscard]] double reconstructed_velocity(const PublishedDamping& published, double e);

/// A point of a reconstructed curve.
struct CurvePoint {
    double velocity;     ///< [m/s]
    double restitution;  ///< [1]
};

/// The rebound of least velocity on the curve: where its rising branch begins. For adhesive laws the curve
/// folds there. eta falls with e, so that v_c does, in proportion to e, while rebounds of eta held fixed
/// need more than v_c only by a share of order e^2: from (v_c, 0) the curve first runs back to lower
/// velocities (Brach-Dunn, 88 um: by 0.85 %), which makes e two-valued, and rises from the fold on. Below the
/// fold e falls with velocity, as no measurement does. Hertz needs a share of 21.415 e - 50 e^(3/2) + ...,
/// and its v_c goes with eta^5: the curve folds at its start only where eta falls by more than 21.415/5
/// = 4.283 of itself per unit of e. The paper's fits fall by 1.9 at most, so their rising branch begins at
/// v_c with e = 0.
[[nodiscard]] CurvePoint least_rebound(const PublishedDamping& published);

/// The curve at a given velocity [m/s]: restitution on the rising branch, the least one at or above
/// least_rebound()'s; 0 below its velocity [1].
[[nodiscard]] double reconstructed_restitution(const PublishedDamping& published, double velocity);

}  // namespace ashimpact
