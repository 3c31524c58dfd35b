#pragma once

#include <functional>
#include <string_view>

#include "solver/contact/registry.hpp"
#include "solver/uncertainty/likelihood/damping_curve_fit.hpp"
#include "tests/solver/uncertainty/synthetic_laboratory.hpp"

namespace ashimpact::test {

/// How often intervals contained the truth.
struct Coverage {
    int repetitions = 0;
    int failures = 0;       ///< of the fit; they count as missed
    int damping_above = 0;  ///< the whole interval of eta_c lies above the truth
    int damping_below = 0;
    int velocity = 0;    ///< intervals of v_c that contain the truth
    double bias = 0.0;   ///< mean of eta_c over the truth, less one
    double width = 0.0;  ///< mean half width of the bounded intervals of eta_c over the truth

    [[nodiscard]] int damping() const { return repetitions - failures - damping_above - damping_below; }
};

/// A true damping curve for the 96 um sample of Dong et al. 2013.
enum class TrueDamping {
    quadratic,    ///< the law's row of Table 2; that of Brach-Dunn for laws without one
    exponential,  ///< c (0.35 + 0.65 exp(-2.4 e))
    bent,         ///< c (1 - 0.7 e - 0.2 tanh(4 e) + 0.2 e^2)
};

[[nodiscard]] std::string_view name_of(TrueDamping damping);

/// A contact of the 96 um sample and a map of the law around the velocities of its impacts.
[[nodiscard]] ContactModel ash_model(Law law);

/// 60 impacts between 0.6 and 3 times v_c, seen by the paper's camera (80,000 frames/s) with pixels of 8 um
/// and 5 frames for each velocity: 0.058 m/s.
[[nodiscard]] SyntheticLaboratory ash_laboratory(const ContactModel& model, TrueDamping damping);

/// Repeats the measurements of a laboratory and their fit.
[[nodiscard]] Coverage coverage_of(const SyntheticLaboratory& laboratory, const DampingCurveOptions& options,
                                   int repetitions, unsigned long seed);

}  // namespace ashimpact::test
