// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "pipeline/present/export/codes/tables.hpp"

namespace ashimpact {

/// A code that folders are written for.
struct ExportCode {
    std::string_view name;  ///< on the command line
    /// The files of a subject. @throws InputError for a subject that the code cannot do, with the reason
    ExportFolder (*folder)(const ExportSubject&, const TableImage&);
    std::string_view script = "run.sh";  ///< runs and compares
};

[[nodiscard]] std::span<const ExportCode> export_codes();

/// The code of that name. @throws InputError with the names of all
[[nodiscard]] const ExportCode& export_code(std::string_view name);

}  // namespace ashimpact
