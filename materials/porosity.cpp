// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/porosity.hpp"

#include <array>
#include <cmath>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/mixture_rules.hpp"

namespace ashimpact {

namespace {

/// The porosities for which a law holds.
struct Validity {
    double lowest = 0;
    double highest = 1;
};

Validity validity_of(PorosityLaw law) {
    if (law == PorosityLaw::coble_kingery) return {.highest = 0.5};
    if (law == PorosityLaw::gibson_ashby) return {.lowest = 0.7};
    return {};
}

PorousModuli with_pores_as_a_phase(const PorousModuli& dense, double p) {
    if (!dense.poisson_ratio)
        throw InputError("the law hashin-shtrikman needs Poisson's ratio, which is not known for every phase",
                         "another law, or Poisson's ratios in the case file");
    const std::array phases{isotropic_moduli(dense.young_modulus, *dense.poisson_ratio), IsotropicModuli{}};
    const IsotropicModuli moduli = hashin_shtrikman_upper(std::array{1 - p, p}, phases);
    return {.young_modulus = young_modulus(moduli), .poisson_ratio = poisson_ratio(moduli)};
}

}  // namespace

void require_valid(const Porosity& porosity) {
    if (!(porosity.value >= 0 && porosity.value < 1))
        throw InputError("porosity is " + shortest(porosity.value), "0 <= porosity < 1");
    if (porosity.law == PorosityLaw::spriggs && !porosity.coefficient)
        throw InputError("the law spriggs has no coefficient b", "b of E = E0 exp(-b P), usually 2 to 5");
    if (porosity.coefficient && porosity.law != PorosityLaw::spriggs)
        throw InputError("the law " + std::string(name_of(porosity.law)) + " has no coefficient", "none");
    if (porosity.coefficient) require_positive("coefficient b", *porosity.coefficient, Dimension::fraction);
    if (porosity.standard_uncertainty)
        require_not_negative("uncertainty of the porosity", *porosity.standard_uncertainty,
                             Dimension::fraction);
}

PorousModuli porous_moduli(const PorousModuli& dense, const Porosity& porosity) {
    const double p = porosity.value;
    PorousModuli porous = dense;
    switch (porosity.law) {
        case PorosityLaw::hashin_shtrikman:
            return with_pores_as_a_phase(dense, p);
        case PorosityLaw::coble_kingery:
            porous.young_modulus *= 1 - 1.9 * p + 0.9 * p * p;
            break;
        case PorosityLaw::pabst_gregorova:
            porous.young_modulus *= std::exp(-2 * p / (1 - p));
            break;
        case PorosityLaw::spriggs:
            porous.young_modulus *= std::exp(-porosity.coefficient.value() * p);
            break;
        case PorosityLaw::gibson_ashby:
            porous.young_modulus *= (1 - p) * (1 - p);
            break;
    }
    return porous;
}

std::string porosity_warning(const Porosity& porosity) {
    const Validity validity = validity_of(porosity.law);
    if (porosity.value >= validity.lowest && porosity.value <= validity.highest) return {};
    return "the porosity " + shortest(porosity.value) + " is outside the validity of the law " +
           std::string(name_of(porosity.law)) + ", " + shortest(validity.lowest) + " to " +
           shortest(validity.highest);
}

double porosity_from_densities(double apparent_density, double true_density) {
    require_positive("apparent density", apparent_density, Dimension::density);
    require_positive("true density", true_density, Dimension::density);
    if (apparent_density > true_density)
        throw InputError("the apparent density " + shortest(apparent_density) +
                             " kg/m3 is above the true density " + shortest(true_density) + " kg/m3",
                         "apparent density <= true density");
    return 1 - apparent_density / true_density;
}

}  // namespace ashimpact
