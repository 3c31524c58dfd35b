// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

/// Bulk and shear modulus of an isotropic solid, in which the rigorous bounds are written.
struct IsotropicModuli {
    double bulk = 0;   ///< K [Pa]
    double shear = 0;  ///< G [Pa]
};

/// Returns K and G from E [Pa] and nu [1]: K = E/(3(1 - 2 nu)), G = E/(2(1 + nu)).
/// Errors: InputError for E <= 0 or nu outside (-1, 0.5); at 0.5 the bulk modulus is infinite.
[[nodiscard]] IsotropicModuli isotropic_moduli(double young_modulus, double poisson_ratio);

/// Returns Young's modulus [Pa]: E = 9KG/(3K + G); it grows with K and with G. Zero if either is zero.
[[nodiscard]] double young_modulus(const IsotropicModuli& moduli);

/// Returns Poisson's ratio [1]: nu = (3K - 2G)/(2(3K + G)). Validity: not both zero, as of a pore.
[[nodiscard]] double poisson_ratio(const IsotropicModuli& moduli);

}  // namespace ashimpact
