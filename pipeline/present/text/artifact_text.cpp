// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

namespace {

/// {"value", "unit"} with a number.
bool is_plain_quantity(const Json& value) {
    return value.is_object() && value.contains("value") && value.contains("unit") &&
           value["value"].is_number() && value["unit"].is_string();
}

/// Whether a member is a list of numbers alone.
bool has_numbers(const Json& value, const char* key) {
    return value.contains(key) && value[key].is_array() &&
           std::ranges::all_of(value[key], [](const Json& v) { return v.is_number(); });
}

/// {"values", "unit"} with numbers.
bool is_any_column(const Json& value) {
    return value.is_object() && value.contains("unit") && value["unit"].is_string() &&
           has_numbers(value, "values");
}

/// One of more numbers than one, or none.
bool is_column(const Json& value) {
    return is_any_column(value) && value["values"].size() != 1;
}

/// {"level", "lower", "upper"}.
bool is_interval(const Json& value) {
    if (!value.is_object() || value.size() != 3 || !value.contains("level") || !value.contains("lower") ||
        !value.contains("upper") || !value["level"].is_number())
        return false;
    const auto is_end = [](const Json& end) {
        return end.is_null() || end.is_number() || is_plain_quantity(end);
    };
    return is_end(value["lower"]) && is_end(value["upper"]);
}

/// The number of a table's cell; what is only rounding of other numbers (below 1e-12) is 0.
std::string cell_number(double value, int digits = 4) {
    constexpr double least = 1e-12;
    return std::abs(value) < least ? "0" : readable_number(value, digits);
}

std::string quantity_text(const Json& value) {
    std::string text = readable(shown_quantity(value));
    const std::string origin = value.value("origin", "");
    if (!origin.empty() && origin != "given" && origin != "computed") text += fmt::format("  ({})", origin);
    return text;
}

/// "1.471 to 1.613 m/s (95 %)".
std::string interval_text(const Json& interval) {
    const auto end = [&](const char* key) {
        const Json& value = interval.at(key);
        if (is_plain_quantity(value)) return quantity_text(value);
        return value.is_number() ? cell_number(value.get<double>()) : std::string("open");
    };
    const std::string level = fmt::format(" ({:g} %)", 100 * interval.at("level").get<double>());
    if (interval.at("lower").is_null() && interval.at("upper").is_null()) return "-";
    std::string lower = end("lower");
    const std::string upper = end("upper");
    const auto unit = [](const std::string& text) {
        return text.substr(std::min(text.size(), text.find(' ')));
    };
    if (unit(lower) == unit(upper)) lower.resize(lower.size() - unit(lower).size());
    return lower + " to " + upper + level;
}

/// A string, number, truth value or null.
std::string scalar_text(const Json& value) {
    if (value.is_null()) return "-";
    if (value.is_string()) {
        const auto& text = value.get_ref<const std::string&>();
        return text.empty() ? "\"\"" : text;
    }
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number_float()) return cell_number(value.get<double>());
    return value.dump();
}

