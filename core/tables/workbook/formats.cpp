// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/tables/workbook/archive.hpp"
#include "core/tables/workbook/number_format.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Refuses sheets that hold more text together than one may. @throws InputError
void require_bytes(const std::vector<Sheet>& sheets) {
    std::size_t bytes = 0;
    for (const Sheet& sheet : sheets) bytes += sheet.bytes();
    if (bytes > Sheet::most_bytes) throw sheets.back().too_large();
}

/// A part of a spreadsheet as XML. @throws InputError if it is not well formed
pugi::xml_document parse_part(const std::string& content, const std::string& name) {
    pugi::xml_document document;
    const auto status = document.load_buffer(
        content.data(), content.size(), pugi::parse_default | pugi::parse_ws_pcdata, pugi::encoding_auto);
    if (!status)
        throw InputError("the part " + name + " of the spreadsheet is damaged: " + status.description(),
                         undamaged);
    return document;
}

/// The name of an element or attribute without its prefix, which each writer chooses for itself.
std::string_view local_name(const char* name) {
    const std::string_view whole(name);
    return whole.substr(whole.find(':') == std::string_view::npos ? 0 : whole.find(':') + 1);
}

/// First child of that local name, or a null node.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& child : node)
        if (local_name(child.name()) == name) return child;
    return {};
}

/// Value of the attribute of that local name, or nothing.
std::optional<std::string> attribute_of(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_attribute& attribute : node.attributes())
        if (local_name(attribute.name()) == name) return attribute.value();
    return std::nullopt;
}

/// A number as a spreadsheet shows it: 15 significant digits at most, which hides that 0.1 is binary. One
/// with three decimals gets a fourth, or its point might be taken for one that groups digits.
std::string shown_number(double value) {
    std::string text = fmt::format("{:.15g}", value);
    const auto point = text.find('.');
    const bool may_group = point != std::string::npos && text.size() - point == 4 && std::abs(value) >= 1;
    if (may_group && text.find('e') == std::string::npos) text += '0';
    return text;
}

/// The same for a cell in the format of per cent: "21.3 %" for 0.213.
std::string shown_per_cent(double fraction) {
    return shown_number(100 * fraction) + " %";
}

/// A number between the texts that its cell shows around it.
std::string beside(std::string_view prefix, std::string number, std::string_view suffix) {
    number.insert(0, trimmed(prefix));
    if (!trimmed(suffix).empty()) number += ' ' + std::string(trimmed(suffix));
    return number;
}

/// Dates and formulas without a result are no numbers; these texts show up in messages about the cell.
std::string shown_date(std::string_view date) {
    return std::string(date) + " (a date)";
}

std::string shown_formula(std::string_view formula) {
    return '=' + std::string(formula) + " (a formula, saved without its result)";
}

std::string shown_in_thousands(double value) {
    return shown_number(value) + " (shown as " + shown_number(value / 1000) + " by its number format)";
}

/// Marks a text that the spreadsheet shows struck out, so that it is neither a number nor a name.
std::string struck_out(std::string text) {
    return text.empty() ? text : std::move(text) + " (struck out)";
}

/// Where a part of a text stands, which the spreadsheet may shift up or down.
enum class Shift { none, raised, lowered };

/// A part of a text, a shifted one with the digits of its place: "753" with a raised 1, as of a footnote, is
/// not 7531.
std::string shown_shifted(std::string_view part, Shift shift) {
    std::string text;
    constexpr std::array<std::string_view, 10> superscripts{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                            "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    constexpr std::array<std::string_view, 10> subscripts{"\u2080", "\u2081", "\u2082", "\u2083", "\u2084",
                                                          "\u2085", "\u2086", "\u2087", "\u2088", "\u2089"};
    for (const char c : part) {
        if (shift == Shift::raised && !is_digit(c)) text += '^';
        if (shift == Shift::none || !is_digit(c))
            text += c;
        else
            text +=
                (shift == Shift::raised ? superscripts : subscripts).at(static_cast<std::size_t>(c - '0'));
    }
    return text;
}

/// Number of repetitions of an element, at most the size of a sheet.
std::size_t repeats(const pugi::xml_node& node, std::string_view attribute) {
    const std::string text = attribute_of(node, attribute).value_or("1");
    std::size_t count = 1;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (status == std::errc::result_out_of_range) return Sheet::most_rows;
    return status == std::errc{} ? std::min(count, Sheet::most_rows) : 1;
}

