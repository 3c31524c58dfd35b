// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/present/report/data/run_data.hpp"
#include "pipeline/present/report/drawing/panel.hpp"

namespace ashimpact::report {

/// Look of a law: by its place in the registry, the same in every figure.
[[nodiscard]] Look look_of(const LawData& law, bool hollow = false);

/// The model's curve of a law as a series; @p y gives what is drawn over the velocity.
[[nodiscard]] Series curve_series(const SampleData& sample, const LawData& law,
                                  const std::function<double(const CurveImpact&)>& y);

/// The band of the model's curve between its two velocities, closed.
[[nodiscard]] std::vector<Point> velocity_band(const ModelCurve& curve);

/// The velocities below which impacts are captured by some and by every law; ends at the headlines.
[[nodiscard]] std::vector<Region> capture_region(const SampleData& sample);

/// Whether the impacts of a law's series were reconstructed.
[[nodiscard]] bool is_reconstructed(const LawData& law);

/// The numbers of a column {"values": [..]} of a JSON entry; empty where there is none; null as NaN.
[[nodiscard]] std::vector<double> column_in(const Json& entry, const char* key);

/// "Points reconstructed from published fits" or the like, as a sentence for captions.
[[nodiscard]] std::string origin_sentence(const RunData& run);

/// The critical velocity at which the fit to measured rebounds meets e = 0, where there is one [m/s].
[[nodiscard]] std::optional<double> extrapolated_velocity(const LawData& law);

/// How that velocity differs from the answer, as a sentence for captions; empty for a run that has none.
[[nodiscard]] std::string extrapolation_sentence(const RunData& run);

}  // namespace ashimpact::report
