// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/checks.hpp"

#include <cmath>
#include <string>

#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

[[noreturn]] void refuse(std::string_view name, double value, Dimension dimension,
                         const std::string& allowed) {
    std::string problem = std::string(name) + " is " + shortest(value);
    if (dimension != Dimension::fraction) problem += " " + std::string(si_unit(dimension));
    throw InputError(problem, allowed);
}

/// "a positive mass [kg]"
std::string allowed_values(std::string_view adjective, Dimension dimension) {
    return "a " + std::string(adjective) + " " + std::string(dimension_name(dimension)) + " [" +
           std::string(si_unit(dimension)) + "]";
}

/// "1e-40 to 1e40 kg"
std::string computable_values(Dimension dimension) {
    std::string range{computable_range};
    if (dimension != Dimension::fraction) range += " " + std::string(si_unit(dimension));
    return range;
}

}  // namespace

void require_positive(std::string_view name, double value, Dimension dimension) {
    if (!(value > 0) || !std::isfinite(value))
        refuse(name, value, dimension, allowed_values("positive", dimension));
    if (!is_computable(value)) refuse(name, value, dimension, computable_values(dimension));
}

void require_positive_or_infinite(std::string_view name, double value, Dimension dimension) {
    if (!(value > 0)) refuse(name, value, dimension, allowed_values("positive", dimension));
}

void require_not_negative(std::string_view name, double value, Dimension dimension) {
    if (!(value >= 0) || !std::isfinite(value))
        refuse(name, value, dimension, allowed_values("non-negative", dimension));
    if (value != 0 && !is_computable(value))
        refuse(name, value, dimension, "0, or " + computable_values(dimension));
}

void require_poisson_ratio(std::string_view name, double value) {
    if (!(value > -1 && value <= 0.5)) refuse(name, value, Dimension::fraction, "-1 < Poisson ratio <= 0.5");
}

InputError unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
    return InputError("no " + std::string(kind) + " is called " + in_quotes(name) + did_you_mean(name, known),
                      joined(known));
}

void require_fraction(std::string_view name, double value) {
    if (!(value >= 0 && value <= 1)) refuse(name, value, Dimension::fraction, "0 to 1 (0 % to 100 %)");
}

}  // namespace ashimpact
