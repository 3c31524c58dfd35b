// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace ashimpact {

/// A part of the standard normal distribution between two cuts.
struct CutNormal {
    double lower;  ///< probability below the lower cut
    double width;  ///< probability between the cuts
    bool mirrored =
        false;  ///< both are those of the mirrored distribution, which keeps digits in the upper tail
};

/// A variable x with a normal x or ln x: x = offset + scale z, or x = scale exp(offset z), cut to [minimum,
/// maximum].
struct NormalScale {
    double offset;     ///< mean; of a logarithm its standard deviation
    double scale;      ///< standard deviation; of a logarithm the median of x
    bool logarithmic;  ///< whether ln x is normal
    double minimum;
    double maximum;
};

/// Replaces probabilities in (0, 1) by quantiles, several in each instruction: algorithm AS 241,
/// Wichura 1988; relative error below 4e-15. No bit of a value depends on the other ones.
void to_normal_quantiles(const CutNormal& cut, const NormalScale& scale, std::span<double> probabilities);

}  // namespace ashimpact
