// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "interface/c/parameters.hpp"
#include "interface/include/ashimpact.h"
#include "solver/batch/single_impacts.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

/// Impacts of spheres one by one, with the constants of a model.
struct SphereImpacts {
    SingleImpacts impacts;
    ContactPair contact;              ///< mass and effective radius are those of the sphere
    double damping = 0.0;             ///< [unit of the damping law]
    std::optional<double> density{};  ///< [kg/m3]; none: every sphere has the mass of the contact

    /// The contact of a sphere of a diameter [m].
    [[nodiscard]] ContactPair contact_of(double diameter) const;
    /// e_n [1] and v_c [m/s] as SingleImpacts gives them; none: let a batch of one solve it.
    [[nodiscard]] std::optional<double> restitution(double diameter, double velocity) const {
        return impacts.restitution(contact_of(diameter), damping, velocity);
    }
    [[nodiscard]] std::optional<double> critical_velocity(double diameter) const {
        return impacts.critical_velocity(contact_of(diameter), damping);
    }
};

}  // namespace ashimpact

/// What a handle of the C interface stands for. It never changes once it is made.
struct ashimpact_model {  // NOLINT(readability-identifier-naming): the name of the C interface
    ashimpact::Law law;
    ashimpact::Detachment detachment;
    ashimpact::DampingLaw damping_law;
    std::array<std::optional<double>, ashimpact::most_parameters> constants{};
    std::optional<ashimpact::SphereImpacts> spheres{};  ///< none: constants for a sphere are missing

    /// The sources of a call without columns: the constants.
    [[nodiscard]] ashimpact::Parameters parameters() const;
};

namespace ashimpact {

/// Makes a model from what ashimpact_open() takes, null pointers included.
/// @throws InputError for a name that is unknown, a constant that is not admissible, missing or given twice
[[nodiscard]] ashimpact_model make_model(const char* law, const char* detachment, const char* damping_law,
                                         const ashimpact_parameter* parameters, std::size_t count);

}  // namespace ashimpact
