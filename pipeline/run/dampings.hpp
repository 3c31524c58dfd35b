// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/inference/damping_laws.hpp"

namespace ashimpact {

/// A comparison of damping laws with what it was made of.
struct DampingStudy {
    DampingComparison comparison;
    std::vector<FittedDamping> fits;
};

/// Which damping law explains the impacts, by one contact law; none for too few impacts or without a rebound.
/// @param names of the samples
[[nodiscard]] std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                                         const std::vector<ImpactsOfSample>& samples,
                                                         const std::vector<std::string>& names);

/// The same for the samples of a run that have impacts by that contact law.
[[nodiscard]] std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                                         const ContactResult& contacts,
                                                         const RestitutionResult& restitutions);

}  // namespace ashimpact
