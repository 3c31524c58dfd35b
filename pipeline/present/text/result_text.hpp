// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/results/note.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

// What the summary in a terminal and the report have in common about critical velocities.

/// Three digits, trailing zeros kept, so that the velocities of a column line up [m/s]. One that is outside
/// of the model is replaced by words, see critical_velocity_text().
[[nodiscard]] std::string velocity_text(double velocity);

/// A critical velocity or another quantity with its unit, "1.934 m/s"; likewise.
[[nodiscard]] std::string value_text(double value, std::string_view unit);

/// "1.85 to 2.01"; an end without a bound is "open". Empty if neither end is known.
[[nodiscard]] std::string bounds_text(const std::optional<Bounds>& bounds);

/// The same with a unit each: "1.85 m/s to 2.01 m/s".
[[nodiscard]] std::string bounds_text(const std::optional<double>& lower, const std::optional<double>& upper,
                                      std::string_view unit);

/// "1.93 m/s (95 %: 1.68 to 2.21 m/s)", or "no finite value".
[[nodiscard]] std::string estimate_text(const std::optional<VelocityEstimate>& velocity);

/// "agrees", "too low" or "too high"; empty if there is nothing to compare with.
[[nodiscard]] std::string_view verdict_words(const std::optional<CriticalVelocityCheck>& check);

/// Whether the velocity of a law is the paper's extrapolation, because its impacts give no estimate.
[[nodiscard]] bool is_extrapolated(const LawComparison& law);

/// Whether v_c follows from the measured impacts alone, the same by every law.
[[nodiscard]] inline bool is_of_impacts(const ReportedVelocity& reported) {
    return reported.velocity && reported.velocity->method == VelocityMethod::estimate;
}

/// Heading of the velocities of the samples in a table by size: "measured", or "of samples" where they rest
/// on a damping that was held, reconstructed or extrapolated, so that no impacts alone give them.
[[nodiscard]] std::string_view samples_words(const ComparisonResult& result);

/// What is reported of a sample: its critical velocity, or the bound that the impacts give instead.
struct Answer {
    enum class Kind { none, velocity, above, below };
    Kind kind = Kind::none;
    double velocity = 0;  ///< that or the bound [m/s]
};
[[nodiscard]] Answer answer_of(const ReportedVelocity& reported);

/// Whether the restitutions of all samples were reconstructed from published fits of damping.
[[nodiscard]] bool is_reproduction(const ComparisonResult& result);

/// The first part of the summary of a run: which particles stick below which velocity, by which law and why,
/// what the intervals are, and what a reproduction leaves open. Empty for older artifacts, which do not have
/// it. @param scope from scope_sentence(); empty: not shown
[[nodiscard]] std::string reported_text(const ComparisonResult& result, const std::string& scope,
                                        std::size_t width);

/// The summary that ends a run, in lines of at most @p width characters: the critical velocity to report of
/// each sample and why; assumptions; velocities of all laws; moduli; the conclusion.
/// @param scope from scope_sentence(); empty: not shown
[[nodiscard]] std::string comparison_text(const ComparisonResult& result, std::size_t width = output_width(),
                                          const std::string& scope = {});

/// For what the results of a case hold, and what it does not state: "Holds for normal impact on a flat wall,
/// dry, at room temperature, smooth surfaces; not stated: temperature, roughness."
[[nodiscard]] std::string scope_sentence(const Case& data);

/// What a run read of its samples, so that a file that was understood otherwise than meant can be seen: size,
/// density, phases by weight, and the ranges of the impacts with their uncertainties. The first six samples.
[[nodiscard]] std::string inputs_text(const Run& run, std::size_t width = output_width());

/// The same of the result of comparison.json. @throws InputError for values that no stage can have written
[[nodiscard]] std::string comparison_text(Json result, std::size_t width = output_width(),
                                          const std::string& scope = {});

/// The part of that summary on temperatures; empty where neither a temperature nor chemistry is known.
[[nodiscard]] std::string temperature_text(const ComparisonResult& result, std::size_t width);

/// Which damping law explains the impacts: constants, misfits and critical velocities in a table.
[[nodiscard]] std::string dampings_text(const DampingComparison& comparison,
                                        std::size_t width = output_width());

/// "60 to 130 um"
[[nodiscard]] std::string size_range_text(const SizeRange& range);

/// What the critical velocities by size say: where the assumptions on damping agree, or on what the others
/// rest. Empty if there are none.
[[nodiscard]] std::string sizes_sentence(const ComparisonResult& result);

/// The critical velocities of some sizes in a table; empty if there are none.
[[nodiscard]] std::string sizes_text(const ComparisonResult& result, std::size_t width);

/// A note of an artifact of a run.
struct Remark {
    std::string file;  ///< of the artifact
    Note note;
};

/// The remarks of one kind.
struct RemarkLine {
    std::string text;
    /// Whether it may change what the reader reports; see Severity.
    bool decides = true;
};

/// Remarks of a run, one line a kind: "2 x 6-fit.json (fine; dmt, jkr): ...", without reasons. Remarks of one
/// artifact that differ in sample, law and numbers alone are of one kind, of which the first is shown. @param
/// samples their number in the run
[[nodiscard]] std::vector<RemarkLine> remark_lines(const std::vector<Remark>& remarks, std::size_t samples);

/// How much of a result is shown.
struct ResultView {
    bool all = false;  ///< every row and every part; else long ones are shortened, with a note
    std::size_t width = output_width();  ///< characters of a line
};

/// Any JSON result for a reader: quantities in convenient units, columns as tables, histograms as bars,
/// entries of one kind (such as those of contact laws) side by side, the rest as an indented list.
[[nodiscard]] std::string result_text(const Json& result, const ResultView& view = {});

/// An artifact for a reader. @param provenance whether inputs, options and citations are shown too
[[nodiscard]] std::string artifact_text(const Json& artifact, const ResultView& view = {},
                                        bool provenance = false);

}  // namespace ashimpact
