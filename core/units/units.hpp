// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ashimpact {

/// What a quantity measures. Inside the program every value is in the SI unit of its dimension.
enum class Dimension {
    fraction,
    length,
    mass,
    time,
    velocity,
    density,
    pressure,  ///< moduli too
    force,
    energy,
    energy_per_area,  ///< the same as a force per length
    damping,
    viscosity,
    inverse_velocity,
    impulse,
    temperature,  ///< absolute; units with an offset (C, F) are converted
    angle,
    angular_velocity,
};

/// Every dimension, with words for messages.
struct DimensionRow {
    Dimension dimension;
    std::string_view name;
    std::string_view unit;  ///< SI
    std::string_view examples;
};
inline constexpr std::array dimension_rows{
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
    DimensionRow{Dimension::inverse_velocity, "inverse velocity", "s/m", "0.2 s/m, 0.2 ms/mm"},
    DimensionRow{Dimension::impulse, "impulse", "N s", "1.9 nN s, 1.9e-9 kg m/s"},
    DimensionRow{Dimension::temperature, "temperature", "K", "1173 K, 900 C"},
    DimensionRow{Dimension::angle, "angle", "rad", "30 deg, 0.52 rad"},
    DimensionRow{Dimension::angular_velocity, "angular velocity", "rad/s", "1000 rad/s, 9550 rpm"},
};

/// Name of the SI unit of a dimension as files and tables show it: "Pa", "kg/m3", "1".
[[nodiscard]] std::string_view si_unit(Dimension dimension);

/// Name of a dimension for messages: "energy per area".
[[nodiscard]] std::string_view dimension_name(Dimension dimension);

/// Reads a quantity such as "44 um", "2160 kg/m3", "0.3 J m-2" or "10 %"; returns it [SI unit of the
/// dimension]. A number without a unit is SI. Units: see read_unit(). Errors: InputError for junk, NaN,
/// infinity, an unknown unit or one of another dimension.
[[nodiscard]] double parse_quantity(std::string_view text, Dimension expected);

/// Converts values of one unit to SI; the unit is looked up once. Errors as to_si().
class SiConversion {
  public:
    SiConversion(std::string_view unit, Dimension expected);
    /// [SI unit of the dimension], with one rounding where the unit is decimal.
    [[nodiscard]] double operator()(double value) const;

  private:
    Dimension expected_;
    double zero_ = 0;       ///< [SI] of the value 0, other than 0 for temperatures in C and F
    bool divides_ = false;  ///< powers of ten below one are not exact, their inverses are
    double factor_ = 1;
};

/// Converts a value to SI [SI unit of the dimension].
/// Errors: InputError for an unknown unit, one of another dimension, and for a value that is not finite.
[[nodiscard]] double to_si(double value, std::string_view unit, Dimension expected);

/// Likewise for a difference, such as an uncertainty: 10 C is 10 K.
[[nodiscard]] double difference_to_si(double value, std::string_view unit, Dimension expected);

/// A factor times powers of base units.
struct Unit {
    double factor = 1;
    std::array<double, 4> powers{};  ///< of m, kg, s, and one for all that is not mechanical (K, A, mol ...)
};

/// Reads a unit such as "kg/m3", "kg m-3", "N.s/m", "mJ/m^2" or "metres per second": from left to right,
/// products (blank, `.`, `*`, `-`), quotients (`/`, `per`), integer powers and brackets of what unit_named()
/// knows. A number is no unit, except "1". Returns nothing for any other text. @param text from ascii_unit()
[[nodiscard]] std::optional<Unit> read_unit(std::string_view text);

/// The unit of a symbol, where case matters, or of a name in any case; both with or without SI prefixes:
/// "um", "Micron", "kilograms". Nothing if the table has none.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

/// The text with `µ`, `μ`, `·`, `−`, superscript digits, no-break spaces, `Å` and `**` in ASCII.
[[nodiscard]] std::string ascii_unit(std::string_view text);

}  // namespace ashimpact
