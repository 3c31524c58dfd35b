// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/contact.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "materials/roughness.hpp"
#include "pipeline/document/case_json.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/run/modulus.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

Stated computed(double value, Dimension dimension, std::string source) {
    return {.quantity = make_quantity(value, dimension), .origin = "computed", .source = std::move(source)};
}

Stated poisson_ratio_of(const Sample& sample, const SampleModulus& modulus) {
    if (sample.poisson_ratio) return *sample.poisson_ratio;
    if (modulus.poisson_ratio)
        return computed(*modulus.poisson_ratio, Dimension::fraction, "mixed from the phases");
    throw InputError("Poisson's ratio of the sample " + sample.name + " is not known",
                     "poisson_ratio of the sample, or of each of its phases");
}

Stated contact_modulus_of(const Sample& sample, const std::optional<Wall>& wall, const SampleModulus& modulus,
                          const std::optional<Stated>& poisson_ratio) {
    if (sample.contact_modulus) return *sample.contact_modulus;
    if (const auto* given = std::get_if<Stated>(&*wall)) return *given;
    const ElasticBody particle{modulus.young_modulus.value, poisson_ratio->value()};
    const auto* elastic = std::get_if<ElasticWall>(&*wall);
    const double value = elastic == nullptr
                             ? contact_modulus(particle, RigidWall{})
                             : contact_modulus(particle, ElasticBody{elastic->young_modulus.value(),
                                                                     elastic->poisson_ratio.value()});
    Stated stated = computed(value, Dimension::pressure, "Eq. 7");
    if (const auto u = modulus.young_modulus.standard_uncertainty)
        stated.quantity.standard_uncertainty =
            value * particle_share_of_compliance(particle, value) * *u / modulus.young_modulus.value;
    return stated;
}

bool needs_poisson_ratio(const Sample& sample, const std::optional<Wall>& wall) {
    return !sample.contact_modulus && !std::holds_alternative<Stated>(*wall);
}

/// Density that follows from the phases and the stated porosity [kg/m3].
double density_from_phases(const Sample& sample, const SampleModulus& modulus) {
    const bool stated = sample.porosity && !sample.porosity_from_density;
    return modulus.density * (1 - (stated ? sample.porosity->value : 0));
}

Stated density_of(const Sample& sample, const SampleModulus& modulus, std::vector<std::string>& warnings) {
    if (!sample.density)
        return computed(density_from_phases(sample, modulus), Dimension::density, "phases, less the pores");
    const double ratio = sample.density->value() / modulus.density;
    if (ratio <= 1 && sample.porosity && !sample.porosity_from_density)
        for (const std::string& note :
             particle_density(modulus.density, sample.porosity->value, sample.density->value()).notes)
            warnings.push_back(sample.name + ": " + note);
    if (ratio > 1)
        warnings.push_back(sample.name +
                           ": the stated density is above that of the dense phases, by a factor " +
                           shortest(std::round(1e4 * ratio) / 1e4));
    return *sample.density;
}

Stated adhesion_of(const Sample& sample) {
    if (!sample.work_of_adhesion)
        return computed(0, Dimension::energy_per_area, "no law of the case uses it");
    if (const auto* stated = std::get_if<Stated>(&*sample.work_of_adhesion)) return *stated;
    const auto& from = std::get<AdhesionFromSurfaces>(*sample.work_of_adhesion);
    return computed(work_of_adhesion(from.rule, from.energies), Dimension::energy_per_area,
                    "surface energies, rule " + std::string(name_of(from.rule)));
}

/// Largest rms roughness for which the reduction of w is meant, absolute [m] and over R* [1].
constexpr double greatest_roughness = 20e-9;
constexpr double greatest_relative_roughness = 0.1;

