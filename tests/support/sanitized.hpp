// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact::test {

/// Whether this is a build with sanitizers, in which a program takes some ten times as long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace ashimpact::test
