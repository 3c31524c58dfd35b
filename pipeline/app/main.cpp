// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <filesystem>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <unistd.h>

#include "core/text/error.hpp"
#include "pipeline/app/command.hpp"

namespace {

/// Replaces this process by ashimpact-sweep, which links MPI and HDF5: they take long to load.
void hand_over(char** argv) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe").replace_filename("ashimpact-sweep");
    execv(program.c_str(), argv);
    throw ashimpact::InputError("cannot be started: " + std::generic_category().message(errno),
                                "ashimpact-sweep beside ashimpact, where it is built and installed")
        .at(ashimpact::FileName{program.string()});
}

/// Keeps the memory of released documents and pages: a part of a run is page faults for new memory instead.
void keep_released_memory() {
#ifdef __GLIBC__
    constexpr int kept = 32 << 20;  // the most that mallopt() takes
    mallopt(M_MMAP_THRESHOLD, kept);
    mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

}  // namespace

int main(int argc, char** argv) {
    keep_released_memory();
    return ashimpact::with_enough_stack([&] {
        return ashimpact::run_program(
            argc, argv, [argv](const ashimpact::CommandOptions&, std::ostream&) { hand_over(argv); },
            [argv](const ashimpact::CommandOptions& options, std::ostream& out) {
                if (options["code"] == "table") hand_over(argv);  // HDF5
                ashimpact::run_export_command(options, {}, out);
            });
    });
}
