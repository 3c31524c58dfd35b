// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/input_files.hpp"
#include "solver/inference/impacts/measurement.hpp"

/// Readers of the parts of a case. The document conforms to the schema; what a schema cannot express is
/// checked here. Errors: InputError with the JSON pointer.
namespace ashimpact {

/// A quantity with its origin.
[[nodiscard]] Stated read_stated(const View& node, Dimension dimension);
/// A quantity with its origin, which must be positive.
[[nodiscard]] Stated read_positive(const View& node, std::string_view name, Dimension dimension);
[[nodiscard]] Stated read_poisson_ratio(const View& node);
/// The diameter of particles: a positive quantity, or the meshes of two sieves, "80-100 um". Between those,
/// diameters are taken as evenly distributed; a note on that is added to @p notes.
[[nodiscard]] Stated read_diameter(const View& node, std::vector<Finding>& notes);

/// What the case states of a table beside its file. @param sheet, decimal the keys
[[nodiscard]] TableOptions read_table_options(const View& node, std::string_view sheet,
                                              std::string_view decimal);

[[nodiscard]] Wall read_wall(const View& node);
/// Diameter, and density or mass, of a second sphere.
[[nodiscard]] PartnerSphere read_partner(const View& node);
[[nodiscard]] Adhesion read_adhesion(const View& node);
/// One temperature of particle and wall, or {"particle", "wall"}.
[[nodiscard]] Temperatures read_temperatures(const View& node);
[[nodiscard]] Porosity read_porosity(const View& node);

/// The analysis of a sample with its source and the warnings of its file.
struct ReadAnalysis {
    Analysis analysis;
    std::string source;
    std::vector<Finding> warnings;
};
[[nodiscard]] ReadAnalysis read_analysis(const View& node, const std::string& sample, InputFiles& files);

/// The keys of a case on glasses: "oxides", a file, and "glass".
struct GlassDefaults {
    std::optional<View> oxides{}, glass{};
    bool of_many = false;  ///< the case has several samples
};

/// The oxides of a sample and which glass counts: its own, else those of the case. @param node composition
/// @param sample its name, which the file may use
/// @param warnings of the file of oxides are added to it
[[nodiscard]] GlassInputs read_glass(const View& node, const GlassDefaults& defaults,
                                     const std::string& sample, InputFiles& files,
                                     std::vector<Finding>& warnings);

/// Restitution data; @p published serves a reconstruction that names no fits, @p camera impacts without
/// an uncertainty.
[[nodiscard]] RestitutionSource read_restitution(const View& node,
                                                 const std::optional<PublishedSample>& published,
                                                 InputFiles& files, const std::optional<View>& camera);

/// Published values; those without an uncertainty get that of the rounding of their last digit, u =
/// d/sqrt(12).
[[nodiscard]] PublishedSample read_published(const View& node, const std::string& source,
                                             const std::optional<View>& rounding);

/// Replaces the detachments of laws by those that a document gives, {"<law>": "<detachment>"}.
/// @param known_laws what @p choices are called in messages, such as "a law of the case"
/// @throws InputError with the JSON pointer for a law that is not among @p choices or does not admit its
/// detachment
void read_detachments(const std::optional<View>& node, std::vector<LawChoice>& choices,
                      const std::string& known_laws);

/// The camera that velocities were read from. @throws InputError with the JSON pointer
[[nodiscard]] Camera read_camera(const View& node);
/// "80000", "80 kHz" or "80000 fps" [1/s]. @throws InputError
[[nodiscard]] double read_frame_rate(std::string_view text);

/// Measured impacts, from columns in the case or a file; @p camera serves impacts without an
/// uncertainty. @throws InputError with the JSON pointer, or the file and line
[[nodiscard]] MeasuredRestitution read_measured(const View& node, InputFiles& files,
                                                const std::optional<View>& camera);

/// How measured impacts are fitted, and how uncertainties are propagated to v_c. Absent keys have their
/// defaults.
[[nodiscard]] MeasuredDampingOptions read_fit_options(const std::optional<View>& node);
[[nodiscard]] UncertaintyChoices read_uncertainty_choices(const std::optional<View>& node);

/// Checks a relative standard uncertainty or deviation. @param is_bare whether it was written without a unit
/// @throws InputError for one that is not above 0, or above @p most, and for a bare one above 0.1, which may
/// be a fraction or per cent
void require_relative(double value, bool is_bare, double most = 0.5);

/// Reads impacts in columns: velocity, restitution or rebound_velocity and, where they are known,
/// velocity_uncertainty, rebound_uncertainty (standard, of v_in and v_r), velocity_correlation (of these two
/// errors), rebound_resolution (v_r that is always seen), noted_capture (1: seen to stick) and impacts (of
/// which a point is the mean). Restitution 0 is a capture. restitution_uncertainty may stand in place of
/// rebound_uncertainty; the errors of v_in and e_n are then taken as independent.
/// @throws InputError with the JSON pointer for columns that contradict each other or invalid impacts
[[nodiscard]] MeasurementSet read_measurement_columns(const View& node);

/// Checks impacts before they are used. A restitution of 1 or more must be explained by three standard
/// uncertainties.
/// @throws InputError naming the point, or its line
void check_impacts(const MeasurementSet& set);
/// The impacts of a table, checked.
[[nodiscard]] MeasurementSet read_impacts(std::string_view text, const std::string& name,
                                          const TableOptions& options = {});

}  // namespace ashimpact
