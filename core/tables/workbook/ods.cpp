// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>

#include "core/tables/workbook/formats.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Number of repetitions of an element, at most the size of a sheet.
std::size_t repeats(const pugi::xml_node& node, std::string_view attribute) {
    const std::string text = attribute_of(node, attribute).value_or("1");
    std::size_t count = 1;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (status == std::errc::result_out_of_range) return Sheet::most_rows;
    return status == std::errc{} ? std::min(count, Sheet::most_rows) : 1;
}

/// Text of a paragraph, whatever it is dressed in; notes at the cell are none of it.
void append_text(const pugi::xml_node& node, std::string& text) {
    for (const pugi::xml_node& inner : node) {
        if (inner.type() == pugi::node_pcdata || inner.type() == pugi::node_cdata) text += inner.value();
        const auto name = local_name(inner.name());
        if (name == "s" || name == "tab" || name == "line-break") text += ' ';
        if (name == "span" || name == "a") append_text(inner, text);
    }
}

std::string text_of_paragraphs(const pugi::xml_node& cell) {
    std::string text;
    for (const pugi::xml_node& node : cell) {
        if (local_name(node.name()) != "p") continue;
        if (!text.empty()) text += ' ';
        append_text(node, text);
    }
    return text;
}

std::string text_of_cell(const pugi::xml_node& cell) {
    // LibreOffice adds a second attribute of that name with the value "error"; the first one is
    // OpenDocument's.
    const std::string type = attribute_of(cell, "value-type").value_or("");
    const auto formula = attribute_of(cell, "formula");
    if (formula && type.empty()) {
        const auto start = formula->find('=');
        return shown_formula(formula->substr(start == std::string::npos ? 0 : start + 1));
    }
    if (type == "date") return shown_date(attribute_of(cell, "date-value").value_or("").substr(0, 10));
    if (type == "float" || type == "percentage" || type == "currency") {
        const auto number = whole_decimal(attribute_of(cell, "value").value_or(""));
        if (number) return type == "percentage" ? shown_per_cent(*number) : shown_number(*number);
    }
    return text_of_paragraphs(cell);
}

/// Fills a sheet from its rows, which may be grouped.
class Filler {
  public:
    explicit Filler(Sheet& sheet) : sheet_(sheet) {}

    void take_rows(const pugi::xml_node& parent, int depth = 0) {
        constexpr int deepest_group = 20;
        for (const pugi::xml_node& node : parent) {
            const auto name = local_name(node.name());
            if (name == "table-row") take_row(node);
            const bool group =
                name == "table-row-group" || name == "table-header-rows" || name == "table-rows";
            if (group && depth < deepest_group) take_rows(node, depth + 1);
        }
    }

  private:
    /// Rows that are equal, such as two impacts captured at the same velocity, are stored once.
    void take_row(const pugi::xml_node& row) {
        std::vector<std::pair<std::size_t, std::string>> cells;
        std::size_t column = 0;
        for (const pugi::xml_node& cell : row) {
            const auto name = local_name(cell.name());
            if (name != "table-cell" && name != "covered-table-cell") continue;
            const std::size_t copies = repeats(cell, "number-columns-repeated");
            const std::string text = text_of_cell(cell);
            for (std::size_t i = 0; !text.empty() && i < copies; ++i) {
                sheet_.require_column(row_, column + i);
                cells.emplace_back(column + i, text);
            }
            column += copies;
        }
        const std::size_t times = repeats(row, "number-rows-repeated");
        const auto visible = attribute_of(row, "visibility");
        for (std::size_t i = 0; !cells.empty() && i < times; ++i) {
            for (const auto& [place, text] : cells) sheet_.put(row_ + i, place, text);
            if (visible == "collapse" || visible == "filter") sheet_.count_hidden_row();
        }
        row_ += times;
    }

    Sheet& sheet_;
    std::size_t row_ = 0;
};

}  // namespace

std::optional<std::vector<Sheet>> read_ods(const Archive& archive) {
    constexpr auto part = "content.xml";
    const auto content = archive.read(part);
    if (!content) return std::nullopt;
    const pugi::xml_document document = parse_part(*content, part);
    const pugi::xml_node body = child_of(document.document_element(), "body");
    const pugi::xml_node tables = child_of(body, "spreadsheet");
    if (!tables) return std::nullopt;
    std::vector<Sheet> sheets;
    for (const pugi::xml_node& table : tables) {
        if (local_name(table.name()) != "table") continue;
        Sheet& sheet = sheets.emplace_back(attribute_of(table, "name").value_or(""));
        Filler(sheet).take_rows(table);
    }
    return sheets;
}

}  // namespace ashimpact
