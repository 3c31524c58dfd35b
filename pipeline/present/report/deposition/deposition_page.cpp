// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/deposition/deposition_page.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/text/deposition_text.hpp"

namespace ashimpact::report {

namespace {

/// A column of numbers along an axis, as a line.
template <class Row, class X, class Y>
Series line_of(const std::string& name, std::size_t look, const std::vector<Row>& rows, X&& x, Y&& y) {
    Series series{.name = name, .legend = name, .look = Look::of(look)};
    for (const Row& row : rows) series.line.push_back({x(row), y(row)});
    return series;
}

std::optional<double> grams(const std::optional<Quantity>& flux) {
    return flux ? std::optional(flux->value * grams_an_hour) : std::nullopt;
}

Figure deposited_sizes_figure(const DepositionResult& result) {
    Figure figure{
        .id = "by-size",
        .title = "What arrives and what stays, by size",
        .caption =
            "Of the particles of each size that fly at the tube, the share that arrives and the "
            "share that stays; the band is the span over intervals of v_c and assumptions.",
        .numbers = {.columns = {"diameter [m]", "from [m]", "to [m]", "mass fraction", "Stokes number",
                                "effective Stokes number", "impaction efficiency", "v_c [m/s]",
                                "mean v_n [m/s]", "stick fraction", "least", "greatest", "mean e of rebounds",
                                "mean rebound v_n [m/s]", "arrives [g/(m2 h)]", "stays [g/(m2 h)]"}},
        .columns = 2,
        .panel_height = 260};
    const Axis diameter{.label = "diameter", .unit = "µm", .scale = 1e-6, .spacing = Spacing::logarithmic};
    const auto x = [](const DepositedSize& size) { return size.diameter; };
    XyPanel shares{
        .title = "share",
        .x = diameter,
        .y = {.label = "of what flies at the tube", .unit = "%", .scale = 0.01, .from_zero = true}};
    shares.series = {line_of("arrives", 0, result.sizes, x,
                             [](const DepositedSize& size) { return size.impaction_efficiency; }),
                     line_of("stays", 1, result.sizes, x, [](const DepositedSize& size) {
                         return size.impaction_efficiency * size.stick_fraction.value;
                     })};
    std::vector<Point>& band = shares.series[1].band;
    for (const DepositedSize& size : result.sizes)
        band.push_back({size.diameter, size.impaction_efficiency * size.stick_fraction.span.greatest});
    for (auto size = result.sizes.rbegin(); size != result.sizes.rend(); ++size)
        band.push_back({size->diameter, size->impaction_efficiency * size->stick_fraction.span.least});
    XyPanel velocities{.title = "velocity",
                       .x = diameter,
                       .y = {.label = "v", .unit = "m/s", .spacing = Spacing::logarithmic}};
    velocities.series = {
        line_of("arrives, mean v_n", 0, result.sizes, x,
                [](const DepositedSize& size) { return size.normal_velocity.value_or(std::nan("")); }),
        line_of("v_c", 2, result.sizes, x,
                [](const DepositedSize& size) {
                    const double velocity = size.critical_velocity.value_or(std::nan(""));
                    return velocity <= fastest_in_model ? velocity : std::nan("");
                }),
        line_of("rebounds, mean v_n", 3, result.sizes, x,
                [](const DepositedSize& size) { return size.rebound.velocity.value_or(std::nan("")); })};
    if (result.measured) {
        velocities.regions.push_back({result.measured->from, result.measured->to, "measured"});
        shares.regions.push_back({result.measured->from, result.measured->to, "measured"});
    }
    for (const DepositedSize& size : result.sizes)
        figure.numbers.rows.push_back(
            {size.diameter, size.from, size.to, size.mass_fraction, size.stokes, size.effective_stokes,
             size.impaction_efficiency, critical_cell(size.critical_velocity), cell_of(size.normal_velocity),
             size.stick_fraction.value, size.stick_fraction.span.least, size.stick_fraction.span.greatest,
             cell_of(size.rebound.restitution), cell_of(size.rebound.velocity),
             cell_of(grams(size.arrival_flux)), cell_of(grams(size.deposition_flux))});
    figure.numbers.shown_every = 4;
    figure.panels = {std::move(shares), std::move(velocities)};
    return figure;
}

Figure around_tube_figure(const DepositionResult& result) {
    const bool flux = result.tube.load.has_value();
    Figure figure{
        .id = "around-the-tube",
        .title = "Where on the tube",
        .caption = fmt::format("{} each part of the circumference, against the angle from the front; "
                               "both sides together.",
                               flux ? "Mass that arrives at and stays on a square metre of"
                                    : "Share of the mass that flies at the tube that arrives at and "
                                      "stays on"),
        .numbers = {.columns = {"from [deg]", "to [deg]", "arrives", "stays", "mean v_n [m/s]",
                                "mean angle from the normal [deg]", "mean e of rebounds",
                                "mean rebound v_n [m/s]", "arrives [g/(m2 h)]", "stays [g/(m2 h)]"}},
        .columns = 2,
        .panel_height = 260};
    const Axis angle{
        .label = "angle from the front", .unit = "deg", .scale = degree, .from = 0.0, .to = 90 * degree};
    const auto middle = [](const DepositedArc& arc) { return (arc.from + arc.to) / 2; };
    const auto shown = [&](const std::optional<Quantity>& of_load, double share) {
        return of_load ? of_load->value * grams_an_hour : share;
    };
    XyPanel mass{.title = flux ? "mass" : "share",
                 .x = angle,
                 .y = flux ? Axis{.label = "flux", .unit = "g/(m2 h)", .from_zero = true}
                           : Axis{.label = "share", .unit = "%", .scale = 0.01, .from_zero = true}};
    mass.series = {line_of("arrives", 0, result.angles, middle,
                           [&](const DepositedArc& arc) { return shown(arc.arrival_flux, arc.arrives); }),
                   line_of("stays", 1, result.angles, middle,
                           [&](const DepositedArc& arc) { return shown(arc.deposition_flux, arc.stays); })};
    XyPanel velocity{
        .title = "mean normal velocity", .x = angle, .y = {.label = "v_n", .unit = "m/s", .from_zero = true}};
    velocity.series = {
        line_of("arrives", 0, result.angles, middle,
                [](const DepositedArc& arc) { return arc.normal_velocity.value_or(std::nan("")); }),
        line_of("rebounds", 3, result.angles, middle,
                [](const DepositedArc& arc) { return arc.rebound.velocity.value_or(std::nan("")); })};
    for (const DepositedArc& arc : result.angles)
        figure.numbers.rows.push_back(
            {arc.from / degree, arc.to / degree, arc.arrives, arc.stays, cell_of(arc.normal_velocity),
             cell_of(arc.incidence ? std::optional(*arc.incidence / degree) : std::nullopt),
             cell_of(arc.rebound.restitution), cell_of(arc.rebound.velocity),
             cell_of(grams(arc.arrival_flux)), cell_of(grams(arc.deposition_flux))});
    figure.panels = {std::move(mass), std::move(velocity)};
    return figure;
}

Figure assumptions_figure(const DepositionResult& result) {
    Figure figure{
        .id = "assumptions",
        .title = "Which assumption matters",
        .caption =
            "What stays of the mass that arrives, under each assumption on v_c of sizes that "
            "were not measured; bars reach over the interval of v_c, where it is known. "
            "Adhesion alone is a lower bound.",
        .numbers = {.columns = {"assumption", "stick fraction", "least", "greatest", "stays [g/(m2 h)]"}},
        .columns = 1};
    RowPanel panel{
        .title = "",
        .x = {.label = "stays of what arrives", .unit = "%", .scale = 0.01, .from = -0.02, .to = 1.02}};
    for (const AssumedDeposition& each : result.assumptions) {
        const std::string name(name_of(each.basis));
        const Look look = each.basis == result.basis ? Look::of(1) : Look::of(0, true);
        panel.rows.push_back(
            {.label = name,
             .items = {{RowItem::Kind::interval, each.stays.span.least, each.stays.span.greatest, look, name},
                       {RowItem::Kind::mark, each.stays.value, each.stays.value, look,
                        fmt::format("{}: {:.3g} %", name, 100 * each.stays.value)}}});
        figure.numbers.rows.push_back({name, each.stays.value, each.stays.span.least,
                                       each.stays.span.greatest, cell_of(grams(each.deposition_flux))});
    }
    figure.panels.emplace_back(std::move(panel));
    return figure;
}

}  // namespace

std::vector<Figure> deposition_figures(const DepositionResult& result) {
    return {deposited_sizes_figure(result), around_tube_figure(result), assumptions_figure(result)};
}

std::string deposition_page(const DepositionResult& result, const Json& artifact) {
    std::vector<std::string_view> ids;
    std::string drawn;
    const std::vector<Figure> figures = deposition_figures(result);
    for (const Figure& figure : figures) {
        ids.emplace_back(figure.id);
        drawn += html_of(figure, figure.id);
    }
    std::string body =
        "<header>\n<h1>Ash on a tube</h1>\n<p class=\"kind\">Report of ashimpact deposit.</p>\n"
        "<ul class=\"answers\">\n";
    for (const std::string& sentence : deposition_sentences(result))
        body += "<li>" + with_subscripts(escaped(sentence)) + "</li>\n";
    body += "</ul>\n<p>" + with_subscripts(escaped(deposition_scope())) + "</p>\n</header>\n<main>\n" +
            html_contents(ids) + html_section("figures", "Figures", drawn);
    if (!artifact.at("warnings").empty())
        body += html_section("warnings", "Warnings", html_notes(escaped_texts(artifact.at("warnings"))));
    return html_page("Ash on a tube", body + html_provenance(artifact) + "</main>\n");
}

}  // namespace ashimpact::report
