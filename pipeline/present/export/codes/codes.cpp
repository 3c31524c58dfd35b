// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/codes/codes.hpp"

#include <array>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

std::span<const ExportCode> export_codes() {
    static constexpr std::array codes{
        ExportCode{"openfoam", openfoam_folder}, ExportCode{"lammps", lammps_folder},
        ExportCode{"liggghts", liggghts_folder}, ExportCode{"yade", yade_folder},
        ExportCode{"fluent", fluent_folder},     ExportCode{"table", table_folder, "compare.py"}};
    return codes;
}

const ExportCode& export_code(std::string_view name) {
    std::vector<std::string> names;
    for (const ExportCode& code : export_codes()) {
        if (code.name == name) return code;
        names.emplace_back(code.name);
    }
    throw InputError("no code is called " + in_quotes(name) + did_you_mean(name, names), joined(names))
        .at("export");
}

}  // namespace ashimpact
