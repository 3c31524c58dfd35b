#include "solver/measurement/measurement_reader.hpp"

#include "materials/base/cells.hpp"
#include "materials/base/error.hpp"
#include "materials/base/number.hpp"
#include "materials/base/text.hpp"
#include "materials/base/text_lines.hpp"
#include "solver/measurement/measurement_headings.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

/// A number of the table in SI.
struct Entry {
    double value;
    std::optional<double> standard_uncertainty;
};

/// Reads cells of one table.
class TableCells {
  public:
    TableCells(const MeasurementHeading& heading, bool decimal_comma)
        : heading_(heading), decimal_comma_(decimal_comma) {}

    [[nodiscard]] Entry entry(const TableRow& row, MeasuredQuantity quantity) const {
        const MeasuredColumn& column = *heading_.of(quantity);
        Entry entry = read(row, column);
        if (const auto& uncertainty = heading_.uncertainty_of(quantity)) {
            if (entry.standard_uncertainty) fail(*uncertainty, row, "is given twice", "one uncertainty");
            entry.standard_uncertainty = read(row, *uncertainty).value;
        }
        if (entry.standard_uncertainty && !(*entry.standard_uncertainty > 0.0))
            fail(column, row, "has an uncertainty that is not positive", "> 0");
        return entry;
    }

  private:
    [[noreturn]] static void fail(const MeasuredColumn& column, const TableRow& row,
                                  const std::string& problem, const std::string& allowed) {
        throw InputError(
            in_quotes(row.cells[column.position]) + " in column " + in_quotes(column.name) + " " + problem,
            allowed);
    }

    [[nodiscard]] Entry read(const TableRow& row, const MeasuredColumn& column) const {
        const auto number = read_number(row.cells[column.position], decimal_comma_);
        if (!number) fail(column, row, "is not a number", "a finite number; 0 for a capture");
        if (number->per_cent && column.to_si != 1.0 && column.to_si != 0.01)
            fail(column, row, "is in per cent", "the unit of the heading");
        const double factor = number->per_cent ? 0.01 : column.to_si;
        Entry entry{number->value * factor, std::nullopt};
        if (number->standard_uncertainty) entry.standard_uncertainty = *number->standard_uncertainty * factor;
        return entry;
    }

    const MeasurementHeading& heading_;
    bool decimal_comma_;
};

void require_cells(const MeasurementHeading& heading, TableRow& row) {
    while (row.cells.size() > heading.columns && row.cells.back().empty()) row.cells.pop_back();
    if (row.cells.size() == heading.columns) return;
    throw InputError("the line has " + std::to_string(row.cells.size()) + " cells, the heading " +
                         std::to_string(heading.columns),
                     "as many as the heading");
}

std::optional<VelocityNoise> noise_of_rebound(const Entry& velocity, const Entry& rebound) {
    if (!velocity.standard_uncertainty && !rebound.standard_uncertainty) return std::nullopt;
    const double of_either = velocity.standard_uncertainty.value_or(rebound.standard_uncertainty.value_or(0));
    return VelocityNoise::of_velocities(of_either, rebound.standard_uncertainty.value_or(of_either));
}

std::optional<VelocityNoise> noise_of_restitution(const Entry& velocity, const Entry& restitution) {
    const double v = velocity.value;
    const double e = restitution.value;
    if (restitution.standard_uncertainty && velocity.standard_uncertainty)
        return VelocityNoise::of_restitution(v, e, *velocity.standard_uncertainty,
                                             *restitution.standard_uncertainty);
    // Of one only: the other follows from equal uncertainties of both velocities, u_e = u sqrt(1 + e^2)/v.
    if (restitution.standard_uncertainty) {
        const double u = v * *restitution.standard_uncertainty / std::sqrt(1.0 + e * e);
        return VelocityNoise::of_velocities(u, u);
    }
    if (!velocity.standard_uncertainty) return std::nullopt;
    return VelocityNoise::of_velocities(*velocity.standard_uncertainty, *velocity.standard_uncertainty);
}

Measurement measurement_of(const MeasurementHeading& heading, const TableCells& cells, const TableRow& row) {
    const Entry velocity = cells.entry(row, MeasuredQuantity::velocity);
    if (!(velocity.value > 0.0))
        throw InputError("v_in is " + shortest(velocity.value) + " m/s", "> 0 m/s, a magnitude");
    Measurement point{.velocity = velocity.value, .rebound = 0.0, .noise = {}, .line = row.line};
    if (heading.of(MeasuredQuantity::rebound)) {
        const Entry rebound = cells.entry(row, MeasuredQuantity::rebound);
        if (!(rebound.value >= 0.0))
            throw InputError("v_r is " + shortest(rebound.value) + " m/s",
                             ">= 0 m/s, a magnitude; 0 for a capture");
        point.rebound = rebound.value;
        point.noise = noise_of_rebound(velocity, rebound);
        return point;
    }
    const Entry restitution = cells.entry(row, MeasuredQuantity::restitution);
    if (!(restitution.value >= 0.0))
        throw InputError("e_n is " + shortest(restitution.value), ">= 0; 0 for a capture");
    point.rebound = restitution.value * velocity.value;
    point.noise = noise_of_restitution(velocity, restitution);
    return point;
}

std::vector<std::string> warnings_of(const MeasurementHeading& heading) {
    std::vector<std::string> warnings;
    for (const std::string& name : heading.unused)
        warnings.push_back("column " + in_quotes(name) + " is not used");
    for (const auto* columns : {&heading.value, &heading.uncertainty}) {
        for (const auto& column : *columns) {
            if (column && !column->unit_given)
                warnings.push_back("column " + in_quotes(column->name) + " has no unit: taken as m/s");
        }
    }
    return warnings;
}

MeasurementSet read_table(const TextLines& file, std::string_view name) {
    const auto lines = lines_with_content(file);
    if (lines.empty()) throw InputError("the file holds no table", "a heading and one line an impact");
    const char separator = separator_of(lines.front().text);
    MeasurementHeading heading{};
    try {
        heading = read_measurement_heading(cut_row(lines.front(), separator).cells);
    } catch (const InputError& error) {
        throw error.at(at_line(lines.front().number));
    }
    const TableCells cells(heading, separator != ',');
    MeasurementSet set{.source = std::string(name), .points = {}, .warnings = warnings_of(heading)};
    for (std::size_t i = 1; i < lines.size(); ++i) {
        TableRow row = cut_row(lines[i], separator);
        try {
            require_cells(heading, row);
            set.points.push_back(measurement_of(heading, cells, row));
        } catch (const InputError& error) {
            throw error.at(at_line(row.line));
        }
    }
    if (set.points.empty())
        throw InputError("there is no measurement below the heading", "one line an impact")
            .at(at_line(file.last_line()));
    return set;
}

}  // namespace

MeasurementSet read_measurements(std::string_view text, std::string_view name) {
    try {
        if (trimmed(text).empty()) throw InputError("the file is empty", "a table of impacts").at("line 1");
        MeasurementSet set = read_table(TextLines(text, {.content = "a table of impacts"}), name);
        validate(set);
        return set;
    } catch (const InputError& error) {
        throw error.in_file(std::string(name));
    }
}

}  // namespace ashimpact
