// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

/// One time step of a DEM run.
struct Sample {
    double overlap;   ///< [m]
    double velocity;  ///< rate of overlap [m/s]
};

/// A DEM run from first touch (sample 0) at a constant time step.
struct Track {
    double time_step = 0;  ///< [s]
    std::vector<Sample> samples;
};

/// What one run says, before any extrapolation in the time step.
struct Contact {
    bool separated = false;
    double restitution = 0;
    double contact_time = 0;     ///< [s]
    double maximum_overlap = 0;  ///< [m]
    double end_in_steps = 0;     ///< contact time in time steps: where between two samples the end fell
};

/// Reads turning point and end of contact between the samples, by polynomials through samples of the contact
/// alone: the first one outside has felt the jump of the force.
/// @param end_overlap the overlap at which the contact ends [m]
Contact read_contact(const Track& track, double end_overlap);

/// Richardson extrapolation to step zero: fits value(h) = c0 + c1 h^p1 + c2 h^p2 + ... through all points and
/// returns c0, in the unit of the values. The error is the distance to the same without the largest step and
/// the highest power, so it belongs to the lower order and is on the safe side.
/// @param steps five or so step sizes in any unit, largest first
/// @param powers ascending, one fewer than there are steps
Estimate extrapolate(std::span<const double> steps, std::span<const double> values,
                     std::span<const double> powers);

/// Returns the coefficients c0, c1, ... of c0 + c1 h^p1 + ... through all points.
std::vector<double> fit_powers(std::span<const double> steps, std::span<const double> values,
                               std::span<const double> powers);

}  // namespace ashimpact::oracles
