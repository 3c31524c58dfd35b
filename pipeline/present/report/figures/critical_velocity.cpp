// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"

namespace ashimpact::report {

namespace {

RowItem mark(double value, const Look& look, const std::string& name, const std::string& legend) {
    return {.kind = RowItem::Kind::mark,
            .from = value,
            .to = value,
            .look = look,
            .name = fmt::format("{}: {:.4g} m/s", name, value),
            .legend = legend};
}

/// The interval of a value; an open end is drawn a factor 1.5 away.
RowItem interval(double value, const Bounds& bounds, const Look& look, const std::string& name) {
    const double from = bounds.lower && *bounds.lower > 0 ? *bounds.lower : value / 1.5;
    const double to = bounds.upper.value_or(value * 1.5);
    return {.kind = RowItem::Kind::interval,
            .from = from,
            .to = to,
            .look = look,
            .name = fmt::format("{}: 95 % from {:.3g} to {:.3g} m/s", name, from, to)};
}

Row law_row(const SampleData& sample, const LawData& law, NumberTable& table) {
    Row row{.label = law.name};
    const auto head = law.headline();
    if (!head) return row;
    const std::string name = sample.name() + ", " + law.name;
    const Bounds bounds = head->interval.value_or(Bounds{});
    if (head->interval) row.items.push_back(interval(head->value, bounds, look_of(law), name));
    row.items.push_back(mark(head->value, look_of(law), name, law.name));
    table.rows.push_back(
        {sample.name(), law.name, head->value, cell_of(bounds.lower), cell_of(bounds.upper)});
    if (!sample.sample->published) return row;
    if (const Quantity* printed = sample.sample->published->critical_velocity.find(law.choice.law)) {
        row.items.push_back(mark(printed->value, Look::plain(5), name + ", published", "published"));
        row.items.back().shift = 7;
        table.rows.push_back(
            {sample.name(), law.name + ", published", printed->value, std::string(), std::string()});
    }
    return row;
}

Row measured_row(const SampleData& sample, const MeasuredCriticalVelocity& measured, NumberTable& table) {
    Row row{.label = "measured"};
    const double value = *measured.value;
    const Bounds bounds{measured.lower, measured.upper};
    const std::string name = sample.name() + ", measured";
    if (bounds.lower || bounds.upper) row.items.push_back(interval(value, bounds, Look::plain(3), name));
    row.items.push_back(mark(value, Look::plain(3), name, "measured"));
    table.rows.push_back(
        {sample.name(), std::string("measured"), value, cell_of(bounds.lower), cell_of(bounds.upper)});
    return row;
}

}  // namespace

Figure critical_velocity_figure(const RunData& run) {
    NumberTable table{.columns = {"sample", "what", "critical velocity [m/s]", "lower end of 95 % [m/s]",
                                  "upper end of 95 % [m/s]"}};
    RowPanel panel{.title = "",
                   .x = {.label = "critical velocity", .unit = "m/s", .spacing = Spacing::logarithmic}};
    bool with_measured = false;
    for (const SampleData& sample : run.samples()) {
        panel.rows.push_back({.label = sample.name(), .heading = true});
        Row analytic{.label = "analytic, Eq. 30"};
        if (sample.analytic->critical_velocity > 0)
            analytic.items.push_back(mark(sample.analytic->critical_velocity, Look::plain(2, true),
                                          sample.name() + ", analytic", "analytic, Eq. 30"));
        table.rows.push_back({sample.name(), std::string("analytic, Eq. 30"),
                              sample.analytic->critical_velocity, std::string(), std::string()});
        panel.rows.push_back(std::move(analytic));
        for (const LawData& law : sample.laws) panel.rows.push_back(law_row(sample, law, table));
        if (const auto& measured = sample.velocity->measured; measured && measured->value) {
            with_measured = true;
            panel.rows.push_back(measured_row(sample, *measured, table));
        }
    }
    Figure figure{.id = "critical-velocity",
                  .title = "The critical velocity, every way there is",
                  .counterpart = "Table 4",
                  .caption =
                      "A particle slower than its critical velocity sticks. Analytic: the energy "
                      "to separate the surfaces alone (Eq. 30). Dynamic: by "
                      "each contact law with its damping, with the interval that holds it with 95 %.",
                  .panels = {},
                  .numbers = std::move(table),
                  .columns = 1};
    if (with_measured) figure.caption += " Measured: as the case reports it, or from which impacts stuck.";
    figure.caption += " " + run.run().comparison.conclusion;
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

namespace {

/// The influences on a critical velocity; empty if none are stated.
std::vector<Influence> influences_of(const LawData& law) {
    if (law.velocity == nullptr || !law.velocity->uncertainty) return {};
    return law.velocity->uncertainty->influences;
}

/// An input beside its bar: "E of mullite".
std::string short_label(const std::string& factor) {
    constexpr std::string_view modulus = "Young's modulus";
    return factor.starts_with(modulus) ? "E" + factor.substr(modulus.size()) : factor;
}

}  // namespace

Figure sensitivity_figure(const RunData& run) {
    Figure figure{.id = "sensitivity",
                  .title = "What the interval of the critical velocity comes from",
                  .counterpart = "",
                  .caption =
                      "Sobol indices of v_c: the share of its variance that each uncertain input makes by "
                      "itself (first order, mark), and with all that it does "
                      "together with others (total, bar). Only what the case states to be uncertain is in "
                      "it; an input without an uncertainty counts as exact.",
                  .panels = {},
                  .numbers = {.columns = {"sample", "law", "input", "first order", "its standard error",
                                          "total", "its standard error"}},
                  .columns = 2};
    bool extrapolated = false;
    for (const SampleData& sample : run.samples()) {
        RowPanel panel{.title = sample.name(),
                       .x = {.label = "share of the variance of v_c",
                             .unit = "%",
                             .scale = 0.01,
                             .from = -0.02,
                             .to = 1.05}};
        for (const LawData& law : sample.laws) {
            std::vector<Influence> influences = influences_of(law);
            if (influences.empty() && law.extrapolated()) {
                influences = law.velocity->extrapolated->uncertainty.influences;
                extrapolated = extrapolated || !influences.empty();
            }
            if (influences.empty()) continue;
            panel.rows.push_back({.label = law.name, .heading = true});
            for (const auto& [factor, first, total] : influences) {
                figure.numbers.rows.push_back({sample.name(), law.name, factor, first.value,
                                               first.standard_error, total.value, total.standard_error});
                if (!(total.value >= 0.005 || first.value >= 0.005)) continue;  // too small to be seen
                panel.rows.push_back(sobol_row(short_label(factor), law.name + ", " + factor, look_of(law),
                                               first.value, total.value));
            }
        }
        if (!panel.rows.empty()) figure.panels.emplace_back(std::move(panel));
    }
    if (figure.panels.empty())
        figure.caption += " This case has no such indices, so there is nothing to show.";
    if (extrapolated)
        figure.caption +=
            " Where impacts were measured, the indices are those of the extrapolated v_c; the interval of "
            "the "
            "critical velocity itself comes from the scatter of the impacts and from which of them stuck.";
    return figure;
}

}  // namespace ashimpact::report
