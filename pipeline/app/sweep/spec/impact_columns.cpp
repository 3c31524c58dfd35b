// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/impact_columns.hpp"

#include <Eigen/Core>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/options/contact_options.hpp"
#include "solver/batch/impact_batch.hpp"

namespace ashimpact {

namespace {

Impact impact_at(const ImpactModel& model, const ImpactColumns& impacts, std::size_t i) {
    ParameterValues<double> parameters;
    for (const auto& [name, values] : impacts.parameters) parameters.set(name, value_at(values, i));
    return {.law = model.law,
            .detachment = model.detachment,
            .damping = {model.damping_law, value_at(impacts.damping, i)},
            .contact = {.mass = value_at(impacts.mass, i),
                        .effective_radius = value_at(impacts.effective_radius, i),
                        .contact_modulus = value_at(impacts.contact_modulus, i),
                        .work_of_adhesion = value_at(impacts.work_of_adhesion, i),
                        .yield_pressure = value_at(impacts.yield_pressure, i),
                        .parameters = parameters},
            .velocity = value_at(impacts.velocity, i)};
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
    if (impact.law.uses_work_of_adhesion()) add("work-of-adhesion", impact.contact.work_of_adhesion);
    if (impact.law.is_plastic()) add("yield-pressure", impact.contact.yield_pressure);
    for (const LawParameter& parameter : impact.law.parameters()) {
        if (!impact.contact.parameters.has(parameter)) continue;
        command += " " + option_of(parameter) + " " + shortest(impact.contact.parameters[parameter]);
    }
    add("damping", impact.damping.coefficient);
    add("velocity", impact.velocity);
    return command;
}

/// Throws for the first impact that is no valid one an error of the variables that make it.
void refuse_first(const ImpactModel& model, const ImpactColumns& impacts) {
    for (std::size_t i = 0; i < impacts.velocity.size(); ++i) {
        try {
            validate(impact_at(model, impacts, i));
        } catch (const InputError& own) {
            throw InputError("at a point of the sweep, " + own.problem(), own.allowed()).at("/variables");
        }
    }
}

}  // namespace

ResultColumns solve_in_batch(const ImpactModel& model, const ImpactColumns& impacts,
                             const WantedResults& wanted) {
    const std::size_t count = impacts.velocity.size();
    ResultColumns results;
    const auto column = [&](std::vector<double>& values, bool is_wanted) -> double* {
        if (!is_wanted) return nullptr;
        values.resize(count);
        return values.data();
    };
    const BatchOutputs outputs{.restitution = column(results.restitution, true),
                               .contact_time = column(results.contact_time, wanted.contact_time),
                               .maximum_overlap = column(results.maximum_overlap, wanted.maximum_overlap)};
    BatchReport report;
    try {
        report = solve_impacts(batch_of(model, impacts), outputs,
                               {.turning_point = wanted.maximum_overlap,
                                .contact_time = wanted.contact_time,
                                .method = wanted.method,
                                .keep_failures = true});
    } catch (const InputError&) {
        refuse_first(model, impacts);
        throw;
    }
    for (const FailedImpact& failed : report.failed) {
        const auto place = static_cast<std::size_t>(failed.place);
        results.failed.push_back({place, failed.reason, command_of(impact_at(model, impacts, place))});
    }
    return results;
}

}  // namespace ashimpact
