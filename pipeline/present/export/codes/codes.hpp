// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "pipeline/present/export/folder.hpp"
#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// The bytes of an HDF5 file with the table; only the program that is linked with HDF5 has one.
using TableImage = std::function<std::string(const ExportSubject&, const ImpactTable&)>;

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

[[nodiscard]] ExportFolder lammps_folder(const ExportSubject& subject, const TableImage& image = {});
[[nodiscard]] ExportFolder liggghts_folder(const ExportSubject& subject, const TableImage& image = {});
[[nodiscard]] ExportFolder yade_folder(const ExportSubject& subject, const TableImage& image = {});
[[nodiscard]] ExportFolder openfoam_folder(const ExportSubject& subject, const TableImage& image = {});
[[nodiscard]] ExportFolder fluent_folder(const ExportSubject& subject, const TableImage& image = {});
/// @param image needed: one of the files
[[nodiscard]] ExportFolder table_folder(const ExportSubject& subject, const TableImage& image);

}  // namespace ashimpact