/// A value that fits behind its name: a text, a number, a quantity, an interval, a list of such.
std::optional<std::string> short_text(const Json& value) {
    if (is_plain_quantity(value)) return quantity_text(value);
    if (is_interval(value)) return interval_text(value);
    if (is_any_column(value) && value["values"].size() == 1)
        return readable(value["values"].front().get<double>(), value["unit"].get<std::string>());
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

/// {"edges": {"values", "unit"}, "counts": [..]} with an edge more than counts, as in the result of a sweep.
bool is_histogram(const Json& value) {
    return value.is_object() && value.contains("edges") && is_column(value["edges"]) &&
           has_numbers(value, "counts") && !value["counts"].empty() &&
           value["edges"]["values"].size() == value["counts"].size() + 1;
}

/// A histogram as bars, at most 16 of them, the zeros apart.
std::string histogram_text(const Json& histogram, std::size_t indent, std::size_t width) {
    constexpr std::size_t most_bars = 16;
    constexpr std::size_t numbers_width = 40;  // of edges and counts beside the bars
    const auto edges = histogram.at("edges").at("values").get<std::vector<double>>();
    const auto counts = histogram.at("counts").get<std::vector<double>>();
    const std::size_t merged = (counts.size() + most_bars - 1) / most_bars;
    std::vector<double> sums;
    for (std::size_t i = 0; i < counts.size(); i += merged)
        sums.push_back(std::accumulate(
            counts.begin() + static_cast<std::ptrdiff_t>(i),
            counts.begin() + static_cast<std::ptrdiff_t>(std::min(i + merged, counts.size())), 0.0));
    const double greatest = *std::max_element(sums.begin(), sums.end());
    const double longest = static_cast<double>(width - std::min(width - 10, indent + numbers_width));

    const std::string unit = histogram.at("edges").at("unit").get<std::string>();
    TextTable table({"from" + (unit == "1" ? "" : " [" + unit + "]"), "to", "count", ""});
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto length = static_cast<std::size_t>(greatest > 0 ? longest * sums[i] / greatest + 0.5 : 0.0);
        const std::string bar(length, '#');
        table.add({readable_number(edges[i * merged]),
                   readable_number(edges[std::min((i + 1) * merged, counts.size())]),
                   readable_number(sums[i], 12),
                   bar + std::string(static_cast<std::size_t>(longest) - length, ' ')});
    }
    std::string text = table.text(indent, width);
    if (histogram.contains("zeros"))
        text += fmt::format("{}zero: {}\n", std::string(indent, ' '),
                            short_text(histogram.at("zeros")).value_or("-"));
    return text;
}

constexpr std::size_t indent_width = 2;
constexpr std::size_t most_rows = 12;
constexpr std::size_t deepest = 2;        ///< parts of what a law has: shown with everything only
constexpr std::size_t longest_cell = 28;  ///< a longer text gets a line of its own

/// A key with its unit behind it, where there is one.
std::string with_unit(const std::string& key, const std::string& unit) {
    return unit == "1" || unit.empty() ? key : fmt::format("{} [{}]", key, unit);
}

/// The rows of a long list that are shown: every so many, from the first.
std::size_t stride_of(std::size_t length, const ResultView& view) {
    return view.all ? 1 : std::max<std::size_t>(1, (length + most_rows - 1) / most_rows);
}

std::string shortened_note(std::size_t stride, std::size_t length, std::size_t indent) {
    if (stride == 1) return {};
    return fmt::format("{}every {} of {} rows; --all shows them\n", std::string(indent, ' '), stride, length);
}

class ResultText {
  public:
    explicit ResultText(const ResultView& view) : view_(view) {}

    [[nodiscard]] std::string block(const Json& value, std::size_t depth) {
        if (is_histogram(value)) return histogram_text(value, indent(depth), view_.width);
        TextList scalars;
        std::string nested;
        std::vector<std::string> left_out;
        const std::vector<std::string> alike = entries_of_one_kind(value);
        for (const auto& [key, member] : value.items()) {
            if (is_column(member) || std::find(alike.begin(), alike.end(), key) != alike.end()) continue;
            if (key == "name" && depth > 0) continue;  // it is the heading
            if (const auto text = short_text(member))
                scalars.add(key, *text);
            else if (depth >= deepest && !view_.all)
                left_out.push_back(key);
            else
                nested += part(key, member, depth);
        }
        std::string text = scalars.text(indent(depth), view_.width) + columns(value, depth) + nested;
        if (!alike.empty()) text += side_by_side(value, alike, depth, left_out);
        if (left_out.empty()) return text;
        return text + wrapped(margin(depth) + "(" + joined(left_out) + ": with --all)", view_.width) + "\n";
    }

  private:
    [[nodiscard]] static std::size_t indent(std::size_t depth) { return depth * indent_width; }
    [[nodiscard]] static std::string margin(std::size_t depth) { return std::string(indent(depth), ' '); }

    /// A member that needs lines of its own, under its name.
    [[nodiscard]] std::string part(const std::string& key, const Json& member, std::size_t depth) {
        if (member.is_array()) return list(key, member, depth);
        return margin(depth) + key + "\n" + block(member, depth + 1);
    }

