// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

/// Position of a phase among all of the run, so that it looks the same in every sample.
std::size_t position(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
}

Row fractions_row(const Json& modulus, const char* key, const std::string& label,
                  std::vector<std::string>& names) {
    Row row{.label = label};
    double from = 0;
    for (const Json& phase : modulus.at("phases")) {
        const double share = number_in(phase, key).value_or(0);
        const std::string name = phase.at("name").get<std::string>();
        row.items.push_back({.kind = RowItem::Kind::bar,
                             .from = from,
                             .to = from + share,
                             .look = Look::of(position(names, name)),
                             .name = fmt::format("{}: {:.4g} %", name, 100 * share),
                             .legend = name});
        from += share;
    }
    return row;
}

RowPanel fractions_panel(const RunData& run) {
    RowPanel panel{.title = "Composition",
                   .x = {.label = "fraction", .unit = "%", .scale = 0.01, .from = 0.0, .to = 1.0}};
    std::vector<std::string> names;
    for (const SampleData& sample : run.samples()) {
        panel.rows.push_back({.label = sample.name, .heading = true});
        panel.rows.push_back(fractions_row(sample.modulus, "weight_fraction", "weight", names));
        panel.rows.push_back(fractions_row(sample.modulus, "volume_fraction", "volume", names));
    }
    return panel;
}

RowPanel modulus_panel(const RunData& run) {
    RowPanel panel{.title = "Young's modulus and its bounds",
                   .x = {.label = "E", .unit = "GPa", .scale = 1e9}};
    for (const SampleData& sample : run.samples()) {
        const Json& json = sample.modulus;
        panel.rows.push_back({.label = sample.name, .heading = true});
        const double value = number_in(json, "young_modulus").value_or(0);
        Row bounds{.label = "bounds"};
        if (json.contains("bounds")) {
            const double lower = number_in(json.at("bounds"), "lower").value_or(value);
            const double upper = number_in(json.at("bounds"), "upper").value_or(value);
            bounds.items.push_back(
                {.kind = RowItem::Kind::bar,
                 .from = lower,
                 .to = upper,
                 .look = Look::plain(3),
                 .name = fmt::format("bounds {:.4g} to {:.4g} GPa", lower / 1e9, upper / 1e9),
                 .legend = "bounds"});
        }
        panel.rows.push_back(std::move(bounds));
        Row own{.label = "E"};
        const Json& quantity = json.at("young_modulus");
        const double u = number_in(quantity, "standard_uncertainty").value_or(0);
        if (u > 0)
            own.items.push_back({.kind = RowItem::Kind::interval,
                                 .from = value - u,
                                 .to = value + u,
                                 .look = Look::plain(0),
                                 .name = fmt::format("± {:.3g} GPa (standard uncertainty)", u / 1e9)});
        own.items.push_back({.kind = RowItem::Kind::mark,
                             .from = value,
                             .to = value,
                             .look = Look::plain(0),
                             .name = fmt::format("E = {:.4g} GPa", value / 1e9),
                             .legend = "E by the rule of the case, ± u"});
        panel.rows.push_back(std::move(own));
    }
    return panel;
}

std::string dominant(const RunData& run) {
    std::string text;
    for (const SampleData& sample : run.samples()) {
        if (!sample.modulus.contains("uncertainty_contributions")) continue;
        const Json& contributions = sample.modulus.at("uncertainty_contributions");
        if (contributions.empty()) continue;
        const Json& first = contributions.front();
        text += fmt::format(" {}: {} gives {:.3g} % of the variance of E.", sample.name,
                            first.at("input").get<std::string>(),
                            100 * number_in(first, "share_of_variance").value_or(0));
    }
    return text.empty() ? " No uncertainty of the phases is known." : text;
}

NumberTable numbers(const RunData& run) {
    NumberTable table{.columns = {"sample", "phase", "weight fraction", "volume fraction", "density [kg/m3]",
                                  "Young's modulus [Pa]"}};
    for (const SampleData& sample : run.samples()) {
        for (const Json& phase : sample.modulus.at("phases"))
            table.rows.push_back({sample.name, phase.at("name").get<std::string>(),
                                  number_in(phase, "weight_fraction").value_or(0),
                                  number_in(phase, "volume_fraction").value_or(0),
                                  number_in(phase, "density").value_or(0),
                                  number_in(phase, "young_modulus").value_or(0)});
        table.rows.push_back({sample.name, std::string("the whole"), 1.0, 1.0,
                              number_in(sample.modulus, "density").value_or(0),
                              number_in(sample.modulus, "young_modulus").value_or(0)});
    }
    return table;
}

}  // namespace

Figure composition_figure(const RunData& run) {
    Figure figure{
        .id = "composition",
        .title = "What the ash is made of, and how stiff that makes it",
        .counterpart = "Table 1",
        .caption =
            "Left: the phases of each sample by weight, as the XRD result gives them, and by "
            "volume, as Eq. 1 needs them. "
            "Right: Young's modulus by the mixture rule of the case with its standard uncertainty u, "
            "and the bounds between which it lies however the phases are arranged. The bounds "
            "take the moduli of the phases as exact, u does not." +
            dominant(run),
        .panels = {},
        .numbers = numbers(run),
        .columns = 2};
    figure.panels.emplace_back(fractions_panel(run));
    figure.panels.emplace_back(modulus_panel(run));
    return figure;
}

}  // namespace ashimpact::report