/// The w that roughness leaves, with the uncertainty of both.
Stated rough_adhesion(const Stated& smooth, const Stated& roughness, double effective_radius) {
    const double rms = roughness.value();
    const auto left = [&](double height) { return roughness_reduction(effective_radius, {.rms = height}); };
    Stated rough = smooth;
    rough.quantity.value *= left(rms);
    const double u = roughness.quantity.standard_uncertainty.value_or(0);
    const double of_rms = 0.5 * (left(rms + u) - left(std::max(0.0, rms - u)));
    const double both =
        std::hypot(left(rms) * smooth.quantity.standard_uncertainty.value_or(0), smooth.value() * of_rms);
    if (both > 0) rough.quantity.standard_uncertainty = both;
    rough.origin = "computed";
    rough.source = "work of adhesion of smooth surfaces and their roughness (Rabinovich et al. 2000)";
    return rough;
}

Quantity radius_of(const Stated& diameter) {
    Quantity radius = diameter.quantity;
    radius.value /= 2;
    if (radius.standard_uncertainty) *radius.standard_uncertainty /= 2;
    return radius;
}

/// R* of two spheres, with the uncertainty that both radii leave (Eq. 6).
Quantity effective_radius_of(const Quantity& particle, const Quantity& partner) {
    Quantity effective = make_quantity(effective_radius(particle.value, partner.value), Dimension::length);
    const auto share = [&](const Quantity& radius) {
        const double ratio = effective.value / radius.value;  // d R*/d r = (R*/r)^2
        return ratio * ratio * radius.standard_uncertainty.value_or(0);
    };
    const double u = std::hypot(share(particle), share(partner));
    if (u > 0) effective.standard_uncertainty = u;
    return effective;
}

/// What stands of two spheres in place of R* and m of a sphere on a wall.
Json two_spheres_json(const Quantity& radius, double mass, const PartnerSphere& partner) {
    const Quantity other = radius_of(partner.diameter);
    const double other_mass =
        partner.mass ? partner.mass->value() : sphere_mass(other.value, partner.density->value());
    return {{"effective_radius", effective_radius_of(radius, other)},
            {"effective_mass", quantity_json(effective_mass(mass, other_mass), Dimension::mass)},
            {"radius", radius},
            {"partner", {{"radius", other}, {"mass", quantity_json(other_mass, Dimension::mass)}}}};
}

Json contact_json(const Sample& sample, const Case& data, const SampleModulus& modulus,
                  std::vector<std::string>& warnings) {
    const std::optional<Wall>& wall = data.wall;
    std::optional<Stated> poisson_ratio;
    if (needs_poisson_ratio(sample, wall)) poisson_ratio = poisson_ratio_of(sample, modulus);
    const Quantity radius = radius_of(sample.diameter);
    const Stated density = density_of(sample, modulus, warnings);
    const double mass = sphere_mass(radius.value, density.value());
    Json json{
        {"name", sample.name},
        {"contact_modulus", stated_json(contact_modulus_of(sample, wall, modulus, poisson_ratio))},
        {"effective_radius", radius},
        {"mass", quantity_json(mass, Dimension::mass)},
        {"density", stated_json(density)},
        {"density_from_phases", quantity_json(density_from_phases(sample, modulus), Dimension::density)},
        {"work_of_adhesion", stated_json(adhesion_of(sample))}};
    if (data.partner) json.update(two_spheres_json(radius, mass, *data.partner));
    if (data.roughness && data.roughness->value() > 0) {
        const double effective_radius = json.at("effective_radius").at("value").get<double>();
        const double rms = data.roughness->value();
        json["smooth_work_of_adhesion"] = json.at("work_of_adhesion");
        json["roughness"] = stated_json(*data.roughness);
        json["work_of_adhesion"] =
            stated_json(rough_adhesion(adhesion_of(sample), *data.roughness, effective_radius));
        if (rms > greatest_roughness || rms > greatest_relative_roughness * effective_radius)
            warnings.push_back(sample.name +
                               ": the reduction of the work of adhesion by roughness is meant for an rms of "
                               "20 nm at most, far below the radius");
    }
    if (poisson_ratio) json["poisson_ratio"] = stated_json(*poisson_ratio);
    if (sample.yield_pressure) json["yield_pressure"] = stated_json(*sample.yield_pressure);
    for (const auto& [parameter, stated] : sample.parameters)
        json[std::string(parameter.name)] = stated_json(stated);
    return json;
}

}  // namespace

