// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "pipeline/present/export/folder.hpp"

/// What DEM codes can represent: models of their own, tables of each code, and for one sphere on one wall
/// Hertz's repulsion with the forces added that the wall of the code lacks.
namespace ashimpact {

/// How a code represents a contact law, or why it cannot.
struct DemModel {
    std::string_view law;
    std::string_view name{};              ///< in the code's input
    bool attracts = false;                ///< by itself; else the attraction of the law is an added force
    std::optional<DampingLaw> damping{};  ///< that it has itself; another one is an added force
    Detachment end = Detachment::zero_overlap;
    std::string_view end_words = "zero overlap";
    std::string_view refusal{};  ///< why there is no such model
};

/// The row of a law, null without any.
[[nodiscard]] const DemModel* model_of(std::span<const DemModel> models, const Law& law);

/// Which forces are added to the model of a wall.
struct AddedForces {
    bool attraction;
    bool damping;
};

/// Commands of ash_wall.in that add these forces by atom-style variables. If the subject has damping, by
/// whichever force, a last force makes it second order in the time step.
[[nodiscard]] std::string added_force_lines(const ExportSubject& subject, AddedForces added);

/// Conversions that these forces make, for assumptions.md.
[[nodiscard]] std::vector<std::string> added_force_conversions(const ExportSubject& subject,
                                                               AddedForces added);

/// What these forces cannot do on a wall, in words; none: they can.
[[nodiscard]] std::optional<std::string> added_forces_refusal(const ExportSubject& subject);

/// How the runs of a code are compared.
struct DemCheck {
    std::string_view code;
    double tolerance;           ///< of the restitution, extrapolated to time step zero [1]
    bool damping_lags = false;  ///< it sees the velocity half a step back: first order in the time step
    bool free_flight = false;   ///< the contact ends away from first touch, where the velocity stays the same
};

/// expected.json with the powers of the time step in the error of the restitution.
[[nodiscard]] ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check);

}  // namespace ashimpact
