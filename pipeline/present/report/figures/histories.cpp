// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/report/figures/figures.hpp"

namespace ashimpact::report {

namespace {

constexpr std::size_t listed_every = 2;  // of the instants drawn; 8-histories.json has them all

struct PartWords {
    HistoryPart part;
    const char* legend;
    const char* column;  ///< in the table, which names it in every row
};

constexpr PartWords parts[]{{HistoryPart::at_critical, "at the critical velocity", "critical"},
                            {HistoryPart::critical, "just above it", "just-above"},
                            {HistoryPart::rising, "rising branch", "rising"},
                            {HistoryPart::falling, "falling branch", "falling"}};

std::size_t place_of(HistoryPart part) {
    return static_cast<std::size_t>(std::ranges::find(parts, part, &PartWords::part) - std::begin(parts));
}

using Histories = std::vector<const History*>;

/// The histories of a law, in the order of their parts.
Histories histories_of(const LawData& law) {
    Histories all;
    const auto add = [&](const std::vector<History>& histories) {
        for (const History& history : histories)
            if (!history.trajectory.empty()) all.push_back(&history);
    };
    if (law.drawn != nullptr) add(law.drawn->histories);
    if (law.histories != nullptr) add(*law.histories);
    std::stable_sort(all.begin(), all.end(), [](const History* a, const History* b) {
        return place_of(a->part) < place_of(b->part);
    });
    return all;
}

/// The longest time drawn: histories at capture creep for ever, the others show how long an impact lasts.
double shown_time(const std::vector<Histories>& laws) {
    double longest = 0;
    for (const Histories& histories : laws)
        for (const History* history : histories)
            if (history->part != HistoryPart::at_critical)
                longest = std::max(longest, history->trajectory.back().time);
    return longest;
}

double overlap_of(const TrajectoryPoint& point) {
    return point.overlap;
}

/// The whole force on the particle.
double force_of(const TrajectoryPoint& point) {
    return point.repulsive_force + point.attractive_force + point.damping_force;
}

using Ordinate = double (*)(const TrajectoryPoint&);

double greatest_drawn(const std::vector<Histories>& laws, Ordinate ordinate) {
    std::vector<double> values;
    for (const Histories& histories : laws)
        for (const History* history : histories)
            for (const TrajectoryPoint& point : history->trajectory) values.push_back(ordinate(point));
    return greatest_of(values);
}

XyPanel panel_of(const std::string& title, const Histories& histories, const Axis& time, const Axis& axis,
                 Ordinate ordinate) {
    XyPanel panel{.title = title, .x = time, .y = axis};
    for (const History* history : histories) {
        const std::size_t place = place_of(history->part);
        Series series{
            .name = fmt::format("{}, {}, {:.3g} m/s", title, parts[place].legend, history->velocity),
            .legend = parts[place].legend,
            .look = Look::of(place)};
        for (const TrajectoryPoint& point : history->trajectory)
            if (point.time <= *time.to) series.line.push_back({point.time, ordinate(point)});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// "Greatest pressure under the contact at the critical velocity: 88 um 2.11 GPa (JKR)"; of each sample by
/// the law whose contact is pressed hardest, beside the yield pressure.
std::string pressure_sentence(const RunData& run) {
    std::string text;
    for (const SampleData& sample : run.samples()) {
        double greatest = 0;
        const LawData* by = nullptr;
        for (const LawData& law : sample.laws) {
            if (law.histories == nullptr || law.histories->empty()) continue;
            const double pressure = law.histories->front().greatest_pressure;
            if (pressure <= greatest) continue;
            greatest = pressure;
            by = &law;
        }
        if (by == nullptr) continue;
        const double yield = sample.contact->pair.yield_pressure;
        text += fmt::format("{} {} {} ({}, yield pressure {})", text.empty() ? "" : ";", sample.name(),
                            readable(greatest, "Pa"), by->name,
                            std::isfinite(yield) ? readable(yield, "Pa") : "not given");
    }
    return text.empty() ? text
                        : " Greatest pressure in the centre of the contact just above v_c:" + text + ".";
}

}  // namespace

Figure histories_figure(const RunData& run) {
    Figure figure{.id = "histories",
                  .title = "Overlap and force during one impact",
                  .counterpart = "Figure 9",
                  .caption =
                      "Overlap, and below it the whole force on the particle (contact and damping, positive "
                      "where it pushes away), over time: at the critical "
                      "velocity, just above it, on the rising and on the falling branch of e_n(v_in). All "
                      "laws of a sample have the same axes. At v_c the "
                      "particle comes to rest as the contact ends, so its curve ends flat; a faster impact "
                      "presses deeper and leaves at a slope.",
                  .numbers = {.columns = {"sample", "law", "part", "v_in [m/s]", "time [s]", "overlap [m]",
                                          "force [N]"},
                              .shown_every = 4},
                  .columns = 4,
                  .narrow_columns = 2,
                  .panel_height = 190};
    bool falling = false;
    for (const SampleData& sample : run.samples()) {
        std::vector<Histories> laws;
        for (const LawData& law : sample.laws) laws.push_back(histories_of(law));
        Axis time = quantity_axis("time", "s", shown_time(laws));
        time.from = 0.0;
        time.to = shown_time(laws) * 1.02;
        if (!(*time.to > 0)) continue;
        for (const Ordinate ordinate : {overlap_of, force_of}) {
            std::vector<Panel> row;
            const double greatest = greatest_drawn(laws, ordinate);
            const Axis axis = ordinate == force_of ? quantity_axis("force", "N", greatest)
                                                   : quantity_axis("overlap", "m", greatest);
            for (std::size_t i = 0; i < laws.size(); ++i)
                row.emplace_back(
                    panel_of(sample.name() + ", " + sample.laws[i].name, laws[i], time, axis, ordinate));
            share_axes(row, false, true);
            for (Panel& panel : row) figure.panels.push_back(std::move(panel));
        }
        for (std::size_t i = 0; i < laws.size(); ++i)
            for (const History* history : laws[i]) {
                falling = falling || history->part == HistoryPart::falling;
                for (std::size_t k = 0; k < history->trajectory.size(); k += listed_every) {
                    const TrajectoryPoint& point = history->trajectory[k];
                    figure.numbers.rows.push_back({sample.name(), sample.laws[i].name,
                                                   std::string(parts[place_of(history->part)].column),
                                                   history->velocity, point.time, point.overlap,
                                                   force_of(point)});
                }
            }
    }
    figure.columns = static_cast<int>(std::clamp<std::size_t>(run.data().laws.size(), 2, 5));
    figure.caption += pressure_sentence(run);
    if (!falling) figure.caption += " These data have no falling branch.";
    return figure;
}

}  // namespace ashimpact::report
