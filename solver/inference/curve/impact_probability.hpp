// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/inference/curve/smooth_damping.hpp"

namespace ashimpact {

/// The recorded outcome of an impact.
enum class Recorded {
    rebound,  ///< with a velocity above zero
    zero,     ///< no rebound was seen: a capture, or a rebound too slow for the camera
    capture,  ///< seen to stick
};

/// One impact as the likelihood needs it.
struct RecordedImpact {
    Recorded recorded;
    double velocity;           ///< v_in [m/s]
    double log_velocity;       ///< ln v_in
    double rebound;            ///< v_r as read; 0 where there is no reading [m/s]
    double incident_u;         ///< standard uncertainty of v_in, in units of the noise scale
    double rebound_u;          ///< of v_r
    double correlation = 0.0;  ///< of the errors of both
    double resolution;         ///< v_r from which on the camera always sees it move; 0: not known [m/s]
    double count = 1.0;        ///< impacts merged into this one
};

/// How measurements scatter about the curve.
struct Scatter {
    double noise;     ///< factor on the uncertainties of both velocities
    double damping;   ///< standard deviation of ln eta between particles, or of what acts like it (size)
    double outliers;  ///< share of impacts whose record does not depend on the curve
};

/// ln of the probability of a recorded capture, or of the probability density of a reading [s/m], integrated
/// over the true velocity and over the scatter between particles.
[[nodiscard]] double log_probability(const SmoothDamping& curve, const Scatter& scatter,
                                     const RecordedImpact& impact);

}  // namespace ashimpact
