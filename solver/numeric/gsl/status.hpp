// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact::gsl {

/// Switches GSL's aborting error handler off; every wrapper here calls it and checks the status instead.
void quiet();

/// @throws ConvergenceError "<what>: <why>" unless @p status is GSL_SUCCESS
void check(int status, const char* what);

}  // namespace ashimpact::gsl
