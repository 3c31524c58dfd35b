// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "pipeline/present/export/folder.hpp"
#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// The bytes of an HDF5 file with the table; only the program that is linked with HDF5 has one.
using TableImage = std::function<std::string(const ExportSubject&, const ImpactTable&)>;

/// critical_velocity.csv and table.csv.
[[nodiscard]] ExportFile critical_velocity_csv(const ImpactTable& table);
[[nodiscard]] ExportFile table_csv(const ExportSubject& subject, const ImpactTable& table);

/// expected.json of codes that look impacts up in a table.
[[nodiscard]] ExportFile table_expected(const ExportSubject& subject, std::string_view code,
                                        const ImpactTable& table);

[[nodiscard]] ExportFolder table_folder(const ExportSubject& subject, const TableImage& image);
[[nodiscard]] ExportFolder openfoam_folder(const ExportSubject& subject);
[[nodiscard]] ExportFolder fluent_folder(const ExportSubject& subject);

}  // namespace ashimpact
