// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/velocity_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "materials/modulus.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/inference/curve/headline.hpp"

namespace ashimpact {

namespace {

/// A velocity that was propagated, with how and the check of it.
using PropagatedVelocity = ExtrapolatedVelocity;

VelocityUncertainty uncertainty_of(const Propagation& propagation, const std::vector<RandomInput>& inputs,
                                   DampingUnderChange damping, const CalibrationResponse& response) {
    VelocityUncertainty uncertainty{.evaluations = propagation.evaluations,
                                    .undefined = propagation.undefined,
                                    .mean = propagation.mean,
                                    .median = propagation.median,
                                    .lower_error = propagation.end_errors[0],
                                    .upper_error = propagation.end_errors[1],
                                    .influences = propagation.influences,
                                    .damping = damping};
    for (const RandomInput& input : inputs) {
        const double relative = input.standard_uncertainty / std::abs(input.value);
        if (!(input.standard_uncertainty > 0))
            uncertainty.taken_as_exact.push_back(input.name);
        else
            uncertainty.relative.emplace_back(
                input.name, std::isfinite(relative) ? std::optional(relative) : std::nullopt);
    }
    if (response.density != 0 || response.work_of_adhesion != 0) uncertainty.response = response;
    return uncertainty;
}

PropagatedVelocity propagated(const VelocityTask& task, const Propagation& propagation,
                              const std::vector<RandomInput>& inputs, DampingUnderChange damping) {
    PropagatedVelocity velocity{.velocity = estimate_of(propagation.interval),
                                .uncertainty = uncertainty_of(propagation, inputs, damping, task.response)};
    if (task.measured)
        velocity.check =
            checked(propagation.interval, *task.measured, task.from_impacts() && !task.measured_is_reported);
    return velocity;
}

/// By the paper's extrapolation of measured impacts.
PropagatedVelocity from_extrapolation(const VelocityTask& task) {
    const ContactModel model = task.models.model_for(task.choice, task.contact.pair, task.series->impacts);
    const auto change = task.data.uncertainty.reread ? DampingUnderChange::reread : DampingUnderChange::held;
    return propagated(task,
                      propagate_critical_velocity(*task.fit.extrapolated, model, task.uncertain, change,
                                                  task.data.uncertainty.propagation),
                      task.uncertain.inputs, change);
}

/// From what the impacts support. The curve v_r(v_in) is what was measured, and it ends at v_c whatever the
/// contact is: where the damping is read again with another contact, v_c stays.
Interval from_estimate(const VelocityTask& task) {
    const Interval& damping = task.fit.estimate->critical_damping;
    const auto velocity_at = [&](const std::optional<double>& value) -> std::optional<double> {
        if (!value) return std::nullopt;
        return critical_velocity({task.choice.law,
                                  task.choice.detachment,
                                  {DampingLaw::constant, *value},
                                  task.contact.pair})
            .value;
    };
    Interval velocity{.value = *velocity_at(damping.value),
                      .standard_uncertainty = 0,
                      .lower = velocity_at(damping.lower),
                      .upper = velocity_at(damping.upper)};
    const double up = 1 + 1e-4;
    velocity.standard_uncertainty = (*velocity_at(damping.value * up) - *velocity_at(damping.value / up)) /
                                    (damping.value * (up - 1 / up)) * damping.standard_uncertainty;
    return velocity;
}

/// From a critical damping that is known by itself.
PropagatedVelocity from_damping(const VelocityTask& task) {
    const Interval damping = task.critical_damping();
    std::vector<RandomInput> inputs{{fit_factor, damping.value, damping.standard_uncertainty}};
    inputs.insert(inputs.end(), task.uncertain.inputs.begin(), task.uncertain.inputs.end());
    return propagated(task,
                      propagate_critical_velocity(task.choice.law, task.choice.detachment, damping,
                                                  task.uncertain, task.data.uncertainty.propagation),
                      inputs, DampingUnderChange::held);
}

/// Whether v_c can be computed for thousands of draws, from tables and maps. There are none for other damping
/// laws and for contacts with a history.
bool can_propagate(const VelocityTask& task) {
    return restitution_rises(task.data.damping_law) && !can_yield(task.choice.law, task.contact.pair);
}

/// Why v_c has no interval; null if it can have one.
const char* reason_for_no_interval(const VelocityTask& task, bool from_impacts) {
    if (!can_propagate(task))
        return "no interval: that takes constant damping and a contact that does not yield";
    if (!from_impacts && !task.fit.critical_damping_uncertainty)
        return "no interval: the critical damping in 6-fit.json states no uncertainty";
    return nullptr;
}

/// Compares a v_c without an interval with the outcomes, whose interval has to hold it.
void check_without_interval(const VelocityTask& task, LawCriticalVelocity& velocity,
                            std::vector<Finding>& findings) {
    const double value = velocity.velocity->value;
    const Interval exact{.value = value, .standard_uncertainty = 0, .lower = value, .upper = value};
    if (task.measured) velocity.check = checked(exact, *task.measured, false);
    const bool contradicts = task.outcomes && checked(exact, *task.outcomes, false).contradicts();
    const bool measured = task.series != nullptr && task.series->origin == Origin::measured;
    if (const auto note = measured ? no_captures_note(task.series->impacts) : std::nullopt)
        findings.push_back(*note);
    std::string words;
    if (contradicts)
        words = "contradicts the captures and rebounds, by which it is " +
                (task.outcomes->value   ? "about " + readable_number(*task.outcomes->value)
                 : task.outcomes->lower ? "above " + readable_number(*task.outcomes->lower)
                                        : "below " + readable_number(*task.outcomes->upper)) +
                " m/s";
    else if (measured)
        words = contradiction_of(task.series->impacts, value);
    if (!words.empty())
        findings.push_back(
            {"contradicts-outcomes", Severity::doubt,
             fmt::format("v_c of {} m/s {}: damping law {} does not describe these impacts down "
                         "to capture",
                         readable_number(value), words, name_of(task.data.damping_law))});
}

/// An input that cannot be negative.
RandomInput positive(std::string name, const Quantity& quantity) {
    return {.name = std::move(name),
            .value = quantity.value,
            .standard_uncertainty = quantity.standard_uncertainty.value_or(0),
            .distribution = quantity.value > 0 ? lognormal_around : normal_around};
}

RandomInput ratio(const char* name, const Quantity& quantity) {
    return {.name = name,
            .value = quantity.value,
            .standard_uncertainty = quantity.standard_uncertainty.value_or(0)};
}

Quantity diameter_of(Quantity radius) {
    radius.value *= 2;
    if (radius.standard_uncertainty) *radius.standard_uncertainty *= 2;
    return radius;
}

/// Of the mass where the case states it, else of the density and the diameter that it follows from.
RandomPartner partner_of(const Case& data, const SecondSphere& partner) {
    const RandomInput diameter = positive("diameter of the partner", diameter_of(partner.radius));
    const bool by_density = data.partner && data.partner->density;
    if (!by_density) return {diameter, positive("mass of the partner", partner.mass)};
    const Quantity& stated = data.partner->density->quantity;
    Quantity density =
        make_quantity(partner.mass.value / sphere_mass(partner.radius.value, 1), Dimension::density);
    density.standard_uncertainty = stated.standard_uncertainty.value_or(0) / stated.value * density.value;
    return {diameter, positive("density of the partner", density), true};
}

/// A value with the uncertainty to which all inputs lead, linearly.
struct LinearResult {
    double value = 0;
    double standard_uncertainty = 0;

