// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "solver/contact/static_curve.hpp"

namespace ashimpact::report {

namespace {

constexpr double greatest_overlap = 4;  ///< in units of Eq. 21, as the paper's Figure 3
constexpr double compared_overlap = 3;

struct LawCurve {
    Law law;
    std::vector<StaticPoint> points;
    double attraction;  ///< at the compared overlap
};

std::vector<LawCurve> curves_of(const RunData& run) {
    std::vector<LawCurve> curves;
    for (const LawChoice& choice : run.data().laws) {
        try {
            const StaticCurve curve = StaticCurve::normalised(choice.law);
            curves.push_back({choice.law, curve.sampled(greatest_overlap, 61),
                              -curve.at_overlap(compared_overlap).attractive_force});
        } catch (const InputError&) {
            continue;  // a law with a history, or without a normalised form, has no curve
        }
    }
    return curves;
}

Series series_of(const LawCurve& curve, double StaticPoint::*force) {
    Series series{.name = display_name(curve.law.name()),
                  .legend = display_name(curve.law.name()),
                  .look = Look::of(curve.law.index())};
    for (const StaticPoint& point : curve.points)
        series.line.push_back({point.overlap, force == nullptr ? point.force() : point.*force});
    return series;
}

/// "at overlap 3 the attraction is 10.9 (Brach-Dunn), ..."; the ratio to the next lower one.
std::string statement(const std::vector<LawCurve>& curves) {
    std::string text;
    for (const LawCurve& curve : curves)
        if (curve.attraction > 0)
            text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", display_name(curve.law.name()),
                                curve.attraction);
    if (text.empty()) return "None of these laws has attraction.";
    text = "At overlap 3 the attraction is, in these units: " + text + ".";
    const auto of = [&](std::string_view name) {
        for (const LawCurve& curve : curves)
            if (curve.law.name() == name) return curve.attraction;
        return 0.0;
    };
    const double brach_dunn = of("brach-dunn");
    const double jkr = of("jkr");
    if (brach_dunn > 0 && jkr > 0)
        text += fmt::format(
            " Brach-Dunn attracts {:.2f} times as strongly as JKR there; the paper says about two times, and "
            "three in the same sentence.",
            brach_dunn / jkr);
    return text;
}

}  // namespace

Figure static_force_figure(const RunData& run) {
    const auto curves = curves_of(run);
    const Axis overlap{.label = "overlap, normalised"};
    XyPanel total{.title = "Total force", .x = overlap, .y = {.label = "force, normalised"}};
    XyPanel attraction{.title = "Attractive part", .x = overlap, .y = {.label = "force, normalised"}};
    NumberTable table{.columns = {"law", "overlap", "repulsive force", "attractive force", "total force"}};
    for (const LawCurve& curve : curves) {
        total.series.push_back(series_of(curve, nullptr));
        attraction.series.push_back(series_of(curve, &StaticPoint::attractive_force));
        for (const StaticPoint& point : curve.points)
            table.rows.push_back({std::string(curve.law.name()), point.overlap, point.repulsive_force,
                                  point.attractive_force, point.force()});
    }
    return {.id = "static-force",
            .title = "Contact force against overlap",
            .counterpart = "Figure 3",
            .caption =
                "Force of each contact law at rest, in the units of Eq. 21: force over π w R*, overlap over "
                "(π² w² R*/K²)^(1/3). "
                "No property of a particle is left in it. Attraction is negative. " +
                statement(curves),
            .panels = {total, attraction},
            .numbers = std::move(table),
            .columns = 2,
            .panel_height = 300};
}

}  // namespace ashimpact::report
