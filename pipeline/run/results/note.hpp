// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/names.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// How much a note matters to what is reported.
enum class Severity {
    background,  ///< an assumption or a model that every such run has
    remark,      ///< may change what is reported
    doubt,       ///< a result is missing or contradicts another
};

template <>
struct Names<Severity> {
    static constexpr std::string_view kind = "severity";
    static constexpr std::array<std::string_view, 3> all{"background", "remark", "doubt"};
};

/// What a note is about. Notes of one code differ in sample, law and numbers only.
enum class NoteCode {
    reading,               ///< how an input file was read
    phase,                 ///< which phase a name was taken for
    input,                 ///< remarks on the values of the case
    assumed_property,      ///< a property of the phases that no source states
    variance,              ///< what dominates the uncertainty of Young's modulus
    porosity,              ///< the porosity follows from the density
    density,               ///< the stated density and that of the phases disagree
    roughness,             ///< the rms is beyond the range of the reduction of w
    no_restitution,        ///< a sample without impacts
    no_point,              ///< a restitution that cannot be reconstructed
    falling_fit,           ///< a published fit that is not one of a rising branch
    unreachable,           ///< restitutions that no damping gives
    outliers,              ///< impacts far from the others
    no_rising_branch,      ///< none can be found
    no_rebound,            ///< captures only
    no_fit,                ///< the impacts allow none
    fit,                   ///< remarks of the analysis of impacts
    no_extrapolation,      ///< the estimate takes its place
    fits_disagree,         ///< the extrapolation and the estimate exclude one another
    extrapolated_fit,      ///< remarks on the extrapolation, which is not the headline
    no_interval,           ///< why v_c has none
    no_measured_velocity,  ///< the outcomes of the impacts give none
    calibration_response,  ///< inferred constants are taken as independent of the modulus
    regime,                ///< the regime of the impact is outside of the law's
    edited,                ///< an artifact was edited after it was written
    example,               ///< values of the example case are left
    report,                ///< the report cannot be made
    general,               ///< of an artifact of a version without codes
};

template <>
struct Names<NoteCode> {
    static constexpr std::string_view kind = "code of a note";
    static constexpr std::array<std::string_view, 28> all{"reading",
                                                          "phase",
                                                          "input",
                                                          "assumed-property",
                                                          "variance",
                                                          "porosity",
                                                          "density",
                                                          "roughness",
                                                          "no-restitution",
                                                          "no-point",
                                                          "falling-fit",
                                                          "unreachable",
                                                          "outliers",
                                                          "no-rising-branch",
                                                          "no-rebound",
                                                          "no-fit",
                                                          "fit",
                                                          "no-extrapolation",
                                                          "fits-disagree",
                                                          "extrapolated-fit",
                                                          "no-interval",
                                                          "no-measured-velocity",
                                                          "calibration-response",
                                                          "regime",
                                                          "edited",
                                                          "example",
                                                          "report",
                                                          "general"};
};

/// A remark on a run as a value; see text_of().
struct Note {
    NoteCode code = NoteCode::general;
    Severity severity = Severity::remark;
    std::string stage{};       ///< that made it, "fit"
    std::string sample{};      ///< empty: it concerns the whole run
    std::optional<Law> law{};  ///< none: it concerns every law
    std::string text{};        ///< without sample and law
};

/// "88 um, hertz: ...": the note with sample and law in front.
[[nodiscard]] inline std::string text_of(const Note& note) {
    if (note.sample.empty()) return note.text;
    return note.sample + (note.law ? ", " + std::string(note.law->name()) : "") + ": " + note.text;
}

}  // namespace ashimpact
