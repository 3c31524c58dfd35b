#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "materials/base/quantity.hpp"
#include "pipeline/stages/stage.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact {

/// The entry of a sample in 2-contact.json, as later stages read it.
struct SampleContact {
    std::string name;
    ContactPair pair;
    Quantity density;           ///< apparent [kg/m3]
    Quantity effective_radius;  ///< [m]
    Quantity contact_modulus;   ///< [Pa]
    Quantity work_of_adhesion;  ///< [J/m2]
    std::optional<Quantity> poisson_ratio;
    std::vector<std::pair<LawParameter, Quantity>> parameters;  ///< of laws that declare their own [SI]
};

/// Contact modulus, effective radius, mass and work of adhesion; Dong et al. 2013, Eqs. 6, 7 and 11.
[[nodiscard]] StageOutput contact_stage(const Artifacts& before);

[[nodiscard]] std::vector<SampleContact> read_contacts(const View& result);

}  // namespace ashimpact