    /// Whether an artifact has this result: values edited there count instead.
    [[nodiscard]] bool is(const Quantity& quantity) const {
        constexpr double rounding = 1e-6;
        const auto near = [&](double one, double other) {
            return std::abs(one - other) <= rounding * std::abs(other);
        };
        return near(value, quantity.value) &&
               near(standard_uncertainty, quantity.standard_uncertainty.value_or(0));
    }
};

/// Takes w of smooth surfaces and their roughness as inputs, where w of the artifact follows from them.
void take_roughness(const SampleContact& contact, SphereInContact& sphere) {
    const auto& smooth = contact.smooth_work_of_adhesion;
    if (!smooth || !contact.roughness || !(contact.roughness->value() > 0)) return;
    const Stated rough = rough_adhesion(*smooth, *contact.roughness, contact.effective_radius.value);
    const Quantity& acting = contact.work_of_adhesion.quantity;
    if (!LinearResult{rough.value(), rough.quantity.standard_uncertainty.value_or(0)}.is(acting)) return;
    sphere.work_of_adhesion = positive("work of adhesion", smooth->quantity);
    sphere.roughness = positive("roughness", contact.roughness->quantity);
}

/// @param law whose parameters are inputs; those of other laws are only carried along
SphereInContact sphere_of(const Case& data, const SampleContact& contact, Law law) {
    const Quantity diameter = diameter_of(contact.radius);
    SphereInContact sphere{
        .diameter = positive("diameter", diameter),
        .density = positive("density", contact.density.quantity),
        .work_of_adhesion = positive("work of adhesion", contact.work_of_adhesion.quantity),
        .yield_pressure = contact.pair.yield_pressure};
    if (contact.partner) sphere.partner = partner_of(data, *contact.partner);
    take_roughness(contact, sphere);
    for (const auto& [parameter, value] : contact.parameters) {
        const auto same = [&, &name = parameter.name](const LawParameter& own) { return own.name == name; };
        if (std::ranges::any_of(law.parameters(), same))
            sphere.parameters.emplace_back(parameter, positive(std::string(parameter.name), value.quantity));
        else
            sphere.other_parameters.set(parameter.name, value.value());
    }
    return sphere;
}

/// E* and the mass of a contact.
std::pair<LinearResult, LinearResult> linear_results(const RandomContact& random) {
    std::vector<UncertainInput> inputs;
    for (const RandomInput& input : random.inputs)
        inputs.push_back({input.name, input.value, input.standard_uncertainty});
    const auto function = [&](const std::vector<double>& values) {
        const ContactPair pair = random.contact(values);
        return std::vector{pair.contact_modulus, pair.mass};
    };
    const ContactPair nominal = random.nominal();
    const auto u = propagate_linearly(function, inputs);
    return {{nominal.contact_modulus, u[0].standard_uncertainty}, {nominal.mass, u[1].standard_uncertainty}};
}

/// The particle of a sample by its phases and pores, with its wall, where the case describes it that way.
std::optional<RandomParticle> particle_of(const Case& data, const Sample& sample) {
    if (!data.wall || std::holds_alternative<Stated>(*data.wall) || sample.contact_modulus)
        return std::nullopt;
    RandomParticle particle{.inputs = particle_inputs(data, sample)};
    if (sample.poisson_ratio)
        particle.poisson_ratio = ratio("Poisson's ratio", sample.poisson_ratio->quantity);
    if (const auto* elastic = std::get_if<ElasticWall>(&*data.wall))
        particle.wall = {positive("Young's modulus of the wall", elastic->young_modulus.quantity),
                         ratio("Poisson's ratio of the wall", elastic->poisson_ratio.quantity)};
    return particle;
}

/// Whether the density of a sample follows from its phases, or its porosity from the density.
bool shares_density(const Sample& sample) {
    return !sample.density || sample.porosity_from_density;
}

/// The same contact from its phases and wall, where the case describes it that way.
std::optional<RandomContact> from_phases(const Case& data, const Sample& sample, const SampleContact& contact,
                                         Law law) {
    SphereInContact sphere = sphere_of(data, contact, law);
    sphere.particle = particle_of(data, sample);
    if (!sphere.particle) return std::nullopt;
    SphereInContact sharing = sphere;
    sharing.density.reset();
    RandomContact random = random_contact(sphere);
    const auto [modulus, mass] = linear_results(random);
    if (!(modulus.standard_uncertainty > 0) || !modulus.is(contact.contact_modulus.quantity))
        return std::nullopt;
    if (!shares_density(sample)) return random;
    RandomContact joint = random_contact(sharing);
    const auto shared_mass = linear_results(joint).second;
    const bool same = shared_mass.is(make_quantity(mass.value, Dimension::mass, mass.standard_uncertainty));
    return same ? joint : random;
}

RandomContact independent_contact(const Case& data, const Sample& sample, const SampleContact& contact,
                                  Law law) {
    if (auto random = from_phases(data, sample, contact, law)) return *std::move(random);
    SphereInContact sphere = sphere_of(data, contact, law);
    sphere.contact_modulus = positive("contact modulus", contact.contact_modulus.quantity);
    return random_contact(sphere);
}

}  // namespace

void set_uncertainty(const VelocityTask& task, LawCriticalVelocity& velocity,
                     std::vector<Finding>& findings) {
    VelocityEstimate& estimate = velocity.velocity.value();
    const double exact = estimate.value;
    velocity.from_impacts = can_propagate(task) && task.series != nullptr && task.from_impacts();
    if (const char* reason = reason_for_no_interval(task, velocity.from_impacts)) {
        findings.push_back({"no-interval", Severity::remark, reason});
        velocity.interval_note = reason;
        estimate.method = VelocityMethod::critical_damping;
        check_without_interval(task, velocity, findings);
        return;
    }
    const auto propagated_or_finding = [&](const char* what, auto propagate) {
        return attempt(what, "no-interval", Severity::doubt, findings, [&] { return propagate(task); });
    };
    if (velocity.from_impacts && task.fit.extrapolated)
        velocity.extrapolated = propagated_or_finding("interval of the extrapolation", from_extrapolation);
    if (velocity.from_impacts && task.fit.estimate && task.data.uncertainty.reread) {
        const Interval interval = from_estimate(task);
        estimate = estimate_of(interval);
        if (task.measured_is_reported) velocity.check = checked(interval, *task.measured, false);
    } else if (const auto found = velocity.from_impacts && !task.fit.estimate
                                      ? velocity.extrapolated
                                      : propagated_or_finding("interval", from_damping)) {
        estimate = found->velocity;
        velocity.uncertainty = found->uncertainty;
        velocity.check = found->check;
    }
    estimate.value = exact;  // the propagation gives its uncertainty only
    if (!velocity.from_impacts || !task.fit.estimate)
        estimate.method = VelocityMethod::extrapolation;
    else  // a damping that is held is known by itself, and v_c depends on the contact
        estimate.method =
            task.data.uncertainty.reread ? VelocityMethod::estimate : VelocityMethod::critical_damping;
}

std::optional<double> contact_modulus_uncertainty(const Case& data, const Sample& sample,
                                                  const SampleModulus& modulus) {
    const auto particle = particle_of(data, sample);
    if (!particle) return std::nullopt;
    std::vector<double> values;
    for (const UncertainInput& input : particle->inputs.list()) values.push_back(input.value);
    const auto function = [&](const std::vector<double>& at) {
        const PorousModuli moduli = particle->inputs.at(at).moduli;
        return std::vector{moduli.young_modulus, moduli.poisson_ratio.value_or(0)};
    };
    const std::vector<double> nominal = function(values);
    const auto u = propagate_linearly(function, particle->inputs.list());
    const auto is = [&](std::size_t i, const Quantity& quantity) {
        return LinearResult{nominal[i], u[i].standard_uncertainty}.is(quantity);
    };
    if (!is(0, modulus.young_modulus) || (modulus.poisson_ratio && !is(1, *modulus.poisson_ratio)))
        return std::nullopt;
    const RandomContact random = random_contact(
        {.diameter = {"diameter", 1}, .work_of_adhesion = {"work of adhesion", 0}, .particle = particle});
    return linear_results(random).first.standard_uncertainty;
}

RandomContact uncertain_contact(const Case& data, const Sample& sample, const SampleContact& contact, Law law,
                                const CalibrationResponse& response) {
    RandomContact random = independent_contact(data, sample, contact, law);
    if (response.density == 0 && response.work_of_adhesion == 0) return random;
    random.contact = [independent = std::move(random.contact), response,
                      calibrated_at = contact.pair.contact_modulus](std::span<const double> values) {
        ContactPair pair = independent(values);
        const double ratio = pair.contact_modulus / calibrated_at;
        pair.mass *= std::pow(ratio, response.density);
        pair.work_of_adhesion *= std::pow(ratio, response.work_of_adhesion);
        return pair;
    };
    return random;
}

}  // namespace ashimpact
