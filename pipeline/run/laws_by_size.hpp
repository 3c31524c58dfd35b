// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

/// Sizes of a picture of the field: 10 nm to 1 mm, four a decade [m].
[[nodiscard]] const std::vector<double>& sizes_of_the_field();

/// v_c of a law over the sizes of the field. Sizes without a finite v_c, with one beyond fastest_in_model, or
/// where the law does not hold are left out.
/// @param problem_of the impact of a sphere of a diameter [m]
[[nodiscard]] LawBySize law_by_size(Law law,
                                    const std::function<CriticalVelocityProblem(double)>& problem_of);

/// Adhesion alone: the laws of a run that have a v_c without damping, and jkr, by the contacts of the
/// samples. Beyond the sizes of the samples the properties of the nearest one hold.
[[nodiscard]] std::vector<LawBySize> laws_by_size(const std::vector<LawChoice>& laws,
                                                  const ContactResult& contacts);

}  // namespace ashimpact
