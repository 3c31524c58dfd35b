// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/glass/properties.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/quantities/checks.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

/// Coefficients of Makishima & Mackenzie for one oxide.
struct ElasticOxide {
    std::string_view formula;
    double dissociation_energy;  ///< G_i per volume [Pa]
    double packing_volume;       ///< V_i [m3/mol]
};

constexpr std::array elastic_oxides{
    ElasticOxide{"SiO2", 68e9, 14e-6},      ElasticOxide{"Al2O3", 131e9, 21e-6},
    ElasticOxide{"Fe2O3", 78.5e9, 21.6e-6}, ElasticOxide{"CaO", 64.1e9, 9.4e-6},
    ElasticOxide{"MgO", 90e9, 7.6e-6},      ElasticOxide{"Na2O", 31.9e9, 11.2e-6},
    ElasticOxide{"K2O", 19.2e9, 18.8e-6},   ElasticOxide{"TiO2", 101.2e9, 14.6e-6},
    ElasticOxide{"P2O5", 28.2e9, 34.8e-6},
};

/// Amounts of substance of one melt, with iron as FeO, in any unit.
struct Melt {
    double si, ti, al, fe, mn, mg, ca, na, k, p, zr, b;

    explicit Melt(const OxideAmounts& weight_fractions) {
        const OxideAmounts moles = mole_fractions(weight_fractions);
        const auto of = [&](std::string_view formula) { return moles[oxide_index(formula)]; };
        si = of("SiO2"), ti = of("TiO2"), al = of("Al2O3"), fe = 2 * of("Fe2O3"), mn = of("MnO");
        mg = of("MgO"), ca = of("CaO"), na = of("Na2O"), k = of("K2O"), p = of("P2O5");
        zr = of("ZrO2"), b = of("B2O3");
    }
};

struct GiordanoConstants {
    double b, c;  ///< [K]
};

GiordanoConstants giordano_constants(Melt melt) {
    const double total =
        melt.si + melt.ti + melt.al + melt.fe + melt.mn + melt.mg + melt.ca + melt.na + melt.k + melt.p;
    for (double* each :
         {&melt.si, &melt.ti, &melt.al, &melt.fe, &melt.mn, &melt.mg, &melt.ca, &melt.na, &melt.k, &melt.p})
        *each *= 100 / total;
    const double ti_al = melt.ti + melt.al;
    const double fe_mg = melt.fe + melt.mn + melt.mg;
    const double alkali = melt.na + melt.k;
    const double b = 159.56 * (melt.si + melt.ti) - 173.34 * melt.al + 72.13 * (melt.fe + melt.mn + melt.p) +
                     75.69 * melt.mg - 38.98 * melt.ca - 84.08 * melt.na -
                     2.43 * (melt.si + melt.ti) * fe_mg - 0.91 * (melt.si + ti_al + melt.p) * alkali +
                     17.62 * melt.al * alkali;
    const double c = 2.75 * melt.si + 15.72 * ti_al + 8.32 * fe_mg + 10.20 * melt.ca - 12.29 * alkali +
                     0.30 * (melt.al + fe_mg + melt.ca - melt.p) * alkali;
    return {b, c};
}

/// B of Urbain et al. 1981 [1000 K]: a cubic in the share of network formers, whose coefficients are
/// quadratic in the share of modifiers in the rest.
double urbain_constant(const Melt& melt) {
    const double formers = melt.si + melt.p;
    const double modifiers =
        melt.ca + melt.mg + melt.na + melt.k + melt.fe + melt.mn + 2 * (melt.ti + melt.zr);
    const double amphoterics = melt.al + melt.b;
    const double rest = modifiers + amphoterics;
    const double share = formers / (formers + rest);
    const double alpha = rest > 0 ? modifiers / rest : 0;
    constexpr std::array<std::array<double, 3>, 4> coefficients{{{13.8, 39.9355, -44.049},
                                                                 {30.481, -117.1505, 129.9978},
                                                                 {-40.9429, 234.0486, -300.04},
                                                                 {60.7619, -153.9276, 211.1616}}};
    double b = 0;
    double power = 1;
    for (const auto& [constant, linear, square] : coefficients) {
        b += power * (constant + alpha * (linear + alpha * square));
        power *= share;
    }
    return b;
}

