// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/sizes.hpp"
#include "solver/inference/damping_laws.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

/// Dampings of impacts of one contact, laws and detachment by the batch solver, to its accuracy; NaN where it
/// has none.
[[nodiscard]] Eigen::ArrayXd near_dampings(const std::vector<DampingProblem>& problems);

/// A comparison of damping laws with what it was made of.
struct DampingStudy {
    DampingComparison comparison;
    std::vector<FittedDamping> fits;
};

/// Which damping law explains the impacts, by one contact law; none for too few impacts or without a rebound.
/// @param names of the samples @param scale_uncertainty as in EstimateOptions: part of those of the constants
[[nodiscard]] std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                                         const std::vector<ImpactsOfSample>& samples,
                                                         const std::vector<std::string>& names,
                                                         double scale_uncertainty);

/// The same for the samples of a run that have impacts by that contact law.
[[nodiscard]] std::optional<DampingStudy> study_dampings(const LawChoice& choice,
                                                         const ContactResult& contacts,
                                                         const RestitutionResult& restitutions,
                                                         double scale_uncertainty);

}  // namespace ashimpact
