// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/document.hpp"
#include "pipeline/present/export/impact_table.hpp"
#include "pipeline/present/export/subject.hpp"
#include "solver/oblique/oblique.hpp"

namespace ashimpact {

/// A file of an exported folder, its name without any folder.
struct ExportFile {
    std::string name;
    std::string content;
};
using ExportFolder = std::vector<ExportFile>;

/// The text for each @key@ of a template.
using TemplateValues = std::map<std::string, std::string, std::less<>>;

/// templates/<path> with every @key@ replaced, by numbers and names of ours, never texts of the user, which
/// might be syntax of the other program. @throws std::logic_error for a key without a value
[[nodiscard]] std::string filled(std::string_view path, const TemplateValues& values);

/// The file templates/<path> as it is.
[[nodiscard]] ExportFile unchanged(std::string_view path);

/// A number that every code reads back as the same double: 17 significant digits.
[[nodiscard]] std::string exact(double value);

/// Values that every template may use: law, detachment, damping, E*, w, sizes, version. E* and w are those of
/// the exported contact; where it is softened, the words for its damping are those of the stiff one.
[[nodiscard]] TemplateValues common_values(const ExportSubject& subject);

/// A line of comment for an input of a softened contact; empty if it is not softened.
[[nodiscard]] std::string softening_comment(const ExportSubject& subject);

/// assumptions.md: sources of the numbers, their conversions (a line each), limits of the model.
[[nodiscard]] ExportFile assumptions(const ExportSubject& subject,
                                     const std::vector<std::string>& conversions);

/// An impact that the other code has to reproduce: outcome and restitution are of the stiff contact, times
/// and overlap of the exported one.
struct ExpectedImpact {
    double diameter;  ///< [m]
    double velocity;  ///< [m/s]
    Outcome outcome;
    double restitution;                      ///< 0 for a capture [1]
    std::optional<double> measured{};        ///< e of the laboratory there; none: not known [1]
    std::optional<double> contact_time;      ///< none for a capture [s]
    std::optional<double> maximum_overlap;   ///< [m]
    double tangential_velocity = 0;          ///< along the wall before the impact; 0 of a normal one [m/s]
    std::optional<ObliqueResult> oblique{};  ///< what an oblique one does along the wall; none: a normal one
};

/// Refuses a size of the expected impacts whose critical velocity is outside the model. @throws InputError
void require_inside_model(const ExportSubject& subject);

/// Refuses a softened contact that overlaps too much in these impacts. @throws InputError with the factor and
/// the velocity that are allowed
void require_small_overlaps(const ExportSubject& subject);

/// Impacts of the smallest, the largest, the known sizes and one between, at 0.99 and 1.01 v_c, at
/// multiples of v_c up to the largest velocity, and at the subject's own velocity.
[[nodiscard]] std::vector<ExpectedImpact> expected_impacts(const ExportSubject& subject);

/// What regime_of() finds on the expected impacts, each once, with the size before it.
[[nodiscard]] std::set<std::string> regime_remarks(const ExportSubject& subject, Severity least);

/// expected.json. @p more has what the comparing script of a code needs beside the impacts.
[[nodiscard]] ExportFile expected_json(const ExportSubject& subject, std::string_view code, const Json& more);

/// The bytes of an HDF5 file with the table; only the program that is linked with HDF5 has one.
using TableImage = std::function<std::string(const ExportSubject&, const ImpactTable&)>;

/// A code that folders are written for.
struct ExportCode {
    std::string_view name;  ///< on the command line
    /// The files of a subject. @throws InputError for a subject that the code cannot do, with the reason
    ExportFolder (*folder)(const ExportSubject&, const TableImage&);
    std::string_view script = "run.sh";  ///< runs and compares
    std::string_view no_contact{};       ///< why there is no contact to soften; empty: there is one
    bool takes_samples = false;          ///< several known sizes, each with its E*, w and damping
    bool pairs_follow = false;           ///< the damping of two spheres may follow the velocity of approach
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

// What DEM codes can represent: their own models; on a wall, Hertz's repulsion with added forces.

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

/// The conversions of a wall, for assumptions.md: the code's own @p lines, then those of these forces.
[[nodiscard]] std::vector<std::string> added_force_conversions(const ExportSubject& subject,
                                                               AddedForces added,
                                                               std::vector<std::string> lines);

/// What these forces cannot do on a wall, in words; none: they can.
[[nodiscard]] std::optional<std::string> added_forces_refusal(const ExportSubject& subject);

/// Stiffness along a wall over that normal to it, where there is friction: large, so that a sphere slides or
/// rolls almost as a rigid one [1].
inline constexpr double tangential_stiffness_ratio = 400;

/// The conversion of the friction, for assumptions.md.
[[nodiscard]] std::string friction_conversion(const ExportSubject& subject);

/// How the runs of a code are compared.
struct DemCheck {
    std::string_view code;
    double tolerance;           ///< of the restitution, extrapolated to time step zero [1]
    bool damping_lags = false;  ///< it sees the velocity half a step back: first order in the time step
    bool free_flight = false;   ///< the contact ends away from first touch, where the velocity stays the same
};

/// Error that codes with a finite tangential stiffness may have of v_t' and spin, of the greater of each and
/// its change [1].
inline constexpr double dem_tangential_tolerance = 0.01;

/// expected.json with the powers of the time step in the error of the restitution.
[[nodiscard]] ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check);

}  // namespace ashimpact
