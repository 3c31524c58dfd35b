// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

struct RunOptions {
    std::string case_file;  ///< empty: the built-in case
    std::string folder = "results";
    std::string from;
    std::string only;
    bool no_report = false;
    bool figures = false;
    bool allow_outside = false;
};

/// `ashimpact run`: every stage, its artifacts in a folder, the comparison as a table.
void run_run_command(const RunOptions& options, std::ostream& out);

}  // namespace ashimpact
