// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"
#include "core/json/document.hpp"
#include "core/units/units.hpp"
#include "pipeline/case/input_files.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"
#include "solver/oblique/oblique.hpp"

namespace ashimpact {

/// Options of a command as the user typed them, by name: "--radius"; an argument without dashes, "file".
class CommandOptions {
  public:
    /// What was typed, else the default of the option, which may be empty; "true" for a flag.
    [[nodiscard]] const std::string& operator[](std::string_view name) const;
    [[nodiscard]] bool has(std::string_view name) const {
        return !(*this)[name].empty() || !list(name).empty();
    }
    [[nodiscard]] std::optional<std::string> if_given(std::string_view name) const {
        return has(name) ? std::optional((*this)[name]) : std::nullopt;
    }
    /// What was typed for an option that may be given several times.
    [[nodiscard]] const std::vector<std::string>& list(std::string_view name) const;
    /// The whole number of an option, which the parser has checked.
    [[nodiscard]] int whole(std::string_view name, int otherwise = 0) const {
        return has(name) ? std::stoi((*this)[name]) : otherwise;
    }
    /// [SI unit of the dimension] @throws InputError naming the option
    [[nodiscard]] double number(std::string_view name, Dimension dimension) const;
    /// The same, > 0. @throws InputError naming the option
    [[nodiscard]] double positive(std::string_view name, Dimension dimension) const;
    /// The doubts about quantities that are far from what particles of ash and walls have.
    /// @throws InputError naming the option for a number without a unit that is too far
    [[nodiscard]] std::vector<Finding> doubts() const;

    /// Where the parser stores what was typed.
    [[nodiscard]] std::string& text_of(const std::string& name) { return texts_[name]; }
    [[nodiscard]] std::vector<std::string>& list_of(const std::string& name) { return lists_[name]; }

  private:
    std::map<std::string, std::string, std::less<>> texts_;
    std::map<std::string, std::vector<std::string>, std::less<>> lists_;
};

/// A sphere on a flat wall, or on another sphere, with its contact law.
struct ContactChoice {
    Law law;
    Detachment detachment;
    ContactPair contact;
    SphereBody sphere;
    std::optional<SphereBody> partner{};  ///< none: a flat wall

    /// @param velocity [m/s]
    [[nodiscard]] Impact impact(const Damping& damping, double velocity) const {
        return {law, detachment, damping, contact, velocity};
    }
};

/// The option of a law parameter: "--cohesion-energy-density".
[[nodiscard]] std::string option_of(const LawParameter& parameter);

/// The contact of the options of a command. @throws InputError naming the option
[[nodiscard]] ContactChoice read_contact(const CommandOptions& options);

/// The time step of --method paper-explicit [s]; none: the exact method. @param impact about as long as those
/// to be solved
[[nodiscard]] std::optional<double> read_explicit_step(const CommandOptions& options, const Impact& impact);

/// Refuses the options of a contact beside a run, which has them all but the law. @throws InputError
void refuse_contact_options(const CommandOptions& options);
/// A contact law with properties that spheres of all sizes share.
struct MaterialChoice {
    ContactChoice reference;  ///< of a sphere of reference_diameter
    double density;           ///< [kg/m3]

    [[nodiscard]] ContactPair contact(double diameter) const;
};
inline constexpr double reference_diameter = 1e-6;  ///< any size [m]

/// Refuses --tabor and --roughness, which belong to one size. @throws InputError naming the option
void refuse_size_dependent(const CommandOptions& options, const std::string& problem);
/// The material of options as Command::add_material_options() adds them. @throws InputError naming the option
[[nodiscard]] MaterialChoice read_material(CommandOptions options);

/// Refuses options of a material without the option that they belong to.
void refuse_material(const CommandOptions& options, const std::string& without);

/// The damping law. @throws InputError naming the option
[[nodiscard]] DampingLaw read_damping_law(const CommandOptions& options);

/// The damping law and its coefficient, 0 where it was not given. Warns of options of a damping that does not
/// act on the contact. @throws InputError naming the option
[[nodiscard]] Damping read_damping(const CommandOptions& options, const ContactPair& contact);

/// An impact and what it did, with the keys of the command's --json.
[[nodiscard]] Json impact_json(const Impact& impact, const ImpactResult& result);

/// The lines a reader gets of it. @param normal behind "velocity", of an impact at an angle
[[nodiscard]] std::string impact_text(const Impact& impact, const ImpactResult& result,
                                      const std::string& normal = {});

/// Adds the coefficients that a damping has beside the first, "adhesion_damping".
void add_further_damping(Json& json, const Damping& damping, const ContactPair& contact);

/// Adds the lines on a damping.
void add_damping_lines(TextList& list, const Damping& damping, const ContactPair& contact);

/// Adds the lines on contact law and damping.
void add_model(TextList& list, Law law, Detachment detachment, const Damping& damping,
               const ContactPair& contact);

/// The lines on the regime of an impact.
[[nodiscard]] std::string regime_text(const Regime& regime);

/// Adds findings to the "notes" of a command's --json, if there are any.
void add_notes(Json& json, const std::vector<Finding>& findings);

/// Warns of an option that changes nothing. @param reason "there is one size"
void warn_idle(const std::string& option, const std::string& reason);

/// Puts findings on standard error as warnings. @param place a file, or empty
void warn_of(const std::vector<Finding>& findings, const std::string& place = {});

/// Prints how a table was read, as a message that is no warning; held as those are. @param reading empty:
/// nothing
void print_reading(const std::string& file, const std::string& reading);
/// The same of the files of a case, the first of many.
void print_readings(const std::vector<InputFile>& files);

}  // namespace ashimpact
