// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/contact/single_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/explicit_scheme.hpp"

namespace ashimpact {

namespace {

/// The radius by either option of a sphere [m]; @p prefix begins the name of each.
double read_radius(const CommandOptions& options, const std::string& prefix) {
    const bool by_diameter = options.has(prefix + "diameter");
    if (options.has(prefix + "radius") == by_diameter)
        throw InputError(by_diameter ? "both are given" : "neither is given", "one of the two")
            .at(prefix + "diameter, " + prefix + "radius");
    if (!by_diameter) return options.positive(prefix + "radius", Dimension::length);
    return 0.5 * options.positive(prefix + "diameter", Dimension::length);
}

SphereBody read_sphere(const CommandOptions& options, const std::string& prefix) {
    const double radius = read_radius(options, prefix);
    const bool by_mass = options.has(prefix + "mass");
    if (options.has(prefix + "density") == by_mass)
        throw InputError(by_mass ? "both are given" : "neither is given", "one of the two")
            .at(prefix + "density, " + prefix + "mass");
    if (by_mass) {
        const double mass = options.positive(prefix + "mass", Dimension::mass);
        if (const auto doubt = implausible_mass(radius, mass)) warn_of({*doubt}, prefix + "mass");
        return {radius, mass};
    }
    const double density = options.positive(prefix + "density", Dimension::density);
    return at_place(prefix + "radius, " + prefix + "density", [&] {
        const double mass = sphere_mass(radius, density);
        require_positive("mass of the sphere", mass, Dimension::mass);
        return SphereBody{radius, mass};
    });
}

std::optional<SphereBody> read_partner(const CommandOptions& options) {
    if (options.has("--partner-radius") || options.has("--partner-diameter"))
        return read_sphere(options, "--partner-");
    if (options.has("--partner-density") || options.has("--partner-mass"))
        throw InputError("is missing", "the radius of the second sphere; or its --partner-diameter")
            .at("--partner-radius");
    return std::nullopt;
}

/// Warns of an option that is given and changes nothing with the law. @return whether it is one
bool warn_if_idle(const CommandOptions& options, const std::string& option, Law law, std::string_view name) {
    const auto reason =
        options.has(option) ? idle_reason(law, read_damping_law(options), name) : std::nullopt;
    if (reason) warn_idle(option, *reason);
    return reason.has_value();
}

/// The share of the work of adhesion that roughness leaves.
double read_roughness(const CommandOptions& options, Law law, double effective_radius) {
    if (!options.has("--roughness")) return 1;
    warn_if_idle(options, "--roughness", law, "work_of_adhesion");
    if (options.has("--tabor") && law.takes(stated_tabor))
        throw InputError("may be that of the smooth surfaces or of the rough ones",
                         "--cohesion-range or --cohesive-stress; or without --roughness")
            .at("--tabor");
    const double rms = options.number("--roughness", Dimension::length);
    if (const auto doubt = roughness_doubt(effective_radius, rms)) warn_of({*doubt}, "--roughness");
    return at_place("--roughness", [&] { return roughness_reduction(effective_radius, {.rms = rms}); });
}

double read_work_of_adhesion(const CommandOptions& options, Law law) {
    constexpr auto option = "--work-of-adhesion";
    warn_if_idle(options, option, law, "work_of_adhesion");
    if (!law.uses_work_of_adhesion() && !options.has(option)) return 0;
    const double value = options.number(option, Dimension::energy_per_area);
    return at_place(option, [&] {
        require_not_negative("work of adhesion", value, Dimension::energy_per_area);
        return value;
    });
}

double read_yield_pressure(const CommandOptions& options, Law law) {
    if (law.is_plastic()) return options.positive("--yield-pressure", Dimension::pressure);
    warn_if_idle(options, "--yield-pressure", law, "yield_pressure");
    return std::numeric_limits<double>::infinity();
}

/// One or more of the options are missing, or more are given than may be.
[[noreturn]] void refuse_options(const ParameterFault& fault) {
    std::string names;
    for (const LawParameter& parameter : fault.parameters)
        names += (names.empty() ? "" : ", ") + option_of(parameter);
    const std::string problem = fault.parameters.size() == 1 ? "is missing"
                                : fault.given == 0           ? "none is given"
                                                             : std::to_string(fault.given) + " are given";
    throw InputError(problem, fault.allowed()).at(names);
}

ParameterValues<double> read_parameters(const CommandOptions& options, Law law) {
    ParameterValues<double> values;
    for (const LawParameter& parameter : law_parameters()) {
        const std::string option = option_of(parameter);
        if (!options.has(option) || warn_if_idle(options, option, law, parameter.name)) continue;
        const double value = options.number(option, parameter.dimension);
        at_place(option, [&] { require_allowed(parameter, value); });
        values.set(parameter.name, value);
    }
    const auto is_given = [&](const LawParameter& parameter) { return values.has(parameter); };
    if (const auto fault = parameter_fault(parameters_of(law, read_damping_law(options)), is_given))
        refuse_options(*fault);
    return values;
}

Detachment read_detachment(const std::string& name, Law law) {
    if (name.empty()) return law.default_detachment();
    return at_place("--detachment", [&] {
        const Detachment detachment = named<Detachment>(name);
        if (const auto reason = refusal(law, detachment))
            throw InputError(*reason, admissible_detachments(law));
        return detachment;
    });
}

/// A unit in which an energy shows four digits.
struct EnergyUnit {
    std::string name;
    int decimals;
    double step;  ///< the last digit [J]
};

EnergyUnit unit_for(double energy) {
    constexpr std::array prefixes{"a", "f", "p", "n", "u", "m", "", "k", "M"};
    const int power = energy > 0 ? static_cast<int>(std::floor(std::log10(energy))) : 0;
    const int prefix = std::clamp((power + 18) / 3, 0, static_cast<int>(prefixes.size()) - 1);
    const int unit_power = 3 * prefix - 18;
    const int decimals = std::clamp(3 - (power - unit_power), 0, 9);
    return {std::string(prefixes.at(static_cast<std::size_t>(prefix))) + "J", decimals,
            std::pow(10.0, unit_power - decimals)};
}

/// The energy before an impact and the terms after it, without those of zero. The term after that is greatest
/// in magnitude takes what rounding leaves, so that the printed terms add up.
void add_energy(TextList& list, const EnergyLedger& energy) {
    const EnergyUnit unit = unit_for(energy.incident);
    const auto steps = [&](double joule) { return std::llround(joule / unit.step); };
    const auto add = [&](const char* name, long long count) {
        list.add(name, fmt::format("{:.{}f} {}", static_cast<double>(count) / std::pow(10.0, unit.decimals),
                                   unit.decimals, unit.name));
    };
    std::array after{std::pair{"  dissipated", steps(energy.dissipated)},
                     std::pair{"  spent in yielding", steps(energy.plastic)},
                     std::pair{"  lost in jumps", steps(energy.jumps)},
                     std::pair{"  left in motion", steps(energy.remaining)},
                     std::pair{"  left in the contact", steps(energy.potential)}};
    long long rounding = steps(energy.incident) + steps(energy.at_touch);
    for (const auto& term : after) rounding -= term.second;
    std::ranges::max_element(after, {}, [](const auto& term) { return std::abs(term.second); })->second +=
        rounding;
    add("incident energy", steps(energy.incident));
    if (steps(energy.at_touch) != 0) add("  at first touch", steps(energy.at_touch));
    for (const auto& [name, count] : after)
        if (count != 0) add(name, count);
}

/// By AdhesionRegime.
constexpr std::array<std::string_view, 4> adhesion_words{
    "no work of adhesion", "hard contact, the limit of DMT", "between the limits of DMT and JKR",
    "soft contact, the limit of JKR"};

}  // namespace

std::string option_of(const LawParameter& parameter) {
    std::string option = "--" + std::string(parameter.name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

const std::string& CommandOptions::operator[](std::string_view name) const {
    static const std::string none;
    const auto found = texts_.find(name);
    return found == texts_.end() ? none : found->second;
}

const std::vector<std::string>& CommandOptions::list(std::string_view name) const {
    static const std::vector<std::string> none;
    const auto found = lists_.find(name);
    return found == lists_.end() ? none : found->second;
}

double CommandOptions::number(std::string_view name, Dimension dimension) const {
    return at_place(std::string(name), [&] {
        const std::string& text = (*this)[name];
        if (text.empty())
            throw InputError("is missing", with_article(dimension_name(dimension)) + " [" +
                                               std::string(si_unit(dimension)) + "]");
        const Quantity quantity = quantity_of_text(text, dimension);
        require_certain(quantity.standard_uncertainty, in_quotes(text) + " ",
                        "the value alone; a case takes uncertainties and carries them to v_c");
        return quantity.value;
    });
}

double CommandOptions::positive(std::string_view name, Dimension dimension) const {
    const double value = number(name, dimension);
    return at_place(std::string(name), [&] {
        require_positive(dimension_name(dimension), value, dimension);
        return value;
    });
}

std::vector<Finding> CommandOptions::doubts() const {
    std::vector<Finding> all;
    for (const auto& [name, text] : texts_)
        for (Finding& doubt : implausible_text(name, text)) all.push_back(std::move(doubt));
    return all;
}

/// Refuses the options named, and those of the parameters of laws, if they are given.
static void refuse_given(const CommandOptions& options, std::vector<std::string> names,
                         const std::string& problem, const std::string& allowed) {
    for (const LawParameter& parameter : law_parameters()) names.push_back(option_of(parameter));
    for (const std::string& name : names)
        if (options.has(name)) throw InputError(problem, allowed).at(name);
}

void refuse_contact_options(const CommandOptions& options) {
    constexpr auto problem = "the run has it";
    constexpr auto allowed = "a run, or the options of an impact";
    refuse_given(
        options,
        {"--radius", "--diameter", "--density", "--mass", "--partner-radius", "--partner-diameter",
         "--partner-density", "--partner-mass", "--roughness", "--contact-modulus", "--work-of-adhesion",
         "--yield-pressure", "--damping-law", "--damping", "--damping-restitution", "--detachment"},
        problem, allowed);
}

ContactChoice read_contact(const CommandOptions& options) {
    if (!options.has("--law")) throw InputError("is missing", law_names()).at("--law");
    const Law law = at_place("--law", [&] { return Law::named(options["--law"]); });
    const Detachment detachment = read_detachment(options["--detachment"], law);
    const SphereBody sphere = read_sphere(options, "--");
    const std::optional<SphereBody> partner = read_partner(options);
    // R* and m* (Eq. 6 and the text under Eq. 2)
    const auto [radius, mass] = !partner ? sphere
                                         : SphereBody{effective_radius(sphere.radius, partner->radius),
                                                      effective_mass(sphere.mass, partner->mass)};
    const double smooth_adhesion = read_work_of_adhesion(options, law);
    const ContactPair contact{.mass = mass,
                              .effective_radius = radius,
                              .contact_modulus = options.positive("--contact-modulus", Dimension::pressure),
                              .work_of_adhesion = smooth_adhesion * read_roughness(options, law, radius),
                              .yield_pressure = read_yield_pressure(options, law),
                              .parameters = read_parameters(options, law)};
    return {law, detachment, contact, sphere, partner};
}

ContactPair MaterialChoice::contact(double diameter) const {
    ContactPair pair = reference.contact;
    pair.effective_radius = diameter / 2;
    pair.mass = sphere_mass(diameter / 2, density);
    return pair;
}

void refuse_size_dependent(const CommandOptions& options, const std::string& problem) {
    for (const auto& [option, allowed] :
         {std::pair{"--tabor", "--cohesion-range or --cohesive-stress, which every size shares"},
          std::pair{"--roughness", "the w of rough surfaces by --work-of-adhesion"}})
        if (options.has(option)) throw InputError(problem, allowed).at(option);
}

MaterialChoice read_material(CommandOptions options) {
    refuse_size_dependent(options, "goes with the size, and several sizes are asked for");
    options.text_of("--diameter") = fmt::format("{} m", reference_diameter);
    const double density = options.positive("--density", Dimension::density);
    return {read_contact(options), density};
}

void refuse_material(const CommandOptions& options, const std::string& without) {
    refuse_given(options,
                 {"--law", "--density", "--contact-modulus", "--work-of-adhesion", "--yield-pressure",
                  "--damping-law", "--damping"},
                 "is given without " + without, "with " + without);
}

DampingLaw read_damping_law(const CommandOptions& options) {
    const std::string& name = options["--damping-law"];
    return at_place("--damping-law",
                    [&] { return name.empty() ? DampingLaw::constant : named<DampingLaw>(name); });
}

Damping read_damping(const CommandOptions& options, const ContactPair& contact) {
    Damping damping{read_damping_law(options), 0};
    if (options.has("--damping")) {
        damping.coefficient = options.number("--damping", dimension_of(damping.law));
        at_place("--damping",
                 [&] { require_not_negative("damping", damping.coefficient, dimension_of(damping.law)); });
    }
    if (options.has("--damping-restitution") || is_damped(damping, contact.parameters)) return damping;
    if (options.has("--damping-law")) warn_idle("--damping-law", "there is no damping");
    for (const LawParameter& parameter : parameters_of(damping.law))
        if (contact.parameters.has(parameter)) warn_idle(option_of(parameter), "there is no damping");
    return damping;
}

void add_further_damping(Json& json, const Damping& damping, const ContactPair& contact) {
    const auto further = further_coefficients(damping, contact.parameters);
    for (const auto& [name, value] : further)
        json[std::string(name)] = quantity_json(value, unit_of(damping.law));
}

Json impact_json(const Impact& impact, const ImpactResult& result) {
    Json json{{"law", impact.law.name()},
              {"detachment", name_of(impact.detachment)},
              {"damping_law", name_of(impact.damping.law)},
              {"damping", quantity_json(impact.damping.coefficient, unit_of(impact.damping.law))}};
    add_further_damping(json, impact.damping, impact.contact);
    json.update({{"outcome", name_of(result.outcome)},
                 {"restitution", quantity_json(result.restitution, Dimension::fraction)},
                 {"contact_time", quantity_json(result.contact_time, Dimension::time)},
                 {"approach_time", quantity_json(result.approach_time, Dimension::time)},
                 {"maximum_overlap", quantity_json(result.maximum_overlap, Dimension::length)},
                 {"rebound_velocity", quantity_json(result.rebound_velocity, Dimension::velocity)},
                 {"energy", energy_json(result.energy)},
                 {"regime", regime_json(regime_of(impact, result.maximum_overlap))}});
    return json;
}

std::string regime_text(const Regime& regime) {
    TextList list;
    list.add("damping number", fmt::format("beta = {}", readable_number(regime.damping_number)));
    list.add("Tabor parameter",
             regime.tabor_parameter > 0
                 ? fmt::format("{} ({})", readable_number(regime.tabor_parameter),
                               adhesion_words.at(static_cast<std::size_t>(regime.adhesion)))
                 : "none: no work of adhesion");
    list.add(
        "greatest pressure",
        regime.yield_pressure
            ? fmt::format("{}, {} times the yield pressure of {}", readable(regime.greatest_pressure, "Pa"),
                          readable_number(regime.greatest_pressure / *regime.yield_pressure),
                          readable(*regime.yield_pressure, "Pa"))
            : readable(regime.greatest_pressure, "Pa"));
    list.add("yield velocity", regime.yield_velocity
                                   ? readable(*regime.yield_velocity, "m/s") + " (Hertz, without adhesion)"
                                   : "none: the law is elastic");
    list.add("contact radius", fmt::format("at most {}, {} of R*", readable(regime.contact_radius, "m"),
                                           readable_number(regime.relative_contact_radius)));
    return list.text(0);
}

void warn_idle(const std::string& option, const std::string& reason) {
    spdlog::warn("warning: {}: {}", option, idle_words(reason));
}

void add_notes(Json& json, const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) json["notes"].push_back(finding.text);
}

std::optional<double> read_explicit_step(const CommandOptions& options, const Impact& impact) {
    constexpr double steps = 1e4;
    if (options["--method"] == "taylor") {
        if (options.has("--time-step"))
            throw InputError("belongs to the explicit method", "--method paper-explicit").at("--time-step");
        return std::nullopt;
    }
    if (options["--method"] != "paper-explicit")
        throw InputError("unknown method " + in_quotes(options["--method"]), "taylor, paper-explicit")
            .at("--method");
    validate(impact);
    return options.has("--time-step") ? options.positive("--time-step", Dimension::time)
                                      : explicit_time_step(impact, steps);
}

void print_reading(const std::string& file, const std::string& reading) {
    if (!reading.empty()) spdlog::warn("{}: read as {}", file, reading);
}

void print_readings(const std::vector<InputFile>& files) {
    constexpr std::size_t most = 12;  // a case may have thousands
    std::size_t tables = 0;
    for (const InputFile& file : files)
        for (const std::string& reading : file.readings)
            if (++tables <= most) print_reading(file.file, reading);
    if (tables > most)
        spdlog::warn("and {} more tables, which {} lists under inputs", tables - most, case_artifact);
}

void warn_of(const std::vector<Finding>& findings, const std::string& place) {
    for (const bool first : {true, false})  // doubts about values come first
        for (const Finding& finding : findings)
            if ((finding.code == implausible_code) == first)
                spdlog::warn("warning: {}{}{}", place, place.empty() ? "" : ": ", finding.text);
}

/// "adhesion damping" of the key "adhesion_damping", as the second line of an entry.
static std::string indented_name(std::string_view key) {
    std::string words = "  " + std::string(key);
    std::ranges::replace(words, '_', ' ');
    return words;
}

void add_damping_lines(TextList& list, const Damping& damping, const ContactPair& contact) {
    list.add("damping", fmt::format("{} ({})", readable(damping.coefficient, unit_of(damping.law)),
                                    name_of(damping.law)));
    const auto further = further_coefficients(damping, contact.parameters);
    for (const auto& [name, value] : further) {
        list.add(indented_name(name), readable(value, unit_of(damping.law)));
    }
}

void add_model(TextList& list, Law law, Detachment detachment, const Damping& damping,
               const ContactPair& contact) {
    list.add("law", fmt::format("{}, contact ends at {}", law.name(), name_of(detachment)));
    list.add("contact", fmt::format("R* {}, m {}, E* {}, w {}", readable(contact.effective_radius, "m"),
                                    readable(contact.mass, "kg"), readable(contact.contact_modulus, "Pa"),
                                    readable(contact.work_of_adhesion, "J/m2")));
    for (const LawParameter& parameter : law.parameters())
        if (contact.parameters.has(parameter))
            list.add(indented_name(parameter.name),
                     readable(contact.parameters[parameter], si_unit(parameter.dimension)));
    add_damping_lines(list, damping, contact);
}

std::string impact_text(const Impact& impact, const ImpactResult& result, const std::string& normal) {
    const auto time = [](const std::optional<double>& value, const char* none) {
        return value ? readable(*value, "s") : std::string(none);
    };
    TextList list;
    add_model(list, impact.law, impact.detachment, impact.damping, impact.contact);
    list.add("velocity" + normal, readable(impact.velocity, "m/s"));
    list.add("outcome", std::string(name_of(result.outcome)));
    list.add("restitution", readable_number(result.restitution));
    list.add("rebound velocity" + normal, readable(result.rebound_velocity, "m/s"));
    list.add("contact time", time(result.contact_time, "none: the particle stays"));
    list.add("approach time", time(result.approach_time, "none: the approach never turns"));
    list.add("maximum overlap", readable(result.maximum_overlap, "m"));
    add_energy(list, result.energy);
    return list.text(0) + regime_text(regime_of(impact, result.maximum_overlap));
}

}  // namespace ashimpact
