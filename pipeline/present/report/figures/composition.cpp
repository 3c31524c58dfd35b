// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"

namespace ashimpact::report {

namespace {

/// Position of a phase among all of the run, so that it looks the same in every sample.
std::size_t position(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
}

Row fractions_row(const SampleModulus& modulus, double PhaseShare::*fraction, const std::string& label,
                  std::vector<std::string>& names) {
    Row row{.label = label};
    double from = 0;
    for (const PhaseShare& phase : modulus.phases) {
        const double share = phase.*fraction;
        row.items.push_back({.kind = RowItem::Kind::bar,
                             .from = from,
                             .to = from + share,
                             .look = Look::of(position(names, phase.name)),
                             .name = fmt::format("{}: {:.4g} %", phase.name, 100 * share),
                             .legend = phase.name});
        from += share;
    }
    return row;
}

RowPanel fractions_panel(const RunData& run) {
    RowPanel panel{.title = "Composition",
                   .x = {.label = "fraction", .unit = "%", .scale = 0.01, .from = 0.0, .to = 1.0}};
    std::vector<std::string> names;
    for (const SampleData& sample : run.samples()) {
        panel.rows.push_back({.label = sample.name(), .heading = true});
        panel.rows.push_back(fractions_row(*sample.modulus, &PhaseShare::weight_fraction, "weight", names));
        panel.rows.push_back(fractions_row(*sample.modulus, &PhaseShare::volume_fraction, "volume", names));
    }
    return panel;
}

RowPanel modulus_panel(const RunData& run) {
    RowPanel panel{.title = "Young's modulus and its bounds",
                   .x = {.label = "E", .unit = "GPa", .scale = 1e9}};
    for (const SampleData& sample : run.samples()) {
        const Quantity& modulus = sample.modulus->young_modulus;
        panel.rows.push_back({.label = sample.name(), .heading = true});
        Row bounds{.label = "bounds"};
        if (const auto& known = sample.modulus->bounds)
            bounds.items.push_back({.kind = RowItem::Kind::bar,
                                    .from = known->lower.value,
                                    .to = known->upper.value,
                                    .look = Look::plain(3),
                                    .name = fmt::format("bounds {:.4g} to {:.4g} GPa",
                                                        known->lower.value / 1e9, known->upper.value / 1e9),
                                    .legend = "bounds"});
        panel.rows.push_back(std::move(bounds));
        Row own{.label = "E"};
        if (const double u = modulus.standard_uncertainty.value_or(0); u > 0)
            own.items.push_back({.kind = RowItem::Kind::interval,
                                 .from = modulus.value - u,
                                 .to = modulus.value + u,
                                 .look = Look::plain(0),
                                 .name = fmt::format("± {:.3g} GPa (standard uncertainty)", u / 1e9)});
        own.items.push_back({.kind = RowItem::Kind::mark,
                             .from = modulus.value,
                             .to = modulus.value,
                             .look = Look::plain(0),
                             .name = fmt::format("E = {:.4g} GPa", modulus.value / 1e9),
                             .legend = "E by the rule of the case, ± u"});
        panel.rows.push_back(std::move(own));
    }
    return panel;
}

std::string dominant(const RunData& run) {
    std::string text;
    for (const SampleData& sample : run.samples())
        if (const auto& contributions = sample.modulus->contributions; !contributions.empty())
            text += fmt::format(" {}: {} gives {:.3g} % of the variance of E.", sample.name(),
                                contributions.front().what, 100 * contributions.front().share);
    return text.empty() ? " No uncertainty of the phases is known." : text;
}

NumberTable numbers(const RunData& run) {
    NumberTable table{.columns = {"sample", "phase", "weight fraction", "volume fraction", "density [kg/m3]",
                                  "Young's modulus [Pa]"}};
    for (const SampleData& sample : run.samples()) {
        for (const PhaseShare& phase : sample.modulus->phases)
            table.rows.push_back({sample.name(), phase.name, phase.weight_fraction, phase.volume_fraction,
                                  cell_of(phase.density), cell_of(phase.young_modulus)});
        table.rows.push_back({sample.name(), std::string("the whole"), 1.0, 1.0,
                              sample.modulus->density.value, sample.modulus->young_modulus.value});
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
