// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/present/text/comparison_table.hpp"

namespace ashimpact::report {

namespace {

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

/// "DMT and JKR agree with the measured 1.92 m/s; Hertz is too low."
std::string measured_sentence(const SampleData& sample) {
    const auto& measured = sample.comparison->measured;
    if (!measured) return "No measured critical velocity to compare with.";
    const std::string bounds = bounds_text(sample.comparison->measured_interval);
    std::string text = "Measured: " + velocity_text(measured->value()) + " m/s" +
                       (bounds.empty() ? "" : " (95 %: " + bounds + ")");
    const auto add = [&](CriticalVelocityVerdict verdict, const char* one, const char* many) {
        std::vector<std::string> laws;
        for (const LawData& law : sample.laws)
            if (law.compared != nullptr && law.compared->check && law.compared->check->verdict == verdict)
                laws.push_back(law.name);
        if (!laws.empty()) text += fmt::format("; {} {}", listed(laws), laws.size() == 1 ? one : many);
    };
    add(CriticalVelocityVerdict::agrees, "agrees with it", "agree with it");
    add(CriticalVelocityVerdict::model_too_low, "is too low", "are too low");
    add(CriticalVelocityVerdict::model_too_high, "is too high", "are too high");
    return text + ".";
}

/// "a particle sticks when it is slower than 1.86 m/s (95 %: 1.60 to 2.16 m/s), by Maugis-Dugdale: ..."
std::string reported_sentence(const ReportedVelocity& reported) {
    const Answer answer = answer_of(reported);
    if (answer.kind == Answer::Kind::none) return "no critical velocity: " + escaped(reported.reason) + ".";
    const std::string velocity =
        fmt::format("<span class=\"value\">{} m/s</span>", velocity_text(answer.velocity));
    if (answer.kind == Answer::Kind::above)
        return "the critical velocity lies above " + velocity + escaped(": " + reported.reason + ".");
    if (answer.kind == Answer::Kind::below)
        return "the critical velocity lies below " + velocity + escaped(": " + reported.reason + ".");
    const std::string bounds = bounds_text(reported.interval);
    return "a particle sticks when it is slower than " + velocity +
           escaped((bounds.empty() ? "" : " (95 %: " + bounds + " m/s)") +
                   (reported.law ? ", by " + display_name(reported.law->name()) : "") + ": " +
                   reported.reason + ".");
}

/// "By each law: Hertz 1.10 m/s, JKR ...", where the laws were computed at all.
std::string by_each_law(const SampleData& sample) {
    std::vector<std::string> laws;
    for (const LawData& law : sample.laws)
        if (law.velocity != nullptr) laws.push_back(law.name + " " + estimate_text(law.headline()));
    return laws.empty() ? "" : "By each law: " + listed(laws) + ".";
}

/// What was computed with: "Diameter 44 um, density 2300 kg/m3, E* 62.1 GPa, w 0.3 J/m2."
std::string inputs_sentence(const SampleComparison& sample) {
    std::vector<std::string> words;
    const auto add = [&](const char* word, const std::optional<double>& value, const char* unit) {
        if (value) words.push_back(fmt::format("{} {}", word, readable(*value, unit)));
    };
    const auto value_of = [](const std::optional<Quantity>& quantity) {
        return quantity ? std::optional(quantity->value) : std::nullopt;
    };
    add("Diameter", sample.diameter, "m");
    add("density", value_of(sample.density), "kg/m3");
    add("E*", sample.contact_modulus, "Pa");
    add("w", value_of(sample.work_of_adhesion), "J/m2");
    return words.empty() ? "" : listed(words) + ".";
}

/// The summary of a sample: the velocity to report, or why there is none; all laws; the inputs.
std::string answer(const SampleData& sample) {
    std::string html =
        fmt::format("<li><strong>{}</strong>: {}", html_name(sample.name()),
                    reported_sentence(sample.comparison->reported.value_or(ReportedVelocity{})));
    for (const std::string& rest :
         {by_each_law(sample), measured_sentence(sample), inputs_sentence(*sample.comparison)})
        if (!rest.empty()) html += fmt::format("<span class=\"rest\">{}</span>", escaped(rest));
    return html + "</li>\n";
}

/// An empty cell.
constexpr std::string_view no_value = "–";

std::string or_no_value(std::string_view text) {
    return std::string(text.empty() ? no_value : text);
}

std::string number_cell(const std::optional<double>& value, double unit = 1) {
    return value ? fmt::format("{:.4g}", *value / unit) : std::string(no_value);
}

bool is_extrapolated(const LawData& law) {
    return law.compared != nullptr && ashimpact::is_extrapolated(*law.compared);
}

std::string dynamic_cell(const LawData& law) {
    if (const auto head = law.headline())
        return (is_extrapolated(law) ? "* " : "") + velocity_text(head->value);
    return law.velocity != nullptr ? std::string(name_of(law.velocity->verdict)) : std::string(no_value);
}

/// The measured velocity, and its 95 % interval below where it has one.
std::string measured_html(const SampleComparison& sample) {
    if (!sample.measured) return std::string(no_value);
    const std::string bounds = bounds_text(sample.measured_interval);
    return velocity_text(sample.measured->value()) + (bounds.empty() ? "" : "<br>(" + bounds + ")");
}

struct Column {
    std::string_view head;
    bool text = false;
    bool of_sample = false;  ///< one cell over all laws of the sample
    bool always = true;      ///< false: left out if no cell has a value
};

constexpr std::array<Column, 11> page_columns{
    {{.head = "E [GPa]", .of_sample = true},
     {.head = "E* [GPa]", .of_sample = true},
     {.head = "W<sub>s</sub> [fJ]", .of_sample = true},
     {.head = "v<sub>c</sub>, Eq. 30 [m/s]", .of_sample = true},
     {.head = "law", .text = true},
     {.head = "dynamic v<sub>c</sub> [m/s]"},
     {.head = "95 % interval"},
     {.head = "extrapolated v<sub>c</sub> [m/s]", .always = false},
     {.head = "published", .always = false},
     {.head = "measured (95&nbsp;%)", .of_sample = true, .always = false},
     {.head = "verdict", .text = true, .always = false}}};
using Cells = std::array<std::string, page_columns.size()>;

/// The cells of a law, in the order of the page_columns.
Cells cells_of(const SampleData& sample, const LawData& law) {
    const auto head = law.headline();
    const auto extrapolated = law.extrapolated();
    const auto& published = sample.sample->published;
    const Quantity* printed = published ? published->critical_velocity.find(law.choice.law) : nullptr;
    return {number_cell(sample.modulus->young_modulus.value, 1e9),
            number_cell(sample.contact->pair.contact_modulus, 1e9),
            number_cell(sample.analytic->separation_energy, 1e-15),
            number_cell(sample.analytic->critical_velocity),
            escaped(law.name),
            dynamic_cell(law),
            or_no_value(head ? bounds_text(head->interval) : ""),
            or_no_value(extrapolated ? velocity_text(*extrapolated) : ""),
            number_cell(printed != nullptr ? std::optional(printed->value) : std::nullopt),
            measured_html(*sample.comparison),
            or_no_value(law.compared != nullptr ? verdict_words(law.compared->check) : "")};
}

/// Whether a column has a value in this run, or is always shown.
bool is_shown(std::size_t column, const std::vector<std::vector<Cells>>& samples) {
    return page_columns[column].always || std::ranges::any_of(samples, [&](const std::vector<Cells>& laws) {
               return std::ranges::any_of(laws, [&](const Cells& row) { return row[column] != no_value; });
           });
}

/// How extrapolated velocities differ from dynamic ones, below the table.
std::string extrapolation_notes(const RunData& run) {
    bool any = false;
    bool instead = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            any = any || law.extrapolated();
            instead = instead || is_extrapolated(law);
        }
    if (!any) return {};
    return with_subscripts(
        std::string("<p class=\"where\">Dynamic v_c: the answer, estimated from rebounds and captures "
                    "together. Extrapolated v_c: where the polynomial η(e_n), fitted to the rebounds alone, "
                    "meets e_n = 0; the curves in the figures end there. The two may lie far apart.") +
        (instead ? " *: extrapolated, as the impacts gave no estimate with this law." : "") + "</p>\n");
}

}  // namespace

