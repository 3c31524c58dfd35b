// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/glass.hpp"

#include <algorithm>

#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

/// The moduli of a run with the other glass in each sample that has oxides.
ModulusResult with_other_glass(ModulusResult moduli) {
    for (SampleModulus& sample : moduli.samples) {
        if (!sample.glass) continue;
        sample.young_modulus = sample.glass->other.young_modulus;
        sample.density = sample.glass->other.density;
        sample.poisson_ratio.reset();
        if (const auto& other = sample.glass->other.poisson_ratio)
            sample.poisson_ratio = make_quantity(*other, Dimension::fraction);
    }
    return moduli;
}

WithEitherGlass either(GlassSource used, double counts, double other) {
    return used == GlassSource::catalogue ? WithEitherGlass{counts, other} : WithEitherGlass{other, counts};
}

std::optional<WithEitherGlass> dynamic_velocity(const Case& data, const ReportedVelocity& reported,
                                                const LawMap<LawCriticalVelocity>& velocities,
                                                const ContactPair& other, GlassSource used) {
    const LawCriticalVelocity* velocity = reported.law ? velocities.find(*reported.law) : nullptr;
    if (velocity == nullptr || !velocity->velocity) return std::nullopt;
    const LawCriticalVelocity changed =
        law_critical_velocity({.law = *reported.law,
                               .detachment = velocity->detachment,
                               .damping = {data.damping_law, velocity->damping},
                               .contact = other});
    if (!changed.velocity) return std::nullopt;
    return either(used, velocity->velocity->value, changed.velocity->value);
}

}  // namespace

std::vector<std::optional<GlassEffect>> glass_effects(const Run& run,
                                                      const std::vector<SampleComparison>& reported) {
    std::vector<std::optional<GlassEffect>> effects(run.modulus.samples.size());
    const auto has_glass = [](const SampleModulus& sample) { return sample.glass.has_value(); };
    if (!std::ranges::any_of(run.modulus.samples, has_glass)) return effects;
    StageRecord unused;
    const ModulusResult moduli = with_other_glass(run.modulus);
    const ContactResult contacts = contact_stage(run.data, moduli, unused);
    const AnalyticResult analytic = analytic_stage(contacts, unused);
    for (std::size_t i = 0; i < effects.size(); ++i) {
        const SampleModulus& sample = run.modulus.samples[i];
        if (!sample.glass) continue;
        const GlassSource used = sample.glass->used ? GlassSource::from_chemistry : GlassSource::catalogue;
        GlassEffect effect{
            .used = used,
            .young_modulus = either(used, sample.young_modulus.value, moduli.samples[i].young_modulus.value),
            .contact_modulus = either(used, run.contact.samples[i].pair.contact_modulus,
                                      contacts.samples[i].pair.contact_modulus),
            .analytic_velocity = either(used, run.analytic.samples[i].critical_velocity,
                                        analytic.samples[i].critical_velocity)};
        if (reported[i].reported)
            effect.dynamic_velocity =
                dynamic_velocity(run.data, *reported[i].reported, run.critical_velocity.samples[i].laws,
                                 contacts.samples[i].pair, used);
        effects[i] = effect;
    }
    return effects;
}

}  // namespace ashimpact
