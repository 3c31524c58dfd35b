// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ashimpact::oracles {

/// The text for each @key@ of a deck template.
using DeckValues = std::map<std::string, std::string>;

/// Returns a number that reads back as the same double.
std::string exact(double number);

/// Returns the template tests/oracles/dem/decks/<file>.
/// @throws std::runtime_error if it cannot be read
std::string deck_template(const std::string& file);

/// Returns the template with every @key@ replaced.
/// @throws std::runtime_error for a key without value, or an unpaired @
std::string fill(const std::string& deck, const DeckValues& values);

/// Returns the path of a program on PATH.
/// @throws std::runtime_error naming the program and the Debian package that has it, where it is missing
std::filesystem::path find_program(const std::string& program, const std::string& debian_package);

/// Runs a program in a directory, on one OpenMP thread and with its output dropped, and waits for it.
/// Returns its exit status; 127 where it cannot be started or was stopped by a signal.
int run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& directory);

}  // namespace ashimpact::oracles
