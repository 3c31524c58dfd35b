// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "materials/glass/balance.hpp"
#include "materials/glass/properties.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/case/values.hpp"

namespace ashimpact {

/// A result with either glass [SI].
struct WithEitherGlass {
    double catalogue = 0, from_chemistry = 0;
};

/// What the chemistry of the glass changes in a sample.
struct GlassEffect {
    GlassSource used = GlassSource::catalogue;
    WithEitherGlass young_modulus{}, contact_modulus{};  ///< of the sample, E* [Pa]
    WithEitherGlass analytic_velocity{};                 ///< of Eq. 30 [m/s]
    /// Of the reported law at its critical damping [m/s]; none: it has no finite one.
    std::optional<WithEitherGlass> dynamic_velocity{};
};

/// Temperatures that bound what a glass does during a contact, by one model of its viscosity [K]; none: the
/// model has no such temperature.
struct GlassTemperatures {
    std::optional<double> elastic_up_to{};              ///< relaxation takes elastic_ratio contact times
    std::optional<double> relaxation_equals_contact{};  ///< it takes one
    std::optional<double> liquid_from{};                ///< it takes liquid_ratio of one
    std::optional<double> relaxation_over_contact{};    ///< at the stated temperature; none: it does not flow
    std::optional<ContactRegime> regime{};              ///< likewise; none: no temperature is stated
};

/// Those of a contact, by both models.
struct ContactTemperatures {
    double contact_time = 0;  ///< [s]
    GlassTemperatures giordano2008{}, urbain1981{};
};

/// Those of a particle of some size by its Hertzian contact time.
struct SizeTemperatures {
    double diameter = 0;  ///< [m]
    ContactTemperatures contact{};
};

/// Up to which temperature a sample's answer holds.
struct TemperatureLimits {
    std::optional<Stated> particle{}, wall{};  ///< as stated [K]
    std::optional<double> shear_modulus{};     ///< of the glass [Pa]; none: no chemistry is known
    std::optional<double> glass_transition{};  ///< 1e12 Pa s by Giordano et al. 2008 [K]
    LawMap<ContactTemperatures> laws{};        ///< at the critical velocity of each law
    std::optional<double> velocity{};          ///< of by_size [m/s]
    std::vector<SizeTemperatures> by_size{};
};

}  // namespace ashimpact
