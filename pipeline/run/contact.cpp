// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "materials/composition.hpp"
#include "materials/contact_properties.hpp"
#include "materials/phase_catalogue.hpp"
#include "pipeline/run/stage.hpp"
#include "pipeline/run/uncertainty/velocity_uncertainty.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

Stated computed(double value, Dimension dimension, std::string source) {
    return {
        .quantity = make_quantity(value, dimension), .origin = Origin::computed, .source = std::move(source)};
}

Stated poisson_ratio_of(const Sample& sample, const SampleModulus& modulus) {
    if (sample.poisson_ratio) return *sample.poisson_ratio;
    if (modulus.poisson_ratio)
        return {.quantity = *modulus.poisson_ratio,
                .origin = Origin::computed,
                .source = "mixed from the phases"};
    throw InputError("Poisson's ratio of the sample " + sample.name + " is not known",
                     "poisson_ratio of the sample, or of each of its phases");
}

/// Standard uncertainty of (1 - nu^2)/E, a body's part of the compliance in Eq. 7 [1/Pa].
double compliance_uncertainty(const Quantity& young_modulus, const Quantity& poisson_ratio) {
    const double nu = poisson_ratio.value;
    const double of_modulus =
        (1 - nu * nu) / young_modulus.value * young_modulus.standard_uncertainty.value_or(0);
    const double of_ratio = 2 * nu * poisson_ratio.standard_uncertainty.value_or(0);
    return std::hypot(of_modulus, of_ratio) / young_modulus.value;
}

/// @param joint standard uncertainty from the phases and the wall, where the case has them [Pa]
Stated contact_modulus_of(const Sample& sample, const std::optional<Wall>& wall, const SampleModulus& modulus,
                          const std::optional<Stated>& poisson_ratio, std::optional<double> joint) {
    if (sample.contact_modulus) return *sample.contact_modulus;
    if (const auto* given = std::get_if<Stated>(&*wall)) return *given;
    const ElasticBody particle{modulus.young_modulus.value, poisson_ratio->value()};
    const auto* elastic = std::get_if<ElasticWall>(&*wall);
    const double value = elastic == nullptr
                             ? contact_modulus(particle, RigidWall{})
                             : contact_modulus(particle, ElasticBody{elastic->young_modulus.value(),
                                                                     elastic->poisson_ratio.value()});
    Stated stated = computed(value, Dimension::pressure, "Eq. 7");
    const double of_wall = elastic != nullptr ? compliance_uncertainty(elastic->young_modulus.quantity,
                                                                       elastic->poisson_ratio.quantity)
                                              : 0;
    // From the phases if they are known: they give both E and Poisson's ratio, whose errors are correlated.
    const double u = joint.value_or(
        value * value *
        std::hypot(compliance_uncertainty(modulus.young_modulus, poisson_ratio->quantity), of_wall));
    if (u > 0) stated.quantity.standard_uncertainty = u;
    return stated;
}

bool needs_poisson_ratio(const Sample& sample, const std::optional<Wall>& wall) {
    return !sample.contact_modulus && !std::holds_alternative<Stated>(*wall);
}

/// Density that follows from the phases and the stated porosity, with the uncertainties of both [kg/m3].
Quantity density_from_phases(const Sample& sample, const SampleModulus& modulus) {
    Porosity pores;
    if (sample.porosity && !sample.porosity_from_density) pores = *sample.porosity;
    const double dense = modulus.density.value;
    Quantity density = make_quantity(dense * (1 - pores.value), Dimension::density);
    const double u = std::hypot((1 - pores.value) * modulus.density.standard_uncertainty.value_or(0),
                                dense * pores.standard_uncertainty.value_or(0));
    if (u > 0) density.standard_uncertainty = u;
    return density;
}

