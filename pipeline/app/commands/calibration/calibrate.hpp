// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace ashimpact {

struct CalibrateOptions {
    std::string case_file;          ///< empty: the built-in case
    std::vector<std::string> free;  ///< "density" or "density:each"; empty: what the case says
    bool compare = false;           ///< hypotheses beside one another instead of one calibration
    bool allow_outside = false;     ///< the case may name files outside of its folder
    bool json = false;
};

/// `ashimpact calibrate`: the unknown constants of a case, from its published critical velocities and contact
/// times.
void run_calibrate_command(const CalibrateOptions& options, std::ostream& out);

}  // namespace ashimpact
