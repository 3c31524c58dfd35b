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

// What figures share.

/// An axis of a quantity in SI with the prefix to its unit with which @p greatest reads as 1 to 1000; units
/// without prefixes, and 1, stay.
[[nodiscard]] Axis quantity_axis(std::string label, std::string_view si, double greatest);

/// The largest magnitude among numbers that are finite, 0 without any.
[[nodiscard]] double greatest_of(const std::vector<double>& values);

/// Look of a law: by its place in the registry, the same in every figure.
[[nodiscard]] Look look_of(const LawData& law, bool hollow = false);

/// A number of a table, or an empty cell.
[[nodiscard]] Cell cell_of(const std::optional<double>& value);

/// A bar of the total Sobol index of a variable, its standard error, and a mark for the first order.
/// @param name begins their readouts
[[nodiscard]] Row sobol_row(const std::string& label, const std::string& name, const Look& look, double first,
                            double total, const std::optional<double>& total_error = {});

}  // namespace ashimpact::report