/// The shift that an .ods writes "super 58%" or "33% 58%", down "sub 58%" or "-33% 58%".
Shift shift_of_position(std::string_view position) {
    if (position.starts_with("sub") || position.starts_with('-')) return Shift::lowered;
    const bool raised = position.starts_with("super") || position.find_first_of("123456789") == 0;
    return raised ? Shift::raised : Shift::none;
}

/// What a style of an .ods sets; what it leaves open is that of its parent.
struct TextStyle {
    std::string parent{};
    std::optional<bool> struck{};
    std::optional<Shift> shift{};
    std::optional<bool> hidden{};                ///< of a sheet
    std::optional<std::string> number_format{};  ///< name of the one of a cell
    std::optional<bool> in_thousands{};          ///< of a number format: whether it divides what it shows
};

TextStyle text_style(const pugi::xml_node& node) {
    TextStyle style{.parent = attribute_of(node, "parent-style-name").value_or(""),
                    .number_format = attribute_of(node, "data-style-name")};
    if (const auto factor = attribute_of(child_of(node, "number"), "display-factor"))
        style.in_thousands = factor != "1";
    if (const auto display = attribute_of(child_of(node, "table-properties"), "display"))
        style.hidden = display == "false";
    const pugi::xml_node text = child_of(node, "text-properties");
    const auto line = attribute_of(text, "text-line-through-style");
    const auto type = attribute_of(text, "text-line-through-type");
    if (line || type) style.struck = line != "none" && type != "none";
    if (const auto position = attribute_of(text, "text-position")) style.shift = shift_of_position(*position);
    return style;
}

/// The styles of an .ods. Each family, such as that of cells, has names of its own; number formats have none.
class TextStyles {
  public:
    /// Adds styles, over those of the same name.
    void add(const pugi::xml_node& styles) {
        for (const pugi::xml_node& node : styles)
            styles_[{attribute_of(node, "family").value_or(""), attribute_of(node, "name").value_or("")}] =
                text_style(node);
    }
    [[nodiscard]] bool strikes_cell(const std::string& style) const {
        return setting(&TextStyle::struck, "table-cell", style).value_or(false);
    }
    [[nodiscard]] bool divides_cell(const std::string& style) const {
        const auto format = setting(&TextStyle::number_format, "table-cell", style);
        return format && setting(&TextStyle::in_thousands, "", *format).value_or(false);
    }
    [[nodiscard]] bool strikes_span(const std::string& style) const {
        return setting(&TextStyle::struck, "text", style).value_or(false);
    }
    [[nodiscard]] Shift shift_of_span(const std::string& style) const {
        return setting(&TextStyle::shift, "text", style).value_or(Shift::none);
    }
    [[nodiscard]] bool hides_sheet(const std::string& style) const {
        return setting(&TextStyle::hidden, "table", style).value_or(false);
    }

  private:
    /// What the style sets, or the nearest of its parents; the last is the family's default, without a name.
    template <class Value>
    [[nodiscard]] std::optional<Value> setting(std::optional<Value> TextStyle::*what,
                                               const std::string& family, std::string style) const {
        constexpr int deepest = 50;  // a damaged file may have a circle of parents
        for (int depth = 0; depth < deepest; ++depth) {
            const auto found = styles_.find({family, style});
            if (found != styles_.end() && found->second.*what) return found->second.*what;
            if (style.empty()) break;
            style = found == styles_.end() ? "" : found->second.parent;
        }
        return std::nullopt;
    }

    std::map<std::pair<std::string, std::string>, TextStyle> styles_;  ///< by family and name
};

/// The name of the style that a node states, or an empty one.
std::string style_of(const pugi::xml_node& node) {
    return attribute_of(node, "style-name").value_or("");
}

/// Appends the text of a paragraph, of spans and links too, but not of comments on the cell.
void append_text(const pugi::xml_node& node, const TextStyles& styles, std::string& text, int depth = 0) {
    constexpr int deepest = 50;
    if (depth > deepest) throw InputError("the text of a cell is nested too deeply", undamaged);
    for (const pugi::xml_node& inner : node) {
        if (inner.type() == pugi::node_pcdata || inner.type() == pugi::node_cdata) text += inner.value();
        const auto name = local_name(inner.name());
        if (name == "s" || name == "tab" || name == "line-break") text += ' ';
        if (name != "span" && name != "a") continue;
        std::string part;
        append_text(inner, styles, part, depth + 1);
        part = shown_shifted(part, styles.shift_of_span(style_of(inner)));
        text += styles.strikes_span(style_of(inner)) ? struck_out(part) : part;
    }
}

