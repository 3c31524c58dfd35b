// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/quantities/names.hpp"
#include "solver/motion/impact.hpp"

/// Impacts at an angle: the normal motion of the contact law, and a rigid sphere with Coulomb friction.
namespace ashimpact {

/// A sphere of a contact.
struct SphereBody {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// The spheres of a contact. The contact pair holds their effective radius and mass.
struct ContactBodies {
    SphereBody sphere;
    std::optional<SphereBody> partner{};  ///< none: a flat wall, which does not move
};

/// Motion along the wall. The slip of the surfaces at the contact is velocity + radius * spin.
struct TangentialMotion {
    double velocity = 0;  ///< v_t of the sphere relative to its partner, any sign [m/s]
    double spin = 0;      ///< omega, positive where it adds to the slip of v_t > 0 (backspin) [rad/s]
};

/// How the surfaces part.
enum class SlidingRegime {
    sliding,  ///< they slide throughout
    rolling,  ///< the slip ends during the impact
    none,     ///< nothing slides: no slip at first touch, or no friction
    captured  ///< the sphere stays; whether it rolls off is not in the model
};

template <>
struct Names<SlidingRegime> {
    static constexpr std::string_view kind = "regime of the contact";
    static constexpr std::array<std::string_view, 4> all{"sliding", "rolling", "none", "captured"};
};

/// What a tangential motion becomes in an impact that rebounds.
struct TangentialRebound {
    SlidingRegime regime = SlidingRegime::none;
    TangentialMotion after{};
    double partner_spin = 0;   ///< that a partner at rest gains, in the sense of the sphere's [rad/s]
    double impulse = 0;        ///< of friction, as a magnitude [N s]
    double friction_work = 0;  ///< what sliding takes [J]
};

/// Kinetic energies of the motion relative to the partner [J].
struct ObliqueEnergy {
    double normal;   ///< m v_n^2/2
    double sliding;  ///< m v_t^2/2
    double spin;     ///< I omega^2/2 of the spheres, I = (2/5) m R^2
};

/// An impact at an angle. The normal velocity is that of @p normal.
struct ObliqueImpact {
    Impact normal;
    ContactBodies bodies;
    TangentialMotion tangential{};
    double friction = 0;  ///< mu [1]
};

/// What it did.
struct ObliqueResult {
    ImpactResult normal;
    TangentialRebound tangential;
    std::optional<double> tangential_restitution{};  ///< e_t = v_t'/v_t; none without v_t, 0 of a capture [1]
    std::optional<double>
        rebound_angle{};  ///< from the normal, negative where v_t' has turned; none: captured [rad]
    std::optional<double>
        impulse_ratio{};           ///< friction over normal impulse m (1 + e) v_n; none: captured [1]
    double repulsive_impulse = 0;  ///< P_r, that friction acts on; 0 of a capture [N s]
    ObliqueEnergy before{};
    ObliqueEnergy after{};
    double stopped = 0;  ///< energy of sliding and spin that a capture ends; the model leaves open how [J]
};

/// @throws InputError for friction below 0 and for numbers that are not finite, or too great to compute with
void require_tangential(const TangentialMotion& before, double friction);

/// Friction impulse that ends a slip: 2/7 of the effective mass times the slip [N s]. Solid spheres resist
/// slip by 1/m* + R^2/I of each = (7/2)/m*.
[[nodiscard]] double rolling_impulse(double effective_mass, double slip);

/// Tangential motion after an impact with a repulsive impulse P_r. The tangential impulse is against the slip
/// s: mu P_r where that is below the impulse that ends it, and the sphere slides throughout; else the contact
/// ends rolling, v_t' = v_t - (2/7) s. Walton 1993; with adhesion friction acts on the repulsion alone.
/// @param effective_mass m* of the pair [kg]
[[nodiscard]] TangentialRebound tangential_rebound(const ContactBodies& bodies, double effective_mass,
                                                   const TangentialMotion& before, double friction,
                                                   double repulsive_impulse);

/// Ratios that describe a rebound, as in ObliqueResult.
struct ReboundRatios {
    std::optional<double> tangential_restitution{};
    double rebound_angle;  ///< [rad]
    double impulse_ratio;  ///< [1]
};

/// @param effective_mass m* [kg] @param incident v_n [m/s] @param rebound v_n' > 0 [m/s]
[[nodiscard]] ReboundRatios rebound_ratios(const TangentialMotion& before,
                                           const TangentialRebound& tangential, double effective_mass,
                                           double incident, double rebound);

/// One impact at an angle.
/// @throws InputError for inadmissible input, as solve_impact(), and for friction below 0
[[nodiscard]] ObliqueResult solve_oblique_impact(const ObliqueImpact& impact);

/// The same where the normal impact is solved already. @param normal what it did
[[nodiscard]] ObliqueResult oblique_result(const ObliqueImpact& impact, const ImpactResult& normal);

/// P_r [N s] of an impact that rebounds with restitution @p e: m (1 + e) v_n + the time integral of |F_a|.
[[nodiscard]] double repulsive_impulse(const Impact& impact, double restitution);

}  // namespace ashimpact
