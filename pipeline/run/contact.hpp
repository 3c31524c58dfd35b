// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/quantity.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/law.hpp"

namespace ashimpact {

/// The second sphere of a contact.
struct SecondSphere {
    Quantity radius;  ///< [m]
    Quantity mass;    ///< [kg]
};

/// The entry of a sample in 2-contact.json, as later stages read it.
struct SampleContact {
    std::string name;
    ContactPair pair;
    Quantity density;           ///< apparent [kg/m3]
    Quantity radius;            ///< of the particle; R* where the other body is a wall [m]
    Quantity contact_modulus;   ///< [Pa]
    Quantity work_of_adhesion;  ///< [J/m2]
    std::optional<Quantity> poisson_ratio;
    std::vector<std::pair<LawParameter, Quantity>> parameters;  ///< of laws that declare their own [SI]
    std::optional<SecondSphere> partner{};                      ///< none: the other body is a flat wall
};

/// Contact modulus, effective radius and mass, and work of adhesion; Dong et al. 2013, Eqs. 6, 7 and 11.
[[nodiscard]] StageOutput contact_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleContact> read_contacts(const View& result);

}  // namespace ashimpact
