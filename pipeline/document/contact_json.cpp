// SPDX-License-Identifier: GPL-3.0-or-later
// Results up to the restitution data: modulus, contact, analytic velocity, restitution.
#include "core/quantities/checks.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/document/fields.hpp"
#include "pipeline/document/results_json.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"

namespace ashimpact {

namespace {

Json rules_json(const std::vector<RuleResult>& rules) {
    Json json = Json::object();
    for (const RuleResult& rule : rules)
        json[std::string(name_of(rule.rule))] =
            make_quantity(rule.young_modulus, Dimension::pressure, rule.standard_uncertainty);
    return json;
}

std::vector<RuleResult> read_rules(const View& node) {
    std::vector<RuleResult> rules;
    for (const auto& [key, value] : node.members()) {
        const Quantity modulus = value.quantity(Dimension::pressure);
        rules.push_back({at_place(value.pointer(), [&name = key] { return named<MixtureRule>(name); }),
                         modulus.value, modulus.standard_uncertainty.value_or(0)});
    }
    return rules;
}

}  // namespace

void fields(auto& io, Is<PhaseShare> auto& share) {
    io("name", share.name);
    io.lenient("phase", share.phase);
    io("weight_fraction", share.weight_fraction);
    io("volume_fraction", share.volume_fraction);
    io("density", share.density, Dimension::density);
    io("young_modulus", share.young_modulus, Dimension::pressure);
}

void fields(auto& io, Is<ModulusBounds> auto& bounds) {
    io("lower", bounds.lower, Dimension::pressure);
    io("upper", bounds.upper, Dimension::pressure);
    io.unless_empty("lower_rule", bounds.lower_rule);
    io.unless_empty("upper_rule", bounds.upper_rule);
}

void fields(auto& io, Is<Contribution> auto& contribution) {
    io("input", contribution.what);
    io("share_of_variance", contribution.share);
}

void fields(auto& io, Is<OtherGlass> auto& other) {
    io("young_modulus", other.young_modulus, Dimension::pressure);
    io("density", other.density, Dimension::density);
    io.unless_empty("poisson_ratio", other.poisson_ratio, Dimension::fraction);
}

void fields(auto& io, Is<SampleGlass> auto& glass) {
    io("used", glass.used);
    io("composition", glass.composition, Dimension::fraction);
    io("young_modulus", glass.young_modulus, Dimension::pressure);
    io("poisson_ratio", glass.poisson_ratio, Dimension::fraction);
    io("density", glass.density, Dimension::density);
    io("density_assumed", glass.density_assumed);
    io("weight_fraction", glass.weight_fraction, Dimension::fraction);
    io("amorphous_fraction", glass.amorphous_fraction, Dimension::fraction);
    io("sample_with_other_glass", glass.other);
}

void modulus_fields(auto& io, Is<SampleModulus> auto& sample) {
    io("phases", sample.phases);
    io.lenient("rule", sample.rule);
    io("young_modulus", sample.young_modulus, Dimension::pressure);
    io.unless_empty("bounds", sample.bounds);
    io.by_hand("rules", sample.rules, rules_json, read_rules);
    io("density", sample.density, Dimension::density);
    io("poisson_ratio", sample.poisson_ratio, Dimension::fraction);
    io.lenient("poisson_ratio_assumed", sample.poisson_ratio_assumed);
    io.lenient("uncertainty_contributions", sample.contributions);
    io.unless_empty("glass", sample.glass);
}

void fields(auto& io, Is<SampleModulus> auto& sample) {
    io("name", sample.name);
    io("diameter", sample.diameter, Dimension::length);
    modulus_fields(io, sample);
}

Json modulus_json(const SampleModulus& sample) {
    FieldWriter writer(DampingLaw::constant);
    modulus_fields(writer, sample);
    return std::move(writer).json();
}

template Json to_json(const ModulusResult& result, DampingLaw law);
template ModulusResult from_json(const View& result, DampingLaw law);

namespace {

void require_positive_member(const View& node, const char* key, Dimension dimension) {
    static_cast<void>(positive_quantity(node.at(key), key, dimension));
}

/// Reads the parameters of contact laws, which stand among the other members.
void read_parameters(const View& node, SampleContact& contact) {
    for (const LawParameter& parameter : law_parameters()) {
        const auto member = node.find(parameter.name);
        if (!member) continue;
        Stated value;
        read_value(*member, value, parameter.dimension);
        at_place(member->pointer(), [&] { require_allowed(parameter, value.value()); });
        contact.parameters.emplace_back(parameter, value);
    }
}

/// Sets what follows from the fields of a contact, and checks it against the members that repeat it.
void complete(const View& node, SampleContact& contact) {
    require_positive_member(node, "density", Dimension::density);
    require_positive_member(node, "effective_radius", Dimension::length);
    contact.radius = contact.effective_radius;
    if (contact.partner) {
        contact.radius = positive_quantity(node.at("radius"), "radius", Dimension::length);
        require_positive_member(node.at("partner"), "radius", Dimension::length);
        require_positive_member(node.at("partner"), "mass", Dimension::mass);
    }
    require_positive_member(node, "contact_modulus", Dimension::pressure);
    require_positive_member(node, "mass", Dimension::mass);
    require_agreement(node.at("mass"), sphere_mass(contact.radius.value, contact.density.value()),
                      Dimension::mass, "is not that of a sphere of this radius and density",
                      "radius or density");
    read_parameters(node, contact);
    contact.pair = pair_of(contact);
    const auto require_of_spheres = [&](const char* key, Dimension dimension, double expected) {
        require_agreement(node.at(key), expected, dimension, "is not that of the two spheres",
                          "radius, mass and partner");
    };
    if (contact.partner) {
        require_of_spheres("effective_radius", Dimension::length, contact.pair.effective_radius);
        require_of_spheres("effective_mass", Dimension::mass, contact.pair.mass);
    }
    at_place(node.pointer(), [&] { validate(contact.pair); });
}

}  // namespace

void fields(auto& io, Is<SecondSphere> auto& partner) {
    io("radius", partner.radius, Dimension::length);
    io("mass", partner.mass, Dimension::mass);
}

template <class Io>
void fields(Io& io, Is<SampleContact> auto& contact) {
    io("name", contact.name);
    io("contact_modulus", contact.contact_modulus, Dimension::pressure);
    io("effective_radius", contact.effective_radius, Dimension::length);
    io("mass", contact.mass, Dimension::mass);
    io("density", contact.density, Dimension::density);
    io.unless_empty("density_from_phases", contact.density_from_phases, Dimension::density);
    io("work_of_adhesion", contact.work_of_adhesion, Dimension::energy_per_area);
    if (contact.partner) {
        io.derived("effective_mass", contact.pair.mass, Dimension::mass);
        io.derived("radius", contact.radius, Dimension::length);
    }
    io.unless_empty("partner", contact.partner);
    io.unless_empty("smooth_work_of_adhesion", contact.smooth_work_of_adhesion, Dimension::energy_per_area);
    io.unless_empty("roughness", contact.roughness, Dimension::length);
    io.unless_empty("poisson_ratio", contact.poisson_ratio, Dimension::fraction);
    io.unless_empty("yield_pressure", contact.yield_pressure, Dimension::pressure);
    for (const auto& [parameter, stated] : contact.parameters)
        io.derived(parameter.name, stated, parameter.dimension);
    if constexpr (Io::reads) complete(io.node(), contact);
}

template Json to_json(const ContactResult& result, DampingLaw law);
template ContactResult from_json(const View& result, DampingLaw law);

void velocity_fields(auto& io, auto& analytic) {
    io("separation_energy", analytic.separation_energy, Dimension::energy);
    io("critical_velocity", analytic.critical_velocity, Dimension::velocity);
}

void fields(auto& io, Is<AnalyticVelocity> auto& analytic) {
    velocity_fields(io, analytic);
}

void fields(auto& io, Is<CohesiveVelocity> auto& cohesive) {
    velocity_fields(io, cohesive.exact);
    io("transition_parameter", cohesive.transition_parameter);
    io.object("fitted", [&](auto& inner) {
        velocity_fields(inner, cohesive.fitted);
        inner("relative_error_of_energy", cohesive.fitted_error);
    });
}

void fields(auto& io, Is<SampleAnalytic> auto& sample) {
    io("name", sample.name);
    velocity_fields(io, sample);
    io.unless_empty("load_controlled", sample.load_controlled);
    io.unless_empty("with_printed_constants", sample.with_printed_constants);
    io.unless_empty("maugis_dugdale", sample.maugis_dugdale);
}

template Json to_json(const AnalyticResult& result, DampingLaw law);
template AnalyticResult from_json(const View& result, DampingLaw law);

template <class Io>
void fields(Io& io, Is<RestitutionSeries> auto& series) {
    io("laws", series.laws);
    io("origin", series.origin);
    io("source", series.source);
    fields(io, series.columns);
    io.unless_empty("coefficient_uncertainty", series.coefficient_uncertainty, Dimension::damping);
    if constexpr (Io::reads) {
        series.impacts = read_measurement_columns(io.node());
        series.impacts.source = series.source;
        if (!series.impacts.points.empty())
            at_place(io.node().pointer(), [&] { check_impacts(series.impacts); });
    }
}

void fields(auto& io, Is<SampleRestitution> auto& sample) {
    io("name", sample.name);
    io("series", sample.series);
}

template Json to_json(const RestitutionResult& result, DampingLaw law);
template RestitutionResult from_json(const View& result, DampingLaw law);

}  // namespace ashimpact
