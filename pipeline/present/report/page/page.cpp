// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/page/page.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/batch/parallel.hpp"

namespace ashimpact::report {

namespace {

std::string embedded(std::string_view path) {
    const auto content = embedded_file(path);
    if (!content) throw std::logic_error("not embedded: " + std::string(path));
    return std::string(*content);
}

/// The hash by which a content security policy lets one inline style or script through.
std::string policy_hash(const std::string& text) {
    const std::string hexadecimal = sha256(text);
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(bytes) + "'";
}

/// @param in_text whether the whole column is text; the class of the table has that
std::string cell_html(const Cell& cell, bool head, bool in_text) {
    if (const auto* number = std::get_if<double>(&cell))
        return "<td>" + (std::isfinite(*number) ? fmt::format("{:.5g}", *number) : std::string());
    const std::string text = html_name(std::get<std::string>(cell));
    return (head ? "<th scope=row>" : in_text ? "<td>" : "<td class=text>") + text;
}

/// Number of columns from the left that hold text only, at most those with a class in page.css.
std::size_t text_columns(const NumberTable& table) {
    std::size_t count = std::min<std::size_t>(3, table.columns.size());
    for (const auto& row : table.rows)
        for (std::size_t i = 0; i < count; ++i)
            if (!std::holds_alternative<std::string>(row[i])) count = i;
    return count;
}

/// A table that scrolls within the page; numbers with five significant digits.
std::string html_table(const NumberTable& table, const std::string& label) {
    const std::size_t texts = text_columns(table);
    std::string html =
        fmt::format("<table{}><thead><tr>", texts > 1 ? fmt::format(" class=\"text{}\"", texts) : "");
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool text = !table.rows.empty() && std::holds_alternative<std::string>(table.rows.front()[i]);
        html += fmt::format("<th scope=\"col\"{}>{}</th>", text ? " class=\"text\"" : "",
                            escaped(table.columns[i]));
    }
    html += "</tr></thead><tbody>";
    for (std::size_t r = 0; r < table.rows.size(); r += static_cast<std::size_t>(table.shown_every)) {
        html += "<tr>";  // the ends of rows and cells are left out, as HTML allows
        for (std::size_t i = 0; i < table.rows[r].size(); ++i)
            html += cell_html(table.rows[r][i], i == 0, i < texts);
    }
    return html_scroll(escaped(label), html + "</tbody></table>", "scroll tall");
}

std::string heading(const std::vector<RunData>& runs) {
    std::string html = "<header>\n";
    if (runs.size() == 1) {
        html += fmt::format(
            "<h1>{}</h1>\n<p class=\"kind\">From the XRD result to the critical velocity of impact. Report "
            "of an ashimpact run.</p>\n",
            html_name(runs.front().data().name));
        return html + answers_html(runs.front()) +
               fmt::format("<p class=\"where\">{}</p>\n", escaped(scope_sentence(runs.front().data()))) +
               "</header>\n";
    }
    html += fmt::format(
        "<h1>{} runs side by side</h1>\n<p class=\"kind\">What differs between their inputs comes first, "
        "then the answers, then each figure for one run after the other.</p>\n</header>\n",
        runs.size());
    return html;
}

/// A quantity, number or word as a reader takes it in.
std::string shown(const Json& value) {
    if (value.is_object() && value.contains("value") && value.at("value").is_number())
        return readable(value.at("value").get<double>(), value.value("unit", "1"));
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return shortest(value.get<double>());
    const std::string text = value.dump();
    return text.size() > 60 ? fmt::format("{} values", value.size()) : text;
}

/// The values of a list from a place on, and how many it has where not all are shown.
std::string listed(const Json& list, std::size_t from) {
    std::string text;
    for (std::size_t i = from; i < list.size() && text.size() <= 50; ++i)
        text += (i == 0 ? "" : i == from ? "…, " : ", ") + shown(list[i]);
    const bool whole = from == 0 && text.size() <= 50;
    return list.empty() ? "none" : whole ? text : text + fmt::format(" … ({} values)", list.size());
}

/// The beginning of a long text, whole characters.
std::string shortened(const std::string& text) {
    if (text.size() <= 200) return text;
    return std::string(whole_start(text, 180)) + "…";
}

/// The values of one input as a reader takes them in: lists from where they differ, numbers with all digits
/// where they are the same rounded.
std::vector<std::string> shown_beside(const std::vector<Json>& values) {
    const Json& first = values.front();
    std::size_t same = 0;  // entries at the begin of lists
    const auto begins_alike = [&](const Json& value) {
        return same < value.size() && value[same] == first[same];
    };
    if (std::ranges::all_of(values, &Json::is_array))
        while (std::ranges::all_of(values, begins_alike)) ++same;
    std::vector<std::string> texts;
    for (const Json& value : values)
        texts.push_back(value.is_null()    ? "–"
                        : value.is_array() ? listed(value, std::min(same, value.size()))
                                           : shown(value));
    if (std::ranges::count(texts, texts.front()) == std::ssize(texts))
        std::transform(values.begin(), values.end(), texts.begin(),
                       [](const Json& value) { return value.dump(); });
    return texts;
}

/// An input by its path; entries of lists with names go by these.
using Inputs = std::vector<std::pair<std::string, Json>>;

void flatten(const Json& node, const std::string& path, Inputs& into) {
    const bool quantity = node.is_object() && node.contains("value");
    if (node.is_object() && !quantity) {
        for (const auto& [key, value] : node.items())
            if (key != "name") flatten(value, path.empty() ? key : fmt::format("{}, {}", path, key), into);
        return;
    }
    const bool named =
        node.is_array() && !node.empty() && node.front().is_object() && node.front().contains("name");
    const bool structured = node.is_array() && !node.empty() && node.front().is_structured();
    if (!named && !structured) {
        into.emplace_back(path, node);
        return;
    }
    for (std::size_t i = 0; i < node.size(); ++i)
        flatten(node[i], path + ", " + (named ? node[i].value("name", "?") : std::to_string(i + 1)), into);
}

Json value_at(const Inputs& inputs, const std::string& path) {
    for (const auto& [key, value] : inputs)
        if (key == path) return value;
    return nullptr;
}

/// Artifacts that were edited in one of the runs: their values are inputs, as the case is.
std::vector<std::string> edited_artifacts(const std::vector<RunData>& runs) {
    std::vector<std::string> files;
    for (const RunData& run : runs)
        for (const StageRecord& record : run.run().records)
            if (record.edited && record.file != case_artifact && std::ranges::count(files, record.file) == 0)
                files.push_back(record.file);
    std::ranges::sort(files);
    return files;
}

/// Where the inputs of several runs differ.
std::string differences_html(const std::vector<RunData>& runs) {
    std::vector<Inputs> all;
    std::vector<std::string> paths;
    const auto edited = edited_artifacts(runs);
    for (const RunData& run : runs) {
        Inputs inputs;
        flatten(case_json(run.data()), "", inputs);
        for (const std::string& file : edited) flatten(result_json(run.run(), file), file, inputs);
        for (const auto& [path, value] : inputs)
            if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
        all.push_back(std::move(inputs));
    }
    NumberTable table{.columns = {"input"}};
    for (const RunData& run : runs) table.columns.push_back(run.label());
    for (const std::string& path : paths) {
        std::vector<Json> values;
        for (const Inputs& inputs : all) values.push_back(value_at(inputs, path));
        if (std::ranges::count(values, values.front()) == std::ssize(values)) continue;
        std::vector<Cell> row{path};
        for (const std::string& text : shown_beside(values)) row.emplace_back(shortened(text));
        table.rows.push_back(std::move(row));
    }
    constexpr std::string_view title = "What differs between the inputs";
    return html_section("differences", title,
                        table.rows.empty() ? "<p>Nothing: the runs have the same inputs.</p>"
                                           : html_table(table, std::string(title)));
}

std::string per_run(const std::vector<RunData>& runs, const std::string& title, const std::string& id,
                    std::string (*part)(const RunData&)) {
    std::string html;
    for (const RunData& run : runs) {
        if (runs.size() > 1) html += fmt::format("<h3>{}</h3>\n", html_name(run.label()));
        html += part(run);
    }
    return html_section(id, title, html);
}

std::string figures_html(const std::vector<RunData>& runs) {
    std::string html = embedded("report/sketch.html");  // in place of the paper's Figures 1 and 2
    std::erase(html, '\n');
    html += '\n';
    std::vector<std::pair<const FigureMaker*, std::size_t>> wanted;
    for (const FigureMaker& maker : figure_makers())
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (maker.is_on_page(runs[i])) wanted.emplace_back(&maker, i);
    const auto drawn = in_parallel(wanted, [&](const auto& each) {
        const auto& [maker, i] = each;
        Figure figure = maker->make(runs[i]);
        if (runs.size() > 1) figure.title += " (" + runs[i].label() + ")";
        return html_of(figure, std::string(maker->id) + (i == 0 ? "" : fmt::format("-{}", i + 1)));
    });
    for (const std::string& figure : drawn) html += figure;
    return html_section("figures", "Figures", html);
}

std::string file_stem(std::string_view id, Width width) {
    return std::string(id) + (width == Width::narrow ? "-single" : "");
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
    std::vector<std::string_view> ids;
    for (const FigureMaker& maker : figure_makers())
        if (std::ranges::any_of(runs, maker.is_on_page)) ids.push_back(maker.id);
    body += html_contents(ids);
    body += per_run(runs, "Critical velocities", "comparison", comparison_html);
    body += figures_html(runs);
    body += per_run(runs, "What was assumed, inferred or reconstructed", "assumptions", assumptions_html);
    body += per_run(runs, "What the model holds for", "validity", validity_html);
    body += per_run(runs, "Warnings", "warnings", warnings_html);
    body += per_run(runs, "Provenance", "provenance", provenance_html);
    body += "</main>\n<footer><p>Made by ashimpact " + escaped(program_version()) +
            ". Curves are read off with the mouse, by touch or with the arrow keys; without scripts "
            "everything else stays.</p></footer>\n";
    const std::string title =
        runs.size() == 1 ? runs.front().data().name : fmt::format("{} runs of ashimpact", runs.size());
    return html_page(title, body);
}

const std::vector<std::string_view>& report_artifacts() {
    static const std::vector<std::string_view> files = [] {
        std::vector<std::string_view> all{case_artifact};
        for (const Stage& stage : stages()) all.push_back(stage.file);
        return all;
    }();
    return files;
}

std::vector<FileContent> figure_files(const RunData& run, const std::filesystem::path& folder) {
    std::vector<FileContent> files;
    for (const FigureMaker& maker : figure_makers()) {
        const Figure figure = maker.make(run);
        if (figure.panels.empty()) continue;
        for (const Width width : {Width::wide, Width::narrow})
            for (const FigureFormat format : {FigureFormat::svg, FigureFormat::pdf}) {
                const std::string name =
                    file_stem(figure.id, width) + (format == FigureFormat::svg ? ".svg" : ".pdf");
                files.push_back({folder / figures_folder / name, figure_bytes(figure, width, format)});
            }
    }
    return files;
}

std::vector<std::filesystem::path> own_figures(const std::filesystem::path& figures) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const FigureMaker& maker : figure_makers())
        for (const Width width : {Width::wide, Width::narrow}) {
            const auto svg = figures / (file_stem(maker.id, width) + ".svg");
            if (!std::filesystem::is_regular_file(svg, ignored) || !is_own_svg(read_file(svg))) continue;
            files.push_back(svg);
            const auto pdf = std::filesystem::path(svg).replace_extension(".pdf");
            if (std::filesystem::is_regular_file(pdf, ignored)) files.push_back(pdf);
        }
    return files;
}