Stated density_of(const Sample& sample, const SampleModulus& modulus, StageRecord& record) {
    if (!sample.density) {
        Stated density = computed(0, Dimension::density, "phases, less the pores");
        density.quantity = density_from_phases(sample, modulus);
        return density;
    }
    const double dense = modulus.density.value;
    const double ratio = sample.density->value() / dense;
    if (ratio <= 1 && sample.porosity && !sample.porosity_from_density)
        record.note(particle_density(dense, sample.porosity->value, sample.density->value()).notes,
                    sample.name);
    if (ratio > 1)
        record.note({"density-above-phases", Severity::doubt,
                     "the stated density is above that of the dense phases, by a factor " +
                         shortest(std::round(1e4 * ratio) / 1e4)},
                    sample.name);
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

/// Mass of a sphere with the uncertainties of its radius and density.
Quantity mass_of(const Quantity& radius, const Quantity& density) {
    Quantity mass = make_quantity(sphere_mass(radius.value, density.value), Dimension::mass);
    const double relative = std::hypot(3 * radius.standard_uncertainty.value_or(0) / radius.value,
                                       density.standard_uncertainty.value_or(0) / density.value);
    if (relative > 0) mass.standard_uncertainty = mass.value * relative;
    return mass;
}

/// Sets the second sphere and the R* of both.
void set_partner(const PartnerSphere& partner, SampleContact& contact) {
    const Quantity radius = radius_of(partner.diameter);
    contact.effective_radius = effective_radius_of(contact.radius, radius);
    contact.partner = SecondSphere{
        radius, partner.mass ? partner.mass->quantity : mass_of(radius, partner.density->quantity)};
}

void set_roughness(const Stated& roughness, const std::string& sample, SampleContact& contact,
                   StageRecord& record) {
    const double radius = contact.effective_radius.value;
    contact.roughness = roughness;
    contact.smooth_work_of_adhesion = contact.work_of_adhesion;
    contact.work_of_adhesion = rough_adhesion(contact.work_of_adhesion, roughness, radius);
    if (const auto doubt = roughness_doubt(radius, roughness.value())) record.note(*doubt, sample);
}

/// Notes the doubt about a computed value; those about stated values are of the case.
void note_implausible(const char* name, const Stated& value, const std::string& sample, StageRecord& record) {
    if (value.origin != Origin::computed) return;
    if (const auto doubt = implausible_at(name, *plausible_range(name), {value.value()}))
        record.note(*doubt, sample);
}

SampleContact contact_of(const Sample& sample, const Case& data, const SampleModulus& modulus,
                         StageRecord& record) {
    SampleContact contact{.name = sample.name, .radius = radius_of(sample.diameter)};
    if (needs_poisson_ratio(sample, data.wall)) contact.poisson_ratio = poisson_ratio_of(sample, modulus);
    contact.contact_modulus = contact_modulus_of(sample, data.wall, modulus, contact.poisson_ratio,
                                                 contact_modulus_uncertainty(data, sample, modulus));
    contact.density = density_of(sample, modulus, record);
    contact.density_from_phases = density_from_phases(sample, modulus).value;
    contact.mass = make_quantity(sphere_mass(contact.radius.value, contact.density.value()), Dimension::mass);
    contact.effective_radius = contact.radius;
    contact.work_of_adhesion = adhesion_of(sample);
    if (data.partner) set_partner(*data.partner, contact);
    if (data.roughness && data.roughness->value() > 0)
        set_roughness(*data.roughness, sample.name, contact, record);
    note_implausible("contact_modulus", contact.contact_modulus, sample.name, record);
    note_implausible("density", contact.density, sample.name, record);
    note_implausible("work_of_adhesion", contact.work_of_adhesion, sample.name, record);
    contact.yield_pressure = sample.yield_pressure;
    contact.parameters = sample.parameters;
    contact.pair = pair_of(contact);
    validate(contact.pair);
    return contact;
}

/// Eq. 30 for a cohesion of finite range: between 0 (DMT) and the value of JKR.
CohesiveVelocity cohesive(const ContactPair& contact, double jkr_energy) {
    const double lambda = transition_parameter_of(contact);
    const double energy = lambda > 0 ? cohesive_separation_energy(contact, lambda) : 0;
    const double fitted = lambda > 0 ? fitted_energy_ratio(lambda) * jkr_energy : 0;
    const auto with_velocity = [&](double separated) {
        return AnalyticVelocity{separated, std::sqrt(2 * separated / contact.mass)};
    };
    return {with_velocity(energy), lambda, with_velocity(fitted), fitted_energy_error};
}

SampleAnalytic analytic_of(const SampleContact& sample) {
    const AdhesiveContact contact{.work_of_adhesion = sample.pair.work_of_adhesion,
                                  .effective_radius = sample.pair.effective_radius,
                                  .contact_modulus = sample.pair.contact_modulus};
    // Of two spheres m* and R* are those of one sphere of this density on a wall.
    const double density = sample.partner ? sphere_density(sample.pair.effective_radius, sample.pair.mass)
                                          : sample.density.value();
    SampleAnalytic analytic{{separation_energy(contact), separation_velocity(contact, density)}, sample.name};
    analytic.load_controlled = {separation_energy(contact, Separation::load_controlled),
                                separation_velocity(contact, density, Separation::load_controlled)};
    analytic.with_printed_constants = {dong2013::separation_energy(contact),
                                       dong2013::separation_velocity(contact, density)};
    analytic.maugis_dugdale = cohesive(sample.pair, analytic.separation_energy);
    return analytic;
}

/// Reuss and Voigt on (K, G), which hold for any arrangement of the phases; without every Poisson ratio the
/// series and parallel models on E take their place.
/// Pores soften them as they soften the chosen rule, by a factor of the porosity and Poisson's ratio alone.
ModulusBounds bounds_of(const ModulusEstimate& estimate, MixtureRule chosen) {
    const RuleResult dense = estimate.by(chosen).value();
    const double softening = estimate.young_modulus / dense.young_modulus;
    // What the uncertainty of the pores adds, relative.
    const double of_pores =
        std::sqrt(std::max(0.0, std::pow(estimate.standard_uncertainty / estimate.young_modulus, 2) -
                                    std::pow(dense.standard_uncertainty / dense.young_modulus, 2)));
    const auto bound = [&](MixtureRule first, MixtureRule second) {
        auto result = estimate.by(first);
        if (!result) result = estimate.by(second).value();
        result->young_modulus *= softening;
        result->standard_uncertainty =
            std::hypot(softening * result->standard_uncertainty, result->young_modulus * of_pores);
        return *result;
    };
    const auto quantity = [](const RuleResult& result) {
        return make_quantity(result.young_modulus, Dimension::pressure, result.standard_uncertainty);
    };
    const RuleResult lower = bound(MixtureRule::reuss, MixtureRule::series);
    const RuleResult upper = bound(MixtureRule::voigt, MixtureRule::parallel);
    return {quantity(lower), quantity(upper), lower.rule, upper.rule};
}

void add_citations(const Composition& composition, std::vector<std::string>& citations) {
    std::set<std::string> known(citations.begin(), citations.end());
    const auto add = [&](const PhaseProperty& property) {
        for (const std::string& citation : property.citations)
            if (known.insert(citation).second) citations.push_back(citation);
    };
    for (const Component& component : composition.components) {
        add(component.phase.density);
        add(component.phase.young_modulus);
        if (component.phase.poisson_ratio) add(*component.phase.poisson_ratio);
    }
}

/// The porosity of a sample; where the case gives none, from its density and that of the phases.
std::optional<Porosity> porosity_of(const Sample& sample, const Composition& composition,
                                    StageRecord& record) {
    if (!sample.porosity_from_density) return sample.porosity;
    const PorosityFromDensity found = at_place("the sample " + sample.name, [&] {
        return porosity_from_density(*sample.porosity, sample.density->quantity, composition.density);
    });
    record.note(found.finding, sample.name);
    return found.porosity;
}

ModulusOptions modulus_options(const Case& data, const Sample& sample,
                               const std::optional<Porosity>& porosity) {
    ModulusOptions options{.rule = data.mixture_rule, .porosity = porosity};
    if (sample.porosity_from_density) options.apparent_density = sample.density->quantity;
    return options;
}

Composition composition_of(const Case& data, const Sample& sample) {
    const PhaseCatalogue catalogue({PhaseSet{.name = "case", .phases = data.phases}});
    return compose_with_glass(sample.analysis, catalogue, sample.glass).composition;
}

}  // namespace

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
    rough.origin = Origin::computed;
    rough.source = "work of adhesion of smooth surfaces and their roughness (Rabinovich et al. 2000)";
    return rough;
}

