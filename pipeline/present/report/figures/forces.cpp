// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of forces: of the contact laws at rest, where each applies, and during an impact.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact::report {

namespace {

constexpr double greatest_overlap = 4;  ///< in units of Eq. 21, as the paper's Figure 3
constexpr double compared_overlap = 3;

struct StaticLaw {
    Law law;
    std::vector<StaticPoint> points;
    double attraction;  ///< at the compared overlap
};

std::vector<StaticLaw> curves_of(const RunData& run) {
    std::vector<StaticLaw> curves;
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

Series series_of(const StaticLaw& curve, double StaticPoint::*force) {
    Series series{.name = display_name(curve.law.name()),
                  .legend = display_name(curve.law.name()),
                  .look = Look::of(curve.law.index())};
    for (const StaticPoint& point : curve.points)
        series.line.push_back({point.overlap, force == nullptr ? point.force() : point.*force});
    return series;
}

/// "at overlap 3 the attraction is 10.9 (Brach-Dunn), ..."; the ratio to the next lower one.
std::string attraction_statement(const std::vector<StaticLaw>& curves) {
    std::string text;
    for (const StaticLaw& curve : curves)
        if (curve.attraction > 0)
            text += fmt::format("{}{} {:.3g}", text.empty() ? "" : ", ", display_name(curve.law.name()),
                                curve.attraction);
    if (text.empty()) return "None of these laws has attraction.";
    text = "At overlap 3 the attraction is, in these units: " + text + ".";
    const auto of = [&](std::string_view name) {
        for (const StaticLaw& curve : curves)
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

constexpr double least_tabor = 0.01;
constexpr double greatest_tabor = 100;
constexpr double least_load = 1;
constexpr int line_points = 17;
constexpr double slight = 0.05;  ///< share of the load below which Johnson & Greenwood leave an effect out

/// Load, over pi w R*, above which adhesion is a slight part of it, by the law of Maugis and Dugdale.
double hertzian_load(double tabor) {
    const CohesiveZone zone(transition_per_tabor() * tabor);
    double lower = 0;  // ln a; adhesion falls from all of the load to none of it
    double upper = std::log(1e3);
    const auto load_at = [&](double logarithm) {
        return static_cast<double>(zone.force(zone.at_contact_radius(std::exp(logarithm))));
    };
    for (int i = 0; i < 40; ++i) {
        const double middle = (lower + upper) / 2;
        const double load = load_at(middle);
        (std::exp(3 * middle) - load > slight * load ? lower : upper) = middle;
    }
    return load_at(upper);
}

/// Place of a sample in the map, at the critical velocity of one law.
struct Place {
    std::string sample, law;
    double tabor, transition;
    double load;  ///< greatest static force over pi w R*
};

/// The law whose critical velocity is reported, else the first that has one; null without any.
const LawData* shown_law(const SampleData& sample) {
    const auto& reported = sample.comparison->reported;
    const LawData* first = nullptr;
    for (const LawData& law : sample.laws) {
        if (law.velocity == nullptr || !law.velocity->maximum_overlap) continue;
        if (reported && reported->law == law.choice.law) return &law;
        if (first == nullptr) first = &law;
    }
    return first;
}

std::vector<Place> places_of(const RunData& run) {
    std::vector<Place> places;
    for (const SampleData& sample : run.samples()) {
        const ContactPair& pair = sample.contact->pair;
        const LawData* law = shown_law(sample);
        if (law == nullptr || !(pair.work_of_adhesion > 0)) continue;
        try {
            const double force =
                StaticCurve(law->choice.law, pair).at_overlap(*law->velocity->maximum_overlap).force();
            places.push_back({sample.name(), law->name, tabor_parameter_of(pair),
                              transition_parameter_of(pair),
                              force / (std::numbers::pi * pair.work_of_adhesion * pair.effective_radius)});
        } catch (const InputError&) {  // a law with a history has no force at an overlap
            continue;
        }
    }
    return places;
}

/// "88 um (Maugis-Dugdale): between DMT and JKR, adhesion counts."
std::string place_statement(const Place& place, double hertzian) {
    const char* where = place.tabor < dmt_limit   ? "DMT holds"
                        : place.tabor > jkr_limit ? "JKR holds"
                                                  : "between DMT and JKR";
    return fmt::format(" {} at v_c by {}: {}; adhesion is {} the load.", place.sample, place.law, where,
                       place.load > hertzian ? "less than a twentieth of" : "no small part of");
}

// Histories.

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

/// Greatest pressure in each sample's contact just above v_c, its law and the yield pressure, as a sentence.
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

Figure static_force_figure(const RunData& run) {
    const auto curves = curves_of(run);
    const Axis overlap{.label = "overlap, normalised"};
    XyPanel total{.title = "Total force", .x = overlap, .y = {.label = "force, normalised"}};
    XyPanel attraction{.title = "Attractive part", .x = overlap, .y = {.label = "force, normalised"}};
    NumberTable table{.columns = {"law", "overlap", "repulsive force", "attractive force", "total force"}};
    for (const StaticLaw& curve : curves) {
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
                "(π² w² R*/K²)^(1/3). No property of a particle is left in it. Attraction is negative. " +
                attraction_statement(curves),
            .panels = {total, attraction},
            .numbers = std::move(table),
            .columns = 2,
            .panel_height = 300};
}

Figure regime_map_figure(const RunData& run) {
    Figure figure{
        .id = "regime-map",
        .title = "Which law of adhesion applies",
        .caption =
            "Map after Johnson & Greenwood 1997 (J. Colloid Interface Sci. 192:326): Tabor parameter and "
            "load over π w R*. DMT holds below 0.1, JKR above 5, Maugis-Dugdale everywhere. Above the line "
            "adhesion is less than 5 % of the load and Hertz is enough while the load lasts; separation "
            "still depends on adhesion. A mark is the greatest load of an impact at the critical velocity.",
        .numbers = {.columns = {"sample", "law", "Tabor parameter", "transition parameter",
                                "greatest load over pi w R*", "load of Hertz over pi w R*"}},
        .columns = 1,
        .panel_height = 320};
    const std::vector<Place> places = places_of(run);
    if (places.empty()) {
        figure.caption += " No sample has adhesion and a critical velocity here.";
        return figure;
    }
    XyPanel panel{.title = "",
                  .x = {.label = "Tabor parameter", .spacing = Spacing::logarithmic},
                  .y = {.label = "load over π w R*", .spacing = Spacing::logarithmic}};
    double greatest = 1e4;
    double least_shown = least_tabor;
    double greatest_shown = greatest_tabor;
    Series line{.name = "adhesion is 5 % of the load",
                .legend = "adhesion is 5 % of the load",
                .look = Look::plain(0)};
    for (int i = 0; i < line_points; ++i) {
        const double tabor =
            least_tabor * std::pow(greatest_tabor / least_tabor, static_cast<double>(i) / (line_points - 1));
        line.line.push_back({tabor, hertzian_load(tabor)});
    }
    panel.series.push_back(std::move(line));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        greatest = std::max(greatest, 2 * place.load);
        least_shown = std::min(least_shown, place.tabor / 2);
        greatest_shown = std::max(greatest_shown, place.tabor * 2);
        Series mark{.name = place.sample + ", " + place.law, .legend = place.sample, .look = Look::of(i)};
        if (place.load > 0) mark.marks.push_back({place.tabor, std::max(place.load, least_load)});
        panel.series.push_back(std::move(mark));
        const double hertzian = hertzian_load(place.tabor);
        figure.numbers.rows.push_back(
            {place.sample, place.law, place.tabor, place.transition, place.load, hertzian});
        figure.caption += place_statement(place, hertzian);
    }
    panel.regions = {{least_shown, dmt_limit, "DMT"}, {jkr_limit, greatest_shown, "JKR"}};
    panel.x.from = least_shown;
    panel.x.to = greatest_shown;
    panel.y.from = least_load;
    panel.y.to = greatest;
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

Figure histories_figure(const RunData& run) {
    Figure figure{.id = "histories",
                  .title = "Overlap and force during one impact",
                  .counterpart = "Figure 9",
                  .caption =
                      "Overlap, and below it the whole force on the particle (contact and damping, positive "
                      "where it pushes away), over time: at the critical velocity, just above it, on the "
                      "rising and on the falling branch of e_n(v_in). All laws of a sample have the same "
                      "axes. At v_c the particle comes to rest as the contact ends, so its curve ends flat; "
                      "a faster impact presses deeper and leaves at a slope.",
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
