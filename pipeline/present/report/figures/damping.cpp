// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"

namespace ashimpact::report {

namespace {

double greatest_damping(const RunData& run) {
    double greatest = 0;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            if (law.damping != nullptr) greatest = std::max(greatest, greatest_of(law.damping->damping));
            for (const CurveImpact& impact : law.curve()) greatest = std::max(greatest, impact.damping);
        }
    return greatest;
}

Axis damping_axis(const RunData& run) {
    Axis axis = quantity_axis("η", run.damping_unit(), greatest_damping(run));
    axis.from_zero = true;
    return axis;
}

/// The dampings of one law over @p x, with their uncertainty where it is known.
Series points_series(const SampleData& sample, const LawData& law, const std::vector<double>& x) {
    Series series{.name = sample.name() + ", " + law.name,
                  .legend = law.name,
                  .look = look_of(law, is_reconstructed(law))};
    const std::vector<double>& uncertainty = law.damping->damping_uncertainty;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = i < uncertainty.size() && std::isfinite(uncertainty[i]) ? uncertainty[i] : 0;
        series.marks.push_back({x[i], law.damping->damping[i], 0, u});
    }
    return series;
}

/// Boundaries between falling, flat and rising eta(v_in), of the first law that has several parts.
std::vector<Rule> boundaries(const SampleData& sample) {
    std::vector<Rule> rules;
    for (const LawData& law : sample.laws) {
        if (law.damping == nullptr) continue;
        for (std::size_t i = 1; i < law.damping->parts.size(); ++i)
            rules.push_back({law.damping->parts[i].from.value,
                             std::string(name_of(law.damping->parts[i].part)), look_of(law)});
        if (!rules.empty()) break;
    }
    return rules;
}

bool any_boundary(const RunData& run) {
    return std::any_of(run.samples().begin(), run.samples().end(),
                       [](const SampleData& sample) { return !boundaries(sample).empty(); });
}

void add_rows(const SampleData& sample, const LawData& law, NumberTable& table) {
    const std::vector<double>& uncertainty = law.damping->damping_uncertainty;
    for (std::size_t i = 0; i < law.damping->damping.size(); ++i)
        table.rows.push_back({sample.name(), law.name, origin_of(*law.damping), law.damping->velocity[i],
                              law.damping->restitution[i], law.damping->damping[i],
                              i < uncertainty.size() ? Cell(uncertainty[i]) : Cell(std::string())});
}

std::vector<std::string> columns(const RunData& run) {
    const std::string unit = " [" + run.damping_unit() + "]";
    return {"sample", "law", "origin", "v_in [m/s]", "e_n", "damping" + unit, "standard uncertainty" + unit};
}

}  // namespace

Figure damping_figure(const RunData& run) {
    Figure figure{.id = "damping",
                  .title = "Damping against incident velocity",
                  .counterpart = "Figure 6",
                  .caption =
                      "The damping coefficient with which each law gives back each restitution, with the "
                      "model's curve where there is a fit. η falls "
                      "as the velocity rises; with plastic deformation it becomes flat and rises again.",
                  .panels = {},
                  .numbers = {.columns = columns(run)}};
    figure.caption += any_boundary(run) ? " Dashed verticals: where the falling part ends and the flat and "
                                          "the rising part begin, by the first law that has them."
                                        : " These data hold the falling part alone.";
    figure.caption += extrapolation_sentence(run) + origin_sentence(run);
    for (const SampleData& sample : run.samples()) {
        XyPanel panel{.title = sample.name(),
                      .x = velocity_axis(),
                      .y = damping_axis(run),
                      .rules = boundaries(sample)};
        for (const LawData& law : sample.laws) {
            if (law.damping == nullptr) continue;
            Series curve =
                curve_series(sample, law, [](const CurveImpact& impact) { return impact.damping; });
            curve.look.thin = true;
            panel.series.push_back(std::move(curve));
            panel.series.push_back(points_series(sample, law, law.damping->velocity));
            add_rows(sample, law, figure.numbers);
        }
        figure.panels.emplace_back(std::move(panel));
    }
    share_axes(figure.panels, false, true);
    return figure;
}

