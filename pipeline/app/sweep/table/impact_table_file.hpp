// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pipeline/present/export/impact_table.hpp"

namespace ashimpact {

/// The bytes of an HDF5 file with a table of impacts: datasets diameter, critical_velocity, start_velocity,
/// slope, t; velocity, restitution, contact_time, damping over (diameter, t), each with its unit. The same
/// table gives the same bytes.
/// @throws hdf5::Hdf5Error
[[nodiscard]] std::string impact_table_image(const ExportSubject& subject, const ImpactTable& table);

}  // namespace ashimpact
