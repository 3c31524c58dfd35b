// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "pipeline/app/options/contact_options.hpp"
#include "pipeline/present/export/codes/codes.hpp"

namespace ashimpact {

/// Options of `ashimpact export`; empty if not given.
struct ExportOptions {
    std::string code;  ///< openfoam, lammps, liggghts, yade, fluent, table
    std::string run;   ///< folder of a run; if empty, the options of an impact
    std::string sample;
    bool follow_velocity = false;
    ContactOptions contact;
    std::string velocity;
    std::string from_diameter;
    std::string to_diameter;
    std::string to_velocity;
    std::string damping_exponent;
    std::string folder;
};

/// The command's body; tables are exported by the program that is linked with HDF5.
using ExportRunner = std::function<void(const ExportOptions&, std::ostream& out)>;

/// `ashimpact export`: writes a folder that runs in another code. @param image used for tables only
/// @throws InputError for a subject that the code cannot do, with the reason; then nothing is written
void run_export_command(const ExportOptions& options, const TableImage& image, std::ostream& out);

}  // namespace ashimpact
