// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units/units.hpp"

namespace ashimpact {

/// A value with its unit: SI, unless shown_quantity() took it from an artifact as it is.
struct Quantity {
    double value = 0;
    std::string unit = "1";
    std::optional<double> standard_uncertainty{};  ///< in the unit of the value
};

/// A quantity from a value that is already SI.
[[nodiscard]] Quantity make_quantity(double value, Dimension dimension,
                                     std::optional<double> standard_uncertainty = std::nullopt);

/// Which three digits behind a point may be thousands: "210.000" is seldom meant as 210, "1.234" often
/// as 1.234.
enum class PointDigits { zeros, any };

/// Refuses a text that begins with a number such as "210.000", which is 210 or 210000. @throws InputError
/// with both readings
void refuse_thousands_point(std::string_view text, PointDigits digits);

/// Reads "60 um", "60 +- 3 um", "60 um +- 5 %" or "60(3) um"; a number alone is SI. @throws InputError
[[nodiscard]] Quantity quantity_of_text(const std::string& text, Dimension expected);

/// Refuses an uncertainty that makes the value meaningless. @throws InputError
void require_uncertainty(const Quantity& quantity, Dimension dimension);

/// Refuses "10 % +- 10 %" of a fraction, which may be 10 +- 10 % or 10 +- 1 %, unless both are the same.
/// @param value [%] @param uncertainty [%] @param form of the two allowed texts: "{} +- {} %"
/// @throws InputError with both readings
void refuse_two_per_cents(std::string_view text, double value, double uncertainty, std::string_view form);

/// Refuses an uncertainty that nothing uses. @param subject of the message with a blank behind it, or empty
/// @throws InputError
void require_certain(const std::optional<double>& uncertainty, const std::string& subject,
                     const std::string& instead);

/// A number in the notations of refinement programs and spreadsheets.
struct PrintedNumber {
    double value = 0;
    std::optional<double> standard_uncertainty{};
    bool per_cent = false;  ///< a "%" follows the number; the value is not divided by 100
};

/// Reads "0.2548+-0.0029", "12.3 ± 0.4", "12.3 +/- 0.4", "12.3(4)", "12,3 %". An uncertainty of zero counts
/// as none. Returns nothing for any other text, or a number that is not finite.
[[nodiscard]] std::optional<PrintedNumber> read_number(std::string_view text, bool decimal_comma = false);

/// A value and its unit for a reader: four significant digits in the unit that keeps the number short
/// ("44 um", "148.1 GPa"). Files never hold this form.
[[nodiscard]] std::string readable(double value, std::string_view unit);

/// The same with the standard uncertainty to two digits and the value to the same decimal: "148.1 +- 9.2
/// GPa". An uncertainty of 1e-4 of the value or less is left out.
[[nodiscard]] std::string readable(const Quantity& quantity);

/// A line that explains "+-" if the text contains it, else an empty text.
[[nodiscard]] std::string uncertainty_legend(std::string_view text);

/// A number for a reader, with @p digits significant digits.
[[nodiscard]] std::string readable_number(double value, int digits = 4);

}  // namespace ashimpact
