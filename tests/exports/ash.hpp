// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "materials/contact_properties.hpp"
#include "pipeline/present/export/subject.hpp"

namespace ashimpact::test {

/// Fly ash of 88 um with constant damping.
inline ExportSubject ash(std::string_view law_name) {
    const Law law = Law::named(law_name);
    return {.law = law,
            .detachment = law.default_detachment(),
            .contact = {.mass = sphere_mass(44e-6, 2600),
                        .effective_radius = 44e-6,
                        .contact_modulus = 90e9,
                        .work_of_adhesion = 0.3},
            .density = 2600,
            .damping = {.law = DampingLaw::constant, .nodes = {{0, 0.0141}}, .reference_diameter = 88e-6},
            .from_diameter = 88e-6,
            .to_diameter = 88e-6};
}

}  // namespace ashimpact::test
