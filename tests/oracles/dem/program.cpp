// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/program.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ashimpact::oracles {

std::string exact(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

std::string deck_template(const std::string& file) {
    std::ifstream stream(std::string(ASHIMPACT_ORACLE_DECKS "/") + file);
    std::ostringstream text;
    if (!(text << stream.rdbuf())) throw std::runtime_error("cannot read the deck template " + file);
    return text.str();
}

std::string fill(const std::string& deck, const DeckValues& values) {
    std::string filled;
    std::size_t position = 0;
    for (std::size_t open = 0; (open = deck.find('@', position)) != std::string::npos;) {
        const std::size_t close = deck.find('@', open + 1);
        if (close == std::string::npos) throw std::runtime_error("deck template: unpaired @");
        const auto value = values.find(deck.substr(open + 1, close - open - 1));
        if (value == values.end())
            throw std::runtime_error("deck template: no value for " + deck.substr(open, close - open + 1));
        filled.append(deck, position, open - position).append(value->second);
        position = close + 1;
    }
    return filled.append(deck, position);
}

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
