// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pipeline/app/sweep/spec/plan.hpp"
#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// Writes the full table as an HDF5 file from the packed rows: a dataset of doubles a column, shuffled and
/// deflated, unit and description as its attributes. No time stamps: the same rows give the same bytes. No
/// reader ever sees half a file.
/// @throws InputError if the file cannot be written
void write_table(const std::filesystem::path& file, const SweepPlan& plan, const std::filesystem::path& rows);

/// Hash (SweepPlan::hash) of the spec to which a table belongs; none if no sweep wrote the file.
[[nodiscard]] std::optional<std::string> spec_of_table(const std::filesystem::path& file);

/// The bytes of an HDF5 file with a table of impacts: datasets diameter, critical_velocity, start_velocity,
/// slope, t; velocity, restitution, contact_time, damping over (diameter, t), each with its unit. The same
/// table gives the same bytes.
/// @throws std::runtime_error if HDF5 fails
[[nodiscard]] std::string impact_table_image(const ExportSubject& subject, const ImpactTable& table);

}  // namespace ashimpact
