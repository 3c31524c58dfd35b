#include "pipeline/cli/program.hpp"
#include "pipeline/sweep/command.hpp"
#include "pipeline/sweep/mpi/session.hpp"

/// ashimpact-sweep: ashimpact with MPI and HDF5, whose libraries take longer to load than other
/// commands take to run. `ashimpact sweep` becomes this program.
int main(int argc, char** argv) {
    ashimpact::MpiSession session;
    const int status =
        ashimpact::run_program(argc, argv, [&](const ashimpact::SweepOptions& options, std::ostream& out) {
            ashimpact::run_sweep_command(options, session, ashimpact::solve_in_batch, out);
        });
    return session.leave(status);
}
