#pragma once

#include "solver/measurement/contact_model.hpp"
#include "solver/uncertainty/likelihood/restitution_data.hpp"

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace ashimpact {

enum class Exclusion {
    above_reach,  ///< v_r exceeds v_in by more than three standard uncertainties, or at all if those are
                  ///< unknown
};

struct ExcludedRebound {
    std::size_t index;
    Exclusion reason;
};

/// Rebounds up to which likelihoods are taken as they are: what is wrong by much less than their noise in
/// each is not seen, and everything can be computed with all of them.
inline constexpr std::size_t few_rebounds = 400;

/// The rebounds of a set that a fit can use, and where they stand in it.
struct ReboundSelection {
    RestitutionData data;  ///< without captures; noise that is not known is 1 m/s
    std::vector<std::size_t> indices;
    std::vector<ExcludedRebound> excluded;
    bool noise_known;
};

[[nodiscard]] ReboundSelection select_rebounds(const ContactModel& model, const MeasurementSet& set);

/// @throws InputError unless there are enough distinct rebounds for a curve of this order
void require_enough(const ReboundSelection& selection, const MeasurementSet& set, int order);

/// Least squares of the inverted damping on the restitution: biased by the noise in both, but close; of a
/// lower order where that of @p order gives no curve. @throws ConvergenceError where none does
[[nodiscard]] Eigen::VectorXd starting_coefficients(const ContactModel& model, const RestitutionData& data,
                                                    int order);

/// Rebounds whose likelihood does not depend on where the velocities end that a laboratory aimed at: all true
/// velocities are taken as equally likely, but close to the fastest none lie above. Of a few hundred that
/// cannot be told from chance; of more, those within three standard uncertainties of that end are left out.
/// A choice by v_in alone has no effect on what the others say.
[[nodiscard]] RestitutionData away_from_fastest(const RestitutionData& data);

/// The captures of a set; noise that is not known is 1 m/s.
[[nodiscard]] std::vector<CapturedImpact> captures_of(const MeasurementSet& set);

}  // namespace ashimpact
