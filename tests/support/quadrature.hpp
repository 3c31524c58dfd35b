// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace ashimpact::test {

/// Integral of @p function from @p lower to @p upper by GSL's adaptive Gauss-Kronrod rule, to 1e-13 of itself
/// or of @p size, whichever is larger: a check on the solver that shares no line with it.
/// @throws std::runtime_error where GSL reports a failure
[[nodiscard]] double integral(const std::function<double(double)>& function, double lower, double upper,
                              double size = 0.0);

}  // namespace ashimpact::test
