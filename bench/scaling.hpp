// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ashimpact::bench {

/// A fixed amount of work, done on so many threads.
struct ThreadedWork {
    std::string name;
    std::function<void(int threads)> run;
};

/// Numbers in order of size, by their quartiles.
struct Quartiles {
    double lower;
    double median;
    double upper;
};

/// How much faster work is on several threads than on one, and how that compares with a yardstick that
/// shares nothing between its threads.
struct Scaling {
    std::string name;
    Quartiles speedup;       ///< time on one thread over time on all, a value a round [1]
    Quartiles ratio;         ///< speedup over that of the yardstick in the same round [1]
    double undisturbed = 0;  ///< the ratio made of the shortest time of each kind in all rounds [1]
};

/// Measures wall times round by round: in each, the yardstick and every work, on one thread and on all, right
/// after one another, in turns forwards and backwards. What else a machine does falls upon all alike, and
/// what it does for a while spoils few rounds; the quartiles show how much it did. Other load only lengthens
/// times, so that the shortest ones are nearest to what a quiet machine does.
/// @returns the yardstick, then the works
[[nodiscard]] std::vector<Scaling> measure_scaling(const ThreadedWork& yardstick,
                                                   const std::vector<ThreadedWork>& works, int threads,
                                                   int rounds);

}  // namespace ashimpact::bench
