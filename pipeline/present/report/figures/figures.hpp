// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/run/results/run.hpp"
#include "solver/inference/calibration/velocities_over_sizes.hpp"

namespace ashimpact::report {

/// What a run found out about one law and one sample; null where there is no such result.
struct LawData {
    LawChoice choice;
    std::string name;  ///< for readers, "Brach-Dunn"
    const RestitutionSeries* measured = nullptr;
    const DampingSeries* damping = nullptr;
    const LawFit* fit = nullptr;
    const LawCriticalVelocity* velocity = nullptr;
    const LawComparison* compared = nullptr;
    const std::vector<History>* histories = nullptr;
    const LawCurve* drawn = nullptr;

    /// Whether the impacts of this law were reconstructed.
    [[nodiscard]] bool is_reconstructed() const {
        return measured != nullptr && measured->origin != Origin::measured;
    }
    /// The critical velocity of this law with its interval.
    [[nodiscard]] std::optional<VelocityEstimate> headline() const {
        return velocity != nullptr ? velocity->velocity : std::nullopt;
    }
    /// The critical velocity at which the fit to measured rebounds meets e = 0 [m/s].
    [[nodiscard]] std::optional<double> extrapolated() const;
    /// The model's curve e(v_in); empty if there is none.
    [[nodiscard]] const ModelCurve& curve() const;
};

/// The results of one sample.
struct SampleData {
    const Sample* sample;
    const SampleModulus* modulus;
    const SampleContact* contact;
    const SampleAnalytic* analytic;
    const SampleCriticalVelocity* velocity;
    const SampleComparison* comparison;
    std::vector<LawData> laws{};

    [[nodiscard]] const std::string& name() const { return sample->name; }
};

/// A run by samples and laws, for figures and pages.
class RunData {
  public:
    /// @param label distinguishes this run from others: its folder; may be empty
    RunData(Run run, std::string label);

    [[nodiscard]] const std::string& label() const { return label_; }
    [[nodiscard]] const Run& run() const { return run_; }
    [[nodiscard]] const Case& data() const { return run_.data; }
    [[nodiscard]] const std::vector<SampleData>& samples() const { return samples_; }
    [[nodiscard]] std::string damping_unit() const;

  private:
    std::string label_;
    Run run_;  // samples_ refer to its vectors, which a move of it leaves in place
    std::vector<SampleData> samples_;
};

/// A law's name for readers: "brach-dunn" as "Brach-Dunn", "jkr" as "JKR".
[[nodiscard]] std::string display_name(std::string_view law);

[[nodiscard]] Figure composition_figure(const RunData& run);
[[nodiscard]] Figure static_force_figure(const RunData& run);
[[nodiscard]] Figure regime_map_figure(const RunData& run);
[[nodiscard]] Figure restitution_figure(const RunData& run);
[[nodiscard]] Figure damping_figure(const RunData& run);
[[nodiscard]] Figure damping_fit_figure(const RunData& run);
[[nodiscard]] Figure damping_laws_figure(const RunData& run);
[[nodiscard]] Figure which_sizes_figure(const RunData& run);
[[nodiscard]] Figure critical_velocity_by_size_figure(const RunData& run);
[[nodiscard]] Figure contact_time_figure(const RunData& run);
[[nodiscard]] Figure sizes_figure(const RunData& run);
[[nodiscard]] Figure histories_figure(const RunData& run);
[[nodiscard]] Figure energy_figure(const RunData& run);
[[nodiscard]] Figure critical_velocity_figure(const RunData& run);
[[nodiscard]] Figure sensitivity_figure(const RunData& run);
[[nodiscard]] Figure oblique_figure(const RunData& run);
[[nodiscard]] Figure temperature_figure(const RunData& run);

/// Whether a run has rebounds at an angle, so that there is a figure of them.
[[nodiscard]] bool has_oblique(const RunData& run);

/// Whether a run knows the viscosity of a glass, so that there is a figure of it.
[[nodiscard]] bool has_temperatures(const RunData& run);

/// A figure of a run, by its id.
struct FigureMaker {
    std::string_view id;
    Figure (*make)(const RunData& run);
    std::vector<std::string_view> shows;  ///< artifacts that it shows numbers of, beside the case
    /// Whether a page has it; figures without data give the reason in their caption.
    bool (*is_on_page)(const RunData& run) = [](const RunData&) { return true; };
};

/// All figures of a run, in the order of the report.
[[nodiscard]] const std::vector<FigureMaker>& figure_makers();

/// The figure of that id. @throws InputError naming the others
[[nodiscard]] const FigureMaker& figure_maker_named(std::string_view id);
[[nodiscard]] inline Figure figure_named(std::string_view id, const RunData& run) {
    return figure_maker_named(id).make(run);
}

// What figures share.

/// Axis of a quantity in SI, with the unit prefix that shows @p greatest as 1 to 1000, if the unit takes any.
[[nodiscard]] Axis quantity_axis(std::string label, std::string_view si, double greatest);

/// The largest magnitude among numbers that are finite, 0 without any.
[[nodiscard]] double greatest_of(const std::vector<double>& values);

/// Look of a law: by its place in the registry, the same in every figure.
[[nodiscard]] Look look_of(const LawData& law, bool hollow = false);

/// The velocities by size of one assumption, with the band of their intervals.
[[nodiscard]] Series size_series_of(const ComparisonResult& comparison, SizeBasis basis);

/// Published critical velocities and lines of laws against diameter; a run adds its own samples.
[[nodiscard]] Figure literature_figure(const std::vector<LawBySize>& laws);

/// Velocities over sizes with a law whose constants were calibrated to them, its line with the band of their
/// uncertainties. @param conclusion of the calibration, in words
[[nodiscard]] Figure calibrated_velocities_figure(const CalibrationProblem& problem,
                                                  const std::vector<CalibratedVelocity>& line,
                                                  const std::string& conclusion);

/// A number of a table, or an empty cell.
[[nodiscard]] Cell cell_of(const std::optional<double>& value);
/// A critical velocity of a table [m/s], in words where it is outside the model.
[[nodiscard]] Cell critical_cell(const std::optional<double>& value);

/// A bar of the total Sobol index, its standard error, a mark of the first order. @param name begins readouts
[[nodiscard]] Row sobol_row(const std::string& label, const std::string& name, const Look& look, double first,
                            double total, const std::optional<double>& total_error = {});

}  // namespace ashimpact::report
