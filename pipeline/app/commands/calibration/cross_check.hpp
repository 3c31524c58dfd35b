// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

struct CrossCheckOptions {
    std::string case_file;       ///< empty: the built-in case
    bool allow_outside = false;  ///< the case may name files outside of its folder
    bool json = false;
};

/// `ashimpact cross-check`: how published fits eta(e_n) of several laws to the same impacts agree. Each
/// implies a curve e_n(v_in), which should be the same one; and the curve of the reference law, inverted by
/// the other laws, should give their published fits.
void run_cross_check_command(const CrossCheckOptions& options, std::ostream& out);

}  // namespace ashimpact