StageOutput contact_stage(const Artifacts& before) {
    const Case data = read_case_artifact(before);
    const auto moduli = before.read(modulus_artifact, read_moduli);
    StageOutput output{.citations = {"dong2013, Eqs. 6, 7, 11"}};
    output.options = {{"geometry", data.partner ? "two spheres: 1/R* = 1/r1 + 1/r2, 1/m* = 1/m1 + 1/m2"
                                                : "sphere on a flat wall: R* = r, m* = m"}};
    if (data.roughness && data.roughness->value() > 0)
        output.citations.emplace_back("rabinovich2000, eq. of the modified Rumpf model: w of rough surfaces");
    output.result["samples"] = Json::array();
    for (const Sample& sample : data.samples) {
        const SampleModulus& modulus = entry_named(moduli, sample.name, before, modulus_artifact);
        output.result["samples"].push_back(contact_json(sample, data, modulus, output.warnings));
    }
    return output;
}

namespace {

SecondSphere read_second_sphere(const View& node) {
    return {positive_quantity(node.at("radius"), "radius", Dimension::length),
            positive_quantity(node.at("mass"), "mass", Dimension::mass)};
}

/// R* and m* of two spheres, which have to be those of the artifact.
void set_two_spheres(const View& sample, double mass, SampleContact& contact) {
    const SecondSphere& partner = *contact.partner;
    contact.pair.effective_radius = effective_radius(contact.radius.value, partner.radius.value);
    contact.pair.mass = effective_mass(mass, partner.mass.value);
    const auto check = [&](const char* key, Dimension dimension, double expected) {
        require_agreement(sample.at(key), expected, dimension, "is not that of the two spheres",
                          "radius, mass and partner");
    };
    check("effective_radius", Dimension::length, contact.pair.effective_radius);
    check("effective_mass", Dimension::mass, contact.pair.mass);
}

}  // namespace

std::vector<SampleContact> read_contacts(const View& result) {
    std::vector<SampleContact> samples;
    for (const View& sample : result.at("samples").elements()) {
        const auto quantity = [&](const char* key, Dimension dimension) {
            return sample.at(key).quantity(dimension);
        };
        const auto positive = [&](const char* key, Dimension dimension) {
            return positive_quantity(sample.at(key), key, dimension);
        };
        SampleContact contact{
            .name = sample.at("name").text(),
            .pair = {},
            .density = positive("density", Dimension::density),
            .radius = positive(sample.has("partner") ? "radius" : "effective_radius", Dimension::length),
            .contact_modulus = positive("contact_modulus", Dimension::pressure),
            .work_of_adhesion = quantity("work_of_adhesion", Dimension::energy_per_area),
            .poisson_ratio = {},
            .parameters = {}};
        contact.pair = {.mass = positive("mass", Dimension::mass).value,
                        .effective_radius = contact.radius.value,
                        .contact_modulus = contact.contact_modulus.value,
                        .work_of_adhesion = contact.work_of_adhesion.value};
        require_agreement(sample.at("mass"), sphere_mass(contact.radius.value, contact.density.value),
                          Dimension::mass, "is not that of a sphere of this radius and density",
                          "radius or density");
        if (const auto partner = sample.find("partner")) {
            contact.partner = read_second_sphere(*partner);
            set_two_spheres(sample, contact.pair.mass, contact);
        }
        if (sample.has("poisson_ratio"))
            contact.poisson_ratio = quantity("poisson_ratio", Dimension::fraction);
        if (const auto pressure = sample.find("yield_pressure"))
            contact.pair.yield_pressure = pressure->number(Dimension::pressure);
        for (const LawParameter& parameter : law_parameters()) {
            const auto node = sample.find(parameter.name);
            if (!node) continue;
            const Quantity value = node->quantity(parameter.dimension);
            at_place(node->pointer(), [&] { require_allowed(parameter, value.value); });
            contact.pair.parameters.set(parameter.name, value.value);
            contact.parameters.emplace_back(parameter, value);
        }
        at_place(sample.pointer(), [&] { validate(contact.pair); });
        samples.push_back(std::move(contact));
    }
    return samples;
}

}  // namespace ashimpact
