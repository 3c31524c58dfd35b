// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/text.hpp"
#include "core/text/utf8.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/present/report/drawing/markup.hpp"
#include "pipeline/present/report/page/html.hpp"
#include "pipeline/present/report/page/run_page.hpp"

namespace ashimpact::report {

namespace {

/// A quantity, number or word as a reader takes it in.
std::string shown(const Json& value) {
    if (value.is_object() && value.contains("value") && value.at("value").is_number())
        return readable(value.at("value").get<double>(), value.value("unit", "1"));
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number()) return shortest(value.get<double>());
    const std::string text = value.dump();
    return text.size() > 60 ? fmt::format("{} values", value.size()) : text;
}

/// The values of a list, and how many they are where not all fit.
std::string listed(const Json& list) {
    std::string text;
    for (const Json& value : list) {
        if (text.size() > 50) return text + fmt::format(", … ({} values)", list.size());
        text += (text.empty() ? "" : ", ") + shown(value);
    }
    return text.empty() ? "none" : text;
}

/// The beginning of a long text, whole characters.
std::string shortened(const std::string& text) {
    if (text.size() <= 200) return text;
    return std::string(whole_start(text, 180)) + "…";
}

/// An input by its path; entries of lists with names go by these.
using Inputs = std::vector<std::pair<std::string, std::string>>;

void flatten(const Json& node, const std::string& path, Inputs& into) {
    const bool quantity = node.is_object() && node.contains("value");
    if (node.is_object() && !quantity) {
        for (const auto& [key, value] : node.items())
            if (key != "published" && key != "name")
                flatten(value, path.empty() ? key : fmt::format("{}, {}", path, key), into);
        return;
    }
    const bool named =
        node.is_array() && !node.empty() && node.front().is_object() && node.front().contains("name");
    const bool structured = node.is_array() && !node.empty() && node.front().is_structured();
    if (!named && !structured) {
        into.emplace_back(path, node.is_array() ? listed(node) : shown(node));
        return;
    }
    for (std::size_t i = 0; i < node.size(); ++i)
        flatten(node[i], path + ", " + (named ? node[i].value("name", "?") : std::to_string(i + 1)), into);
}

std::string value_at(const Inputs& inputs, const std::string& path) {
    for (const auto& [key, value] : inputs)
        if (key == path) return value;
    return "–";
}

}  // namespace

std::string differences_html(const std::vector<RunData>& runs) {
    std::vector<Inputs> all;
    std::vector<std::string> paths;
    for (const RunData& run : runs) {
        Inputs inputs;
        flatten(case_json(run.data()), "", inputs);
        for (const auto& [path, value] : inputs)
            if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
        all.push_back(std::move(inputs));
    }
    NumberTable table{.columns = {"input"}};
    for (const RunData& run : runs) table.columns.push_back(run.label());
    for (const std::string& path : paths) {
        std::vector<Cell> row{path};
        bool differs = false;
        const std::string first = value_at(all.front(), path);
        for (const Inputs& inputs : all) {
            std::string value = value_at(inputs, path);
            differs = differs || value != first;
            row.emplace_back(shortened(value));
        }
        if (differs) table.rows.push_back(std::move(row));
    }
    std::string html = "<section><h2 id=\"differences\">What differs between the inputs</h2>\n";
    if (table.rows.empty()) return html + "<p>Nothing: the runs have the same inputs.</p></section>\n";
    return html + html_table(table, "What differs between the inputs") + "</section>\n";
}

}  // namespace ashimpact::report
