// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/codes/codes.hpp"

#include <array>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/export/codes/dem.hpp"

namespace ashimpact {

namespace {

template <ExportFolder (*folder)(const ExportSubject&)>
ExportFolder without_image(const ExportSubject& subject, const TableImage& /*image*/) {
    return folder(subject);
}

}  // namespace

std::span<const ExportCode> export_codes() {
    static constexpr std::array codes{ExportCode{"openfoam", without_image<openfoam_folder>},
                                      ExportCode{"lammps", without_image<lammps_folder>},
                                      ExportCode{"liggghts", without_image<liggghts_folder>},
                                      ExportCode{"yade", without_image<yade_folder>},
                                      ExportCode{"fluent", without_image<fluent_folder>},
                                      ExportCode{"table", table_folder, "compare.py"}};
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
