// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/sweep/sweep_page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"

namespace ashimpact::report {

namespace {

Figure capture_figure(const CaptureFractions& captured) {
    Figure figure{
        .id = "capture",
        .title = "Captured impacts against each variable",
        .caption = fmt::format("The share of impacts that stay on the wall, against one variable while the "
                               "others are spread as the sweep says. From {} impacts of its design, solved "
                               "again for this figure; bars are one standard uncertainty.",
                               captured.impacts),
        .numbers = {.columns = {"law", "variable", "value [SI]", "captured", "standard uncertainty"}},
        .columns = 2,
        .panel_height = 260};
    for (const CaptureVariable& variable : captured.variables) {
        std::vector<double> values;
        for (const CaptureCurve& curve : variable.curves)
            for (const CaptureShare& share : curve.shares) values.push_back(share.value);
        XyPanel panel{.title = words_of(variable.name),
                      .x = quantity_axis(words_of(variable.name), variable.unit, greatest_of(values)),
                      .y = {.label = "captured", .unit = "%", .scale = 0.01, .from = -0.03, .to = 1.03}};
        for (const CaptureCurve& curve : variable.curves) {
            const std::string name = display_name(curve.law.name());
            Series series{.name = name, .legend = name, .look = Look::of(curve.law.index())};
            for (const CaptureShare& share : curve.shares) {
                series.line.push_back({share.value, share.fraction});
                series.marks.push_back({share.value, share.fraction, 0, share.standard_uncertainty});
                figure.numbers.rows.push_back({std::string(curve.law.name()), variable.name, share.value,
                                               share.fraction, share.standard_uncertainty});
            }
            panel.series.push_back(std::move(series));
        }
        figure.panels.emplace_back(std::move(panel));
    }
    return figure;
}

/// A histogram as the outline of its bars, in at most fifty of them.
std::vector<Point> outline(const std::vector<double>& edges, const std::vector<double>& counts,
                           double whole) {
    std::vector<Point> line;
    const std::size_t together = counts.size() / 50 + 1;
    for (std::size_t i = 0; i < counts.size(); i += together) {
        const std::size_t end = std::min(counts.size(), i + together);
        double sum = 0;
        for (std::size_t k = i; k < end; ++k) sum += counts[k];
        line.push_back({edges[i], sum / whole});
        line.push_back({edges[end], sum / whole});
    }
    return line;
}

Figure histogram_figure(const Json& result) {
    Figure figure{
        .id = "histogram",
        .title = "How the results are spread",
        .caption =
            "Histograms: the share of impacts in each bin. Captures, whose restitution is 0, are left out of "
            "the bins:",
        .numbers = {.columns = {"law", "observable", "lower edge [SI]", "upper edge [SI]", "count"}},
        .columns = 2,
        .panel_height = 260};
    std::vector<std::string> titles;
    for (const Json& law : result.at("laws")) {
        const std::string name = law.at("law").get<std::string>();
        for (const Json& observable : law.at("observables")) {
            if (!observable.contains("histogram")) continue;
            const std::string of = observable.at("name").get<std::string>();
            const Json& histogram = observable.at("histogram");
            const auto edges = histogram.at("edges").at("values").get<std::vector<double>>();
            const auto counts = histogram.at("counts").get<std::vector<double>>();
            const auto found = std::find(titles.begin(), titles.end(), of);
            const auto place = static_cast<std::size_t>(found - titles.begin());
            if (found == titles.end()) {
                titles.push_back(of);
                figure.panels.emplace_back(
                    XyPanel{.title = words_of(of),
                            .x = quantity_axis(words_of(of), histogram.at("edges").value("unit", "1"),
                                               greatest_of(edges)),
                            .y = {.label = "share", .unit = "%", .scale = 0.01, .from_zero = true}});
            }
            const double whole = std::max(1.0, observable.value("count", 1.0));
            const Law known = Law::named(name);
            std::get<XyPanel>(figure.panels[place])
                .series.push_back({.name = display_name(name),
                                   .legend = display_name(name),
                                   .look = Look::of(known.index()),
                                   .line = outline(edges, counts, whole)});
            for (std::size_t i = 0; i < counts.size(); ++i)
                figure.numbers.rows.push_back({name, of, edges[i], edges[i + 1], counts[i]});
            if (of == "restitution")
                figure.caption += fmt::format(" {} {:.3g} %,", display_name(name),
                                              100 * histogram.value("zeros", 0.0) / whole);
        }
    }
    figure.caption.back() = '.';
    figure.numbers.shown_every =
        figure.numbers.rows.size() > 400 ? static_cast<int>(figure.numbers.rows.size() / 200) : 1;
    return figure;
}

Figure sweep_sensitivity_figure(const Json& result) {
    Figure figure{.id = "sensitivity",
                  .title = "Which variable matters",
                  .caption =
                      "Sobol indices: the share of the variance of each observable that a variable makes by "
                      "itself (first order, mark), and with all that it does together with others (total, "
                      "bar); intervals are one standard uncertainty of the total.",
                  .numbers = {.columns = {"law", "observable", "variable", "first order",
                                          "its standard uncertainty", "total", "its standard uncertainty"}},
                  .columns = 2};
    for (const Json& law : result.at("laws")) {
        const std::string name = law.at("law").get<std::string>();
        if (!law.contains("sensitivity")) continue;
        RowPanel panel{
            .title = display_name(name),
            .x = {.label = "share of the variance", .unit = "%", .scale = 0.01, .from = -0.02, .to = 1.05}};
        for (const Json& of : law.at("sensitivity")) {
            panel.rows.push_back({.label = words_of(of.at("of").get<std::string>()), .heading = true});
            for (const Json& index : of.at("indices")) {
                const std::string variable = index.at("variable").get<std::string>();
                const Quantity first = shown_quantity(index.at("first"));
                const Quantity total = shown_quantity(index.at("total"));
                panel.rows.push_back(sobol_row(words_of(variable), variable,
                                               Look::of(Law::named(name).index()), first.value, total.value,
                                               total.standard_uncertainty));
                figure.numbers.rows.push_back({name, of.at("of").get<std::string>(), variable, first.value,
                                               cell_of(first.standard_uncertainty), total.value,
                                               cell_of(total.standard_uncertainty)});
            }
        }
        if (!panel.rows.empty()) figure.panels.emplace_back(std::move(panel));
    }
    return figure;
}

std::string sweep_answers(const Json& result) {
    std::string html = "<ul class=\"answers\">\n";
    for (const Json& law : result.at("laws")) {
        const Quantity fraction = shown_quantity(law.at("capture_fraction"));
        const auto& u = fraction.standard_uncertainty;
        html += fmt::format(
            "<li>By {} <span class=\"value\">{:#.4g} %</span>{} of {} impacts are captured{}.</li>\n",
            escaped(display_name(law.at("law").get<std::string>())), 100 * fraction.value,
            u ? fmt::format(" (± {:#.2g} %)", 100 * *u) : "", law.at("impacts").get<std::uint64_t>(),
            captures_words(law));
    }
    return html + "</ul>\n";
}

}  // namespace

std::string captures_words(const Json& law) {
    const auto outside = law.find("captured_outside_model");
    if (outside == law.end()) return {};
    const double share = shown_quantity(*outside).value;
    return fmt::format(": {:.3g} % with v_c {}, {:.3g} % within it", 100 * share, outside_model_text(),
                       100 * (shown_quantity(law.at("capture_fraction")).value - share));
}

std::string sweep_page(const Json& artifact, const CaptureFractions& captured, const std::string& name) {
    const Json& result = artifact.at("result");
    std::vector<std::string_view> ids;
    std::string drawn;
    const std::vector<Figure> figures{capture_figure(captured), histogram_figure(result),
                                      sweep_sensitivity_figure(result)};
    for (const Figure& figure : figures) {
        if (figure.panels.empty()) continue;
        ids.emplace_back(figure.id);
        drawn += html_of(figure, figure.id);
    }
    std::string body = fmt::format(
        "<header>\n<h1>{}</h1>\n<p class=\"kind\">Report of an ashimpact sweep.</p>\n{}</header>\n<main>\n",
        html_name(name), sweep_answers(result));
    body += html_contents(ids) + html_section("figures", "Figures", drawn);
    if (!artifact.at("warnings").empty())
        body += html_section("warnings", "Warnings", html_notes(escaped_texts(artifact.at("warnings"))));
    return html_page(name, body + html_provenance(artifact) + "</main>\n");
}

}  // namespace ashimpact::report
