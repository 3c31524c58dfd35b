#pragma once

#include "solver/measurement/damping_parts.hpp"
#include "solver/measurement/inversion.hpp"
#include "solver/uncertainty/curve/headline.hpp"
#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"
#include "solver/uncertainty/outcomes/estimate_comparison.hpp"
#include "solver/uncertainty/outcomes/measured_critical_velocity.hpp"
#include "solver/uncertainty/propagation/critical_velocity_uncertainty.hpp"
#include "solver/uncertainty/propagation/random_contact.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ashimpact {

struct MeasuredDampingOptions {
    PartOptions parts{};
    DampingCurveOptions extrapolated{};
    std::optional<double>
        size_scatter{};  ///< of single diameters about their mean, relative, where it is known
    /// End of the rising branch, where it is known: the impacts are then not inverted again [m/s].
    std::optional<double> rising_to{};
    bool propagate = true;  ///< also the contact's uncertainty, not only that of the impacts
    DampingUnderChange change = DampingUnderChange::reread;
    PropagationOptions propagation{};
    /// A critical velocity reported beside the impacts; none: that of their outcomes [m/s].
    std::optional<MeasuredCriticalVelocity> reported{};
};

/// A fit with what follows from it.
struct DampingResult {
    DampingCurveFit fit;
    std::optional<Propagation> propagation;  ///< of v_c, everything uncertain; none: not asked for
    CriticalVelocityCheck check;             ///< of v_c, propagated where that was asked for
};

/// The analysis of the impacts of one sample under one law. Parts that the data do not support are missing;
/// the notes say why.
struct MeasuredDamping {
    Law law;
    Detachment detachment;
    ContactPair contact;
    std::vector<InvertedImpact> impacts;               ///< in the order of the set
    std::optional<DampingSmoothing> smoothing;         ///< eta(v_in) as a smooth curve
    DampingParts parts;                                ///< with the flagged outliers
    std::optional<RisingBranch> rising;                ///< what the extrapolation uses
    std::optional<DampingResult> extrapolated;         ///< the paper's way
    std::optional<CriticalVelocityEstimate> estimate;  ///< the headline, from all impacts
    std::optional<CriticalVelocityCheck> check;        ///< of the estimate by the measured v_c
    std::optional<FitComparison> comparison;           ///< of estimate and extrapolation
    MeasuredCriticalVelocity measured;                 ///< reported, or from the outcomes
    double accuracy;  ///< of restitutions read from the law's map; 0: solved [1]
    std::vector<std::string> notes;
};

/// Velocities that fits of a set may need: an extrapolated v_c and its interval lie below the data.
/// @param set not empty
[[nodiscard]] VelocityRange velocities_for_fits(Law law, Detachment detachment, const ContactPair& contact,
                                                const MeasurementSet& set);

/// The whole analysis of a series of impacts with constant damping: inversion, parts of eta(v_in), rising
/// branch, fits, v_c with its interval beside the measured one.
///
/// A law with a history (a contact that yields) is inverted by solving impacts and not fitted.
/// @param contact properties with what is known of their uncertainty
/// @throws InputError for impacts that are none (no point, numbers not finite, v_in <= 0, v_r < 0) or an
/// unphysical contact
[[nodiscard]] MeasuredDamping analyse_impacts(Law law, Detachment detachment, const RandomContact& contact,
                                              const MeasurementSet& set,
                                              const MeasuredDampingOptions& options = {});

/// The same with a given model, for a contact without history.
/// @param contact null: what is known of the contact is not propagated
[[nodiscard]] MeasuredDamping analyse_impacts(const ContactModel& model, const RandomContact* contact,
                                              const MeasurementSet& set,
                                              const MeasuredDampingOptions& options = {});

}  // namespace ashimpact