std::string text_of_paragraphs(const pugi::xml_node& cell, const TextStyles& styles) {
    std::string text;
    for (const pugi::xml_node& node : cell) {
        if (local_name(node.name()) != "p") continue;
        if (!text.empty()) text += ' ';
        append_text(node, styles, text);
    }
    return text;
}

/// Adds the texts that an .ods shows outside its cells, in shapes and text boxes of a sheet.
void take_shapes(const pugi::xml_node& table, const TextStyles& styles, Sheet& sheet) {
    for (const pugi::xpath_node& shape :
         table.select_nodes(".//*[starts-with(name(),'draw:')][*[local-name()='p']]"))
        sheet.comment("a text box", text_of_paragraphs(shape.node(), styles));
}

/// Adds the headers and footers of the pages of an .ods, except those with a page number.
void take_page_texts(const pugi::xml_node& styles_root, const TextStyles& styles,
                     std::vector<Sheet>& sheets) {
    for (const pugi::xpath_node& page :
         styles_root.select_nodes("*[local-name()='master-styles']//*[*[local-name()='p']"
                                  "[not(*[local-name()='page-number'])]]")) {
        const std::string text = text_of_paragraphs(page.node(), styles);
        if (std::ranges::any_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; }))
            for (Sheet& sheet : sheets) sheet.comment("the page", text);
    }
}

/// Whether digits with marks, as a cell shows them, are a number but for rounding: "1.234,5" is 1234.46, and
/// "12.3" is not 123, as a number format `0"."0` shows it. Exponents and fractions count as right.
bool shows(std::string digits, double value) {
    if (digits.find_first_of("eE/") != std::string::npos) return true;
    for (const std::string_view blank : {" ", "'", "\u00a0", "\u202f", "\u2009", "\u2019"})
        for (auto at = digits.find(blank); at != std::string::npos; at = digits.find(blank, at))
            digits.erase(at, blank.size());
    for (const std::string_view marks : {".,", ",.", "+.,"}) {  // the decimal mark and the other one; or none
        std::string plain;
        std::size_t decimals = 0;
        bool in_decimals = false;
        for (const char c : digits) {
            if (c == marks.front()) {
                plain += '.';
                in_decimals = true;
            } else if (is_digit(c)) {
                plain += c;
                decimals += in_decimals ? 1 : 0;
            } else if (marks.find(c) == std::string_view::npos) {
                return false;
            }
        }
        // Groups have three digits, in India also two.
        const auto group = digits.find_last_of(marks.substr(1));
        const std::size_t behind =
            group == std::string::npos ? 3 : digits.find_first_of(marks.front(), group);
        const bool grouped = group == std::string::npos || std::min(behind, digits.size()) - group - 1 == 3;
        const auto number = grouped ? whole_decimal(plain) : std::nullopt;
        const double last = std::pow(10.0, -static_cast<double>(decimals));
        if (number && std::abs(*number - std::abs(value)) <= 0.501 * last + 1e-12 * std::abs(value))
            return true;
    }
    return false;
}

/// The number of a cell with the texts around it in what the cell shows: "<0.10", "3.20 g/kg", "n.d.".
std::string as_shown(const std::string& shown, const std::string& number, double value) {
    constexpr std::string_view digits = "0123456789";
    const auto first = shown.find_first_of(digits);
    const auto last = shown.find_last_of(digits);
    if (first == std::string::npos) return has_meaning(shown) && !shown.ends_with('#') ? shown : number;
    const std::string prefix = shown.substr(0, first);
    std::string suffix = shown.substr(last + 1);
    if (number.ends_with('%') && suffix.find('%') != std::string::npos) suffix.clear();
    const std::string_view core = std::string_view(shown).substr(first, last + 1 - first);
    if (core.find_first_of("^(") != std::string::npos || core.find("\u00b1") != std::string::npos)
        return shown;
    if (!shows(std::string(core), value)) return number + " (shown as " + shown + ")";
    const bool has_sign = number.front() != '-' && prefix.find_first_of("-(") != std::string::npos;
    return beside(has_meaning(prefix) || has_sign ? prefix : "", number, has_meaning(suffix) ? suffix : "");
}

