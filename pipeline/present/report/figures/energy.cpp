// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

struct Share {
    std::string name;
    double (*of)(const CurveImpact& impact);
};

/// Where the energy goes, from the bottom of the stack up.
const std::array<Share, 4>& shares() {
    static const std::array<Share, 4> all{{
        {"damping", [](const CurveImpact& i) { return i.dissipated; }},
        {"yielding", [](const CurveImpact& i) { return i.plastic; }},
        {"breaking the contact", [](const CurveImpact& i) { return i.adhesion; }},
        {"rebound", [](const CurveImpact& i) { return i.restitution * i.restitution; }},
    }};
    return all;
}

XyPanel panel_of(const SampleData& sample, const LawData& law) {
    XyPanel panel{.title = sample.name() + ", " + law.name,
                  .x = velocity_axis(),
                  .y = {.label = "share", .unit = "%", .scale = 0.01, .from = 0.0, .to = 1.0}};
    panel.x.from_zero = false;
    std::vector<double> below(law.curve().size(), 0.0);
    for (std::size_t k = 0; k < shares().size(); ++k) {
        Series series{.name = panel.title + ", up to " + shares()[k].name,
                      .legend = shares()[k].name,
                      .look = Look::of(k),
                      .area = true};
        const auto is_zero = [&](const CurveImpact& impact) { return shares()[k].of(impact) == 0; };
        if (std::all_of(law.curve().begin(), law.curve().end(), is_zero)) continue;
        std::vector<double> above = below;
        for (std::size_t i = 0; i < law.curve().size(); ++i) above[i] += shares()[k].of(law.curve()[i]);
        for (std::size_t i = 0; i < law.curve().size(); ++i) {
            series.line.push_back({law.curve()[i].velocity, above[i]});
            series.band.push_back({law.curve()[i].velocity, above[i]});
        }
        for (std::size_t i = law.curve().size(); i-- > 0;)
            series.band.push_back({law.curve()[i].velocity, below[i]});
        below = above;
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// What breaking the contact takes beside damping, at the velocity where each curve begins.
std::string statement(const RunData& run) {
    double damping = 1;
    double breaking = 0;
    bool any = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (!law.curve().empty()) {
                any = true;
                damping = std::min(damping, law.curve().front().dissipated);
                breaking = std::max(breaking, law.curve().front().adhesion);
            }
    if (!any) return " No law has a curve here.";
    const std::string shares = fmt::format(
        " Where the curves begin, at capture, damping takes at least {:.4g} % and breaking the "
        "contact at most {:.2g} %",
        100 * damping, 100 * breaking);
    return shares + (breaking < 0.1 * damping
                         ? ": the first-contact adhesive loss of Eq. 28 does not explain capture."
                         : ".");
}

}  // namespace

Figure energy_figure(const RunData& run) {
    Figure figure{.id = "energy",
                  .title = "Where the incident energy goes",
                  .counterpart = "",
                  .caption =
                      "Shares of the kinetic energy before impact, along the model's curve e_n(v_in) of each "
                      "law. The rebound keeps e_n² of it." +
                      statement(run),
                  .panels = {},
                  .numbers = {.columns = {"sample", "law", "v_in [m/s]", "damping", "yielding",
                                          "breaking the contact", "rebound"}},
                  .columns = 4,
                  .narrow_columns = 2,
                  .panel_height = 210};
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            if (law.curve().empty()) continue;
            figure.panels.emplace_back(panel_of(sample, law));
            for (const CurveImpact& i : law.curve())
                figure.numbers.rows.push_back({sample.name(), law.name, i.velocity, i.dissipated, i.plastic,
                                               i.adhesion, i.restitution * i.restitution});
        }
    return figure;
}

}  // namespace ashimpact::report
