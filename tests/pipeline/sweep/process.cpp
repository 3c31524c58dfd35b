// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pipeline/sweep/process.hpp"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ashimpact::test {

namespace {

void redirect(int stream, const std::string& path, int flags) {
    const int file = open(path.c_str(), flags, 0600);
    if (file < 0 || dup2(file, stream) < 0) _exit(127);
}

}  // namespace

Process::Process(const Sandbox& sandbox, const std::vector<std::string>& command,
                 const std::vector<std::string>& environment)
    : id_(fork()) {
    if (id_ < 0) throw std::runtime_error("no new process");
    if (id_ > 0) return;
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, outputs_.path("out"), O_WRONLY | O_CREAT);
    redirect(STDERR_FILENO, outputs_.path("err"), O_WRONLY | O_CREAT);
    if (chdir(sandbox.folder().c_str()) != 0) _exit(127);
    for (const std::string& each : environment) {
        const auto equals = each.find('=');
        setenv(each.substr(0, equals).c_str(), each.substr(equals + 1).c_str(), 1);
    }
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
}

Process::~Process() {
    if (id_ <= 0) return;
    signal(SIGKILL);
    static_cast<void>(wait());
}

void Process::signal(int number) const {
    kill(id_, number);
}

Ended Process::wait() {
    int result = 0;
    rusage usage{};
    wait4(id_, &result, 0, &usage);
    id_ = 0;
    const int status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
    return {status, outputs_.read("out"), outputs_.read("err"), usage.ru_maxrss};
}

Ended run(const Sandbox& sandbox, const std::vector<std::string>& command,
          const std::vector<std::string>& environment) {
    return Process(sandbox, command, environment).wait();
}

std::vector<std::string> under_mpi(int processes, const std::vector<std::string>& command) {
    // Open MPI leaves memory behind, of parts it has unloaded: nothing that could be told by name. It takes
    // two locks of its own in either order, in its TCP transport.
    std::vector<std::string> whole{"env",    "ASAN_OPTIONS=detect_leaks=0", "TSAN_OPTIONS=detect_deadlocks=0",
                                   "mpirun", "--allow-run-as-root",         "--oversubscribe",
                                   "-n",     std::to_string(processes)};
    whole.insert(whole.end(), command.begin(), command.end());
    return whole;
}

}  // namespace ashimpact::test
