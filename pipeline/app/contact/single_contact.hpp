// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/document.hpp"
#include "core/units/units.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

/// One contact as the user typed it; empty where an option was not given.
struct ContactOptions {
    std::string law;
    std::string detachment;
    std::string radius;
    std::string diameter;  ///< instead of the radius
    std::string density;
    std::string mass;
    std::string partner_radius;    ///< of a second sphere; a flat wall where it is not given
    std::string partner_diameter;  ///< instead of its radius
    std::string partner_density;
    std::string partner_mass;
    std::string roughness;  ///< rms of both surfaces
    std::string contact_modulus;
    std::string work_of_adhesion;
    std::string yield_pressure;
    std::vector<std::string> parameters = std::vector<std::string>(law_parameters().size());  ///< their order
    std::string damping_law = "constant";
    std::string damping;
};

/// A sphere of the options.
struct Sphere {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// A sphere on a flat wall, or on another sphere, with its contact law.
struct ContactChoice {
    Law law;
    Detachment detachment;
    ContactPair contact;
    Sphere sphere;
    std::optional<Sphere> partner{};  ///< none: a flat wall
};

/// The option of a law parameter: "--cohesion-energy-density".
[[nodiscard]] std::string option_of(const LawParameter& parameter);

/// @throws InputError naming the option
[[nodiscard]] ContactChoice read_contact(const ContactOptions& options);

/// The damping law and its coefficient, 0 where it was not given. @throws InputError naming the option
[[nodiscard]] Damping read_damping(const ContactOptions& options);

/// What an option says [SI unit of the dimension]. @throws InputError naming the option
[[nodiscard]] double read_option(const std::string& option, const std::string& text, Dimension dimension);

/// The same, > 0. @throws InputError naming the option
[[nodiscard]] double read_positive_option(const std::string& option, const std::string& text,
                                          Dimension dimension);

/// An impact and what it did, with the keys of the command's --json.
[[nodiscard]] Json impact_json(const Impact& impact, const ImpactResult& result);

/// The lines a reader gets of it.
[[nodiscard]] std::string impact_text(const Impact& impact, const ImpactResult& result);

/// The lines on the regime of an impact.
[[nodiscard]] std::string regime_text(const Regime& regime);

/// Puts the warnings of a regime on standard error.
void warn_of_regime(const Regime& regime);

}  // namespace ashimpact
