// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/app/sweep/spec/spec.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"

namespace ashimpact {

/// The capture fraction of a sweep against each of its variables, from at most the first 8192 impacts of its
/// design, solved again. A variable of few values is taken value by value, others in sixteen parts of equally
/// many impacts.
[[nodiscard]] report::CaptureFractions capture_fractions(const SweepSpec& spec);

/// The same from the result of a sweep, whose provenance holds the spec. @throws InputError for an invalid
/// one
[[nodiscard]] report::CaptureFractions capture_fractions(const Json& artifact);

}  // namespace ashimpact
