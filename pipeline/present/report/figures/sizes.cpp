// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"
#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact::report {

namespace {

/// Damping of one size at equal velocity, interpolated between its points and never beyond them.
struct SizeCurve {
    const SampleData* sample;
    std::vector<Point> points;  ///< by velocity, increasing
};

/// The points of a law by velocity; equal velocities once.
std::vector<Point> sorted_points(const LawData& law) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < law.damping->velocity.size(); ++i)
        points.push_back({law.damping->velocity[i], law.damping->damping[i]});
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    points.erase(
        std::unique(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x == b.x; }),
        points.end());
    return points;
}

MeasuredCurve interpolated(const std::vector<Point>& points) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Point& point : points) {
        x.push_back(point.x);
        y.push_back(point.y);
    }
    return {x, y};
}

/// "damping of 88 um is 1.02 to 1.31 times that of 104 um at equal velocity", between the smallest and the
/// largest.
std::string statement(const std::string& law, std::vector<SizeCurve> sizes) {
    if (sizes.size() < 2) return {};
    std::sort(sizes.begin(), sizes.end(), [](const SizeCurve& a, const SizeCurve& b) {
        return a.sample->sample->diameter.value() < b.sample->sample->diameter.value();
    });
    const SizeCurve& small = sizes.front();
    const SizeCurve& large = sizes.back();
    if (small.points.size() < 3 || large.points.size() < 3) return {};
    const MeasuredCurve one = interpolated(small.points);
    const MeasuredCurve other = interpolated(large.points);
    const double from = std::max(one.lower(), other.lower());
    const double to = std::min(one.upper(), other.upper());
    if (!(to > from))
        return fmt::format(" {}: no velocity is in the range of both {} and {}.", law, small.sample->name(),
                           large.sample->name());
    double least = one(from) / other(from);
    double greatest = least;
    for (int i = 0; i <= 64; ++i) {
        const double v = std::min(to, from + (to - from) * i / 64);
        least = std::min(least, one(v) / other(v));
        greatest = std::max(greatest, one(v) / other(v));
    }
    return fmt::format(
        " {}: from {:.3g} to {:.3g} m/s the damping of {} is {:.3g} to {:.3g} times that of {} at equal "
        "velocity.",
        law, from, to, small.sample->name(), least, greatest, large.sample->name());
}

}  // namespace

Figure sizes_figure(const RunData& run) {
    Figure figure{.id = "sizes",
                  .title = "Sizes compared: damping against incident velocity",
                  .counterpart = "Figure 8",
                  .caption =
                      "The dampings of all samples over one axis, a panel for each law. Lines interpolate "
                      "the points without overshoot, and only "
                      "between them.",
                  .panels = {},
                  .numbers = {.columns = {"law", "sample", "diameter [m]", "v_in [m/s]",
                                          "damping [" + run.damping_unit() + "]"}},
                  .columns = 2,
                  .panel_height = 250};
    double greatest = 0;
    for (const LawChoice& choice : run.data().laws) {
        XyPanel panel{.title = display_name(choice.law.name()),
                      .x = velocity_axis(),
                      .y = {.label = "η", .from_zero = true}};
        std::vector<SizeCurve> sizes;
        for (std::size_t s = 0; s < run.samples().size(); ++s) {
            const SampleData& sample = run.samples()[s];
            for (const LawData& law : sample.laws) {
                if (!(law.choice.law == choice.law) || law.damping == nullptr ||
                    law.damping->velocity.empty())
                    continue;
                sizes.push_back({&sample, sorted_points(law)});
                Series series{.name = sample.name() + ", " + law.name,
                              .legend = sample.name(),
                              .look = Look::of(s, is_reconstructed(law))};
                if (sizes.back().points.size() >= 3) {
                    const MeasuredCurve curve = interpolated(sizes.back().points);
                    for (int i = 0; i <= 40; ++i) {
                        const double v =
                            std::min(curve.upper(), curve.lower() + (curve.upper() - curve.lower()) * i / 40);
                        series.line.push_back({v, curve(v)});
                    }
                }
                for (const Point& point : sizes.back().points) {
                    greatest = std::max(greatest, point.y);
                    series.marks.push_back({point.x, point.y});
                    figure.numbers.rows.push_back(
                        {law.name, sample.name(), sample.sample->diameter.value(), point.x, point.y});
                }
                panel.series.push_back(std::move(series));
            }
        }
        figure.caption += statement(panel.title, std::move(sizes));
        figure.panels.emplace_back(std::move(panel));
    }
    for (Panel& panel : figure.panels) {
        Axis& axis = std::get<XyPanel>(panel).y;
        const ShownUnit unit = shown_unit(run.damping_unit(), greatest);
        axis.unit = unit.name;
        axis.scale = unit.scale;
    }
    share_axes(figure.panels, true, true);
    return figure;
}

}  // namespace ashimpact::report
