// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace ashimpact {

/// What a gas does to particles in it.
struct Gas {
    double density = 0;    ///< [kg/m3]
    double viscosity = 0;  ///< dynamic [Pa s]
};

/// Dry air at 101,325 Pa: an ideal gas of 287.05 J/(kg K), its viscosity by Sutherland's law,
/// 1.458e-6 T^(3/2)/(T + 110.4) in SI (U.S. Standard Atmosphere 1976, Eqs. 33a and 51).
[[nodiscard]] inline Gas air_at(double temperature) {
    return {.density = 101325 / (287.05 * temperature),
            .viscosity = 1.458e-6 * temperature * std::sqrt(temperature) / (temperature + 110.4)};
}

/// Drag on a sphere over that of Stokes, C_D Re/24 = 1 + coefficient Re^(2/3).
struct SphereDrag {
    /// Serafini 1954 (NACA Report 1159), the law behind the correlation of Israel & Rosner 1982; within 5 %
    /// of Schiller & Naumann 1935 up to Re = 200, within 8 % up to 800. 1/6: Putnam 1961, as in OpenFOAM; 0:
    /// Stokes.
    double coefficient = 0.158;

    [[nodiscard]] double factor(double reynolds) const {
        const double root = std::cbrt(reynolds);
        return 1 + coefficient * root * root;
    }
    /// Stopping distance over that of Stokes for a sphere that starts with that Reynolds number: psi of
    /// Israel & Rosner, the mean of 1/factor over 0 ... Re.
    [[nodiscard]] double stopping_ratio(double reynolds) const {
        const double x = std::sqrt(coefficient) * std::cbrt(reynolds);
        // Below, the series: the difference x - atan(x) loses digits.
        if (x < 1e-3) return 1 - 0.6 * x * x;
        return 3 * (x - std::atan(x)) / (x * x * x);
    }
};

/// The Stokes number up to which no particle meets a cylinder in potential flow: near the front the gas slows
/// down by 2 U/R, and a particle with S below 1/8 never crosses the last distance.
inline constexpr double least_stokes = 0.125;

/// A particle in a flow across a tube. Lengths are in radii of the tube, velocities in that of the gas far
/// upstream.
struct TubeParticle {
    double stokes = 0;    ///< S = rho d^2 U/(9 mu D) [1]
    double reynolds = 0;  ///< rho_gas d U/mu [1]
    SphereDrag drag{};

    /// S times the stopping ratio, by which particles beyond Stokes' drag compare with those within.
    [[nodiscard]] double effective_stokes() const { return stokes * drag.stopping_ratio(reynolds); }
};

/// Share of the particles that fly at a cylinder and meet it, by the correlation of Israel & Rosner 1982
/// (Aerosol Sci. Technol. 2:45), for effective Stokes numbers above 0.14 [1].
[[nodiscard]] inline double israel_rosner(double effective_stokes) {
    const double x = 1 / (effective_stokes - 0.125);
    return 1 / (1 + x * (1.25 + x * (-0.014 + x * 0.508e-4)));
}

}  // namespace ashimpact
