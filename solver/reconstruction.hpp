#pragma once

#include "solver/damping_fit.hpp"
#include "solver/impact.hpp"

namespace ashimpact {

/// A particle and law whose measured restitution is known only through a published fit eta(e_n).
struct PublishedDamping {
    Law law;
    Detachment detachment;
    ContactPair contact;
    double a;  ///< eta = a e^2 + b e + c, constant damping [kg/s]
    double b;  ///< [kg/s]
    double c;  ///< [kg/s]

    /// eta at restitution @p e [kg/s].
    [[nodiscard]] double damping(double e) const { return (a * e + b) * e + c; }
};

/// The incident velocity at which an impact with this damping rebounds with restitution @p restitution [m/s].
/// Restitution rises monotonically with velocity for constant damping.
/// @param impact its velocity is not used
/// @throws InputError for another damping law, a restitution outside (0, 1) or not reached at any velocity
[[nodiscard]] double velocity_of_restitution(const Impact& impact, double restitution);

/// The point of the measured curve e_n(v_in) that a published fit implies at restitution @p e: the velocity
/// at which an impact with eta(e) gives e back [m/s]. Reconstructed, not measured: label it so.
[[nodiscard]] double reconstructed_velocity(const PublishedDamping& published, double e);

/// The same curve at a given velocity [m/s]: restitution, or 0 where the curve has none that high [1].
[[nodiscard]] double reconstructed_restitution(const PublishedDamping& published, double velocity);

}  // namespace ashimpact
