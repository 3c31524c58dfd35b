// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "pipeline/present/export/folder.hpp"

namespace ashimpact {

/// Files that the DEM codes with LAMMPS's input language share, of which one sphere on one wall is the check.
/// impacts.in: the impacts as index variables; ash_wall_z or partner_z last.
[[nodiscard]] ExportFile impact_variables(const ExportSubject& subject);

/// Values of the decks: box, skin, time step of the cloud.
[[nodiscard]] TemplateValues dem_values(const ExportSubject& subject);

/// Commands of ash_wall.in that add forces which the wall of the code lacks, by atom-style variables:
/// attraction if @p attraction, damping if @p damping. If the subject has damping, by whichever force, a last
/// force makes it second order in the time step.
[[nodiscard]] std::string added_forces(const ExportSubject& subject, bool attraction, bool damping);

/// Whether the law attracts: by a work of adhesion or by a parameter of its own.
[[nodiscard]] bool attracts(const ExportSubject& subject);

/// What these codes cannot do on a wall, in words; none: they can.
[[nodiscard]] std::optional<std::string> added_forces_refusal(const ExportSubject& subject);

/// @throws InputError with that reason. @param code its name
void require_added_forces(const ExportSubject& subject, std::string_view code);

/// Conversions that these forces make, for assumptions.md.
[[nodiscard]] std::vector<std::string> added_force_conversions(const ExportSubject& subject, bool attraction,
                                                               bool damping);

/// How the runs of a code are compared.
struct DemCheck {
    std::string_view code;
    double tolerance;           ///< of the restitution, extrapolated to time step zero [1]
    bool damping_lags = false;  ///< it sees the velocity half a step back: first order in the time step
    bool free_flight = false;   ///< the contact ends away from first touch, where the velocity stays the same
};

/// expected.json with the powers of the time step in the error of the restitution.
[[nodiscard]] ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check);

[[nodiscard]] ExportFolder lammps_folder(const ExportSubject& subject);
[[nodiscard]] ExportFolder liggghts_folder(const ExportSubject& subject);
[[nodiscard]] ExportFolder yade_folder(const ExportSubject& subject);

}  // namespace ashimpact
