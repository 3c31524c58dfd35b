#include "pipeline/case/impact_table.hpp"

#include <algorithm>
#include <array>

#include "materials/error.hpp"
#include "materials/json_input.hpp"
#include "materials/text.hpp"
#include "materials/units.hpp"
#include "materials/xrd/number.hpp"
#include "materials/xrd/text_lines.hpp"

namespace ashimpact {

namespace {

constexpr auto headings = "velocity [m/s], restitution or rebound_velocity [m/s]";

/// Names under which columns are known.
constexpr std::array velocity_names{"velocity", "incident_velocity", "incident velocity", "v_in", "vin"};
constexpr std::array restitution_names{"restitution", "e_n", "en", "e"};
constexpr std::array rebound_names{"rebound_velocity", "rebound velocity", "v_r", "v_rn", "vr"};

struct Column {
    std::size_t index;
    std::string unit;
    bool found = false;
};

char separator_of(std::string_view heading) {
    for (const char separator : {'\t', ';', ','})
        if (heading.find(separator) != std::string_view::npos) return separator;
    throw InputError("the heading has one column", headings);
}

std::vector<std::string_view> cells(std::string_view line, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= line.size();) {
        const auto end = std::min(line.find(separator, start), line.size());
        parts.push_back(trimmed(line.substr(start, end - start)));
        start = end + 1;
    }
    return parts;
}

/// A heading such as "velocity [m/s]" in its two parts.
std::pair<std::string, std::string> name_and_unit(std::string_view heading) {
    const auto open = heading.find_first_of("[(");
    if (open == std::string_view::npos) return {lower_case(heading), {}};
    const auto close = heading.find_first_of("])", open);
    return {lower_case(trimmed(heading.substr(0, open))),
            std::string(trimmed(
                heading.substr(open + 1, close == std::string_view::npos ? close : close - open - 1)))};
}

template <class Names>
Column column_named(const std::vector<std::string_view>& heading, const Names& names) {
    for (std::size_t i = 0; i < heading.size(); ++i) {
        auto [name, unit] = name_and_unit(heading[i]);
        if (std::find(names.begin(), names.end(), name) != names.end()) return {i, std::move(unit), true};
    }
    return {0, {}, false};
}

double value_in(const std::vector<std::string_view>& row, const Column& column, Dimension dimension,
                bool comma) {
    if (column.index >= row.size()) throw InputError("the line has too few columns", headings);
    const auto number = xrd::read_number(row[column.index], comma);
    if (!number) throw InputError(in_quotes(row[column.index]) + " is not a number", "a finite number");
    return to_si(number->value, column.unit.empty() ? si_unit(dimension) : column.unit, dimension);
}

/// Where a table has what.
struct Layout {
    char separator;
    Column velocity;
    Column restitution;
    Column rebound;
};

Layout layout_of(std::string_view line) {
    const char separator = separator_of(line);
    const auto heading = cells(line, separator);
    Layout layout{separator, column_named(heading, velocity_names), column_named(heading, restitution_names),
                  column_named(heading, rebound_names)};
    if (!layout.velocity.found || (!layout.restitution.found && !layout.rebound.found))
        throw InputError("the heading lacks a column", headings);
    return layout;
}

void add_impact(const Layout& layout, std::string_view line, MeasuredRestitution& data) {
    const auto row = cells(line, layout.separator);
    const bool comma = layout.separator != ',';
    const double velocity = value_in(row, layout.velocity, Dimension::velocity, comma);
    const double restitution = layout.restitution.found
                                   ? value_in(row, layout.restitution, Dimension::fraction, comma)
                                   : value_in(row, layout.rebound, Dimension::velocity, comma) / velocity;
    data.velocity.push_back(velocity);
    data.restitution.push_back(restitution);
}

}  // namespace

MeasuredRestitution read_impact_table(std::string_view text) {
    const xrd::TextLines file(text);
    std::vector<xrd::Line> lines;
    for (const xrd::Line& line : file.lines())
        if (!trimmed(line.text).empty() && !line.text.starts_with('#')) lines.push_back(line);
    if (lines.empty()) throw InputError("the file has no lines", headings);

    const Layout layout =
        at_place(xrd::at_line(lines.front().number), [&] { return layout_of(lines.front().text); });
    if (lines.size() == 1) throw InputError("the file has a heading and nothing under it", headings);
    MeasuredRestitution data;
    for (std::size_t i = 1; i < lines.size(); ++i)
        at_place(xrd::at_line(lines[i].number), [&] { add_impact(layout, lines[i].text, data); });
    return data;
}

}  // namespace ashimpact
