#include "pipeline/sweep/impact_columns.hpp"

#include <limits>

#include "materials/error.hpp"
#include "materials/text.hpp"

namespace ashimpact {

namespace {

Impact impact_at(const ContactModel& model, const ImpactColumns& impacts, std::size_t i) {
    return {.law = model.law,
            .detachment = model.detachment,
            .damping = {model.damping_law, impacts.damping[i]},
            .contact = {.mass = impacts.mass[i],
                        .effective_radius = impacts.effective_radius[i],
                        .contact_modulus = impacts.contact_modulus[i],
                        .work_of_adhesion = impacts.work_of_adhesion[i],
                        .yield_pressure = impacts.yield_pressure[i]},
            .velocity = impacts.velocity[i]};
}

/// The command that computes an impact alone.
std::string command_of(const Impact& impact) {
    std::string command = "ashimpact impact --law " + std::string(impact.law.name()) + " --detachment " +
                          std::string(name_of(impact.detachment)) + " --damping-law " +
                          std::string(name_of(impact.damping.law));
    const auto add = [&](const char* option, double value) {
        command += std::string(" --") + option + " " + shortest(value);
    };
    add("mass", impact.contact.mass);
    add("radius", impact.contact.effective_radius);
    add("contact-modulus", impact.contact.contact_modulus);
    add("work-of-adhesion", impact.contact.work_of_adhesion);
    if (impact.law == Law::of<ThorntonNing>()) add("yield-pressure", impact.contact.yield_pressure);
    add("damping", impact.damping.coefficient);
    add("velocity", impact.velocity);
    return command;
}

void solve_into(const Impact& impact, const WantedResults& wanted, std::size_t i, ResultColumns& results) {
    if (!wanted.contact_time && !wanted.maximum_overlap) {
        results.restitution[i] = restitution_of(impact);
        return;
    }
    const ImpactResult result = solve_impact(impact);
    results.restitution[i] = result.restitution;
    if (wanted.contact_time)
        results.contact_time[i] = result.contact_time.value_or(std::numeric_limits<double>::quiet_NaN());
    if (wanted.maximum_overlap) results.maximum_overlap[i] = result.maximum_overlap;
}

}  // namespace

ResultColumns solve_one_by_one(const ContactModel& model, const ImpactColumns& impacts,
                               const WantedResults& wanted) {
    const std::size_t count = impacts.velocity.size();
    ResultColumns results;
    results.restitution.resize(count);
    if (wanted.contact_time) results.contact_time.resize(count);
    if (wanted.maximum_overlap) results.maximum_overlap.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Impact impact = impact_at(model, impacts, i);
        try {
            solve_into(impact, wanted, i, results);
        } catch (const ConvergenceError& error) {
            throw ConvergenceError(std::string(error.what()) + "; the impact: " + command_of(impact));
        }
    }
    return results;
}

}  // namespace ashimpact
