// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/sweep/sweep_page.hpp"

#include <fmt/format.h>

#include "core/json/writer.hpp"
#include "core/quantities/readable.hpp"
#include "pipeline/present/report/data/run_data.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/page/html.hpp"

namespace ashimpact::report {

namespace {

std::string answers(const Json& result) {
    std::string html = "<ul class=\"answers\">\n";
    for (const Json& law : result.at("laws")) {
        const Quantity fraction = shown_quantity(law.at("capture_fraction"));
        const auto& u = fraction.standard_uncertainty;
        html += fmt::format(
            "<li>By {} <span class=\"value\">{:#.4g} %</span>{} of {} impacts are captured.</li>\n",
            escaped(display_name(law.at("law").get<std::string>())), 100 * fraction.value,
            u ? fmt::format(" (± {:#.2g} %)", 100 * *u) : "", law.at("impacts").get<std::uint64_t>());
    }
    return html + "</ul>\n";
}

std::string provenance(const Json& artifact) {
    const Json& from = artifact.at("provenance");
    std::string html = fmt::format(
        "<section><h2 id=\"provenance\">Provenance</h2>\n<p>{} {}, revision <span "
        "class=\"hash\">{}</span>.</p>\n",
        escaped(from.value("program", "")), escaped(from.value("version", "")),
        escaped(from.value("revision", "")));
    for (const Json& input : from.at("inputs"))
        html += fmt::format("<p>{} <span class=\"hash\">{}</span></p>\n", html_name(input.value("file", "")),
                            escaped(input.value("sha256", "")));
    html +=
        "<details open><summary>What was asked for</summary><div class=\"scroll tall\" role=\"region\" "
        "tabindex=\"0\" aria-label=\"What was asked for\"><pre>" +
        escaped(write_json(from.at("options"))) + "</pre></div></details>\n<ul class=\"notes\">\n";
    for (const Json& citation : artifact.at("citations"))
        html += "<li>" + escaped(citation.get<std::string>()) + "</li>\n";
    return html + "</ul></section>\n";
}

}  // namespace

std::string sweep_page(const Json& artifact, const CaptureFractions& captured, const std::string& name) {
    const Json& result = artifact.at("result");
    std::string body = fmt::format(
        "<header>\n<h1>{}</h1>\n<p class=\"kind\">Report of an ashimpact sweep.</p>\n{}</header>\n<main>\n",
        html_name(name), answers(result));
    const auto figures = sweep_figures(artifact, captured);
    body += "<nav aria-label=\"Figures\">";
    for (const Figure& figure : figures)
        body += fmt::format("<a href=\"#{}\">{}</a>", figure.id, link_words(figure.id));
    body += "<a href=\"#provenance\">Provenance</a></nav>\n<section><h2 id=\"figures\">Figures</h2>\n";
    for (const Figure& figure : figures) body += html_of(figure, figure.id);
    body += "</section>\n";
    if (!artifact.at("warnings").empty()) {
        body += "<section><h2 id=\"warnings\">Warnings</h2>\n<ul class=\"notes\">\n";
        for (const Json& warning : artifact.at("warnings"))
            body += "<li>" + escaped(warning.get<std::string>()) + "</li>\n";
        body += "</ul></section>\n";
    }
    return html_page(name, body + provenance(artifact) + "</main>\n");
}

}  // namespace ashimpact::report