ParticleInputs particle_inputs(const Case& data, const Sample& sample) {
    return {composition_of(data, sample), modulus_options(data, sample, sample.porosity)};
}

ContactResult contact_stage(const Case& data, const ModulusResult& moduli, StageRecord& record) {
    record.citations = {"dong2013, Eqs. 6, 7, 11"};
    if (data.roughness && data.roughness->value() > 0)
        record.citations.emplace_back("rabinovich2000, eq. of the modified Rumpf model: w of rough surfaces");
    ContactResult result;
    for (std::size_t i = 0; i < data.samples.size(); ++i)
        result.samples.push_back(contact_of(data.samples[i], data, moduli.samples[i], record));
    return result;
}

AnalyticResult analytic_stage(const ContactResult& contacts, StageRecord& record) {
    record.citations = {"dong2013, Eqs. 28-30", "thornton1998"};
    AnalyticResult result;
    for (const SampleContact& sample : contacts.samples) result.samples.push_back(analytic_of(sample));
    return result;
}

PorosityFromDensity porosity_from_density(Porosity porosity, const Quantity& apparent, double true_density) {
    porosity.value = porosity_from_densities(apparent.value, true_density);
    return {porosity,
            {"porosity", Severity::remark,
             "a porosity of " + readable_number(porosity.value) + " follows from the density"}};
}

