// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "solver/deposition/impaction.hpp"
#include "solver/deposition/particle_sizes.hpp"
#include "solver/deposition/tube_flow.hpp"

namespace ashimpact {

/// A tube across a flow of gas.
struct CrossedTube {
    double diameter = 0;  ///< [m]
    double velocity = 0;  ///< of the gas far upstream [m/s]
    Gas gas{};
    SphereDrag drag{};

    [[nodiscard]] TubeParticle particle(double size, double density) const {
        return {.stokes = density * size * size * velocity / (9 * gas.viscosity * diameter),
                .reynolds = gas.density * size * velocity / gas.viscosity,
                .drag = drag};
    }
    /// The size of S = 1/8; no finer particle meets the tube [m].
    [[nodiscard]] double finest_arriving(double density) const {
        return std::sqrt(9 * least_stokes * gas.viscosity * diameter / (density * velocity));
    }
};

/// Restitution of an impact over its normal velocity [m/s]; NaN where it is not known.
using RestitutionOfVelocity = std::function<double(double)>;

/// What rebounds of particles that arrive.
struct Rebounds {
    double share = 0;                      ///< of what flies at the tube [1]
    double restitution = 0, velocity = 0;  ///< means: [1]; normal, away from the wall [m/s]

    void add(const Rebounds& other, double weight);
};

/// What becomes of the particles of one class. Shares are of the mass that flies at the tube, which is what
/// passes through its projected area far upstream.
struct ClassImpaction {
    SizeClass size{};
    double density = 0;  ///< [kg/m3]
    TubeParticle particle{};
    TubeImpaction impaction;

    /// Share of what arrives that stays: arrives with a normal velocity below @p critical [m/s]; infinite:
    /// all.
    [[nodiscard]] double stick_fraction(double critical, double gas_velocity) const;
    /// Mean of the normal velocity of what arrives [U]; 0 if nothing does.
    [[nodiscard]] double mean_normal() const;
    /// What rebounds of the particles of this class, its share that of the class.
    [[nodiscard]] Rebounds rebounds(double critical, double gas_velocity,
                                    const RestitutionOfVelocity& restitution) const;
};

/// The paths of all classes, in parallel. @param densities of the particles of each class [kg/m3]
/// @throws ConvergenceError
[[nodiscard]] std::vector<ClassImpaction> impactions_on(const CrossedTube& tube,
                                                        const std::vector<SizeClass>& classes,
                                                        const std::vector<double>& densities);

/// What reaches a part of the circumference, on both sides of the tube together.
struct ArcImpaction {
    double from = 0, to = 0;           ///< from the front [rad]
    double arrives = 0, stays = 0;     ///< shares of what flies at the tube [1]
    double normal = 0, incidence = 0;  ///< means of what arrives: velocity [U]; angle to the normal [rad]
    Rebounds rebounds{};
};

/// Arcs of equal width from the front to 90 degrees, beyond which nothing arrives; the last one counts what
/// rounding has put beyond. @param critical velocity of each class [m/s] @param restitution of each class
[[nodiscard]] std::vector<ArcImpaction> arcs_of(const std::vector<ClassImpaction>& classes,
                                                const std::vector<double>& critical,
                                                const std::vector<RestitutionOfVelocity>& restitution,
                                                double gas_velocity, int count);

}  // namespace ashimpact
