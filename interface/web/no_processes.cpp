// SPDX-License-Identifier: GPL-3.0-or-later
// A page starts no programs: what would start one is told so.
#include <cerrno>

#include <spawn.h>

extern "C" int posix_spawnp(pid_t* /*process*/, const char* /*file*/,
                            const posix_spawn_file_actions_t* /*actions*/,
                            const posix_spawnattr_t* /*attributes*/, char* const* /*arguments*/,
                            char* const* /*environment*/) {
    return ENOSYS;
}