/// What a cell in this style holds, but for a line through it.
std::string ods_cell_value(const pugi::xml_node& cell, const std::string& style, const TextStyles& styles) {
    // LibreOffice adds a second attribute of that name with the value "error"; attribute_of() returns the
    // first.
    const std::string type = attribute_of(cell, "value-type").value_or("");
    const auto formula = attribute_of(cell, "formula");
    if (formula && type.empty()) {
        const auto start = formula->find('=');
        return shown_formula(formula->substr(start == std::string::npos ? 0 : start + 1));
    }
    if (type == "time") return attribute_of(cell, "time-value").value_or("") + " (a time)";
    if (type == "date") return shown_date(attribute_of(cell, "date-value").value_or("").substr(0, 10));
    if (type == "float" || type == "percentage" || type == "currency") {
        const auto number = whole_decimal(attribute_of(cell, "value").value_or(""));
        if (number && *number != 0 && styles.divides_cell(style)) return shown_in_thousands(*number);
        const std::string shown = text_of_paragraphs(cell, styles);
        if (number && shown.empty() && !cell.children().empty())
            return shown_number(*number) + " (hidden by its number format)";
        if (number && type == "percentage") return as_shown(shown, shown_per_cent(*number), 100 * *number);
        if (number) return as_shown(shown, shown_number(*number), *number);
    }
    return text_of_paragraphs(cell, styles);
}

std::string ods_cell_text(const pugi::xml_node& cell, const std::string& style, const TextStyles& styles) {
    std::string text = ods_cell_value(cell, style, styles);
    return styles.strikes_cell(style) ? struck_out(std::move(text)) : text;
}

/// Fills a sheet from the rows of an .ods, which may be grouped.
class OdsRows {
  public:
    OdsRows(Sheet& sheet, const TextStyles& styles) : sheet_(sheet), styles_(styles) {}

    void take_rows(const pugi::xml_node& parent, int depth = 0) {
        constexpr int deepest_group = 20;
        for (const pugi::xml_node& node : parent) {
            const auto name = local_name(node.name());
            if (name == "table-row") take_row(node);
            if (name == "table-column") take_column(node);
            const bool group = name == "table-row-group" || name == "table-header-rows" ||
                               name == "table-rows" || name == "table-column-group" ||
                               name == "table-header-columns" || name == "table-columns";
            if (group && depth == deepest_group)
                throw InputError("rows are grouped too deeply", "groups in at most 20 others");
            if (group) take_rows(node, depth + 1);
        }
    }

  private:
    void take_column(const pugi::xml_node& column) {
        const std::size_t copies = repeats(column, "number-columns-repeated");
        const auto visible = attribute_of(column, "visibility");
        if (visible == "collapse" || visible == "filter") sheet_.hide_columns(column_, copies);
        column_ += copies;
        cell_styles_[column_] = attribute_of(column, "default-cell-style-name").value_or("");
    }

    /// The style of a cell: its own, else that of its row, else that of its column.
    [[nodiscard]] std::string cell_style(const pugi::xml_node& row, const pugi::xml_node& cell,
                                         std::size_t column) const {
        if (auto own = attribute_of(cell, "style-name")) return *std::move(own);
        if (auto of_row = attribute_of(row, "default-cell-style-name")) return *std::move(of_row);
        const auto found = cell_styles_.upper_bound(column);
        return found == cell_styles_.end() ? "" : found->second;
    }

