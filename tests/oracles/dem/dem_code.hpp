// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/dem/program.hpp"
#include "tests/oracles/time_domain.hpp"

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

/// How an installed DEM code is told about an impact.
struct DemCode {
    struct Setup {
        std::string
            deck;  ///< template; it prints position and velocity of a sphere that touches at 0, moving down
        DeckValues values;  ///< all but those of the schedule
    };

    std::string name;
    std::string program;
    std::string debian_package;
    std::function<bool(const Impact&)> covers;
    std::function<Setup(const Impact&)> setup;
};

/// Hertz and DMT on a wall; JKR as a pair of spheres, ending load-controlled.
DemCode lammps();

/// Hertz and DMT on a wall.
DemCode liggghts();

/// One run of one impact.
struct DemRun {
    Impact impact{};
    double time_step = 0;          ///< [s]
    std::size_t steps = 0;         ///< from first touch
    std::size_t output_every = 1;  ///< steps between samples
};

/// Runs them all in one call of the code; the decks and the log stay in the directory of the given name below
/// the build directory. Returns a track for each run, its time step being that between samples.
/// @throws std::runtime_error if the code is missing, fails, or prints anything but the samples asked for
std::vector<Track> run(const DemCode& code, std::span<const DemRun> runs, const std::string& directory);

/// Impacts by a DEM code, extrapolated to time step zero from five steps.
///
/// Velocity Verlet takes the damping at the half-step velocity, so a damped run is of first order, an
/// undamped one of second. On top, the force of Hertz and DMT goes like overlap^1.5 where contact begins and
/// ends, which puts half powers from h^2.5 on into the error, with a coefficient that depends on where
/// between two steps the contact ends. So three coarse runs find how the contact time depends on the step,
/// and the five steps are then chosen such that every contact ends in the middle of a step: only then are the
/// half powers there to be extrapolated away.
/// @throws std::runtime_error if an impact is a capture, or the code fails
std::vector<OracleResult> dem_impacts(const DemCode& code, std::span<const Impact> impacts);

/// Tells rebound (true) from capture by one finely stepped run each.
std::vector<bool> dem_rebounds(const DemCode& code, std::span<const Impact> impacts);

}  // namespace ashimpact::oracles