    /// Columns of an object as tables: those of one length side by side, captures apart from rebounds.
    [[nodiscard]] std::string columns(const Json& object, std::size_t depth) const {
        std::vector<std::pair<std::pair<bool, std::size_t>, std::vector<std::string>>> groups;
        for (const auto& [key, value] : object.items()) {
            if (!is_column(value) || value["values"].empty()) continue;
            const std::pair group{key.starts_with("captur"), value["values"].size()};
            const auto found =
                std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == group; });
            auto& keys = found == groups.end() ? groups.emplace_back(group, std::vector<std::string>{}).second
                                               : found->second;
            keys.push_back(key);
        }
        std::string text;
        for (const auto& [group, keys] : groups) text += column_table(object, keys, group.second, depth);
        return text;
    }

    [[nodiscard]] std::string column_table(const Json& object, std::vector<std::string> keys,
                                           std::size_t length, std::size_t depth) const {
        const auto number = std::find(keys.begin(), keys.end(), "number");  // rows that have their own
        const bool numbered = number != keys.end();
        if (numbered) keys.erase(number);
        if (keys.empty()) keys.emplace_back("number");
        std::vector<std::string> heading{"#"};
        for (const std::string& key : keys)
            heading.push_back(with_unit(key, object.at(key).at("unit").get<std::string>()));
        TextTable table(std::move(heading));
        const std::size_t stride = stride_of(length, view_);
        for (std::size_t i = 0; i < length; i += stride) {
            std::vector<std::string> row{numbered ? readable_number(object.at("number").at("values")[i], 12)
                                                  : std::to_string(i + 1)};
            for (const std::string& key : keys)
                row.push_back(readable_number(object.at(key).at("values")[i].get<double>(), 5));
            table.add(std::move(row));
        }
        return table.text(indent(depth), view_.width) + shortened_note(stride, length, indent(depth));
    }

    /// Whether two objects have at least half of their keys in common, and @p least of them.
    [[nodiscard]] static bool are_alike(const Json& one, const Json& other, std::size_t least) {
        std::size_t shared = 0;
        for (const auto& [key, _] : other.items()) shared += one.contains(key) ? 1 : 0;
        return shared >= least && 2 * shared >= std::max(one.size(), other.size());
    }

    /// Members that are objects of one kind, such as those of contact laws: they share most of their keys.
    /// The kind begins with the first object that another one resembles.
    [[nodiscard]] static std::vector<std::string> entries_of_one_kind(const Json& object) {
        std::vector<std::string> keys;
        const Json* first = nullptr;
        for (const auto& entry : object.items()) {
            const Json& member = entry.value();
            if (!member.is_object() || short_text(member) || is_column(member) || is_histogram(member))
                continue;
            const auto resembles = [&](const Json& other) {
                return other.is_object() && &other != &member && are_alike(member, other, 2);
            };
            const bool belongs = first != nullptr ? are_alike(*first, member, 0)
                                                  : std::any_of(object.begin(), object.end(), resembles);
            if (!belongs) continue;
            if (first == nullptr) first = &member;
            keys.push_back(entry.key());
        }
        return keys.size() > 1 ? keys : std::vector<std::string>{};
    }

    /// The unit that a member has in every entry; empty if it is no quantity or they differ.
    [[nodiscard]] static std::string common_unit(const Json& object, const std::vector<std::string>& entries,
                                                 const std::string& key) {
        std::string unit;
        for (const std::string& entry : entries) {
            const Json value = object.at(entry).value(key, Json(nullptr));
            if (value.is_null()) continue;
            if (!is_plain_quantity(value) || value.contains("origin")) return {};
            const std::string text = readable(shown_quantity(value));
            const std::string shown = text.substr(std::min(text.size(), text.rfind(' ') + 1));
            if (value.at("unit") == "1" || (!unit.empty() && unit != shown)) return {};
            unit = shown;
        }
        return unit;
    }

    /// Entries of one kind as the columns of a table, a row a member; what needs lines of its own below it.
    [[nodiscard]] std::string side_by_side(const Json& object, const std::vector<std::string>& entries,
                                           std::size_t depth, std::vector<std::string>& left_out) {
        std::vector<std::string> keys;
        for (const std::string& entry : entries)
            for (const auto& [key, _] : object.at(entry).items())
                if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
        std::vector<std::string> heading{""};
        heading.insert(heading.end(), entries.begin(), entries.end());
        TextTable table(std::move(heading));
        TextList lines;
        std::string nested;
        for (const std::string& key : keys) {
            const std::string unit = common_unit(object, entries, key);
            std::vector<std::string> row{with_unit(key, unit)};
            bool is_short = true;
            bool any_column = false;
            for (const std::string& entry : entries) {
                const Json& of = object.at(entry);
                const auto text = of.contains(key) ? short_text(of.at(key)) : std::string("-");
                is_short = is_short && text;
                any_column = any_column || (of.contains(key) && is_column(of.at(key)));
                std::string cell = text.value_or("");
                if (!unit.empty() && cell.ends_with(" " + unit)) cell.resize(cell.size() - unit.size() - 1);
                row.push_back(std::move(cell));
            }
            if (any_column) continue;
            if (!is_short) {
                if (depth + 1 >= deepest && !view_.all)
                    left_out.push_back(key);
                else
                    for (const std::string& entry : entries)
                        if (object.at(entry).contains(key))
                            nested +=
                                part(fmt::format("{}, {}", entry, key), object.at(entry).at(key), depth);
                continue;
            }
            const bool same = std::all_of(row.begin() + 2, row.end(),
                                          [&](const std::string& cell) { return cell == row[1]; });
            const bool is_long = std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) {
                return width_of(cell) > longest_cell;
            });
            if (is_long && same)
                lines.add(key, row[1]);
            else if (is_long)
                for (std::size_t i = 0; i < entries.size(); ++i) {
                    if (row[i + 1] != "-") lines.add(key + ", " + entries[i], row[i + 1]);
                }
            else
                table.add(std::move(row));
        }
        std::string text = table.empty() ? "" : table.text(indent(depth), view_.width);
        text += lines.text(indent(depth), view_.width);
        for (const std::string& entry : entries)
            if (const std::string own = columns(object.at(entry), depth + 1); !own.empty())
                text.append(margin(depth)).append(entry).append("\n").append(own);
        return text + nested;
    }

    /// Whether a list holds objects that make the rows of a table: same keys, short values.
    [[nodiscard]] static bool is_table(const Json& list) {
        if (!list.is_array() || list.size() < 2) return false;
        for (const Json& row : list) {
            if (!row.is_object() || row.size() != list.front().size() || row.size() > 12) return false;
            for (const auto& [key, cell] : row.items())
                if (!list.front().contains(key) || !short_text(cell)) return false;
        }
        return true;
    }

    [[nodiscard]] std::string rows(const Json& list, std::size_t depth) const {
        std::vector<std::string> heading;
        const bool named = list.front().contains("name");
        if (named) heading.emplace_back("name");
        for (const auto& [key, _] : list.front().items())
            if (key != "name") heading.push_back(key);
        const bool two_names =
            heading.size() > 2 && std::all_of(list.begin(), list.end(), [&](const Json& row) {
                return row.at(heading[0]).is_string() && row.at(heading[1]).is_string();
            });
        TextTable table(heading, two_names ? 2 : 1);
        const std::size_t stride = list.size() > 2 * most_rows ? stride_of(list.size(), view_) : 1;
        for (std::size_t i = 0; i < list.size(); i += stride) {
            std::vector<std::string> cells;
            cells.reserve(heading.size());
            for (const std::string& key : heading) cells.push_back(short_text(list[i].at(key)).value());
            table.add(std::move(cells));
        }
        return table.text(indent(depth), view_.width) + shortened_note(stride, list.size(), indent(depth));
    }

    /// The heading of one element of a list: its name, or what else it has of that kind.
    [[nodiscard]] static std::string title_of(const Json& element, std::size_t index) {
        for (const char* key : {"name", "part", "file", "law"})
            if (element.is_object() && element.contains(key) && element[key].is_string())
                return element[key].get<std::string>();
        return "#" + std::to_string(index + 1);
    }

    /// A list under its name: rows of a table, rows of a matrix, or one block an element.
    [[nodiscard]] std::string list(const std::string& name, const Json& list, std::size_t depth) {
        if (list.empty()) return margin(depth) + name + "  none\n";
        if (is_table(list)) return margin(depth) + name + "\n" + rows(list, depth + 1);
        std::string text;
        if (list.front().is_array()) {
            text = margin(depth) + name + "\n";
            for (const Json& row : list)
                text += wrapped(fmt::format("{}  {}", margin(depth), short_text(row).value_or(row.dump())),
                                view_.width, 2) +
                        "\n";
            return text;
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            text += fmt::format("{}{} {}\n", margin(depth), name, title_of(list[i], i));
            text += list[i].is_object()
                        ? block(list[i], depth + 1)
                        : margin(depth + 1) + short_text(list[i]).value_or(list[i].dump()) + "\n";
        }
        return text;
    }

    const ResultView& view_;
};