Figure damping_fit_figure(const RunData& run) {
    Figure figure{.id = "damping-fit",
                  .title = "Damping against restitution, with the fits",
                  .counterpart = "Table 2",
                  .caption =
                      "The same dampings over the restitution. The fit η(e_n) (line) is taken over the "
                      "rising branch of e_n(v_in) and meets the axis "
                      "e_n = 0 at the critical damping, from which a critical velocity follows." +
                      extrapolation_sentence(run) + origin_sentence(run),
                  .panels = {},
                  .numbers = {.columns = columns(run)}};
    for (const SampleData& sample : run.samples()) {
        XyPanel panel{.title = sample.name(), .x = restitution_axis(), .y = damping_axis(run)};
        for (const LawData& law : sample.laws) {
            if (law.damping == nullptr) continue;
            Series fit{
                .name = sample.name() + ", " + law.name + ", fit", .legend = law.name, .look = look_of(law)};
            fit.look.thin = true;
            const double end = greatest_of(law.damping->restitution);
            for (int i = 0; i <= 24 && law.fit != nullptr; ++i) {
                const double e = end * i / 24;
                fit.line.push_back({e, law.fit->along_rising_branch()(e)});
            }
            panel.series.push_back(std::move(fit));
            panel.series.push_back(points_series(sample, law, law.damping->restitution));
            add_rows(sample, law, figure.numbers);
        }
        figure.panels.emplace_back(std::move(panel));
    }
    share_axes(figure.panels, true, true);
    return figure;
}

Figure contact_time_figure(const RunData& run) {
    std::vector<double> times;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.damping != nullptr) times.push_back(greatest_of(law.damping->contact_time));
    Axis axis = quantity_axis("contact time", "s", greatest_of(times));
    axis.from_zero = true;
    Figure figure{.id = "contact-time",
                  .title = "Contact time against incident velocity",
                  .counterpart = "Figure 7",
                  .caption =
                      "From first touch to detachment, by each law with the damping of each impact, and "
                      "along the model's curve. The contact lasts the "
                      "longer the nearer the impact is to capture.",
                  .panels = {},
                  .numbers = {.columns = {"sample", "law", "origin", "v_in [m/s]", "contact time [s]"}}};
    bool published = false;
    for (const SampleData& sample : run.samples()) {
        XyPanel panel{.title = sample.name(), .x = velocity_axis(), .y = axis};
        for (const LawData& law : sample.laws) {
            if (law.damping == nullptr) continue;
            Series curve =
                curve_series(sample, law, [](const CurveImpact& impact) { return impact.contact_time; });
            curve.look.thin = true;
            panel.series.push_back(std::move(curve));
            Series points{.name = sample.name() + ", " + law.name,
                          .legend = law.name,
                          .look = look_of(law, is_reconstructed(law))};
            for (std::size_t i = 0; i < law.damping->velocity.size() && i < law.damping->contact_time.size();
                 ++i) {
                points.marks.push_back({law.damping->velocity[i], law.damping->contact_time[i]});
                figure.numbers.rows.push_back({sample.name(), law.name, origin_of(*law.damping),
                                               law.damping->velocity[i], law.damping->contact_time[i]});
            }
            panel.series.push_back(std::move(points));
        }
        if (sample.sample->published)
            for (const auto& printed : sample.sample->published->contact_times) {
                published = true;
                const std::string name = display_name(printed.law.name());
                panel.series.push_back({.name = sample.name() + ", " + name + ", published",
                                        .legend = "published",
                                        .look = Look::plain(6),
                                        .marks = {{printed.velocity.value, printed.contact_time.value}}});
                figure.numbers.rows.push_back({sample.name(), name, std::string("published"),
                                               printed.velocity.value, printed.contact_time.value});
            }
        figure.panels.emplace_back(std::move(panel));
    }
    if (published) figure.caption += " Crosses: published values, at about the velocity printed.";
    figure.caption += origin_sentence(run);
    share_axes(figure.panels, false, true);
    return figure;
}

}  // namespace ashimpact::report
