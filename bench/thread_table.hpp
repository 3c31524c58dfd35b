// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact::bench {

/// Prints how batches and `ashimpact sweep` scale over all cores, beside pure multiply-adds.
void print_thread_table(int repetitions);

}  // namespace ashimpact::bench
