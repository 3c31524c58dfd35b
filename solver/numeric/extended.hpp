// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

/// The scalar solver's number type: its extra bits separate capture from rebound where the adhesive well is a
/// million times deeper than the kinetic energy.
#ifdef ASHIMPACT_DOUBLE_PRECISION  // WebAssembly has no wider numbers than double but in software, a hundred
                                   // times slower
using Extended = double;
#else
using Extended = long double;
#endif

/// Numbers in which Taylor series of a cohesive zone are computed; its states are Extended in any case.
enum class Precision {
    extended,  ///< Extended: exact to the rounding of double
    standard,  ///< double: a third of the time, for searches and batches
};

/// A number of that type with all the digits it has: 0.1_ext.
constexpr Extended operator""_ext(long double value) {
    return static_cast<Extended>(value);
}

}  // namespace ashimpact
