// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/figures/law_series.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/present/text/readable.hpp"

namespace ashimpact::report {

namespace {

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

std::string verdict_of(const LawData& law) {
    if (law.velocity_json.is_object() && law.velocity_json.contains("check") &&
        law.velocity_json.at("check").is_object())
        return law.velocity_json.at("check").at("verdict").get<std::string>();
    return {};
}

/// "1.91 to 1.93" of the measured velocity; empty where nothing bounds it.
std::string measured_interval(const SampleData& sample) {
    const auto interval = sample.measured.find("interval");
    if (interval == sample.measured.end()) return {};
    const auto lower = number_in(*interval, "lower");
    const auto upper = number_in(*interval, "upper");
    return lower || upper ? interval_text(lower, upper) : std::string();
}

/// "DMT and JKR agree with the measured 1.92 m/s; Hertz is too low."
std::string measured_sentence(const SampleData& sample) {
    const auto measured = number_in(sample.measured, "critical_velocity");
    if (!measured) return "No measured critical velocity to compare with.";
    std::vector<std::string> agree;
    std::vector<std::string> low;
    std::vector<std::string> high;
    for (const LawData& law : sample.laws) {
        const std::string verdict = verdict_of(law);
        if (verdict == "agrees") agree.push_back(law.name);
        if (verdict == "model-too-low") low.push_back(law.name);
        if (verdict == "model-too-high") high.push_back(law.name);
    }
    const std::string ends = measured_interval(sample);
    std::string text =
        fmt::format("Measured: {:#.3g} m/s", *measured) + (ends.empty() ? "" : " (95 %: " + ends + ")");
    const auto add = [&](const std::vector<std::string>& laws, const char* one, const char* many) {
        if (!laws.empty()) text += fmt::format("; {} {}", listed(laws), laws.size() == 1 ? one : many);
    };
    add(agree, "agrees with it", "agree with it");
    add(low, "is too low", "are too low");
    add(high, "is too high", "are too high");
    return text + ".";
}

/// The velocity to report, or the bounds that the impacts give instead.
struct Answer {
    std::string before;    ///< what it is a velocity of
    std::string velocity;  ///< "1.86 m/s"
    std::string after;     ///< "(95 %: 1.60 to 2.16 m/s), by Maugis-Dugdale, ..."
};

std::string reason_in(const Json& reported) {
    return reported.value("reason", std::string());
}

/// @param reported of a sample in comparison.json
std::optional<Answer> answer_of(const Json& reported) {
    const Json nothing;
    const Json& interval = reported.contains("interval") ? reported.at("interval") : nothing;
    const auto lower = number_in(interval, "lower");
    const auto upper = number_in(interval, "upper");
    if (const auto velocity = number_in(reported, "critical_velocity")) {
        const bool modelled = reported.contains("law") && reported.at("law").is_string();
        const std::string by =
            modelled ? ", by " + display_name(reported.at("law").get<std::string>()) : std::string();
        return Answer{"a particle sticks when it is slower than", fmt::format("{:#.3g} m/s", *velocity),
                      (lower || upper ? fmt::format(" (95 %: {} m/s)", interval_text(lower, upper)) : "") +
                          by + ": " + reason_in(reported) + "."};
    }
    if (lower)
        return Answer{"the critical velocity lies above", fmt::format("{:#.3g} m/s", *lower),
                      ": " + reason_in(reported) + "."};
    if (upper)
        return Answer{"the critical velocity lies below", fmt::format("{:#.3g} m/s", *upper),
                      ": " + reason_in(reported) + "."};
    return std::nullopt;
}

/// "By each law: Hertz 1.10 m/s, JKR ...", where the laws were computed at all.
std::string by_each_law(const SampleData& sample) {
    std::vector<std::string> laws;
    for (const LawData& law : sample.laws)
        if (law.velocity != nullptr) laws.push_back(fmt::format("{} {}", law.name, text_of(law.headline)));
    return laws.empty() ? "" : "By each law: " + listed(laws) + ".";
}

/// What was computed with: "Diameter 44 um, density 2300 kg/m3, E* 62.1 GPa, w 0.3 J/m2."
std::string inputs_sentence(const SampleData& sample) {
    constexpr std::pair<const char*, const char*> inputs[] = {{"diameter", "Diameter"},
                                                              {"density", "density"},
                                                              {"contact_modulus", "E*"},
                                                              {"work_of_adhesion", "w"}};
    std::vector<std::string> words;
    for (const auto& [key, word] : inputs)
        if (const auto value = number_in(sample.comparison, key))
            words.push_back(
                fmt::format("{} {}", word, readable(*value, sample.comparison.at(key).value("unit", "1"))));
    return words.empty() ? "" : listed(words) + ".";
}

/// What to take home of a sample: the velocity to report as the summary of the run names it, or why there is
/// none, then all laws.
std::string answer(const SampleData& sample) {
    const auto reported = sample.comparison.find("reported");
    const Json summary = reported == sample.comparison.end() ? Json::object() : *reported;
    const std::optional<Answer> found = answer_of(summary);
    const std::string first =
        found ? fmt::format("{} <span class=\"value\">{}</span>{}", escaped(found->before),
                            escaped(found->velocity), escaped(found->after))
              : "no critical velocity: " + escaped(reason_in(summary)) + ".";
    std::string html = fmt::format("<li><strong>{}</strong>: {}", html_name(sample.name), first);
    for (const std::string& rest : {by_each_law(sample), measured_sentence(sample), inputs_sentence(sample)})
        if (!rest.empty()) html += fmt::format("<span class=\"rest\">{}</span>", escaped(rest));
    return html + "</li>\n";
}

/// What a cell says where there is nothing to say.
constexpr std::string_view no_value = "–";

std::string text_or_dash(const std::optional<double>& value, double unit = 1) {
    return value ? fmt::format("{:.4g}", *value / unit) : std::string(no_value);
}

std::string verdict_words(const LawData& law) {
    const std::string verdict = verdict_of(law);
    if (verdict == "model-too-low") return "too low";
    if (verdict == "model-too-high") return "too high";
    return verdict == "agrees" ? verdict : std::string(no_value);
}

/// Whether the impacts gave no estimate with this law, so that its velocity is the extrapolation.
bool is_extrapolated(const LawData& law) {
    return extrapolated_velocity(law) && law.headline.method.starts_with("eta(e) extra");
}

std::string velocity_cell(const LawData& law) {
    if (law.headline.value)
        return fmt::format("{}{:#.3g}", is_extrapolated(law) ? "* " : "", *law.headline.value);
    return law.velocity != nullptr ? escaped(name_of(law.velocity->verdict)) : std::string(no_value);
}

std::string extrapolated_cell(const LawData& law) {
    const auto velocity = extrapolated_velocity(law);
    return velocity ? fmt::format("{:#.3g}", *velocity) : std::string(no_value);
}

std::string interval_cell(const LawData& law) {
    if (!law.headline.value || !law.headline.with_interval) return std::string(no_value);
    return interval_text(law.headline.lower, law.headline.upper);
}

/// The measured velocity, and its 95 % interval below where it has one.
std::string measured_cell(const SampleData& sample) {
    const auto measured = number_in(sample.measured, "critical_velocity");
    if (!measured) return std::string(no_value);
    std::string velocity = fmt::format("{:#.3g}", *measured);
    const std::string ends = measured_interval(sample);
    return ends.empty() ? velocity : fmt::format("{}<br>({})", velocity, ends);
}

struct Column {
    std::string_view head;
    std::string (*cell)(const SampleData&, const LawData&);
    bool text = false;
    bool of_sample = false;  ///< One cell over all laws of the sample.
    bool always = true;      ///< False: left out where no law has a value in it.
};

constexpr Column columns[] = {
    {.head = "E [GPa]",
     .cell = [](const SampleData& sample,
                const LawData&) { return text_or_dash(number_in(sample.modulus, "young_modulus"), 1e9); },
     .of_sample = true},
    {.head = "E* [GPa]",
     .cell = [](const SampleData& sample,
                const LawData&) { return text_or_dash(sample.contact->pair.contact_modulus, 1e9); },
     .of_sample = true},
    {.head = "W<sub>s</sub> [fJ]",
     .cell = [](const SampleData& sample,
                const LawData&) { return text_or_dash(sample.analytic->separation_energy, 1e-15); },
     .of_sample = true},
    {.head = "v<sub>c</sub>, Eq. 30 [m/s]",
     .cell = [](const SampleData& sample,
                const LawData&) { return text_or_dash(sample.analytic->critical_velocity); },
     .of_sample = true},
    {.head = "law",
     .cell = [](const SampleData&, const LawData& law) { return escaped(law.name); },
     .text = true},
    {.head = "dynamic v<sub>c</sub> [m/s]",
     .cell = [](const SampleData&, const LawData& law) { return velocity_cell(law); }},
    {.head = "95 % interval",
     .cell = [](const SampleData&, const LawData& law) { return interval_cell(law); }},
    {.head = "extrapolated v<sub>c</sub> [m/s]",
     .cell = [](const SampleData&, const LawData& law) { return extrapolated_cell(law); },
     .always = false},
    {.head = "published",
     .cell =
         [](const SampleData& sample, const LawData& law) {
             const auto& published = sample.sample->published;
             const Quantity* printed =
                 published ? published->critical_velocity.find(law.choice.law) : nullptr;
             return text_or_dash(printed != nullptr ? std::optional(printed->value) : std::nullopt);
         },
     .always = false},
    {.head = "measured (95&nbsp;%)",
     .cell = [](const SampleData& sample, const LawData&) { return measured_cell(sample); },
     .of_sample = true,
     .always = false},
    {.head = "verdict",
     .cell = [](const SampleData&, const LawData& law) { return verdict_words(law); },
     .text = true,
     .always = false},
};

/// The columns that say something of this run.
std::vector<Column> columns_of(const RunData& run) {
    std::vector<Column> shown;
    for (const Column& column : columns) {
        const auto has_value = [&](const SampleData& sample) {
            return std::ranges::any_of(
                sample.laws, [&](const LawData& law) { return column.cell(sample, law) != no_value; });
        };
        if (column.always || std::ranges::any_of(run.samples(), has_value)) shown.push_back(column);
    }
    return shown;
}

/// What tells the extrapolated velocities from the dynamic ones, below the table.
std::string extrapolation_notes(const RunData& run) {
    bool any = false;
    bool instead = false;
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws) {
            any = any || extrapolated_velocity(law);
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
    const std::vector<Column> shown = columns_of(run);
    std::string html = fmt::format(
        "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\"><table><thead><tr><th "
        "scope=\"col\">sample</th>",
        region_label("Critical velocities", run));
    for (const Column& column : shown)
        html += fmt::format("<th scope=\"col\"{}>{}</th>", column.text ? " class=\"text\"" : "", column.head);
    html += "</tr></thead><tbody>\n";
    for (const SampleData& sample : run.samples()) {
        bool first = true;
        for (const LawData& law : sample.laws) {
            html += first ? fmt::format("<tr class=\"first\"><th scope=\"rowgroup\" rowspan=\"{}\">{}</th>",
                                        sample.laws.size(), html_name(sample.name))
                          : "<tr>";
            for (const Column& column : shown)
                if (first || !column.of_sample)
                    html += fmt::format(
                        "<td{}{}>{}</td>", column.text ? " class=\"text\"" : "",
                        column.of_sample ? fmt::format(" rowspan=\"{}\"", sample.laws.size()) : "",
                        column.cell(sample, law));
            html += "</tr>\n";
            first = false;
        }
    }
    html += "</tbody></table></div>\n";
    html += extrapolation_notes(run);
    for (const SampleData& sample : run.samples())
        for (const LawData& law : sample.laws)
            if (law.velocity != nullptr && !law.velocity->interval_note.empty())
                html += fmt::format("<p class=\"where\">{}, {}: {}.</p>\n", html_name(sample.name),
                                    escaped(law.name), escaped(law.velocity->interval_note));
    return html;
}

}  // namespace ashimpact::report
