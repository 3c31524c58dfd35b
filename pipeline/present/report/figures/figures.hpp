// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/present/report/data/run_data.hpp"
#include "pipeline/present/report/drawing/figure.hpp"

namespace ashimpact::report {

[[nodiscard]] Figure composition_figure(const RunData& run);
[[nodiscard]] Figure static_force_figure(const RunData& run);
[[nodiscard]] Figure regime_map_figure(const RunData& run);
[[nodiscard]] Figure restitution_figure(const RunData& run);
[[nodiscard]] Figure damping_figure(const RunData& run);
[[nodiscard]] Figure damping_fit_figure(const RunData& run);
[[nodiscard]] Figure contact_time_figure(const RunData& run);
[[nodiscard]] Figure sizes_figure(const RunData& run);
[[nodiscard]] Figure histories_figure(const RunData& run);
[[nodiscard]] Figure energy_figure(const RunData& run);
[[nodiscard]] Figure critical_velocity_figure(const RunData& run);
[[nodiscard]] Figure sensitivity_figure(const RunData& run);

/// A figure of a run, by its id.
struct FigureMaker {
    std::string_view id;
    Figure (*make)(const RunData& run);
};

/// All figures of a run, in the order of the report.
[[nodiscard]] const std::vector<FigureMaker>& figure_makers();

/// The figure of that id. @throws InputError naming the others
[[nodiscard]] Figure figure_named(std::string_view id, const RunData& run);

}  // namespace ashimpact::report