    /// Rows that are equal, such as two impacts captured at the same velocity, are stored once.
    void take_row(const pugi::xml_node& row) {
        std::vector<std::pair<std::size_t, std::string>> cells;
        std::vector<std::size_t> covered, spanning;
        std::size_t column = 0;
        for (const pugi::xml_node& cell : row) {
            const auto name = local_name(cell.name());
            if (name != "table-cell" && name != "covered-table-cell") continue;
            const std::size_t copies = repeats(cell, "number-columns-repeated");
            sheet_.see_formula(row_, column, attribute_of(cell, "formula").value_or(""));
            for (std::size_t i = 0; i < copies; ++i) {
                std::string text = ods_cell_text(cell, cell_style(row, cell, column + i), styles_);
                if (text.empty()) break;  // as it is in any style
                sheet_.require_column(row_, column + i);
                cells.emplace_back(column + i, std::move(text));
                if (name == "covered-table-cell") covered.push_back(column + i);
            }
            if (repeats(cell, "number-rows-spanned") > 1) spanning.push_back(column);
            if (const pugi::xml_node note = child_of(cell, "annotation"))
                sheet_.comment(cell_name(row_, column), text_of_paragraphs(note, styles_));
            column += copies;
        }
        const std::size_t times = repeats(row, "number-rows-repeated");
        const auto visible = attribute_of(row, "visibility");
        for (std::size_t i = 0; !cells.empty() && i < times; ++i) {
            for (const auto& [place, text] : cells) sheet_.put(row_ + i, place, text);
            if (visible == "collapse" || visible == "filter") sheet_.count_hidden_row();
        }
        for (const std::size_t place : covered) sheet_.cover(row_, place);
        for (const std::size_t place : spanning) sheet_.span_rows(row_, place);
        row_ += times;
    }

    Sheet& sheet_;
    const TextStyles& styles_;
    std::size_t row_ = 0;
    std::size_t column_ = 0;                          ///< of the next description of columns
    std::map<std::size_t, std::string> cell_styles_;  ///< of cells without one, by the column behind the last
};

/// The sheets of an .ods (OpenDocument 1.0 to 1.3); none if the archive is something else.
std::optional<std::vector<Sheet>> read_ods(Archive& archive) {
    constexpr auto name = "content.xml";
    const auto content = archive.read(name);
    if (!content) return std::nullopt;
    const pugi::xml_document document = parse_part(*content, name);
    const pugi::xml_node body = child_of(document.document_element(), "body");
    const pugi::xml_node tables = child_of(body, "spreadsheet");
    if (!tables) return std::nullopt;
    TextStyles styles;
    constexpr auto common = "styles.xml";  // the styles that have a name for the user
    pugi::xml_document named;
    if (const auto text = archive.read(common)) named = parse_part(*text, common);
    styles.add(child_of(named.document_element(), "styles"));
    styles.add(child_of(document.document_element(), "automatic-styles"));
    std::vector<Sheet> sheets;
    for (const pugi::xml_node& table : tables) {
        if (local_name(table.name()) != "table") continue;
        Sheet& sheet = sheets.emplace_back(attribute_of(table, "name").value_or(""));
        if (styles.hides_sheet(style_of(table))) sheet.hide();
        OdsRows(sheet, styles).take_rows(table);
        take_shapes(table, styles, sheet);
        require_bytes(sheets);
    }
    take_page_texts(named.document_element(), styles, sheets);
    return sheets;
}

/// What all sheets of a workbook share.
struct Shared {
    std::vector<std::string> strings{};
    std::vector<NumberFormat> formats{};  ///< by the cell's style
    std::vector<bool> struck{};           ///< whether it is struck out, by the cell's style
    bool since_1904 = false;              ///< the calendar of old Macintosh files
};

