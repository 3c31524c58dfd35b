// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/dem/program.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

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
    std::string command =
        "cd '" + directory.string() + "' && OMP_NUM_THREADS=1 exec '" + program.string() + "'";
    for (const std::string& argument : arguments) command += " '" + argument + "'";
    const int status = std::system((command + " </dev/null >/dev/null 2>&1").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 127;
}

}  // namespace ashimpact::oracles
