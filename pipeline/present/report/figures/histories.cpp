// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "pipeline/present/report/figures/axis_units.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/figures/law_series.hpp"
#include "pipeline/present/text/readable.hpp"
#include "solver/batch/in_parallel.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact::report {

namespace {

constexpr int instants = 41;
constexpr std::size_t listed_every = 2;  // of the instants drawn; 8-histories.json has them all
constexpr int fine_instants = 641;       // of an impact at v_c, which may creep far longer than it is drawn

struct History {
    std::string part;
    double velocity;
    std::vector<double> time{};
    std::vector<double> overlap{};
    std::vector<double> force{};  ///< static force plus damping
};

const std::array<std::string, 4>& parts() {
    static const std::array<std::string, 4> all{"at the critical velocity", "just above it", "rising branch",
                                                "falling branch"};
    return all;
}

/// A part in the table, which names it in every row.
std::string short_name(const std::string& part) {
    static const std::array<std::string, 4> names{"critical", "just-above", "rising", "falling"};
    return names[static_cast<std::size_t>(std::find(parts().begin(), parts().end(), part) - parts().begin())];
}

History computed(const std::string& part, const Impact& impact, int count) {
    History history{.part = part, .velocity = impact.velocity};
    for (const TrajectoryPoint& point : trajectory(impact, count)) {
        history.time.push_back(point.time);
        history.overlap.push_back(point.overlap);
        history.force.push_back(point.repulsive_force + point.attractive_force + point.damping_force);
    }
    return history;
}

/// A history that the run left in 8-histories.json.
History stored(const std::string& part, const Json& json) {
    const Json& path = json.at("trajectory");
    History history{.part = part,
                    .velocity = number_in(json, "velocity").value_or(0),
                    .time = column_in(path, "time"),
                    .overlap = column_in(path, "overlap")};
    const auto repulsive = column_in(path, "repulsive_force");
    const auto attractive = column_in(path, "attractive_force");
    const auto damping = column_in(path, "damping_force");
    for (std::size_t i = 0; i < repulsive.size(); ++i)
        history.force.push_back(repulsive[i] + attractive[i] + damping[i]);
    return history;
}

/// The middle one of the impacts beyond the rising branch.
std::optional<std::size_t> falling_point(const LawData& law) {
    if (law.damping == nullptr || !law.damping->rising) return std::nullopt;
    std::vector<std::size_t> beyond;
    for (std::size_t i = 0; i < law.damping->velocity.size(); ++i)
        if (law.damping->velocity[i] > law.damping->rising->to) beyond.push_back(i);
    if (beyond.empty()) return std::nullopt;
    return beyond[beyond.size() / 2];
}

std::vector<History> histories_of(const RunData& run, const SampleData& sample, const LawData& law) {
    std::vector<History> all;
    Impact impact{.law = law.choice.law,
                  .detachment = law.choice.detachment,
                  .damping = {run.data().damping_law, 0},
                  .contact = sample.contact->pair,
                  .velocity = 0};
    const auto add = [&](const std::string& part, int count) {
        try {
            all.push_back(computed(part, impact, count));
        } catch (const ConvergenceError&) {  // nothing to draw for this one
            return;
        }
    };
    const auto critical = number_in(law.velocity_json, "critical_velocity");
    const auto damping = number_in(law.velocity_json, "damping");
    if (critical && damping) {
        impact.velocity = *critical;
        impact.damping.coefficient = *damping;
        add(parts()[0], fine_instants);
    }
    if (law.histories.is_array())
        for (const Json& json : law.histories) {
            const std::string part = json.at("part").get<std::string>();
            all.push_back(stored(part == "critical" ? parts()[1] : parts()[2], json));
        }
    if (const auto point = falling_point(law)) {
        impact.velocity = law.damping->velocity[*point];
        impact.damping.coefficient = law.damping->damping[*point];
        add(parts()[3], instants);
    }
    return all;
}

/// The longest time drawn: histories at capture creep for ever, the others say how long an impact lasts.
double shown_time(const std::vector<std::vector<History>>& laws) {
    double longest = 0;
    for (const auto& histories : laws)
        for (const History& history : histories)
            if (history.part != parts()[0] && !history.time.empty())
                longest = std::max(longest, history.time.back());
    return longest;
}

/// Cuts a history off at a time and keeps no more of it than is drawn.
void shorten(History& history, double time) {
    std::size_t count = 0;
    while (count < history.time.size() && history.time[count] <= time) ++count;
    const std::size_t every = std::max<std::size_t>(1, count / static_cast<std::size_t>(instants));
    History kept{.part = history.part, .velocity = history.velocity};
    for (std::size_t i = 0; i < count; i += every) {
        kept.time.push_back(history.time[i]);
        kept.overlap.push_back(history.overlap[i]);
        kept.force.push_back(history.force[i]);
    }
    history = std::move(kept);
}

XyPanel panel_of(const std::string& title, const std::vector<History>& histories, const Axis& time,
                 const Axis& axis, std::vector<double> History::*quantity) {
    XyPanel panel{.title = title, .x = time, .y = axis};
    for (const History& history : histories) {
        const auto place = static_cast<std::size_t>(std::find(parts().begin(), parts().end(), history.part) -
                                                    parts().begin());
        Series series{.name = fmt::format("{}, {}, {:.3g} m/s", title, history.part, history.velocity),
                      .legend = history.part,
                      .look = Look::of(place)};
        for (std::size_t i = 0; i < history.time.size(); ++i)
            if (history.time[i] <= *time.to) series.line.push_back({history.time[i], (history.*quantity)[i]});
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
            if (!law.histories.is_array() || law.histories.empty()) continue;
            const double pressure = number_in(law.histories.front(), "greatest_pressure").value_or(0);
            if (pressure <= greatest) continue;
            greatest = pressure;
            by = &law;
        }
        if (by == nullptr) continue;
        const double yield = sample.contact->pair.yield_pressure;
        text += fmt::format("{} {} {} ({}, yield pressure {})", text.empty() ? "" : ";", sample.name,
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
                  .panels = {},
                  .numbers = {.columns = {"sample", "law", "part", "v_in [m/s]", "time [s]", "overlap [m]",
                                          "force [N]"},
                              .rows = {},
                              .shown_every = 4},
                  .columns = 4,
                  .narrow_columns = 2,
                  .panel_height = 190};
    bool falling = false;
    std::vector<std::pair<const SampleData*, const LawData*>> pairs;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) pairs.emplace_back(&sample, &law);
    const auto computed_all =
        in_parallel(pairs, [&](const auto& pair) { return histories_of(run, *pair.first, *pair.second); });
    std::size_t next = 0;
    for (const SampleData& sample : run.samples()) {
        std::vector<std::vector<History>> laws(
            computed_all.begin() + static_cast<std::ptrdiff_t>(next),
            computed_all.begin() + static_cast<std::ptrdiff_t>(next + sample.laws.size()));
        next += sample.laws.size();
        Axis time = quantity_axis("time", "s", shown_time(laws));
        time.from = 0.0;
        time.to = shown_time(laws) * 1.02;
        for (auto& histories : laws)
            for (History& history : histories)
                if (history.part == parts()[0]) shorten(history, shown_time(laws) * 1.02);
        double deepest = 0;
        double strongest = 0;
        for (const auto& histories : laws)
            for (const History& history : histories) {
                deepest = std::max(deepest, greatest_of(history.overlap));
                strongest = std::max(strongest, greatest_of(history.force));
                falling = falling || history.part == parts()[3];
            }
        if (!(*time.to > 0)) continue;
        for (const bool force : {false, true}) {
            std::vector<Panel> row;
            const Axis axis =
                force ? quantity_axis("force", "N", strongest) : quantity_axis("overlap", "m", deepest);
            for (std::size_t i = 0; i < laws.size(); ++i)
                row.emplace_back(panel_of(sample.name + ", " + sample.laws[i].name, laws[i], time, axis,
                                          force ? &History::force : &History::overlap));
            share_axes(row, false, true);
            for (Panel& panel : row) figure.panels.push_back(std::move(panel));
        }
        for (std::size_t i = 0; i < laws.size(); ++i)
            for (const History& history : laws[i])
                for (std::size_t k = 0; k < history.time.size(); k += listed_every)
                    figure.numbers.rows.push_back({sample.name, sample.laws[i].name, short_name(history.part),
                                                   history.velocity, history.time[k], history.overlap[k],
                                                   history.force[k]});
    }
    figure.columns = static_cast<int>(std::clamp<std::size_t>(run.data().laws.size(), 2, 5));
    figure.caption += pressure_sentence(run);
    if (!falling) figure.caption += " These data have no falling branch.";
    return figure;
}

}  // namespace ashimpact::report
