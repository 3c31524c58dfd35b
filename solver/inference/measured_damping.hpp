// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/finding.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/impacts/inverted_impacts.hpp"

namespace ashimpact {

/// Whether the paper's extrapolation and the estimate from all impacts agree.
struct FitComparison {
    double critical_damping_ratio;   ///< of the estimate to the extrapolated [1]
    double critical_velocity_ratio;  ///< [1]
    bool consistent;        ///< whether they differ by no more than estimates from the same impacts may
    std::string statement;  ///< in words
};

struct MeasuredDampingOptions {
    PartOptions parts{};
    DampingCurveOptions extrapolated{};
    EstimateOptions estimate{};
    /// End of the rising branch, if known: the impacts are then not inverted again [m/s].
    std::optional<double> rising_to{};
    const OnsetEstimate* velocity = nullptr;  ///< estimate_without_law() of the set, if it is known
};

/// Results of the impacts of one sample under one law. Results that the data do not allow are missing; the
/// findings give the reasons.
struct MeasuredDamping {
    Law law;
    Detachment detachment;
    ContactPair contact;
    std::vector<InvertedImpact> impacts{};        ///< in the order of the set
    std::optional<DampingSmoothing> smoothing{};  ///< eta(v_in) as a smooth curve
    DampingParts parts{};                         ///< with the flagged outliers
    /// What the extrapolation uses: every impact, if outliers hide the branch.
    std::optional<RisingBranch> rising{};
    std::optional<DampingCurveFit> extrapolated{};       ///< the paper's way
    std::optional<CriticalVelocityEstimate> estimate{};  ///< the headline: what the impacts support
    std::optional<FitComparison> comparison{};           ///< of the two
    MeasuredCriticalVelocity measured{};                 ///< from the outcomes alone
    double accuracy = 0.0;  ///< of restitutions read from the law's map; 0: solved [1]
    std::vector<Finding> findings{};
};

/// Velocities that a fit of a set may need [m/s]. They reach below the data, where an extrapolated v_c and
/// its interval lie.
/// @param set not empty
[[nodiscard]] VelocityRange velocities_for_fits(Law law, Detachment detachment, const ContactPair& contact,
                                                const MeasurementSet& set);

/// The whole analysis of a series of impacts with constant damping: inversion, parts of eta(v_in), rising
/// branch, fits, v_c with its interval beside the measured one. Intervals hold for the contact as given; see
/// propagate_critical_velocity() for its uncertainty.
///
/// A law with a history (a contact that yields) is inverted by solving impacts and not fitted.
/// @throws InputError for invalid impacts (no point, numbers not finite, v_in <= 0, v_r < 0) or an unphysical
/// contact
[[nodiscard]] MeasuredDamping analyse_impacts(Law law, Detachment detachment, const ContactPair& contact,
                                              const MeasurementSet& set,
                                              const MeasuredDampingOptions& options = {});

/// Like the above, but with an existing model of a contact without history.
[[nodiscard]] MeasuredDamping analyse_impacts(const ContactModel& model, const MeasurementSet& set,
                                              const MeasuredDampingOptions& options = {});

}  // namespace ashimpact
