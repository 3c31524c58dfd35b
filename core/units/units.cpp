// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/units.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "core/text/decimal.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/unit.hpp"

namespace ashimpact {

namespace {

struct DimensionRow {
    Dimension dimension;
    std::string_view name;
    std::string_view unit;
    std::string_view examples;
};

constexpr std::array dimension_rows{
    DimensionRow{Dimension::fraction, "fraction", "1", "0.1, 10 %"},
    DimensionRow{Dimension::length, "length", "m", "44 um, 4.4e-5 m"},
    DimensionRow{Dimension::mass, "mass", "kg", "0.93 ug, 9.3e-10 kg"},
    DimensionRow{Dimension::time, "time", "s", "294 ns, 2.94e-7 s"},
    DimensionRow{Dimension::velocity, "velocity", "m/s", "2 m/s, 150 cm/s"},
    DimensionRow{Dimension::density, "density", "kg/m3", "2160 kg/m3, 2.16 g/cm3"},
    DimensionRow{Dimension::pressure, "pressure", "Pa", "90 GPa, 35.3 MPa"},
    DimensionRow{Dimension::force, "force", "N", "40 uN, 4e-5 N"},
    DimensionRow{Dimension::energy, "energy", "J", "1.9 nJ, 1.9e-9 J"},
    DimensionRow{Dimension::energy_per_area, "energy per area", "J/m2", "0.3 J/m2, 300 mJ/m2, 0.3 N/m"},
    DimensionRow{Dimension::damping, "damping", "kg/s", "0.0141 kg/s, 14.1 g/s, 0.0141 N s/m"},
    DimensionRow{Dimension::viscosity, "viscosity", "Pa s", "300 Pa s, 0.3 kPa s"},
    DimensionRow{Dimension::impulse, "impulse", "N s", "1.9 nN s, 1.9e-9 kg m/s"},
};

const DimensionRow& row(Dimension dimension) {
    return dimension_rows.at(static_cast<std::size_t>(dimension));
}

std::string allowed(Dimension dimension) {
    const auto& [_, name, unit, examples] = row(dimension);
    return with_article(name) + " [" + std::string(unit) + "], e.g. " + std::string(examples);
}

/// The factor rounded to 15 significant digits, which removes the rounding errors of a product of unit
/// factors.
double without_rounding_noise(double factor) {
    const std::string rounded = decimal::scientific(factor, 14);
    decimal::read(rounded.data(), rounded.data() + rounded.size(), factor);
    return factor;
}

}  // namespace

std::string_view si_unit(Dimension dimension) {
    return row(dimension).unit;
}

std::string_view dimension_name(Dimension dimension) {
    return row(dimension).name;
}

SiConversion::SiConversion(std::string_view unit, Dimension expected) : expected_(expected) {
    const std::optional<Unit> from = read_unit(ascii_unit(unit));
    if (!from) throw InputError("the unit " + in_quotes(unit) + " is not known", allowed(expected));
    if (from->powers != read_unit(si_unit(expected))->powers)
        throw InputError(
            "the unit " + in_quotes(unit) + " is not one of " + std::string(dimension_name(expected)),
            allowed(expected));
    divides_ = from->factor < 1;
    factor_ = without_rounding_noise(divides_ ? 1 / from->factor : from->factor);
}

double SiConversion::operator()(double value) const {
    if (!std::isfinite(value)) throw InputError("the value is not finite", allowed(expected_));
    const double converted = divides_ ? value / factor_ : value * factor_;
    if (std::isfinite(converted)) return converted;
    throw InputError("the value is too large in SI units", allowed(expected_));
}

double to_si(double value, std::string_view unit, Dimension expected) {
    return SiConversion(unit, expected)(value);
}

double parse_quantity(std::string_view text, Dimension expected) {
    const std::string plain = ascii_unit(text);
    std::string_view rest = trimmed(plain);
    if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
    double value = 0;
    const auto [end, status] = decimal::read(rest.data(), rest.data() + rest.size(), value);
    if (status == std::errc::result_out_of_range)
        throw InputError(in_quotes(text) + " is outside the range of numbers", allowed(expected));
    if (status != std::errc{})
        throw InputError(in_quotes(text) + " does not start with a number", allowed(expected));
    if (!std::isfinite(value)) throw InputError(in_quotes(text) + " is not finite", allowed(expected));
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (rest.size() > 1 && (rest.front() == ',' || rest.front() == '.'))
        if (const std::string remedy = remedy_for_commas(trimmed(plain)); !remedy.empty())
            throw InputError(in_quotes(text) + " has a decimal comma, " + remedy, allowed(expected));
    const std::string_view unit = trimmed(rest);
    return unit.empty() ? value : to_si(value, unit, expected);
}

}  // namespace ashimpact
