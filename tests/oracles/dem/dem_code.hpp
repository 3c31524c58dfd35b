// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/oracles/dem/deck.hpp"
#include "tests/oracles/dem/track.hpp"
#include "tests/oracles/impact_case.hpp"

namespace ashimpact::oracles {

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
    std::function<bool(const ImpactCase&)> covers;
    std::function<Setup(const ImpactCase&)> setup;
};

/// Hertz and DMT on a wall; JKR as a pair of spheres, ending load-controlled.
DemCode lammps();

/// Hertz and DMT on a wall.
DemCode liggghts();

/// One run of one impact.
struct DemRun {
    ImpactCase impact{};
    double time_step = 0;          ///< [s]
    std::size_t steps = 0;         ///< from first touch
    std::size_t output_every = 1;  ///< steps between samples
};

/// Runs them all in one call of the code; the decks and the log stay in the directory of the given name below
/// the build directory. Returns a track for each run, its time step being that between samples.
/// @throws std::runtime_error if the code is missing, fails, or prints anything but the samples asked for
std::vector<Track> run(const DemCode& code, std::span<const DemRun> runs, const std::string& directory);

}  // namespace ashimpact::oracles
