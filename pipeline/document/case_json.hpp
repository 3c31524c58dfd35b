// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/document.hpp"
#include "pipeline/case/case.hpp"

namespace ashimpact {

/// The case, complete, as a case document: reading it back gives the same case.
[[nodiscard]] Json case_json(const Case& data);

/// a, b and c of a published fit.
[[nodiscard]] Json quadratic_json(const DampingPolynomial& fit);

/// Impacts in the columns that read_measurement_columns() reads.
[[nodiscard]] Json measurement_columns(const MeasurementSet& set);

}  // namespace ashimpact
