// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// Reads a table of measured impacts: comma, semicolon or tab; a heading with units, then one impact a line.
///
///     v_in [m/s]; v_r (mm/s); u(v_in) [m/s]; u(v_r) [m/s]
///     1,95; 120; 0,02; 0,02
///
/// Columns, under several names: the incident velocity v_in, and the rebound velocity v_r (a magnitude) or
/// the restitution e_n; their standard uncertainties u(...), or "1.95 ± 0.02" in the cell. e_n may be in per
/// cent. A decimal comma is understood where the comma does not separate.
///
/// A column "outcome" holds rebound, capture or unknown. If it is empty or missing the reading decides: v_r =
/// 0, or a word for it such as "captured", is a capture; an empty cell or "unknown" is not known, and such an
/// impact is counted and left out. A reading below zero is taken for zero where noise explains it: within 6
/// standard uncertainties, or without those within a tenth of v_in. A column "correlation" holds that of the
/// errors of v_in and v_r.
/// Uncertainties of one velocity only are taken for the other, too; those of v_in and e_n as independent.
/// Other columns are left out with a warning, lines that begin with # without one.
/// The table may be a sheet of a spreadsheet (.xlsx, .ods): the one of that name, else the only one that
/// holds one. Errors: InputError "NAME: line N: problem; allowed: ..." for anything that is not that; of a
/// spreadsheet the place is `sheet "S", cell B7`.
[[nodiscard]] MeasurementSet read_measurements(std::string_view text, std::string_view name,
                                               std::string_view sheet = {});

}  // namespace ashimpact
