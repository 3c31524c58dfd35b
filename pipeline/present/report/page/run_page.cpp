// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/page/run_page.hpp"

#include <functional>

#include <fmt/format.h>

#include "core/version.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "solver/batch/in_parallel.hpp"

namespace ashimpact::report {

namespace {

/// Link targets are the figures' ids; those of further runs carry their number.
std::string suffix(std::size_t run) {
    return run == 0 ? "" : fmt::format("-{}", run + 1);
}

std::string heading(const std::vector<RunData>& runs) {
    std::string html = "<header>\n";
    if (runs.size() == 1) {
        html += fmt::format(
            "<h1>{}</h1>\n<p class=\"kind\">From the XRD result to the critical velocity of impact. Report "
            "of an ashimpact run.</p>\n",
            html_name(runs.front().data().name));
        return html + answers_html(runs.front()) + "</header>\n";
    }
    html += fmt::format(
        "<h1>{} runs side by side</h1>\n<p class=\"kind\">What differs between their inputs comes first, "
        "then the answers, then each figure for one "
        "run after the other.</p>\n</header>\n",
        runs.size());
    return html;
}

std::string contents() {
    std::string html = "<nav aria-label=\"Figures\">";
    for (const FigureMaker& maker : figure_makers())
        html += fmt::format("<a href=\"#{}\">{}</a>", maker.id, link_words(maker.id));
    return html + "<a href=\"#provenance\">Provenance</a></nav>\n";
}

std::string per_run(const std::vector<RunData>& runs, const std::string& title, const std::string& id,
                    std::string (*part)(const RunData&)) {
    std::string html = fmt::format("<section><h2 id=\"{}\">{}</h2>\n", id, title);
    for (const RunData& run : runs) {
        if (runs.size() > 1) html += fmt::format("<h3>{}</h3>\n", html_name(run.label()));
        html += part(run);
    }
    return html + "</section>\n";
}

std::string figures_html(const std::vector<RunData>& runs) {
    std::string html = "<section><h2 id=\"figures\">Figures</h2>\n" + sketch_html("impact");
    std::vector<std::pair<const FigureMaker*, std::size_t>> wanted;
    for (const FigureMaker& maker : figure_makers())
        for (std::size_t i = 0; i < runs.size(); ++i) wanted.emplace_back(&maker, i);
    const auto drawn = in_parallel(wanted, [&](const auto& each) {
        const auto& [maker, i] = each;
        Figure figure = maker->make(runs[i]);
        if (runs.size() > 1) figure.title += " (" + runs[i].label() + ")";
        return html_of(figure, std::string(maker->id) + suffix(i));
    });
    for (const std::string& figure : drawn) html += figure;
    return html + "</section>\n";
}

std::string notes(const std::vector<RunData>& runs) {
    return per_run(runs, "What was assumed, inferred or reconstructed", "assumptions", assumptions_html) +
           per_run(runs, "What the model holds for", "validity", validity_html) +
           per_run(runs, "Warnings", "warnings", warnings_html);
}

}  // namespace

std::string region_label(const std::string& label, const RunData& run) {
    return escaped(run.label().empty() ? label : label + ", " + run.label());
}

std::string run_page(const std::vector<RunData>& runs) {
    std::string body = heading(runs) + "<main>\n";
    if (runs.size() > 1) {
        body += differences_html(runs);
        body += per_run(runs, "Answers", "answers", answers_html);
    }
    body += contents();
    const std::vector<std::function<std::string()>> parts{
        [&] { return figures_html(runs); },
        [&] { return per_run(runs, "Provenance", "provenance", provenance_html); },
        [&] { return notes(runs); },
        [&] { return per_run(runs, "Critical velocities", "comparison", comparison_html); }};
    const auto made = in_parallel(parts, [](const auto& part) { return part(); });  // the longest first
    body += made[3] + made[0] + made[2] + made[1];
    body += "</main>\n<footer><p>Made by ashimpact " + escaped(program_version()) +
            ". Curves are read off with the mouse, by touch or with the arrow keys; without scripts "
            "everything else stays.</p></footer>\n";
    const std::string title =
        runs.size() == 1 ? runs.front().data().name : fmt::format("{} runs of ashimpact", runs.size());
    return html_page(title, body);
}

}  // namespace ashimpact::report