/// The whole text as an unsigned number.
std::optional<std::size_t> whole_number(std::string_view text) {
    std::size_t value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<std::string> part(Archive& archive, const std::string& name) {
    return name.empty() ? std::nullopt : archive.read(name);
}

/// "xl/worksheets/sheet1.xml" for a target in the relationships of "xl/workbook.xml", absolute or
/// relative.
std::string resolved(const std::string& of, std::string target) {
    std::replace(target.begin(), target.end(), '\\', '/');
    if (target.starts_with('/')) return target.substr(1);
    std::string folder = of.substr(0, of.find_last_of('/') + 1);
    while (target.starts_with("../") && !folder.empty()) {
        target.erase(0, 3);
        folder.pop_back();
        folder.erase(folder.find_last_of('/') + 1);
    }
    return folder + target;
}

struct Relationship {
    std::string type;  ///< last word of the address that names it
    std::string target;
};

/// The relationships of a part, by their identity; of the whole archive where `of` is empty.
std::map<std::string, Relationship> relationships(Archive& archive, const std::string& of) {
    const std::size_t file = of.find_last_of('/') + 1;
    const std::string name = of.substr(0, file) + "_rels/" + of.substr(file) + ".rels";
    std::map<std::string, Relationship> found;
    const auto content = archive.read(name);
    if (!content) return found;
    const pugi::xml_document document = parse_part(*content, name);
    for (const pugi::xml_node& node : document.document_element()) {
        const std::string type = attribute_of(node, "Type").value_or("");
        found[attribute_of(node, "Id").value_or("")] = {
            .type = type.substr(type.find_last_of('/') + 1),
            .target = resolved(of, attribute_of(node, "Target").value_or(""))};
    }
    return found;
}

std::string target_of_type(const std::map<std::string, Relationship>& all, std::string_view type) {
    for (const auto& [id, relationship] : all)
        if (relationship.type == type) return relationship.target;
    return {};
}

/// Whether a font of an .xlsx strikes its text out.
bool strikes(const pugi::xml_node& font) {
    const pugi::xml_node strike = child_of(font, "strike");
    const std::string value = attribute_of(strike, "val").value_or("1");
    return strike && value != "0" && value != "false";
}

/// The text of a string item: its own, or that of its runs; no phonetic hints.
std::string text_of_item(const pugi::xml_node& item) {
    std::string text;
    for (const pugi::xml_node& node : item) {
        const auto name = local_name(node.name());
        if (name == "t") text += node.child_value();
        if (name != "r") continue;
        const pugi::xml_node font = child_of(node, "rPr");
        const std::string run = child_of(node, "t").child_value();
        const auto place = attribute_of(child_of(font, "vertAlign"), "val");
        const std::string shown = shown_shifted(run, place == "superscript" ? Shift::raised
                                                     : place == "subscript" ? Shift::lowered
                                                                            : Shift::none);
        text += strikes(font) ? struck_out(shown) : shown;
    }
    return text;
}

void read_styles(const std::optional<std::string>& content, const std::string& name, Shared& shared) {
    if (!content) return;
    const pugi::xml_document document = parse_part(*content, name);
    const pugi::xml_node root = document.document_element();
    std::map<std::string, NumberFormat> own;
    for (const pugi::xml_node& node : child_of(root, "numFmts"))
        own[attribute_of(node, "numFmtId").value_or("")] =
            format_of_code(attribute_of(node, "formatCode").value_or(""));
    std::vector<bool> fonts;
    for (const pugi::xml_node& font : child_of(root, "fonts")) fonts.push_back(strikes(font));
    for (const pugi::xml_node& node : child_of(root, "cellXfs")) {
        const std::string id = attribute_of(node, "numFmtId").value_or("0");
        const auto found = own.find(id);
        shared.formats.push_back(found != own.end() ? found->second
                                                    : built_in_format(whole_number(id).value_or(0)));
        const auto font = whole_number(attribute_of(node, "fontId").value_or("0")).value_or(0);
        shared.struck.push_back(font < fonts.size() && fonts[font]);
    }
}

std::vector<std::string> read_strings(const std::optional<std::string>& content, const std::string& name) {
    std::vector<std::string> strings;
    if (!content) return strings;
    const pugi::xml_document document = parse_part(*content, name);
    for (const pugi::xml_node& item : document.document_element()) strings.push_back(text_of_item(item));
    return strings;
}

/// "2026-03-01" of a serial day number.
std::string date_of(double serial, bool since_1904) {
    using namespace std::chrono;
    if (!(serial >= 0 && serial < 2'958'466)) return shown_number(serial);  // up to the year 9999
    const sys_days origin = since_1904 ? sys_days(year(1904) / 1 / 1) : sys_days(year(1899) / 12 / 30);
    const year_month_day day(origin + days(static_cast<int>(std::floor(serial))));
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                       static_cast<unsigned>(day.day()));
}

std::string shown_value(const std::string& value, const pugi::xml_node& cell, const Shared& shared) {
    const auto number = whole_decimal(value);
    if (!number) return value;
    const auto style = whole_number(attribute_of(cell, "s").value_or("0")).value_or(0);
    if (style >= shared.formats.size()) return shown_number(*number);
    const FormatSection& section = section_of(shared.formats[style], *number);
    if (section.format == Format::date) return shown_date(date_of(*number, shared.since_1904));
    if (section.format == Format::unknown)
        return shown_number(*number) + " (in a number format that may change it)";
    if (!section.has_number && !section.prefix.empty()) return section.prefix;
    if (!section.has_number && shared.formats[style].size() > 1)
        return shown_number(*number) + " (hidden by its number format)";
    if (section.in_thousands && *number != 0) return shown_in_thousands(*number);
    return beside(section.prefix,
                  section.format == Format::per_cent ? shown_per_cent(*number) : shown_number(*number),
                  section.suffix);
}

