// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/law.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact::studies {

inline constexpr unsigned long default_seed = 20130829;

/// The laws of the studies.
inline const std::vector<Law>& laws() {
    static const std::vector<Law> all{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()};
    return all;
}

/// The contact of the invented laboratories, known as they know it.
inline ContactModel model_of(const Law& law, double critical_velocity) {
    const ContactPair ash{.mass = sphere_mass(48e-6, 2158.5),
                          .effective_radius = 48e-6,
                          .contact_modulus = 90e9,
                          .work_of_adhesion = 0.2959};
    return make_contact_model(law, law.default_detachment(), ash,
                              {0.02 * critical_velocity, 40.0 * critical_velocity});
}

}  // namespace ashimpact::studies
