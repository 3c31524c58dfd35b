// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "pipeline/app/contact/single_contact.hpp"

namespace ashimpact {

/// A restitution without adhesion from which the damping follows: --damping-restitution, --at.
struct RequestedRestitution {
    double
        restitution;  ///< of a Hertz impact that ends at zero overlap, or zero force if the contact does [1]
    std::optional<double> velocity;  ///< none where it is the same at every velocity [m/s]
};

/// The damping of the options of a command.
struct DampingChoice {
    Damping damping;
    std::optional<RequestedRestitution> requested{};  ///< none: the coefficient was given, or none was
};

/// Reads --damping, or --damping-restitution with --at. @throws InputError naming the option
[[nodiscard]] DampingChoice read_damping_choice(const CommandOptions& options, const ContactPair& contact);

/// "damping constant 2.1 g/s, for restitution 0.3 at 2 m/s without adhesion and yield".
[[nodiscard]] std::string requested_words(const RequestedRestitution& requested, const Damping& damping);

/// Adds "damping_restitution" to a command's --json, with what DEM codes make of the same request; nothing if
/// none was made.
void add_requested(Json& json, const DampingChoice& choice);

/// The lines of the same for a reader; empty if none was made.
[[nodiscard]] std::string requested_text(const DampingChoice& choice);

}  // namespace ashimpact
