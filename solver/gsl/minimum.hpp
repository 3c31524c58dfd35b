#pragma once

#include <functional>

namespace ashimpact::gsl {

/// Position of a minimum of @p function in [lower, upper] by Brent's method (GSL min).
/// @param guess between the ends; returned unchanged unless the function is less there than at both ends
/// @throws whatever the function throws
[[nodiscard]] double minimise_between(const std::function<double(double)>& function, double lower,
                                      double guess, double upper, double relative = 1e-4);

}  // namespace ashimpact::gsl
