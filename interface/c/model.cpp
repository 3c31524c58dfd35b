// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/c/model.hpp"

#include <string>
#include <string_view>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

std::string_view text_of(const char* text, std::string_view what, const std::string& allowed) {
    if (text == nullptr) throw InputError("no " + std::string(what) + " is given", allowed);
    return text;
}

void take_constants(ashimpact_model& model, const ashimpact_parameter* parameters, std::size_t count) {
    if (count > 0 && parameters == nullptr)
        throw InputError("parameters is NULL", "an array of count of them");
    for (std::size_t i = 0; i < count; ++i) {
        const Parameter parameter = parameter_named(parameters[i].name);
        const auto place = static_cast<std::size_t>(parameter);
        const auto other = static_cast<std::size_t>(alternative_to(parameter));
        const std::string name(parameter_names()[place]);
        if (model.constants[place]) throw InputError(name + " is given twice");
        if (model.constants[other]) {
            throw InputError(name + " is given beside " + std::string(parameter_names()[other]),
                             "one of them");
        }
        model.constants[place] = parameters[i].value;
    }
}

/// The model's constants as a contact of a sphere; none if a constant that it needs is missing.
std::optional<SphereImpacts> sphere_impacts(const ashimpact_model& model) {
    const auto constant = [&model](std::string_view name) {
        return model.constants[place_of(parameter_named(std::string(name).c_str()))];
    };
    const auto density = constant("density");
    const auto mass = constant("mass");
    const auto is_given = [&](const LawParameter& parameter) { return constant(parameter.name).has_value(); };
    if ((!density && !mass) || parameter_fault(model.law, is_given)) return std::nullopt;
    SphereImpacts spheres{.impacts = {model.law, model.detachment, model.damping_law},
                          .contact = {.mass = mass.value_or(1.0),
                                      .effective_radius = 1.0,
                                      .contact_modulus = constant("contact_modulus").value_or(1.0),
                                      .work_of_adhesion = constant("work_of_adhesion").value_or(0.0)},
                          .damping = constant("damping").value_or(0.0),
                          .density = density};
    if (const auto yield_pressure = constant("yield_pressure"))
        spheres.contact.yield_pressure = *yield_pressure;
    for (const LawParameter& parameter : model.law.parameters()) {
        if (const auto value = constant(parameter.name))
            spheres.contact.parameters.set(parameter.name, *value);
    }
    return spheres;
}

/// The constants that are given are checked in an impact whose other numbers are admissible.
void check_constants(const ashimpact_model& model) {
    const auto constant = [&model](Parameter parameter) {
        return model.constants[static_cast<std::size_t>(parameter)];
    };
    if (!constant(Parameter::contact_modulus))
        throw InputError("contact_modulus is missing", "its value in Pa");
    if (const auto density = constant(Parameter::density)) {
        require_positive("density", *density, Dimension::density);
    }
    if (const auto diameter = constant(Parameter::diameter)) {
        require_positive("diameter", *diameter, Dimension::length);
    }
    ContactPair pair{.mass = constant(Parameter::mass).value_or(1.0),
                     .effective_radius = constant(Parameter::effective_radius).value_or(1.0),
                     .contact_modulus = *constant(Parameter::contact_modulus),
                     .work_of_adhesion = constant(Parameter::work_of_adhesion).value_or(0.0)};
    if (const auto yield_pressure = constant(Parameter::yield_pressure))
        pair.yield_pressure = *yield_pressure;
    pair.parameters = typical_parameters(model.law);
    for (const LawParameter& parameter : law_parameters()) {
        const auto value = constant(parameter_named(std::string(parameter.name).c_str()));
        if (!value) continue;
        if (!model.law.takes(parameter)) {
            throw InputError("law " + std::string(model.law.name()) + " takes no " +
                             std::string(parameter.name));
        }
        require_allowed(parameter, *value);
    }
    validate(Impact{model.law,
                    model.detachment,
                    {model.damping_law, constant(Parameter::damping).value_or(0.0)},
                    pair,
                    constant(Parameter::velocity).value_or(1.0)});
}

}  // namespace

ashimpact_model make_model(const char* law, const char* detachment, const char* damping_law,
                           const ashimpact_parameter* parameters, std::size_t count) {
    const Law chosen = Law::named(text_of(law, "law", law_names()));
    ashimpact_model model{
        .law = chosen,
        .detachment = detachment == nullptr ? chosen.default_detachment() : named<Detachment>(detachment),
        .damping_law = damping_law == nullptr ? DampingLaw::constant : named<DampingLaw>(damping_law)};
    if (const auto reason = refusal(model.law, model.detachment)) {
        throw InputError(*reason, admissible_detachments(model.law));
    }
    take_constants(model, parameters, count);
    check_constants(model);
    model.spheres = sphere_impacts(model);
    return model;
}

ContactPair SphereImpacts::contact_of(double diameter) const {
    ContactPair pair = contact;
    pair.effective_radius = diameter / 2.0;
    if (density) pair.mass = mass_of_sphere(*density, diameter);
    return pair;
}

}  // namespace ashimpact

ashimpact::Parameters ashimpact_model::parameters() const {
    ashimpact::Parameters sources;
    for (std::size_t place = 0; place < constants.size(); ++place) {
        if (constants[place]) sources.set(static_cast<ashimpact::Parameter>(place), {&*constants[place], 0});
    }
    return sources;
}
