// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/program.hpp"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ashimpact::oracles {

namespace {

constexpr int cannot_start = 127;

[[noreturn]] void become(const std::filesystem::path& program, std::vector<std::string> words,
                         const std::filesystem::path& directory) {
    words.insert(words.begin(), program.string());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int nothing = open("/dev/null", O_RDWR);
    if (nothing >= 0 && chdir(directory.c_str()) == 0) {
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
        setenv("OMP_NUM_THREADS", "1", 1);
        execv(program.c_str(), argv.data());
    }
    _exit(cannot_start);
}

}  // namespace

std::filesystem::path find_program(const std::string& program, const std::string& debian_package) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        auto candidate = std::filesystem::path(folder) / program;
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    throw std::runtime_error("the independent oracle '" + program +
                             "' is not installed; on Debian: apt-get install " + debian_package);
}

int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& directory) {
    const pid_t child = fork();
    if (child == 0) become(program, arguments, directory);
    int status = 0;
    const bool ended = child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
    return ended ? WEXITSTATUS(status) : cannot_start;
}

}  // namespace ashimpact::oracles
