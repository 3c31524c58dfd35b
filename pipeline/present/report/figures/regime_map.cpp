// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/static_curve.hpp"
#include "solver/contact/transition.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact::report {

namespace {

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
std::string statement(const Place& place, double hertzian) {
    const char* where = place.tabor < dmt_limit   ? "DMT holds"
                        : place.tabor > jkr_limit ? "JKR holds"
                                                  : "between DMT and JKR";
    return fmt::format(" {} at v_c by {}: {}; adhesion is {} the load.", place.sample, place.law, where,
                       place.load > hertzian ? "less than a twentieth of" : "no small part of");
}

}  // namespace

Figure regime_map_figure(const RunData& run) {
    Figure figure{
        .id = "regime-map",
        .title = "Which law of adhesion applies",
        .counterpart = {},
        .caption =
            "Map after Johnson & Greenwood 1997 (J. Colloid Interface Sci. 192:326): Tabor parameter "
            "and load over π w R*. DMT holds below 0.1, JKR above 5, Maugis-Dugdale everywhere. Above "
            "the line adhesion is less than 5 % of the load and Hertz is enough while the load lasts; "
            "separation still depends on adhesion. A mark is the greatest load of an impact at the "
            "critical velocity.",
        .panels = {},
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
        figure.caption += statement(place, hertzian);
    }
    panel.regions = {{least_shown, dmt_limit, "DMT"}, {jkr_limit, greatest_shown, "JKR"}};
    panel.x.from = least_shown;
    panel.x.to = greatest_shown;
    panel.y.from = least_load;
    panel.y.to = greatest;
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

}  // namespace ashimpact::report
