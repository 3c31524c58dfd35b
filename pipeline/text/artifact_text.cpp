#include "pipeline/text/artifact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "materials/base/text.hpp"
#include "pipeline/text/comparison_table.hpp"
#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t indent_width = 2;
constexpr std::size_t most_rows = 12;

bool is_quantity(const Json& value) {
    return value.is_object() && value.contains("value") && value.contains("unit") &&
           value["value"].is_number();
}

bool is_column(const Json& value) {
    return value.is_object() && value.contains("values") && value.contains("unit") &&
           value["values"].is_array() &&
           std::all_of(value["values"].begin(), value["values"].end(),
                       [](const Json& v) { return v.is_number(); });
}

std::string quantity_text(const Json& value) {
    Quantity quantity{.value = value["value"], .unit = value["unit"]};
    if (value.contains("standard_uncertainty") && value["standard_uncertainty"] != 0.0)
        quantity.standard_uncertainty = value["standard_uncertainty"].get<double>();
    std::string text = readable(quantity);
    const std::string origin = value.value("origin", "");
    if (!origin.empty() && origin != "given" && origin != "computed") text += fmt::format("  ({})", origin);
    return text;
}

/// A string, number, truth value or null.
std::string scalar_text(const Json& value) {
    if (value.is_null()) return "-";
    if (value.is_string()) return value == "" ? "\"\"" : value.get<std::string>();
    if (value.is_number_float()) return readable_number(value.get<double>());
    return value.dump();
}

/// A value that fits behind its name, or nothing.
std::optional<std::string> short_text(const Json& value) {
    if (is_quantity(value)) return quantity_text(value);
    if (!value.is_structured()) return scalar_text(value);
    if (value.empty()) return "none";
    if (!value.is_array()) return std::nullopt;
    std::vector<std::string> list;
    for (const Json& element : value) {
        if (element.is_structured()) return std::nullopt;
        list.push_back(scalar_text(element));
    }
    return joined(list);
}

/// All columns of an object that have one length, side by side.
std::string columns_text(const Json& object, std::size_t indent) {
    std::vector<std::string> heading{"#"};
    std::vector<const Json*> columns;
    for (const auto& [key, value] : object.items()) {
        if (!is_column(value) || value["values"].empty()) continue;
        heading.push_back(fmt::format("{} [{}]", key, value["unit"].get<std::string>()));
        columns.push_back(&value["values"]);
    }
    if (columns.empty()) return {};
    TextTable table(std::move(heading));
    std::size_t length = 0;
    for (const Json* column : columns) length = std::max(length, column->size());
    const std::size_t stride = std::max<std::size_t>(1, (length + most_rows - 1) / most_rows);
    for (std::size_t i = 0; i < length; i += stride) {
        std::vector<std::string> row{std::to_string(i + 1)};
        for (const Json* column : columns)
            row.push_back(i < column->size() ? readable_number((*column)[i].get<double>(), 5) : "");
        table.add(std::move(row));
    }
    return table.text(indent) +
           (stride > 1 ? fmt::format("{}every {} of {} rows\n", std::string(indent, ' '), stride, length)
                       : "");
}

/// Whether a list holds objects that make the rows of a table: same keys, short values.
bool is_table(const Json& list) {
    if (!list.is_array() || list.size() < 2) return false;
    for (const Json& row : list) {
        if (!row.is_object() || row.size() != list.front().size() || row.size() > 8) return false;
        for (const auto& [key, cell] : row.items())
            if (!list.front().contains(key) || !short_text(cell)) return false;
    }
    return true;
}

std::string rows_text(const Json& list, std::size_t indent) {
    std::vector<std::string> heading;
    for (const auto& [key, _] : list.front().items()) heading.push_back(key);
    TextTable table(heading);
    for (const Json& row : list) {
        std::vector<std::string> cells;
        cells.reserve(heading.size());
        for (const std::string& key : heading) cells.push_back(short_text(row.at(key)).value());
        table.add(std::move(cells));
    }
    return table.text(indent);
}

/// The heading of one element of a list: its name, or what else it has of that kind.
std::string title_of(const Json& element, std::size_t index) {
    for (const char* key : {"name", "part", "file"})
        if (element.is_object() && element.contains(key) && element[key].is_string())
            return element[key].get<std::string>();
    return "#" + std::to_string(index + 1);
}

std::string block_text(const Json& value, std::size_t indent);

/// A list under its name: rows of a table, rows of a matrix, or one block an element.
std::string list_text(const std::string& name, const Json& list, std::size_t indent) {
    const std::string margin(indent, ' ');
    if (is_table(list)) return margin + name + "\n" + rows_text(list, indent + indent_width);
    std::string text;
    if (list.front().is_array()) {
        text = margin + name + "\n";
        for (const Json& row : list)
            text += fmt::format("{}  {}\n", margin, short_text(row).value_or(row.dump()));
        return text;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        text += fmt::format("{}{} {}\n", margin, name, title_of(list[i], i));
        text += block_text(list[i], indent + indent_width);
    }
    return text;
}

std::string block_text(const Json& value, std::size_t indent) {
    TextList scalars;
    std::string nested;
    bool any = false;
    for (const auto& [key, member] : value.items()) {
        if (is_column(member)) continue;
        if (const auto text = short_text(member)) {
            scalars.add(key, *text);
            any = true;
        } else if (member.is_array()) {
            nested += list_text(key, member, indent);
        } else {
            nested += std::string(indent, ' ') + key + "\n" + block_text(member, indent + indent_width);
        }
    }
    return (any ? scalars.text(indent) : std::string{}) + columns_text(value, indent) + nested;
}

}  // namespace

std::string result_text(const Json& result) {
    return block_text(result, 0);
}

std::string artifact_text(const Json& artifact) {
    const Json& provenance = artifact.at("provenance");
    std::string text =
        fmt::format("{} by {} {} ({})\n", artifact.at("schema").get<std::string>(),
                    provenance.at("program").get<std::string>(), provenance.at("version").get<std::string>(),
                    provenance.at("revision").get<std::string>());
    for (const Json& input : provenance.at("inputs"))
        text += fmt::format("  from {}  sha256 {}\n", input.at("file").get<std::string>(),
                            input.at("sha256").get<std::string>());
    if (!provenance.at("options").empty())
        text += "options\n" + block_text(provenance.at("options"), indent_width);
    for (const Json& citation : artifact.at("citations"))
        text += "cites " + citation.get<std::string>() + "\n";
    for (const Json& warning : artifact.at("warnings"))
        text += "warning: " + warning.get<std::string>() + "\n";
    text += "\n";
    if (artifact.at("stage") == "comparison") text += comparison_text(View(artifact).at("result")) + "\n";
    return text + result_text(artifact.at("result"));
}

}  // namespace ashimpact