std::string answers_html(const RunData& run) {
    std::string html = "<ul class=\"answers\">\n";
    for (const SampleData& sample : run.samples()) html += answer(sample);
    return html + "</ul>\n";
}

std::string comparison_html(const RunData& run) {
    std::vector<std::vector<Cells>> samples;
    for (const SampleData& sample : run.samples()) {
        auto& laws = samples.emplace_back();
        for (const LawData& law : sample.laws) laws.push_back(cells_of(sample, law));
    }
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < page_columns.size(); ++i)
        if (is_shown(i, samples)) shown.push_back(i);
    std::string html = "<table><thead><tr><th scope=\"col\">sample</th>";
    const auto text_class = [](const Column& column) { return column.text ? " class=\"text\"" : ""; };
    for (const std::size_t i : shown)
        html += fmt::format("<th scope=\"col\"{}>{}</th>", text_class(page_columns[i]), page_columns[i].head);
    html += "</tr></thead><tbody>\n";
    for (std::size_t s = 0; s < samples.size(); ++s)
        for (const Cells& row : samples[s]) {
            const bool first = &row == &samples[s].front();
            const std::string span = fmt::format(" rowspan=\"{}\"", samples[s].size());
            html += first ? fmt::format("<tr class=\"first\"><th scope=\"rowgroup\"{}>{}</th>", span,
                                        html_name(run.samples()[s].name()))
                          : "<tr>";
            for (const std::size_t i : shown)
                if (first || !page_columns[i].of_sample)
                    html += fmt::format("<td{}{}>{}</td>", text_class(page_columns[i]),
                                        page_columns[i].of_sample ? span : "", row[i]);
            html += "</tr>\n";
        }
    html = html_scroll(region_label("Critical velocities", run), html + "</tbody></table>") + "\n";
    html += extrapolation_notes(run);
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.velocity != nullptr && !law.velocity->interval_note.empty())
                html += fmt::format("<p class=\"where\">{}, {}: {}.</p>\n", html_name(sample.name()),
                                    escaped(law.name), escaped(law.velocity->interval_note));
    return html;
}

}  // namespace ashimpact::report
