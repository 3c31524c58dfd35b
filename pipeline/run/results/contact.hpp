// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/case/case.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// The second sphere of a contact.
struct SecondSphere {
    Quantity radius;  ///< [m]
    Quantity mass;    ///< [kg]
};

/// Properties of the contact of a sample.
struct SampleContact {
    std::string name{};
    ContactPair pair{};                           ///< as the solver takes it
    Stated contact_modulus{};                     ///< E* [Pa]
    Quantity effective_radius{};                  ///< R* [m]
    Quantity radius{};                            ///< of the particle; R* where the other body is a wall [m]
    Quantity mass{};                              ///< of the particle [kg]
    Stated density{};                             ///< apparent [kg/m3]
    Stated work_of_adhesion{};                    ///< w that acts, reduced by roughness [J/m2]
    std::optional<double> density_from_phases{};  ///< less the stated pores [kg/m3]
    std::optional<Stated>
        smooth_work_of_adhesion{};           ///< before that reduction; none: the surfaces are smooth
    std::optional<Stated> roughness{};       ///< rms [m]
    std::optional<Stated> poisson_ratio{};   ///< of the particle; none: nothing needs it [1]
    std::optional<Stated> yield_pressure{};  ///< none: the contact stays elastic [Pa]
    std::vector<std::pair<LawParameter, Stated>> parameters{};  ///< of laws that declare their own [SI]
    std::optional<SecondSphere> partner{};                      ///< none: the other body is a flat wall
};

/// Result of the contact stage, 2-contact.json.
struct ContactResult {
    std::vector<SampleContact> samples{};
};

}  // namespace ashimpact
