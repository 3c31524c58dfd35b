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
RowItem interval(double value, const std::optional<double>& lower, const std::optional<double>& upper,
                 const Look& look, const std::string& name) {
    const double from = lower && *lower > 0 ? *lower : value / 1.5;
    const double to = upper.value_or(value * 1.5);
    return {.kind = RowItem::Kind::interval,
            .from = from,
            .to = to,
            .look = look,
            .name = fmt::format("{}: 95 % from {:.3g} to {:.3g} m/s", name, from, to)};
}

Row law_row(const SampleData& sample, const LawData& law, NumberTable& table) {
    Row row{.label = law.name};
    if (!law.headline.value) return row;
    const std::string name = sample.name + ", " + law.name;
    const Headline& head = law.headline;
    if (head.with_interval)
        row.items.push_back(interval(*head.value, head.lower, head.upper, look_of(law), name));
    row.items.push_back(mark(*head.value, look_of(law), name, law.name));
    table.rows.push_back({sample.name, law.name, *head.value,
                          head.lower ? Cell(*head.lower) : Cell(std::string()),
                          head.upper ? Cell(*head.upper) : Cell(std::string())});
    if (!sample.sample->published) return row;
    if (const Quantity* printed = sample.sample->published->critical_velocity.find(law.choice.law)) {
        row.items.push_back(mark(printed->value, Look::plain(5), name + ", published", "published"));
        row.items.back().shift = 7;
        table.rows.push_back(
            {sample.name, law.name + ", published", printed->value, std::string(), std::string()});
    }
    return row;
}

Row measured_row(const SampleData& sample, NumberTable& table) {
    Row row{.label = "measured"};
    const double value = *number_in(sample.measured, "critical_velocity");
    const Json interval_json =
        sample.measured.contains("interval") ? sample.measured.at("interval") : Json(nullptr);
    const auto lower = number_in(interval_json, "lower");
    const auto upper = number_in(interval_json, "upper");
    if (lower || upper)
        row.items.push_back(interval(value, lower, upper, Look::plain(3), sample.name + ", measured"));
    row.items.push_back(mark(value, Look::plain(3), sample.name + ", measured", "measured"));
    table.rows.push_back({sample.name, std::string("measured"), value,
                          lower ? Cell(*lower) : Cell(std::string()),
                          upper ? Cell(*upper) : Cell(std::string())});
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
        panel.rows.push_back({.label = sample.name, .heading = true});
        Row analytic{.label = "analytic, Eq. 30"};
        if (sample.analytic->critical_velocity > 0)
            analytic.items.push_back(mark(sample.analytic->critical_velocity, Look::plain(2, true),
                                          sample.name + ", analytic", "analytic, Eq. 30"));
        table.rows.push_back({sample.name, std::string("analytic, Eq. 30"),
                              sample.analytic->critical_velocity, std::string(), std::string()});
        panel.rows.push_back(std::move(analytic));
        for (const LawData& law : sample.laws) panel.rows.push_back(law_row(sample, law, table));
        if (number_in(sample.measured, "critical_velocity")) {
            with_measured = true;
            panel.rows.push_back(measured_row(sample, table));
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
    const Json& comparison = run.artifacts().at("comparison.json").document.at("result");
    if (comparison.contains("conclusion"))
        figure.caption += " " + comparison.at("conclusion").get<std::string>();
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

namespace {

/// The influences on a critical velocity, or null where none are stated.
const Json* influences_of(const Json& velocity) {
    if (!velocity.is_object() || !velocity.contains("uncertainty")) return nullptr;
    const Json& uncertainty = velocity.at("uncertainty");
    if (!uncertainty.is_object() || !uncertainty.contains("influences") ||
        uncertainty.at("influences").empty())
        return nullptr;
    return &uncertainty.at("influences");
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
        RowPanel panel{.title = sample.name,
                       .x = {.label = "share of the variance of v_c",
                             .unit = "%",
                             .scale = 0.01,
                             .from = -0.02,
                             .to = 1.05}};
        for (const LawData& law : sample.laws) {
            const Json* influences = influences_of(law.velocity_json);
            if (influences == nullptr && law.velocity_json.is_object() &&
                law.velocity_json.contains("extrapolated")) {
                influences = influences_of(law.velocity_json.at("extrapolated"));
                extrapolated = extrapolated || influences != nullptr;
            }
            if (influences == nullptr) continue;
            panel.rows.push_back({.label = law.name, .heading = true});
            for (const Json& influence : *influences) {
                const std::string factor = influence.at("factor").get<std::string>();
                const double first = number_in(influence, "first").value_or(0);
                const double total = number_in(influence, "total").value_or(0);
                figure.numbers.rows.push_back({sample.name, law.name, factor, first,
                                               number_in(influence, "first_error").value_or(0), total,
                                               number_in(influence, "total_error").value_or(0)});
                if (total < 0.005 && first < 0.005) continue;  // nothing to see; the table has it
                Look bar = look_of(law);
                panel.rows.push_back(
                    {.label = short_label(factor),
                     .items = {
                         {.kind = RowItem::Kind::bar,
                          .from = 0,
                          .to = total,
                          .look = bar,
                          .name = fmt::format("{}, {}: total {:.3g} %", law.name, factor, 100 * total)},
                         {.kind = RowItem::Kind::mark,
                          .from = 0,
                          .to = first,
                          .look = Look::plain(3),
                          .name = fmt::format("{}, {}: first order {:.3g} %", law.name, factor, 100 * first),
                          .legend = "first order; bar: total"}}});
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
