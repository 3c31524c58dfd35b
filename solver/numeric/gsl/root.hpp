// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace ashimpact::gsl {

/// How close a root is to be bracketed.
struct RootOptions {
    double relative = 1e-13;
    double absolute = 0.0;
    int most_iterations = 200;
};

struct RootSummary {
    double root;
    int iterations;
};

/// The root of @p function in [lower, upper], whose ends must differ in sign, by Brent's method.
/// @throws ConvergenceError
[[nodiscard]] RootSummary brent(const std::function<double(double)>& function, double lower, double upper,
                                const RootOptions& options = {});

}  // namespace ashimpact::gsl
