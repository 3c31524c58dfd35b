// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/measured.hpp"

namespace ashimpact::bench {

/// Prints what `ashimpact sweep` and the Python module make of the rate of a batch, on one core.
void print_seams(const Options& options);

}  // namespace ashimpact::bench
