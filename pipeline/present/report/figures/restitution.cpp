// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"
#include "solver/statistics/interval.hpp"

namespace ashimpact::report {

namespace {

/// The impacts of one series: the law's own where reconstructed, shared by all laws where measured.
Series impacts_series(const SampleData& sample, const LawData& law) {
    const bool reconstructed = is_reconstructed(law);
    Series series{
        .name = sample.name() + (reconstructed ? ", " + law.name + ", reconstructed" : ", measured"),
        .legend = reconstructed ? law.name + ", reconstructed" : "measured, ± 95 %",
        .look = reconstructed ? look_of(law, true) : Look::plain(0)};
    for (const Measurement& impact : law.measured->impacts.points) {
        const double e = impact.restitution();
        double error = 0;
        if (!reconstructed && impact.noise)
            error = confidence_quantile() *
                    std::sqrt(std::max(0.0, impact.noise->rebound + e * e * impact.noise->incident -
                                                2 * e * impact.noise->covariance)) /
                    impact.velocity;
        series.marks.push_back({impact.velocity, e, 0, std::isfinite(error) ? error : 0});
    }
    return series;
}

XyPanel panel_of(const SampleData& sample, NumberTable& table) {
    XyPanel panel{.title = sample.name(),
                  .x = velocity_axis(),
                  .y = restitution_axis(),
                  .regions = capture_region(sample)};
    const RestitutionSeries* drawn = nullptr;
    std::vector<Series> points;
    for (const LawData& law : sample.laws) {
        Series curve =
            curve_series(sample, law, [](const CurveImpact& impact) { return impact.restitution; });
        if (!curve.line.empty() && law.drawn->start)
            curve.line.insert(curve.line.begin(), {*law.drawn->start, 0.0});
        curve.band = velocity_band(law.curve());
        panel.series.push_back(std::move(curve));
        for (const CurveImpact& impact : law.curve())
            table.rows.push_back({sample.name(), law.name, std::string("model"), impact.velocity,
                                  impact.restitution, impact.lower, impact.upper});
        if (law.measured == nullptr || law.measured == drawn) continue;
        drawn = law.measured;
        points.push_back(impacts_series(sample, law));
        for (const Mark& mark : points.back().marks)
            table.rows.push_back({sample.name(), is_reconstructed(law) ? law.name : std::string(),
                                  std::string(name_of(law.measured->origin)), mark.x, mark.y, std::string(),
                                  std::string()});
    }
    for (Series& each : points) panel.series.push_back(std::move(each));
    if (const auto& measured = sample.velocity->measured; measured && measured->value)
        panel.rules.push_back({*measured->value, "v_c measured", Look::plain(0)});
    return panel;
}

}  // namespace

Figure restitution_figure(const RunData& run) {
    Figure figure{.id = "restitution",
                  .title = "Restitution against incident velocity",
                  .counterpart = "Figure 5",
                  .caption =
                      "Below the critical velocity a particle is captured (e_n = 0); just above it e_n rises "
                      "steeply. Lines are the model of each "
                      "law with the damping η(e_n) of its fit, drawn down to the fit's critical velocity and "
                      "up to the greatest restitution of "
                      "its data; a band in a law's colour is what the uncertainty of that fit "
                      "leaves open (95 %), the contact taken as known. The grey strip that begins at zero: "
                      "captured by every law." +
                      extrapolation_sentence(run) + origin_sentence(run),
                  .panels = {},
                  .numbers = {.columns = {"sample", "law", "origin", "v_in [m/s]", "e_n",
                                          "v_in, lower end [m/s]", "v_in, upper end [m/s]"}}};
    for (const SampleData& sample : run.samples())
        figure.panels.emplace_back(panel_of(sample, figure.numbers));
    share_axes(figure.panels, false, true);
    return figure;
}

}  // namespace ashimpact::report
