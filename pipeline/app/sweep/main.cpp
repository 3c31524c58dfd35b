// SPDX-License-Identifier: GPL-3.0-or-later
#include <malloc.h>

#include "pipeline/app/command.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/app/sweep/workers.hpp"

/// ashimpact with MPI and HDF5, which take long to load: runs `ashimpact sweep` and `ashimpact export table`.
int main(int argc, char** argv) {
    // The columns of one chunk after another: memory goes from one to the next, not to the system and back.
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    return ashimpact::with_enough_stack([&] {
        ashimpact::MpiSession session;
        const int status = ashimpact::run_program(
            argc, argv,
            [&](const ashimpact::CommandOptions& options, std::ostream& out) {
                ashimpact::run_sweep_command(options, session, ashimpact::solve_in_batch, out);
            },
            [](const ashimpact::CommandOptions& options, std::ostream& out) {
                ashimpact::run_export_command(options, ashimpact::impact_table_image, out);
            });
        return session.leave(status);
    });
}
