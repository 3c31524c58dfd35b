// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/measured.hpp"

namespace ashimpact::bench {

/// Prints how many sizes, and how many particles one by one, a core follows to a tube in a second.
void print_tube(const Options& options);

}  // namespace ashimpact::bench