std::string with_subscripts(std::string text) {
    for (const std::string_view symbol : {"v_in", "v_c", "v_r", "e_n", "W_s", "F_r", "F_a"})
        for (auto at = text.find(symbol); at != std::string::npos; at = text.find(symbol, at + 1)) {
            const auto end = at + symbol.size();
            const bool word = end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') ||
                                                    (text[end] >= '0' && text[end] <= '9'));
            if (word) continue;
            const std::string set = fmt::format("{}<sub>{}</sub>", symbol.front(), symbol.substr(2));
            text.replace(at, symbol.size(), set);
        }
    return text;
}

std::string capitalized(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

std::string words_of(std::string key) {
    std::ranges::replace(key, '_', ' ');
    return key;
}

std::string html_name(std::string_view name) {
    return is_ascii(name) ? escaped(name) : "<bdi>" + escaped(name) + "</bdi>";
}

std::string html_scroll(const std::string& label, const std::string& content, std::string_view look) {
    return fmt::format("<div class=\"{}\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">{}</div>", look,
                       label, content);
}

std::string html_section(std::string_view id, std::string_view title, const std::string& content) {
    return fmt::format("<section><h2 id=\"{}\">{}</h2>\n{}</section>\n", id, title, content);
}

std::string html_notes(const std::vector<std::string>& notes) {
    std::string html = "<ul class=\"notes\">\n";
    for (const std::string& note : notes) html += "<li>" + note + "</li>\n";
    return html + "</ul>";
}

std::vector<std::string> escaped_texts(const Json& list) {
    std::vector<std::string> texts;
    for (const Json& text : list) texts.push_back(escaped(text.get<std::string>()));
    return texts;
}

std::string html_provenance(const Json& artifact) {
    const Json& from = artifact.at("provenance");
    std::string html = fmt::format("<p>{} {}, revision <span class=\"hash\">{}</span>.</p>\n",
                                   escaped(from.value("program", "")), escaped(from.value("version", "")),
                                   escaped(from.value("revision", "")));
    for (const Json& input : from.at("inputs"))
        html += fmt::format("<p>{} <span class=\"hash\">{}</span></p>\n", html_name(input.value("file", "")),
                            escaped(input.value("sha256", "")));
    html += "<details open><summary>What was asked for</summary>" +
            html_scroll("What was asked for", "<pre>" + escaped(write_json(from.at("options"))) + "</pre>",
                        "scroll tall") +
            "</details>\n" + html_notes(escaped_texts(artifact.at("citations")));
    return html_section("provenance", "Provenance", html);
}

std::string html_contents(const std::vector<std::string_view>& figures) {
    std::string html = "<nav aria-label=\"Figures\">";
    for (const std::string_view id : figures) {
        std::string words(id);
        std::ranges::replace(words, '-', ' ');
        html += fmt::format("<a href=\"#{}\">{}</a>", id, capitalized(words));
    }
    return html + "<a href=\"#provenance\">Provenance</a></nav>\n";
}

std::string html_of(const Figure& figure, const std::string& id) {
    std::string html = fmt::format(
        "<figure id=\"{0}\"><h3>{1}<a class=\"anchor\" href=\"#{0}\" aria-label=\"Link to {1}\">#</a></h3>",
        id, escaped(figure.title));
    if (!figure.panels.empty())
        html += fmt::format(
            "<div class=\"plot\" role=\"group\" aria-label=\"{}, readout with the arrow "
            "keys\">{}{}</div><output class=\"readout\"></output>",
            escaped(figure.title), svg_of(figure, Width::wide), svg_of(figure, Width::narrow));
    html += "<figcaption>" + with_subscripts(escaped(figure.caption));
    if (!figure.counterpart.empty())
        html +=
            " <span class=\"counterpart\">In Dong et al. 2013: " + escaped(figure.counterpart) + ".</span>";
    html += "</figcaption>";
    if (figure.numbers.rows.empty()) return html + "</figure>\n";
    const int every = figure.numbers.shown_every;
    html += fmt::format(
        "<details><summary>The numbers</summary><p><a download=\"{0}.csv\" "
        "href=\"data:text/csv;charset=utf-8,{1}\">{0}.csv</a>, SI, seven digits{2}</p>{3}</details>",
        id, percent_encoded(csv_of(figure.numbers)),
        every > 1 ? fmt::format("; the table has every {}th row of it", every) : "",
        html_table(figure.numbers, "The numbers of: " + figure.title));
    return html + "</figure>\n";
}

bool is_own_page(const std::filesystem::path& file) {
    constexpr std::size_t head = 4096;
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) &&
           read_start(file, head).find(own_page_mark) != std::string::npos;
}

std::string html_page(const std::string& title, const std::string& body) {
    const std::string style = embedded("report/page.css") + page_drawing_style();
    const std::string script = embedded("report/readout.js");
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "{}; script-src {}; base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n{}\n<title>{}</title>\n<link rel=\"icon\" "
        "href=\"data:,\">\n<style>{}</style>\n</head>\n<body>\n"
        "<svg width=\"0\" height=\"0\" aria-hidden=\"true\" focusable=\"false\" "
        "class=\"defs\"><defs>{}</defs></svg>\n{}<script>{}</script>\n</body>\n</html>\n",
        policy_hash(style), policy_hash(script), own_page_mark, escaped(title), style, marker_definitions(),
        body, script);
}

}  // namespace ashimpact::report
