// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/present/report/data/run_data.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/drawing/panel.hpp"

namespace ashimpact::report {

/// Look of a law: by its place in the registry, the same in every figure.
[[nodiscard]] Look look_of(const LawData& law, bool hollow = false);

/// The model's curve of a law as a series; @p y gives what is drawn over the velocity.
[[nodiscard]] Series curve_series(const SampleData& sample, const LawData& law,
                                  const std::function<double(const CurveImpact&)>& y);

/// The band of the model's curve between its two velocities, closed.
[[nodiscard]] std::vector<Point> velocity_band(const ModelCurve& curve);

/// The velocities below which impacts are captured by every law; ends at the least critical velocity.
[[nodiscard]] std::vector<Region> capture_region(const SampleData& sample);

/// Whether the impacts of a law's series were reconstructed.
[[nodiscard]] bool is_reconstructed(const LawData& law);

/// Where the points of a law's series come from, as tables list it.
[[nodiscard]] std::string origin_of(const DampingSeries& series);

/// A number of a table, or an empty cell.
[[nodiscard]] Cell cell_of(const std::optional<double>& value);

/// A bar of the total Sobol index of a variable, its standard error, and a mark for the first order.
/// @param name begins their readouts
[[nodiscard]] Row sobol_row(const std::string& label, const std::string& name, const Look& look, double first,
                            double total, const std::optional<double>& total_error = {});

/// "Points reconstructed from published fits" or the like, as a sentence for captions.
[[nodiscard]] std::string origin_sentence(const RunData& run);

/// How the extrapolated velocities differ from the answer, as a sentence for captions; empty for a run
/// without any.
[[nodiscard]] std::string extrapolation_sentence(const RunData& run);

}  // namespace ashimpact::report