SampleModulus sample_modulus(const Composition& composition, const ModulusEstimate& estimate,
                             MixtureRule rule) {
    SampleModulus sample{
        .rule = rule,
        .young_modulus =
            make_quantity(estimate.young_modulus, Dimension::pressure, estimate.standard_uncertainty),
        .bounds = bounds_of(estimate, rule),
        .rules = estimate.rules,
        .density = make_quantity(estimate.density, Dimension::density, estimate.density_uncertainty),
        .poisson_ratio = {},
        .poisson_ratio_assumed = estimate.poisson_ratio_assumed,
        .contributions = estimate.contributions};
    if (estimate.poisson_ratio) {
        sample.poisson_ratio = make_quantity(*estimate.poisson_ratio, Dimension::fraction);
        if (estimate.poisson_ratio_uncertainty > 0)
            sample.poisson_ratio->standard_uncertainty = estimate.poisson_ratio_uncertainty;
    }
    for (const Component& component : composition.listed())
        sample.phases.push_back({.name = component.name,
                                 .phase = component.phase.name,
                                 .weight_fraction = component.weight_fraction,
                                 .volume_fraction = component.volume_fraction,
                                 .density = component.phase.density.value,
                                 .young_modulus = component.phase.young_modulus.value});
    return sample;
}

SampleGlass sample_glass(const GlassInSample& sample, const ModulusEstimate& other, GlassSource used) {
    const ChemicalGlass& chemistry = sample.glass.value();
    SampleGlass glass{
        .used = used == GlassSource::from_chemistry,
        .young_modulus = chemistry.young_modulus,
        .poisson_ratio = chemistry.poisson_ratio,
        .density = chemistry.density,
        .density_assumed = chemistry.density_assumed,
        .weight_fraction = chemistry.weight_fraction,
        .amorphous_fraction = chemistry.amorphous_fraction,
        .other = {make_quantity(other.young_modulus, Dimension::pressure, other.standard_uncertainty),
                  make_quantity(other.density, Dimension::density, other.density_uncertainty),
                  other.poisson_ratio}};
    for (const OxideShare& each : chemistry.oxides)
        glass.composition.emplace_back(
            each.oxide, make_quantity(each.fraction, Dimension::fraction, each.standard_uncertainty));
    return glass;
}

ModulusResult modulus_stage(const Case& data, StageRecord& record) {
    const PhaseCatalogue catalogue({PhaseSet{.name = "case", .phases = data.phases}});
    record.citations = {"dong2013, Eq. 1"};
    ModulusResult result;
    for (const Sample& sample : data.samples) {
        const GlassInSample composed = compose_with_glass(sample.analysis, catalogue, sample.glass);
        const Composition& composition = composed.composition;
        const auto porosity = porosity_of(sample, composition, record);
        const ModulusOptions options = modulus_options(data, sample, porosity);
        const ModulusEstimate estimate = estimate_modulus(composition, options);
        SampleModulus modulus = sample_modulus(composition, estimate, data.mixture_rule);
        modulus.name = sample.name;
        modulus.diameter = sample.diameter.quantity;
        if (composed.other)
            modulus.glass =
                sample_glass(composed, estimate_modulus(*composed.other, options), sample.glass.source);
        result.samples.push_back(std::move(modulus));
        record.note(composition.notes, sample.name);
        if (composed.glass) record.note(composed.glass->notes, sample.name);
        record.note(estimate.notes, sample.name);
        add_citations(composition, record.citations);
    }
    return result;
}

}  // namespace ashimpact
