// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/finding.hpp"
#include "pipeline/run/results/run.hpp"

namespace ashimpact {

/// Code of findings on temperatures.
inline constexpr std::string_view temperature_code = "temperature";

/// Above this particle temperature nothing is known of a glass whose chemistry is not [K]; 600 C.
inline constexpr double known_without_chemistry = 873.15;

/// The results of a sample on which its temperatures rest.
struct TemperatureEvidence {
    const Temperatures& stated;
    const SampleModulus& modulus;
    const SampleContact& contact;
    const LawMap<LawCriticalVelocity>& velocities;
    const std::optional<ReportedVelocity>& reported;
};

/// Up to which temperatures the glass of a sample stays elastic during a contact, by the contact time of each
/// law at its critical velocity, and by size with Hertzian contact times at the reported velocity, else 1
/// m/s. The viscosity is that of the glass by its chemistry, the shear modulus E/(2 (1 + nu)) of it. None
/// without a stated temperature and oxides.
[[nodiscard]] std::optional<TemperatureLimits> temperature_limits(const TemperatureEvidence& evidence);

/// The contact by which a sample is judged: that of its reported law at its critical velocity, else a
/// Hertzian one of its size; null without chemistry.
[[nodiscard]] const ContactTemperatures* deciding_contact(const SampleComparison& sample);

/// What the glass does during that contact, if it is not elastic; none: it is, or nothing is known or stated.
[[nodiscard]] std::optional<ContactRegime> relaxing_glass(const SampleComparison& sample);

/// Notes for a reader of the sample's results; law: those that concern one law.
struct TemperatureNote {
    std::optional<Law> law{};
    Finding finding;
};
[[nodiscard]] std::vector<TemperatureNote> temperature_notes(const TemperatureLimits& limits);

/// A temperature [K] for a reader: "900 C".
[[nodiscard]] std::string celsius(double temperature);

}  // namespace ashimpact
