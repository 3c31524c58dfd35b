#pragma once

#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"
#include "solver/uncertainty/likelihood/likelihood_maximum.hpp"

namespace ashimpact {

/// How well the rebounds are fitted, with the noise as given.
struct Goodness {
    double chi_squared;
    int degrees_of_freedom;
    double probability;
    double scatter;
};

/// A fitted curve, the noise it was fitted with, and its interval.
struct FittedCurve {
    LikelihoodMaximum maximum;
    Goodness goodness;
    RestitutionData data;
    std::size_t used;  ///< rebounds in the likelihood
    Interval critical_damping;
    bool profiled;
};

/// Fits eta(e_n): by the closest curve where the noise is negligible, else by the most likely one.
/// @param data with the noise as it was measured, or 1 m/s where that is not known
/// @throws ConvergenceError
[[nodiscard]] FittedCurve fit_curve(const ContactModel& model, RestitutionData data,
                                    const DampingCurveOptions& options, bool noise_known);

}  // namespace ashimpact
