// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace ashimpact {

/// What a quantity measures. Inside the program every value is in the SI unit of its dimension.
enum class Dimension {
    fraction,         ///< [1]; "10 %" is 0.1
    length,           ///< [m]
    mass,             ///< [kg]
    time,             ///< [s]
    velocity,         ///< [m/s]
    density,          ///< [kg/m3]
    pressure,         ///< [Pa], moduli too
    force,            ///< [N]
    energy,           ///< [J]
    energy_per_area,  ///< [J/m2], the same as N/m
    damping,          ///< [kg/s], the same as N s/m
    viscosity,        ///< [Pa s]
    impulse,          ///< [N s], the same as kg m/s
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
    bool divides_ = false;  ///< powers of ten below one are not exact, their inverses are
    double factor_ = 1;
};

/// Converts a value to SI [SI unit of the dimension].
/// Errors: InputError for an unknown unit, one of another dimension or one with an offset (degC), and for a
/// value that is not finite.
[[nodiscard]] double to_si(double value, std::string_view unit, Dimension expected);

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
