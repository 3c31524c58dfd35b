// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/quantities/names.hpp"
#include "materials/contact_properties.hpp"
#include "materials/glass/chemistry.hpp"

/// Elasticity and viscosity of a glass from its oxides.
namespace ashimpact {

/// Relative standard uncertainty of Young's modulus by Makishima & Mackenzie [1].
inline constexpr double makishima_mackenzie_uncertainty = 0.07;

/// Returns Young's modulus [Pa] and Poisson's ratio [1] of a glass of that density [kg/m3]:
///     E = 2 V_t sum(G_i x_i),  nu = 1/2 - 1/(7.2 V_t),  V_t = (rho/M) sum(V_i x_i),
/// with mole fractions x_i, the mean molar mass M, dissociation energies per volume G_i and packing volumes
/// V_i of SiO2, Al2O3, Fe2O3, CaO, MgO, Na2O, K2O, TiO2 and P2O5. Sources: Makishima & Mackenzie 1973
/// (J. Non-Cryst. Solids 12:35) for E, 1975 (17:147) for nu. All iron counts as Fe2O3. Other oxides have no
/// coefficients and are left out; see share_without_coefficients().
/// Errors: InputError if no oxide has coefficients, for a density that is not positive, and for one with
/// which the ratio is outside of (-1, 0.5].
[[nodiscard]] ElasticBody makishima_mackenzie(const OxideAmounts& weight_fractions, double density);

/// Returns the weight fraction of oxides without coefficients of Makishima & Mackenzie [1].
[[nodiscard]] double share_without_coefficients(const OxideAmounts& weight_fractions);

/// A model of the viscosity of a melt against temperature.
enum class ViscosityModel {
    giordano2008,  ///< magmas
    urbain1981,    ///< slags
};

template <>
struct Names<ViscosityModel> {
    static constexpr std::string_view kind = "viscosity model";
    static constexpr std::array<std::string_view, 2> all{"giordano2008", "urbain1981"};
};

/// Viscosity of one melt by one model.
class MeltViscosity {
  public:
    /// Giordano, Russell & Dingwell 2008 (Earth Planet. Sci. Lett. 271:123), Table 1: log10 eta = -4.55 +
    /// B/(T - C), B and C from mol% of oxides without water, P2O5 included, all iron as FeO.
    /// Urbain et al. 1981 (Trans. J. Br. Ceram. Soc. 80:139): eta = 0.1 A T exp(1000 B/T), ln A = -(0.2693 B
    /// + 11.6725), B from network formers (SiO2, P2O5), modifiers (CaO, MgO, Na2O, K2O, FeO, MnO, twice TiO2
    /// and ZrO2) and amphoterics (Al2O3, B2O3); all iron as FeO, as in the other model.
    /// Both are calibrated on magmas and slags, and extrapolated to fly-ash glass.
    /// Errors: InputError if the melt has none of the oxides of the model.
    MeltViscosity(ViscosityModel model, const OxideAmounts& weight_fractions);

    /// Returns log10 of the viscosity in Pa s [1] at a temperature [K]; infinite at and below C, where
    /// Giordano's melt no longer flows.
    [[nodiscard]] double log10_at(double temperature) const;

    /// Returns the temperature at which the viscosity has that log10 [K], the inverse of log10_at().
    [[nodiscard]] double temperature_at(double log10_viscosity) const;

    [[nodiscard]] double b() const { return b_; }
    [[nodiscard]] double c() const { return c_; }

  private:
    ViscosityModel model_;
    double b_ = 0;  ///< [K], Urbain's in 1000 K
    double c_ = 0;  ///< [K]; Urbain has none
};

/// What a glass does during a contact.
enum class ContactRegime { elastic, viscoelastic, liquid };

template <>
struct Names<ContactRegime> {
    static constexpr std::string_view kind = "regime";
    static constexpr std::array<std::string_view, 3> all{"elastic", "viscoelastic", "liquid"};
};

/// Ratios of the Maxwell relaxation time eta/G to the contact time that bound the regimes [1]. An undamped
/// Hertzian impact of a Maxwell body loses 10 % of its energy at 10, 60 % at 1, and does not rebound at 0.1.
inline constexpr double elastic_ratio = 10;
inline constexpr double liquid_ratio = 0.1;

/// The regime at a ratio of relaxation time to contact time [1].
[[nodiscard]] ContactRegime contact_regime(double relaxation_over_contact);

/// Shear modulus E/(2 (1 + nu)) [Pa].
[[nodiscard]] double shear_modulus(const ElasticBody& body);

/// Returns log10 of the viscosity in Pa s at which a glass of that shear modulus [Pa] relaxes in @p ratio
/// times the contact time [s]: eta = ratio G t_c.
[[nodiscard]] double log10_viscosity_of_ratio(double ratio, double shear_modulus, double contact_time);

}  // namespace ashimpact
