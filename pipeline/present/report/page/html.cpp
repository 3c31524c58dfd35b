// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/page/html.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/text/utf8.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/sha256.hpp"
#include "pipeline/present/report/drawing/markup.hpp"

namespace ashimpact::report {

namespace {

constexpr std::string_view generator = "<meta name=\"generator\" content=\"ashimpact\">";

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

}  // namespace

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

std::string html_contents(const std::vector<std::string_view>& figures) {
    std::string html = "<nav aria-label=\"Figures\">";
    for (const std::string_view id : figures) {
        std::string words(id);
        std::ranges::replace(words, '-', ' ');
        words.front() = static_cast<char>(words.front() - 'a' + 'A');
        html += fmt::format("<a href=\"#{}\">{}</a>", id, words);
    }
    return html + "<a href=\"#provenance\">Provenance</a></nav>\n";
}

std::string html_sketch() {
    std::string html = embedded("report/sketch.html");
    std::erase(html, '\n');
    return html + "\n";
}

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

std::string html_of(const Figure& figure, const std::string& id) {
    std::string html = fmt::format(
        "<figure id=\"{0}\"><h3>{1}<a class=\"anchor\" href=\"#{0}\" aria-label=\"Link to {1}\">#</a></h3>",
        id, escaped(figure.title));
    if (!figure.panels.empty())
        html += fmt::format(
            "<div class=\"plot\" role=\"group\" aria-label=\"{}, readout with the arrow keys\">{}{}</div>"
            "<output class=\"readout\"></output>",
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
           read_start(file, head).find(generator) != std::string::npos;
}

std::string html_page(const std::string& title, const std::string& body) {
    const std::string style = embedded("report/page.css") + page_drawing_style();
    const std::string script = embedded("report/readout.js");
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "{}; script-src {}; base-uri 'none'; "
        "form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n{}\n<title>{}</title>\n<link rel=\"icon\" "
        "href=\"data:,\">\n<style>{}</style>\n</head>\n<body>\n"
        "<svg width=\"0\" height=\"0\" aria-hidden=\"true\" focusable=\"false\" "
        "class=\"defs\"><defs>{}</defs></svg>\n{}"
        "<script>{}</script>\n</body>\n</html>\n",
        policy_hash(style), policy_hash(script), generator, escaped(title), style, marker_definitions(), body,
        script);
}

}  // namespace ashimpact::report
