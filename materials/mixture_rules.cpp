// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/mixture_rules.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

using Fractions = std::span<const double>;
using Phases = std::span<const IsotropicModuli>;

/// sum v_i f(x_i) over the phases that are there
template <class Value, class Function>
double mean(Fractions fractions, std::span<const Value> phases, Function function) {
    assert(fractions.size() == phases.size() && !fractions.empty());
    double sum = 0;
    for (std::size_t i = 0; i < fractions.size(); ++i)
        if (fractions[i] != 0) sum += fractions[i] * function(phases[i]);
    return sum;
}

/// [sum v_i/(x_i + offset)]^-1 - offset; grows with the offset from the harmonic to the arithmetic mean
template <class Function>
double shifted_harmonic_mean(Fractions fractions, Phases phases, double offset, Function modulus) {
    return 1 / mean(fractions, phases, [&](const IsotropicModuli& m) { return 1 / (modulus(m) + offset); }) -
           offset;
}

double bulk(const IsotropicModuli& moduli) {
    return moduli.bulk;
}
double shear(const IsotropicModuli& moduli) {
    return moduli.shear;
}

/// Walpole's bounds with a comparison medium of these moduli.
IsotropicModuli walpole_bounds(Fractions fractions, Phases phases, const IsotropicModuli& medium) {
    const double y = 4.0 / 3.0 * medium.shear;
    // A medium without shear modulus (pores) resists no change of shape, whatever its bulk modulus.
    const double z = medium.shear == 0 ? 0
                                       : medium.shear * (9 * medium.bulk + 8 * medium.shear) /
                                             (6 * (medium.bulk + 2 * medium.shear));
    return {.bulk = shifted_harmonic_mean(fractions, phases, y, bulk),
            .shear = shifted_harmonic_mean(fractions, phases, z, shear)};
}

/// The largest (std::max) or smallest (std::min) K and G of the phases that are there.
IsotropicModuli extreme_moduli(Fractions fractions, Phases phases,
                               const double& (*choose)(const double&, const double&)) {
    std::optional<IsotropicModuli> extreme;
    for (std::size_t i = 0; i < phases.size(); ++i) {
        if (fractions[i] == 0) continue;
        if (!extreme) extreme = phases[i];
        *extreme = {.bulk = choose(extreme->bulk, phases[i].bulk),
                    .shear = choose(extreme->shear, phases[i].shear)};
    }
    return extreme.value();
}

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

double parallel_young_modulus(Fractions volume_fractions, Fractions young_moduli) {
    return mean(volume_fractions, young_moduli, [](double e) { return e; });
}

double series_young_modulus(Fractions volume_fractions, Fractions young_moduli) {
    return 1 / mean(volume_fractions, young_moduli, [](double e) { return 1 / e; });
}

double hill_young_modulus(Fractions volume_fractions, Fractions young_moduli) {
    return (parallel_young_modulus(volume_fractions, young_moduli) +
            series_young_modulus(volume_fractions, young_moduli)) /
           2;
}

IsotropicModuli voigt_moduli(Fractions volume_fractions, Phases phases) {
    return {.bulk = mean(volume_fractions, phases, bulk), .shear = mean(volume_fractions, phases, shear)};
}

IsotropicModuli reuss_moduli(Fractions volume_fractions, Phases phases) {
    return {.bulk = shifted_harmonic_mean(volume_fractions, phases, 0, bulk),
            .shear = shifted_harmonic_mean(volume_fractions, phases, 0, shear)};
}

IsotropicModuli hill_moduli(Fractions volume_fractions, Phases phases) {
    const IsotropicModuli upper = voigt_moduli(volume_fractions, phases);
    const IsotropicModuli lower = reuss_moduli(volume_fractions, phases);
    return {.bulk = (upper.bulk + lower.bulk) / 2, .shear = (upper.shear + lower.shear) / 2};
}

IsotropicModuli hashin_shtrikman_lower(Fractions volume_fractions, Phases phases) {
    return walpole_bounds(volume_fractions, phases, extreme_moduli(volume_fractions, phases, std::min));
}

IsotropicModuli hashin_shtrikman_upper(Fractions volume_fractions, Phases phases) {
    return walpole_bounds(volume_fractions, phases, extreme_moduli(volume_fractions, phases, std::max));
}

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
