// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/run.hpp"
#include "solver/inference/damping_explanation.hpp"

namespace ashimpact {

/// Which damping law explains the impacts of spheres, by one contact law; none without a rebound.
/// @param names of the spheres
[[nodiscard]] std::optional<DampingComparison> explained_dampings(const LawChoice& choice,
                                                                  const std::vector<ImpactsOfSphere>& spheres,
                                                                  const std::vector<std::string>& names);

/// The same for a run: each with the same constants for all samples, by the contact law
/// that most samples report. None without a reported law.
/// @param samples with the velocities that they report
[[nodiscard]] std::optional<DampingComparison> compare_dampings(const Case& data,
                                                                const ContactResult& contacts,
                                                                const RestitutionResult& restitutions,
                                                                const std::vector<SampleComparison>& samples);

}  // namespace ashimpact
