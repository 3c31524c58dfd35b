// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace ashimpact {

enum class DampingLaw;
enum class Detachment;

namespace batch {

/// How the impact of one lane ended.
enum class LaneEnd : std::uint8_t {
    rebound,
    capture,
    undecided,  ///< left to the scalar solver
};

/// Greatest number of problems in a task.
inline constexpr std::size_t most_impacts = 2048;

/// A chunk of scaled impacts for one thread, given by adhesion and damping number; results are scaled.
struct NumberTask {
    DampingLaw damping_law;
    Detachment detachment;
    std::size_t count;
    const double* adhesion;
    const double* damping;
    LaneEnd* end;
    double* speed;  ///< at the end of contact, where it is a rebound
    double* time;   ///< of contact, where it is a rebound
};

/// Integrates a task: one function for each contact law and instruction set.
using NumberKernel = void (*)(const NumberTask&);

}  // namespace batch
}  // namespace ashimpact
