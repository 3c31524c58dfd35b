#pragma once

#include "solver/measurement/measurement.hpp"

#include <string_view>

namespace ashimpact {

/// Reads a table of measured impacts: comma, semicolon or tab; a heading with units, then one impact a line.
///
///     v_in [m/s]; v_r (mm/s); u(v_in) [m/s]; u(v_r) [m/s]
///     1,95; 120; 0,02; 0,02
///
/// Columns, under several names: the incident velocity v_in, and the rebound velocity v_r (a magnitude) or
/// the restitution e_n; their standard uncertainties u(...), or "1.95 ± 0.02" in the cell. e_n may be in per
/// cent. A decimal comma is understood where the comma does not separate. v_r = 0 or e_n = 0 is a capture.
/// Uncertainties of one velocity only are taken for the other, too; those of v_in and e_n as independent.
/// Other columns are left out with a warning, lines that begin with # without one.
/// Errors: InputError "NAME: line N: problem; allowed: ..." for anything that is not that.
[[nodiscard]] MeasurementSet read_measurements(std::string_view text, std::string_view name);

}  // namespace ashimpact