constexpr double giordano_a = -4.55;  // log10 of the viscosity in Pa s at infinite temperature

/// log10(0.1 A T exp(1000 B/T)) of Urbain, and its A.
double urbain_log10(double b, double temperature) {
    const double ln_a = -(0.2693 * b + 11.6725);
    return (std::log(0.1 * temperature) + ln_a + 1000 * b / temperature) / std::numbers::ln10;
}

}  // namespace

ElasticBody makishima_mackenzie(const OxideAmounts& weight_fractions, double density) {
    require_positive("density of the glass", density, Dimension::density);
    OxideAmounts known = no_oxides();
    for (const ElasticOxide& oxide : elastic_oxides) {
        const std::size_t i = oxide_index(oxide.formula);
        known[i] = weight_fractions[i];
    }
    const OxideAmounts x = mole_fractions(known);
    double mass = 0;
    double volume = 0;
    double energy = 0;
    for (const ElasticOxide& oxide : elastic_oxides) {
        const double share = x[oxide_index(oxide.formula)];
        mass += share * molar_mass(oxide.formula);
        volume += share * oxide.packing_volume;
        energy += share * oxide.dissociation_energy;
    }
    if (!(mass > 0))
        throw InputError("the glass has none of the oxides of which Makishima & Mackenzie know its modulus",
                         "SiO2, Al2O3, CaO or another of their nine oxides");
    const double packing = density / mass * volume;
    const ElasticBody glass{.young_modulus = 2 * packing * energy,
                            .poisson_ratio = 0.5 - 1 / (7.2 * packing)};
    if (!(glass.poisson_ratio > -1))
        throw InputError("with a density of " + shortest(density) + " kg/m3 the glass has no Poisson ratio",
                         "the density of a dense glass, 2200 to 3000 kg/m3");
    return glass;
}

double share_without_coefficients(const OxideAmounts& weight_fractions) {
    double total = 0;
    double known = 0;
    for (const double fraction : weight_fractions) total += fraction;
    for (const ElasticOxide& oxide : elastic_oxides) known += weight_fractions[oxide_index(oxide.formula)];
    return total > 0 ? (total - known) / total : 0;
}

MeltViscosity::MeltViscosity(ViscosityModel model, const OxideAmounts& weight_fractions) : model_(model) {
    const Melt melt(weight_fractions);
    if (!(melt.si + melt.p > 0))
        throw InputError("the melt has no SiO2, so that its viscosity is not known", "a silicate glass");
    if (model == ViscosityModel::urbain1981) {
        b_ = urbain_constant(melt);
        return;
    }
    const auto [b, c] = giordano_constants(melt);
    b_ = b;
    c_ = c;
}

double MeltViscosity::log10_at(double temperature) const {
    if (model_ == ViscosityModel::urbain1981) return urbain_log10(b_, temperature);
    return temperature > c_ ? giordano_a + b_ / (temperature - c_) : std::numeric_limits<double>::infinity();
}

double MeltViscosity::temperature_at(double log10_viscosity) const {
    if (model_ == ViscosityModel::giordano2008) {
        if (!(log10_viscosity > giordano_a)) return std::numeric_limits<double>::infinity();
        return c_ + b_ / (log10_viscosity - giordano_a);
    }
    // The viscosity falls with temperature up to T = 1000 B.
    double low = 1;
    double high = 1000 * b_;
    if (!(high > low) || urbain_log10(b_, high) > log10_viscosity)
        return std::numeric_limits<double>::infinity();
    constexpr int halvings = 100;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (urbain_log10(b_, middle) > log10_viscosity ? low : high) = middle;
    }
    return (low + high) / 2;
}

ContactRegime contact_regime(double relaxation_over_contact) {
    if (relaxation_over_contact >= elastic_ratio) return ContactRegime::elastic;
    return relaxation_over_contact > liquid_ratio ? ContactRegime::viscoelastic : ContactRegime::liquid;
}

double shear_modulus(const ElasticBody& body) {
    return body.young_modulus / (2 * (1 + body.poisson_ratio));
}

double log10_viscosity_of_ratio(double ratio, double shear_modulus, double contact_time) {
    return std::log10(ratio * shear_modulus * contact_time);
}

}  // namespace ashimpact
