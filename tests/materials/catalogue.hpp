// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "materials/phase_catalogue.hpp"

namespace ashimpact::test {

/// The bytes of a file below the source folder.
[[nodiscard]] inline std::string file_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The catalogue as the program loads it: literature values first.
[[nodiscard]] inline PhaseCatalogue shipped_catalogue() {
    const std::string folder = ASHIMPACT_DATA "/phases/";
    return PhaseCatalogue({read_phase_set(file_text(folder + "literature.json")),
                           read_phase_set(file_text(folder + "dong2013.json"))});
}

}  // namespace ashimpact::test
