// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/critical_velocity.hpp"

#include <ostream>

#include <fmt/format.h>

#include "core/json/writer.hpp"
#include "core/quantities/readable.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/impact_text.hpp"
#include "pipeline/app/options/contact_options.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/table.hpp"

namespace ashimpact {

namespace {

struct CriticalVelocityOptions {
    ContactOptions contact;
    bool json = false;
};

std::string verdict_text(const CriticalVelocity& result) {
    switch (result.verdict) {
        case CaptureVerdict::finite:
            return readable(*result.value, "m/s");
        case CaptureVerdict::always_captured:
            return "none: captured at every velocity";
        case CaptureVerdict::never_captured:
            return "none: rebounds at every velocity";
    }
    return {};
}

std::string critical_velocity_text(const CriticalVelocityProblem& problem, const CriticalVelocity& result) {
    TextList list;
    list.add("law", fmt::format("{}, contact ends at {}", problem.law.name(), name_of(problem.detachment)));
    list.add("damping",
             fmt::format("{} ({})", readable(problem.damping.coefficient, unit_of(problem.damping.law)),
                         name_of(problem.damping.law)));
    list.add("critical velocity", verdict_text(result));
    if (result.verdict == CaptureVerdict::finite) {
        list.add("contact time",
                 result.contact_time
                     ? readable(*result.contact_time, "s")
                     : "none: the particle comes to rest ever more slowly, contact never ends");
        if (result.maximum_overlap) list.add("maximum overlap", readable(*result.maximum_overlap, "m"));
        list.add("energy", fmt::format("{} dissipated, {} spent in yielding, {} to break the contact",
                                       readable(result.dissipated, "J"), readable(result.plastic, "J"),
                                       readable(result.detachment_energy, "J")));
        for (const double crossing : result.crossings)
            if (crossing != *result.value) list.add("another crossing", readable(crossing, "m/s"));
    }
    return list.text(0);
}

/// The regime of the impact at v_c.
Regime regime_at(const CriticalVelocityProblem& problem, const CriticalVelocity& result) {
    return regime_of({.law = problem.law,
                      .detachment = problem.detachment,
                      .damping = problem.damping,
                      .contact = problem.contact,
                      .velocity = *result.value},
                     result.maximum_overlap.value_or(0));
}

void run_critical_velocity_command(const CriticalVelocityOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options.contact);
    const CriticalVelocityProblem problem{.law = choice.law,
                                          .detachment = choice.detachment,
                                          .damping = read_damping(options.contact),
                                          .contact = choice.contact};
    const CriticalVelocity result = at_place("--damping", [&] { return critical_velocity(problem); });
    std::string regime;
    if (result.value) {
        warn_of_regime(regime_at(problem, result));
        regime = regime_text(regime_at(problem, result));
    }
    if (options.json) {
        Json json{{"law", problem.law.name()}};
        json.update(critical_velocity_json(law_critical_velocity(problem), problem.damping.law));
        out << write_json(json, Digits::seventeen);
        return;
    }
    out << critical_velocity_text(problem, result) + regime;
}

}  // namespace

void add_critical_velocity(const CommandLine& line) {
    auto [command, options] = line.add<CriticalVelocityOptions>(
        "critical-velocity", "The velocity below which a sphere is captured",
        "ashimpact critical-velocity --law brach-dunn --radius \"44 um\" "
        "--density \"2600 kg/m3\" --contact-modulus \"90 GPa\" "
        "--work-of-adhesion \"0.3 J/m2\" --damping \"0.0141 kg/s\"",
        run_critical_velocity_command);
    add_contact_options(*command, options->contact, ContactNeeds::required);
    add_damping_option(*command, options->contact);
    add_json_flag(*command, options->json);
}

}  // namespace ashimpact
