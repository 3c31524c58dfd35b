// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

Axis angle_axis(std::string label) {
    return {.label = std::move(label), .unit = "°", .scale = degree, .from = 0, .to = 90 * degree};
}

/// One number of all rebounds of a sample against the angle, a line for each velocity.
XyPanel oblique_panel(const SampleData& sample, std::string title, Axis y, double ObliqueRebound::*member) {
    XyPanel panel{
        .title = sample.name() + ", " + std::move(title), .x = angle_axis("angle"), .y = std::move(y)};
    std::size_t number = 0;
    for (const ObliqueCurve& curve : sample.comparison->oblique->curves) {
        const std::string multiple = fmt::format("{:.3g} v_c", curve.multiple);
        Series series{.name = multiple + " = " + readable(curve.velocity, "m/s"),
                      .legend = multiple,
                      .look = Look::of(number++)};
        for (const ObliqueRebound& each : curve.rebounds) series.line.push_back({each.angle, each.*member});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

void add_oblique_numbers(const SampleData& sample, NumberTable& numbers) {
    for (const ObliqueCurve& curve : sample.comparison->oblique->curves)
        for (const ObliqueRebound& each : curve.rebounds)
            numbers.rows.push_back({sample.name(), curve.velocity, each.angle / degree, each.restitution,
                                    each.tangential_restitution, each.rebound_angle / degree});
}

}  // namespace

bool has_oblique(const RunData& run) {
    for (const SampleData& sample : run.samples())
        if (sample.comparison->oblique) return true;
    return false;
}

Figure oblique_figure(const RunData& run) {
    Figure figure{.id = "oblique",
                  .title = "Rebound at an angle",
                  .numbers = {.columns = {"sample", "velocity [m/s]", "angle [deg]", "restitution",
                                          "tangential restitution", "rebound angle [deg]"},
                              .shown_every = 4},
                  .columns = 2};
    for (const SampleData& sample : run.samples()) {
        if (!sample.comparison->oblique) continue;
        const auto& [law, friction, curves] = *sample.comparison->oblique;
        figure.caption = fmt::format(
            "Of a rigid sphere without spin before the impact, by {} and a coefficient of friction of "
            "{:.3g}, "
            "at velocities of the sphere in multiples of v_c; angles are from the normal. Left: the share of "
            "the velocity along the wall that is left. Where the sphere rolls in the end it is 5/7. Right: "
            "the "
            "angle of the rebound. A line ends where the normal velocity falls to v_c: beyond, the sphere is "
            "captured.",
            display_name(law.name()), friction);
        figure.panels.emplace_back(oblique_panel(sample, "tangential restitution",
                                                 {.label = "e_t", .from = 0.6, .to = 1},
                                                 &ObliqueRebound::tangential_restitution));
        figure.panels.emplace_back(oblique_panel(sample, "rebound angle", angle_axis("rebound angle"),
                                                 &ObliqueRebound::rebound_angle));
        add_oblique_numbers(sample, figure.numbers);
    }
    if (figure.panels.empty())
        figure.caption = "The case has no friction, or no sample a finite critical velocity.";
    return figure;
}

}  // namespace ashimpact::report
