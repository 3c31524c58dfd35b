// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "materials/xrd/xrd.hpp"

/// The composition of a sample in JSON. A case and the project's own XRD results write it in the same way,
/// which docs/case.md describes.
namespace ashimpact::xrd {

/// Reads the fractions: "weight_fractions" or "volume_fractions" (an object with a fraction under the name of
/// each phase), "phases" (a list of such fractions with names) or "peaks". The place of each phase is its
/// JSON pointer. Errors: InputError with the JSON pointer for a fraction outside 0 to 1, a phase that is
/// there twice, and fractions given in more than one way or in none.
[[nodiscard]] Analysis read_fractions_json(const View& node);

/// Completes fractions, from any source, by the keys beside them: "densities" of single phases,
/// "amorphous", "amorphous_phase" and "internal_standard". What is not there stays as it is in @p analysis.
/// Errors: InputError with the JSON pointer for a density of no phase, and an amorphous part that is stated
/// twice.
[[nodiscard]] Analysis completed_by_json(Analysis analysis, const View& node);

}  // namespace ashimpact::xrd
