// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace ashimpact::test {

/// A JSON file of tests/data. @throws std::runtime_error where it cannot be read
[[nodiscard]] inline nlohmann::json data_file(const std::string& name) {
    const std::string path = std::string(ASHIMPACT_TEST_DATA "/").append(name);
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return nlohmann::json::parse(file);
}

}  // namespace ashimpact::test
