#pragma once

#include <array>
#include <string>

#include "solver/contact/registry.hpp"
#include "solver/uncertainty/damping_curve_fit.hpp"
#include "tests/solver/uncertainty/synthetic_laboratory.hpp"

namespace ashimpact::test {

/// How often intervals contained the truth.
struct Coverage {
    int repetitions = 0;
    int failures = 0;  ///< of the fit
    int damping_above = 0;   ///< the whole interval of eta_c lies above the truth
    int damping_below = 0;
    int velocity = 0;  ///< intervals of v_c that contain the truth
    double bias = 0.0;    ///< mean of eta_c over the truth, less one
    double width = 0.0;  ///< mean half width of the bounded intervals of eta_c over the truth

    [[nodiscard]] double of_damping() const {
        return 1.0 - static_cast<double>(damping_above + damping_below + failures) / repetitions;
    }
    [[nodiscard]] double of_velocity() const { return static_cast<double>(velocity) / repetitions; }
};

/// Repeats the measurements of a laboratory and their fit.
[[nodiscard]] Coverage coverage_of(const SyntheticLaboratory& laboratory, const DampingCurveOptions& options,
                                   int repetitions, unsigned long seed);

}  // namespace ashimpact::test