std::string xlsx_cell_text(const pugi::xml_node& cell, const Shared& shared) {
    const std::string type = attribute_of(cell, "t").value_or("n");
    if (type == "inlineStr") return text_of_item(child_of(cell, "is"));
    std::string value = child_of(cell, "v").child_value();
    const pugi::xml_node formula = child_of(cell, "f");
    if (value.empty() && formula && (type != "str" || !child_of(cell, "v")))
        return shown_formula(formula.child_value());
    if (type == "s") {
        const auto index = whole_number(value);
        if (!index || *index >= shared.strings.size())
            throw InputError("the text of a cell is not in the file", "an undamaged file");
        return shared.strings[*index];
    }
    if (type == "b") return value == "1" ? "TRUE" : "FALSE";
    if (type == "d") return shown_date(value);
    if (type == "n" && !value.empty()) return shown_value(value, cell, shared);
    return value;  // a string of a formula, an error value
}

/// Column, counted from zero, of a reference such as "AB12"; none if there is no letter.
std::optional<std::size_t> column_of(std::string_view reference) {
    std::size_t column = 0;
    for (const char c : reference) {
        const char letter = static_cast<char>(c & ~0x20);
        if (letter < 'A' || letter > 'Z' || column > Sheet::most_columns) break;
        column = 26 * column + static_cast<std::size_t>(letter - 'A' + 1);
    }
    return column > 0 ? std::optional(column - 1) : std::nullopt;
}

struct Cell {
    std::size_t row, column;  ///< counted from zero
};

/// The cell of a reference such as "AB12".
std::optional<Cell> cell_of(std::string_view reference) {
    const auto column = column_of(reference);
    const auto row =
        whole_number(reference.substr(std::min(reference.find_first_of("0123456789"), reference.size())));
    return column && row && *row > 0 ? std::optional(Cell{*row - 1, *column}) : std::nullopt;
}

/// Takes the ranges of merged cells, "A1:C3".
void take_merged(const pugi::xml_node& worksheet, Sheet& sheet) {
    for (const pugi::xml_node& node : child_of(worksheet, "mergeCells")) {
        const std::string range = attribute_of(node, "ref").value_or("");
        const auto first = cell_of(range.substr(0, range.find(':')));
        const auto last = cell_of(range.substr(range.find(':') + 1));
        if (first && last) sheet.merge(first->row, first->column, last->row, last->column);
    }
}

void take_comments(const std::string& content, const std::string& name, Sheet& sheet) {
    const pugi::xml_document document = parse_part(content, name);
    for (const pugi::xml_node& comment : child_of(document.document_element(), "commentList"))
        if (const auto cell = cell_of(attribute_of(comment, "ref").value_or("")))
            sheet.comment(cell_name(cell->row, cell->column), text_of_item(child_of(comment, "text")));
}

/// Adds the texts of shapes and text boxes.
void take_drawing(const std::string& content, const std::string& name, Sheet& sheet) {
    const pugi::xml_document document = parse_part(content, name);
    for (const pugi::xpath_node& body : document.select_nodes("//*[local-name()='txBody']")) {
        std::string text;
        for (const pugi::xpath_node& run : body.node().select_nodes(".//*[local-name()='t']"))
            (text += text.empty() ? "" : " ") += run.node().child_value();
        sheet.comment("a text box", std::move(text));
    }
}

/// Adds the headers and footers of the pages, without their codes ("&C&12"), except those with a page number.
void take_page_texts(const pugi::xml_node& worksheet, Sheet& sheet) {
    static const std::regex codes("&(?:\"[^\"]*\"|K[0-9A-F]{6}|[0-9]+|.)");
    constexpr std::size_t longest = 1000;  // 255 in a spreadsheet
    for (const pugi::xml_node& page : child_of(worksheet, "headerFooter")) {
        const std::string text = page.child_value();
        if (text.find("&P") == std::string::npos && text.size() <= longest)
            sheet.comment("the page", std::regex_replace(text, codes, " "));
    }
}

