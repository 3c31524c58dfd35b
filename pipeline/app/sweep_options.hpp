// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace ashimpact {

struct SweepOptions {
    std::string spec;                 ///< the file that says what to compute
    std::string output;               ///< JSON file for the result
    int threads = 0;                  ///< of each process; 0: its share of the cores
    double checkpoint_interval = 10;  ///< [s]
    bool restart = false;             ///< leave a checkpoint aside
    bool no_report = false;           ///< leave the page beside the result out
    bool progress = false;            ///< show progress though standard error is no terminal
};

/// Who runs a sweep: the program itself, or the one it hands over to.
using SweepRunner = std::function<void(const SweepOptions&, std::ostream& out)>;

}  // namespace ashimpact
