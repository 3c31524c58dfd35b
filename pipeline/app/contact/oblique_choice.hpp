// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "pipeline/app/contact/single_contact.hpp"
#include "solver/oblique/oblique.hpp"

namespace ashimpact {

/// The motion along the wall of the options of a command: --angle or --tangential-velocity, --spin,
/// --friction.
struct ObliqueChoice {
    double normal_velocity = 0;  ///< [m/s]
    TangentialMotion tangential{};
    double friction = 0;  ///< mu [1]
};

/// Reads the options; none if the impact is normal. @param velocity of --velocity: of the sphere where an
/// angle is given, else normal to the wall [m/s]
/// @throws InputError naming the option
[[nodiscard]] std::optional<ObliqueChoice> read_oblique(const CommandOptions& options, double velocity);

/// --angle from the normal, if it is given [rad]. @throws InputError unless 0 <= angle < 90 degrees
[[nodiscard]] std::optional<double> read_angle(const CommandOptions& options);

/// The bodies of a contact.
[[nodiscard]] ContactBodies bodies_of(const ContactChoice& choice);

/// Adds what the impact does along the wall to the --json of the normal one: its key "regime" becomes that of
/// the sliding, and the regime of the contact is "contact_regime".
void add_oblique(Json& json, const ObliqueImpact& impact, const ObliqueResult& result);

/// The lines of the same for a reader.
[[nodiscard]] std::string oblique_text(const ObliqueImpact& impact, const ObliqueResult& result);

/// Makes "critical_velocity" of a command's --json that of a sphere at an angle [rad], of which the one so
/// far is the component "normal_critical_velocity".
void add_at_angle(Json& json, double angle, const std::optional<double>& normal);

/// The lines of the same for a reader.
[[nodiscard]] std::string at_angle_text(double angle, const std::optional<double>& normal);

}  // namespace ashimpact
