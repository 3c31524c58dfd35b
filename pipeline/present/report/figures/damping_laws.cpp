// SPDX-License-Identifier: GPL-3.0-or-later
// Which damping law explains the impacts.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

/// The impacts of a sample by the contact law, without the law of damping.
Series explained_impacts(const SampleData& sample, const LawData& law) {
    const bool reconstructed = law.is_reconstructed();
    Series series{.name = sample.name() + (reconstructed ? ", reconstructed" : ", measured"),
                  .legend = reconstructed ? "reconstructed" : "measured",
                  .look = Look::plain(0, reconstructed)};
    for (const Measurement& impact : law.measured->impacts.points)
        series.marks.push_back({impact.velocity, impact.captured() ? 0 : impact.restitution()});
    return series;
}

Series explained_series(const std::string& sample, const ExplainedDamping& damping,
                        const ExplainedSample& of) {
    const std::string law(name_of(damping.law));
    Series series{.name = sample + ", " + law,
                  .legend = fmt::format("{} (misfit {:.2g})", law, damping.misfit),
                  .look = Look::of(static_cast<std::size_t>(damping.law))};
    for (const ExplainedImpact& impact : of.curve)
        series.line.push_back({impact.velocity, impact.restitution});
    return series;
}

}  // namespace

Figure damping_laws_figure(const RunData& run) {
    Figure figure{.id = "damping-laws",
                  .title = "Which damping explains the impacts",
                  .caption =
                      "Each damping law with those constants, the same for all samples, that come "
                      "closest to the restitutions. The misfit is the root mean square of the "
                      "differences of e_n.",
                  .numbers = {.columns = {"sample", "damping law", "v_in [m/s]", "e_n"}}};
    const auto& comparison = run.run().comparison.damping_laws;
    if (!comparison) {
        figure.caption += " Without a reported law and its rebounds there is nothing to show.";
        return figure;
    }
    figure.caption += fmt::format(" All by the contact law {}.", display_name(comparison->law.name()));
    for (const SampleData& sample : run.samples()) {
        const auto law = std::ranges::find(sample.laws, comparison->law,
                                           [](const LawData& each) { return each.choice.law; });
        if (law == sample.laws.end() || law->measured == nullptr) continue;
        XyPanel panel{.title = sample.name(),
                      .x = {.label = "v_in", .unit = "m/s", .from_zero = true},
                      .y = {.label = "e_n", .from_zero = true}};
        for (const ExplainedDamping& damping : comparison->dampings)
            for (const ExplainedSample& of : damping.samples) {
                if (of.name != sample.name() || of.curve.empty()) continue;
                panel.series.push_back(explained_series(sample.name(), damping, of));
                for (const ExplainedImpact& impact : of.curve)
                    figure.numbers.rows.push_back({sample.name(), std::string(name_of(damping.law)),
                                                   impact.velocity, impact.restitution});
            }
        panel.series.push_back(explained_impacts(sample, *law));
        figure.panels.emplace_back(std::move(panel));
    }
    for (const ExplainedDamping& damping : comparison->dampings)
        if (damping.constants.empty())
            figure.caption +=
                fmt::format(" The impacts do not tell the two constants of {} apart.", name_of(damping.law));
    return figure;
}

}  // namespace ashimpact::report
