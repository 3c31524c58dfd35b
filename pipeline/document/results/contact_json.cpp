// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/view.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/document/results/fields.hpp"
#include "pipeline/document/results/results_json.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

Json sample_contact_json(const SampleContact& contact) {
    Json json{{"name", contact.name},
              {"contact_modulus", stated_json(contact.contact_modulus)},
              {"effective_radius", contact.effective_radius},
              {"mass", contact.mass},
              {"density", stated_json(contact.density)}};
    if (contact.density_from_phases)
        json["density_from_phases"] = quantity_json(*contact.density_from_phases, Dimension::density);
    json["work_of_adhesion"] = stated_json(contact.work_of_adhesion);
    if (contact.partner) {
        json["effective_mass"] = quantity_json(contact.pair.mass, Dimension::mass);
        json["radius"] = contact.radius;
        json["partner"] = {{"radius", contact.partner->radius}, {"mass", contact.partner->mass}};
    }
    const auto add = [&](const char* key, const std::optional<Stated>& value) {
        if (value) json[key] = stated_json(*value);
    };
    add("smooth_work_of_adhesion", contact.smooth_work_of_adhesion);
    add("roughness", contact.roughness);
    add("poisson_ratio", contact.poisson_ratio);
    add("yield_pressure", contact.yield_pressure);
    for (const auto& [parameter, stated] : contact.parameters)
        json[std::string(parameter.name)] = stated_json(stated);
    return json;
}

/// R* and m* of two spheres, which have to be those of the artifact.
void set_two_spheres(const View& node, SampleContact& contact) {
    const SecondSphere& partner = *contact.partner;
    contact.pair.effective_radius = effective_radius(contact.radius.value, partner.radius.value);
    contact.pair.mass = effective_mass(contact.mass.value, partner.mass.value);
    const auto check = [&](const char* key, Dimension dimension, double expected) {
        require_agreement(node.at(key), expected, dimension, "is not that of the two spheres",
                          "radius, mass and partner");
    };
    check("effective_radius", Dimension::length, contact.pair.effective_radius);
    check("effective_mass", Dimension::mass, contact.pair.mass);
}

Stated read_positive_stated(const View& node, const char* key, Dimension dimension) {
    const View member = node.at(key);
    static_cast<void>(positive_quantity(member, key, dimension));
    return read_stated(member, dimension);
}

void read_parameters(const View& node, SampleContact& contact) {
    for (const LawParameter& parameter : law_parameters()) {
        const auto member = node.find(parameter.name);
        if (!member) continue;
        const Stated value = read_stated(*member, parameter.dimension);
        at_place(member->pointer(), [&] { require_allowed(parameter, value.value()); });
        contact.pair.parameters.set(parameter.name, value.value());
        contact.parameters.emplace_back(parameter, value);
    }
}

SampleContact read_sample_contact(const View& node) {
    const auto stated_if = [&](const char* key, Dimension dimension) {
        return read_if(node, key, [&](const View& member) { return read_stated(member, dimension); });
    };
    SampleContact contact{.name = node.at("name").text(), .contact_modulus = {}, .effective_radius = {}};
    contact.density = read_positive_stated(node, "density", Dimension::density);
    contact.effective_radius =
        positive_quantity(node.at("effective_radius"), "effective_radius", Dimension::length);
    contact.radius = node.has("partner") ? positive_quantity(node.at("radius"), "radius", Dimension::length)
                                         : contact.effective_radius;
    contact.contact_modulus = read_positive_stated(node, "contact_modulus", Dimension::pressure);
    contact.work_of_adhesion = read_stated(node.at("work_of_adhesion"), Dimension::energy_per_area);
    contact.mass = positive_quantity(node.at("mass"), "mass", Dimension::mass);
    contact.pair = {.mass = contact.mass.value,
                    .effective_radius = contact.radius.value,
                    .contact_modulus = contact.contact_modulus.value(),
                    .work_of_adhesion = contact.work_of_adhesion.value()};
    require_agreement(node.at("mass"), sphere_mass(contact.radius.value, contact.density.value()),
                      Dimension::mass, "is not that of a sphere of this radius and density",
                      "radius or density");
    if (const auto partner = node.find("partner")) {
        contact.partner = {positive_quantity(partner->at("radius"), "radius", Dimension::length),
                           positive_quantity(partner->at("mass"), "mass", Dimension::mass)};
        set_two_spheres(node, contact);
    }
    contact.density_from_phases = number_if(node, "density_from_phases", Dimension::density);
    contact.smooth_work_of_adhesion = stated_if("smooth_work_of_adhesion", Dimension::energy_per_area);
    contact.roughness = stated_if("roughness", Dimension::length);
    contact.poisson_ratio = stated_if("poisson_ratio", Dimension::fraction);
    contact.yield_pressure = stated_if("yield_pressure", Dimension::pressure);
    if (contact.yield_pressure) contact.pair.yield_pressure = contact.yield_pressure->value();
    read_parameters(node, contact);
    at_place(node.pointer(), [&] { validate(contact.pair); });
    return contact;
}

}  // namespace

Json to_json(const ContactResult& result, DampingLaw /*law*/) {
    return samples_json(result.samples, sample_contact_json);
}

template <>
ContactResult from_json<ContactResult>(const View& result, DampingLaw /*law*/) {
    return {samples_of(result, read_sample_contact)};
}

}  // namespace ashimpact
