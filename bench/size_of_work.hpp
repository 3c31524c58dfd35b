// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact::bench {

/// Prints how processor time of the program grows with the size of its work: `run` with samples and with
/// impacts, `damping` with impacts, `sweep` with samples; and the exponent between the last two sizes.
void print_sizes_of_work();

}  // namespace ashimpact::bench
