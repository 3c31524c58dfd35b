// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/elastic_moduli.hpp"

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

IsotropicModuli isotropic_moduli(double young_modulus, double poisson_ratio) {
    require_positive("young_modulus", young_modulus, Dimension::pressure);
    require_poisson_ratio("poisson_ratio", poisson_ratio);
    if (poisson_ratio == 0.5)
        throw InputError("poisson_ratio is 0.5, which has no finite bulk modulus",
                         "-1 < Poisson ratio < 0.5");
    return {.bulk = young_modulus / (3 * (1 - 2 * poisson_ratio)),
            .shear = young_modulus / (2 * (1 + poisson_ratio))};
}

double young_modulus(const IsotropicModuli& moduli) {
    const double sum = 3 * moduli.bulk + moduli.shear;
    return sum == 0 ? 0 : 9 * moduli.bulk * moduli.shear / sum;
}

double poisson_ratio(const IsotropicModuli& moduli) {
    return (3 * moduli.bulk - 2 * moduli.shear) / (2 * (3 * moduli.bulk + moduli.shear));
}

}  // namespace ashimpact
