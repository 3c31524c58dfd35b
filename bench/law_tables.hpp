// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/measured.hpp"
#include "solver/batch/batch.hpp"

namespace ashimpact::bench {

/// Prints for every law and damping law what it does from tables: impacts, their worst error, what making the
/// tables took over the range of those impacts (only where none has been made), dampings and critical
/// velocities. @param unit impacts/s of GSL
void print_tabulated_laws(const Options& options, double unit);

/// Prints the same of laws whose scaled impacts have three numbers, of one size and of many.
void print_laws_of_three_numbers(const Options& options, double unit);

/// Prints the same of laws and damping laws without kernels, whose impacts go one by one, turns included.
void print_single_laws(const Options& options, double unit);

/// Prints the same impacts integrated, and what share of the core's peak they take.
void print_integrated_laws(const Options& options);

/// A batch without turning points.
[[nodiscard]] inline BatchOptions without_turn(BatchMethod method) {
    return {.turning_point = false, .method = method};
}

}  // namespace ashimpact::bench