Sheet read_xlsx_sheet(const std::string& content, const std::string& name, const std::string& called,
                      const Shared& shared) {
    const pugi::xml_document document = parse_part(content, name);
    Sheet sheet(called);
    for (const pugi::xml_node& columns : child_of(document.document_element(), "cols")) {
        const auto first = whole_number(attribute_of(columns, "min").value_or(""));
        const auto last = whole_number(attribute_of(columns, "max").value_or(""));
        if (attribute_of(columns, "hidden") == "1" && first && last && *first > 0 && *first <= *last)
            sheet.hide_columns(*first - 1, std::min(*last - *first + 1, Sheet::most_columns));
    }
    std::size_t next_row = 0;
    for (const pugi::xml_node& row : child_of(document.document_element(), "sheetData")) {
        const auto number = whole_number(attribute_of(row, "r").value_or(""));
        const std::size_t place =
            number && *number > 0 ? *number - 1 : next_row;  // the number may be left out
        if (attribute_of(row, "hidden") == "1" || attribute_of(row, "ht") == "0") sheet.count_hidden_row();
        std::size_t next_column = 0;
        for (const pugi::xml_node& cell : row) {
            if (local_name(cell.name()) != "c") continue;
            const std::size_t column = column_of(attribute_of(cell, "r").value_or("")).value_or(next_column);
            const auto style = whole_number(attribute_of(cell, "s").value_or("0")).value_or(0);
            std::string text = xlsx_cell_text(cell, shared);
            if (style < shared.struck.size() && shared.struck[style]) text = struck_out(std::move(text));
            sheet.put(place, column, text);
            sheet.see_formula(place, column, child_of(cell, "f").child_value());
            next_column = column + 1;
        }
        next_row = place + 1;
    }
    take_merged(document.document_element(), sheet);
    take_page_texts(document.document_element(), sheet);
    return sheet;
}

/// The sheets of an .xlsx (ECMA-376 and ISO 29500, both sets of namespaces); none if the archive is something
/// else.
std::optional<std::vector<Sheet>> read_xlsx(Archive& archive) {
    const std::string workbook = target_of_type(relationships(archive, ""), "officeDocument");
    if (workbook.ends_with(".bin"))
        throw InputError("this is a binary workbook (.xlsb)", "the same saved as .xlsx, .ods or CSV");
    const auto content = part(archive, workbook);
    if (!content) return std::nullopt;
    const pugi::xml_document document = parse_part(*content, workbook);
    const pugi::xml_node root = document.document_element();
    if (local_name(root.name()) != "workbook") return std::nullopt;

    const auto parts = relationships(archive, workbook);
    const std::string strings = target_of_type(parts, "sharedStrings");
    const std::string styles = target_of_type(parts, "styles");
    const auto calendar = attribute_of(child_of(root, "workbookPr"), "date1904");
    Shared shared{.strings = read_strings(part(archive, strings), strings),
                  .since_1904 = calendar == "1" || calendar == "true"};
    read_styles(part(archive, styles), styles, shared);
    std::vector<Sheet> sheets;
    for (const pugi::xml_node& node : child_of(root, "sheets")) {
        const auto found = parts.find(attribute_of(node, "id").value_or(""));
        if (found == parts.end() || found->second.type != "worksheet") continue;  // a sheet of a chart
        const std::string called = attribute_of(node, "name").value_or("");
        const auto cells = part(archive, found->second.target);
        const std::string state = attribute_of(node, "state").value_or("visible");
        if (!cells)
            throw InputError("the sheet " + in_quotes(called) + " is not in the file", "an undamaged file");
        sheets.push_back(read_xlsx_sheet(*cells, found->second.target, called, shared));
        if (state != "visible") sheets.back().hide();
        const auto beside = relationships(archive, found->second.target);
        const std::string comments = target_of_type(beside, "comments");
        if (const auto texts = part(archive, comments)) take_comments(*texts, comments, sheets.back());
        const std::string drawing = target_of_type(beside, "drawing");
        if (const auto texts = part(archive, drawing)) take_drawing(*texts, drawing, sheets.back());
        require_bytes(sheets);
    }
    return sheets;
}

}  // namespace

std::vector<Sheet> read_workbook(std::string_view bytes) {
    constexpr auto allowed = "a spreadsheet saved as .xlsx or .ods, without a password, or the table as CSV";
    if (!bytes.starts_with("PK"))
        throw InputError("this is an old Excel file (.xls), or one with a password", allowed);
    Archive archive(bytes);
    if (auto sheets = read_xlsx(archive)) return *std::move(sheets);
    if (auto sheets = read_ods(archive)) return *std::move(sheets);
    throw InputError("this is a zip archive and no spreadsheet", allowed);
}

}  // namespace ashimpact
