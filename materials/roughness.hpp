// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

/// Roughness of the surfaces in contact; see roughness_reduction().
struct Roughness {
    double rms = 0;                    ///< root-mean-square height of both surfaces together [m]
    double closest_distance = 0.3e-9;  ///< H_0, distance of surfaces in contact [m]
};

/// Returns the factor by which roughness reduces the work of adhesion [1], by the modified Rumpf model of
/// Rabinovich et al. 2000 (J. Colloid Interface Sci. 232:10, after Rumpf 1990):
///
///     w_rough/w = 1/(1 + R*/(1.48 rms)) + 1/(1 + 1.48 rms/H_0)^2.
///
/// A hemispherical asperity of radius 1.48 rms separates sphere and wall. The first term is the van der
/// Waals force of the asperity on the sphere, the second that of the wall, which the asperity holds off. The
/// model gives the ratio of pull-off forces; it scales w here, since pull-off forces are proportional to w
/// R*. Validity: rms below about 20 nm and far below R*, one asperity under the contact, elastic deformation
/// small against the asperity (hard particles). 1 for rms = 0. A lower estimate: for wide asperities
/// Rabinovich et al. measured up to ten times more.
/// Errors: InputError for a negative rms or a radius or H_0 that is not positive.
[[nodiscard]] double roughness_reduction(double effective_radius, const Roughness& roughness);

}  // namespace ashimpact
