// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/pipeline/sandbox.hpp"

namespace ashimpact::test {

/// How a program ended.
struct Ended {
    int status;  ///< its exit status, or 128 and the signal that ended it
    std::string out;
    std::string err;
    long peak_memory;  ///< greatest resident set [kB]
};

/// A program running in a sandbox.
class Process {
  public:
    /// @param environment "NAME=value", beside what there is
    Process(const Sandbox& sandbox, const std::vector<std::string>& command,
            const std::vector<std::string>& environment = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    Process(Process&&) = delete;
    Process& operator=(Process&&) = delete;

    void signal(int number) const;
    [[nodiscard]] Ended wait();

  private:
    Sandbox outputs_;
    pid_t id_;
};

/// Runs a program to its end.
[[nodiscard]] Ended run(const Sandbox& sandbox, const std::vector<std::string>& command,
                        const std::vector<std::string>& environment = {});

/// The command that starts a program with so many MPI processes, more than there are cores if need be.
[[nodiscard]] std::vector<std::string> under_mpi(int processes, const std::vector<std::string>& command);

}  // namespace ashimpact::test
