#pragma once

#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Units of the scaled impact problem, in which mass and Hertz stiffness are 1: choose a velocity, the rest
/// follows from L = (m V^2/k)^(2/5).
struct Scale {
    double mass;           ///< [kg]
    double stiffness;      ///< k [N/m^(3/2)]
    double velocity;       ///< V [m/s]
    double length;         ///< L [m]
    double radius_length;  ///< sqrt(R* L), unit of the contact radius [m]

    /// @param velocity V > 0 [m/s]
    [[nodiscard]] static Scale of(const ContactPair& pair, double velocity);

    [[nodiscard]] double time() const { return length / velocity; }             ///< [s]
    [[nodiscard]] double energy() const { return mass * velocity * velocity; }  ///< [J]
    [[nodiscard]] double force() const { return energy() / length; }            ///< [N]
    [[nodiscard]] double momentum() const { return mass * velocity; }           ///< [N s]

    /// The scaled coefficient of a damping law [1]; beta = eta m^(-3/5) k^(-2/5) V^(-1/5) for constant
    /// damping.
    [[nodiscard]] double damping_number(const Damping& damping) const;
    /// The coefficient [unit of the law] that has this scaled value; inverse of damping_number.
    [[nodiscard]] double damping_coefficient(DampingLaw law, double number) const;

  private:
    [[nodiscard]] double damping_unit(DampingLaw law) const;
};

}  // namespace ashimpact