/// A result in which words replace critical velocities that are outside of the model.
/// @param is_critical whether the node is below the key of a critical velocity
Json with_words(const Json& node, bool is_critical = false) {
    if (is_critical && is_plain_quantity(node) && node["unit"] == "m/s" && node["value"] > fastest_in_model)
        return critical_velocity_text(node["value"], "");
    if (!node.is_structured()) return node;
    Json shown = node;
    for (const auto& [key, member] : node.items()) {
        Json& place = node.is_array() ? shown[std::stoul(key)] : shown[key];
        place = with_words(member, is_critical || key.ends_with("critical_velocity"));
    }
    return shown;
}

std::string provenance_text(const Json& artifact, std::size_t width) {
    const Json& provenance = artifact.at("provenance");
    std::string text;
    for (const Json& input : provenance.at("inputs")) {
        text += fmt::format("from {}\n  sha256 {}\n", input.at("file").get<std::string>(),
                            input.at("sha256").get<std::string>());
        for (const std::string& reading : input.value("read_as", std::vector<std::string>()))
            text += "  " + wrapped("read as " + reading, width - 2, 2) + "\n";
    }
    if (!provenance.at("options").empty())
        text += "options\n" + result_text(provenance.at("options"), {.all = true, .width = width});
    for (const Json& citation : artifact.at("citations"))
        text += wrapped("cites " + citation.get<std::string>(), width, 2) + "\n";
    return text;
}

}  // namespace

