// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// Which damping law explains the impacts: each with the same constants for all samples, by the contact law
/// that most samples report. None without a reported law or without a rebound.
/// @param samples with the velocities that they report
[[nodiscard]] std::optional<DampingComparison> compare_dampings(const Case& data,
                                                                const ContactResult& contacts,
                                                                const RestitutionResult& restitutions,
                                                                const std::vector<SampleComparison>& samples);

}  // namespace ashimpact