std::string result_text(const Json& result, const ResultView& view) {
    return ResultText(view).block(result, 0);
}

std::string artifact_text(const Json& artifact, const ResultView& view, bool with_provenance) {
    const std::size_t width = view.width;
    const Json& provenance = artifact.at("provenance");
    std::string text =
        fmt::format("{} by {} {} ({})\n\n", artifact.at("schema").get<std::string>(),
                    provenance.at("program").get<std::string>(), provenance.at("version").get<std::string>(),
                    provenance.at("revision").get<std::string>());
    const bool is_comparison = artifact.at("stage") == "comparison";
    if (is_comparison) text += comparison_text(artifact.at("result"), width);
    std::string result;
    if (!is_comparison || view.all) result = result_text(with_words(artifact.at("result")), view);
    text += (is_comparison && !result.empty() ? "\n" : "") + result;
    if (const std::string legend = uncertainty_legend(text); !legend.empty()) text += "\n" + legend;
    if (!artifact.at("warnings").empty()) text += "\n";
    for (const Json& warning : artifact.at("warnings"))
        text += wrapped("warning: " + warning.get<std::string>(), width, 2) + "\n";
    if (with_provenance) return text + "\n" + provenance_text(artifact, width);
    return text + "\nInputs, options and citations: -v." +
           (is_comparison && !view.all ? " Everything else it holds: --all." : "") + "\n";
}

}  // namespace ashimpact
