// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/contact/damping_choice.hpp"
#include "pipeline/app/contact/oblique_choice.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/app/contact/softened_contact.hpp"
#include "pipeline/app/contact/static_contact.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/motion/explicit_scheme.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

std::string trajectory_csv(const std::vector<TrajectoryPoint>& points) {
    std::string csv =
        "time [s],overlap [m],velocity [m/s],contact_radius [m],repulsive_force [N],attractive_force [N],"
        "damping_force [N]\n";
    for (const TrajectoryPoint& p : points) {
        const char* separator = "";
        for (const double value : {p.time, p.overlap, p.velocity, p.contact_radius, p.repulsive_force,
                                   p.attractive_force, p.damping_force}) {
            csv += separator + shortest(value);
            separator = ",";
        }
        csv += '\n';
    }
    return csv;
}

/// How an impact was solved: without a time step by the exact method.
struct Solution {
    ImpactResult result;
    std::optional<double> time_step;  ///< [s]
};

Solution solve(const CommandOptions& options, const Impact& impact) {
    const auto time_step = read_explicit_step(options, impact);
    if (!time_step) return {solve_impact(impact), time_step};
    if (options.has("--trajectory"))
        throw InputError("is written by the exact method alone", "--method taylor").at("--trajectory");
    return at_place("--method, --time-step", [&] {
        return Solution{solve_impact_explicit(impact, {.time_step = *time_step}), time_step};
    });
}

void run_impact_command(const CommandOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options);
    const DampingChoice damping = read_damping_choice(options, choice.contact);
    const double velocity = options.positive("--velocity", Dimension::velocity);
    const auto oblique = read_oblique(options, velocity);
    const Impact impact = choice.impact(damping.damping, oblique ? oblique->normal_velocity : velocity);
    const auto [result, time_step] = solve(options, impact);
    warn_of(regime_of(impact, result.maximum_overlap).warnings);
    if (options.has("--trajectory")) {
        const auto points = trajectory(impact, options.whole("--points"));
        write_file(options["--trajectory"], trajectory_csv(points));
        spdlog::info("{}: {} points", options["--trajectory"], points.size());
    }
    std::optional<ObliqueImpact> at_angle;
    std::optional<ObliqueResult> rebound;
    if (oblique) {
        at_angle = {impact, bodies_of(choice), oblique->tangential, oblique->friction};
        rebound = oblique_result(*at_angle, result);
    }
    if (!options.has("--json")) {
        out << impact_text(impact, result, oblique ? ", normal" : "");
        if (time_step) {
            TextList list;
            list.add("by the paper's scheme", "time step " + readable(*time_step, "s"));
            out << list.text(0);
        }
        out << (rebound ? oblique_text(*at_angle, *rebound) : std::string()) << requested_text(damping);
        return;
    }
    Json json = impact_json(impact, result);
    if (rebound) add_oblique(json, *at_angle, *rebound);
    add_requested(json, damping);
    json["method"] = options["--method"];
    if (time_step) json["time_step"] = quantity_json(*time_step, Dimension::time);
    add_notes(json, options.doubts());
    out << write_json(json, Digits::seventeen);
}

std::string verdict_text(const CriticalVelocity& result, bool plastic) {
    if (result.verdict == CaptureVerdict::finite) return value_text(*result.value, "m/s");
    const std::string outcome = result.verdict == CaptureVerdict::always_captured ? "captured" : "rebounds";
    return fmt::format("none: {} at every velocity{}", outcome, plastic ? " with an overlap up to R*" : "");
}

/// A critical velocity by the scheme of the paper.
struct ByScheme {
    double velocity;   ///< [m/s]
    double time_step;  ///< [s]
};

std::optional<ByScheme> by_scheme(const CommandOptions& options, const Impact& critical) {
    const auto time_step = read_explicit_step(options, critical);
    if (!time_step) return std::nullopt;
    return at_place("--method, --time-step", [&] {
        return ByScheme{explicit_critical_velocity(critical, {.time_step = *time_step}), *time_step};
    });
}

std::string result_text(const CriticalVelocityProblem& problem, const CriticalVelocity& result,
                        const std::optional<ByScheme>& scheme, bool at_angle) {
    TextList list;
    add_model(list, problem.law, problem.detachment, problem.damping, problem.contact);
    list.add(at_angle ? "critical velocity, normal" : "critical velocity",
             verdict_text(result, problem.law.is_plastic()));
    if (scheme)
        list.add(at_angle ? "by the paper's scheme, normal" : "by the paper's scheme",
                 fmt::format("{}, time step {}", value_text(scheme->velocity, "m/s"),
                             readable(scheme->time_step, "s")));
    if (result.verdict == CaptureVerdict::finite && !outside_model(*result.value)) {
        list.add("contact time",
                 result.contact_time
                     ? readable(*result.contact_time, "s")
                     : "none: the particle comes to rest ever more slowly, contact never ends");
        if (result.maximum_overlap) list.add("maximum overlap", readable(*result.maximum_overlap, "m"));
        list.add("energy", fmt::format("{} dissipated, {} spent in yielding, {} to break the contact",
                                       readable(result.dissipated, "J"), readable(result.plastic, "J"),
                                       readable(result.detachment_energy, "J")));
        bool rebounds = true;  // beyond v_c
        for (std::size_t i = 1; i < result.crossings.size(); ++i) {
            const double crossing = result.crossings[i];
            rebounds = !rebounds;
            list.add(rebounds ? "rebounds again" : "captured again",
                     (outside_model(crossing) ? "" : "above ") + value_text(crossing, "m/s"));
        }
    }
    return list.text(0);
}

void run_critical_velocity_command(const CommandOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options);
    const DampingChoice damping = read_damping_choice(options, choice.contact);
    const CriticalVelocityProblem problem{.law = choice.law,
                                          .detachment = choice.detachment,
                                          .damping = damping.damping,
                                          .contact = choice.contact};
    const CriticalVelocity result = at_place("--damping", [&] { return critical_velocity(problem); });
    std::string regime_at_capture;
    std::vector<Finding> doubts = options.doubts();
    const auto angle = read_angle(options);
    std::optional<ByScheme> scheme;
    constexpr double usual_velocity = 1;  // [m/s]; of the impact whose warnings are printed without a v_c
    if (result.value) {
        if (const auto doubt = outside_model(*result.value)) {
            warn_of({*doubt});
            doubts.push_back(*doubt);
        }
        if (!outside_model(*result.value)) {  // beyond, the numbers of the impact mean nothing
            const Impact critical = choice.impact(problem.damping, *result.value);
            scheme = by_scheme(options, critical);
            const Regime regime = regime_of(critical, result.maximum_overlap.value_or(0));
            warn_of(regime.warnings);
            regime_at_capture = regime_text(regime);
        }
    } else {
        if (angle) warn_idle("--angle", "there is no critical velocity");
        const Impact usual = choice.impact(problem.damping, usual_velocity);
        warn_of(regime_of(usual, solve_impact(usual).maximum_overlap).warnings);
    }
    if (!scheme && read_explicit_step(options, choice.impact(problem.damping, usual_velocity)))
        warn_idle("--method", result.value ? "the critical velocity is outside the model"
                                           : "there is no critical velocity");
    if (options.has("--json")) {
        Json json{{"law", problem.law.name()}};
        json.update(critical_velocity_json(law_critical_velocity(problem), problem.damping.law));
        if (angle) add_at_angle(json, *angle, result.value);
        if (scheme) {
            json["paper_explicit"] = {
                {"critical_velocity", quantity_json(scheme->velocity, Dimension::velocity)},
                {"time_step", quantity_json(scheme->time_step, Dimension::time)}};
            if (angle) add_at_angle(json["paper_explicit"], *angle, scheme->velocity);
        }
        add_further_damping(json, problem.damping, problem.contact);
        add_requested(json, damping);
        add_notes(json, doubts);
        out << write_json(json, Digits::seventeen);
        return;
    }
    out << result_text(problem, result, scheme, angle.has_value()) +
               (angle ? at_angle_text(*angle, result.value) : std::string()) + regime_at_capture +
               requested_text(damping);
}

/// One body of the pair. @p young and @p poisson name the options
ElasticBody read_body(const CommandOptions& options, const char* young, const char* poisson) {
    if (!options.has(poisson)) throw InputError("is missing", "Poisson's ratio, such as 0.2").at(poisson);
    return {.young_modulus = options.positive(young, Dimension::pressure),
            .poisson_ratio = options.number(poisson, Dimension::fraction)};
}

/// Refuses options that say in another way what @p option says.
void refuse_beside(const CommandOptions& options, const std::string& option,
                   std::initializer_list<const char*> others) {
    for (const char* other : others)
        if (options.has(other))
            throw InputError("both are given", "one of the two").at(option + ", " + other);
}

/// E*, given or of both bodies by Eq. 7 [Pa].
double read_contact_modulus(const CommandOptions& options) {
    if (options.has("--contact-modulus")) {
        refuse_beside(options, "--contact-modulus",
                      {"--young-modulus", "--poisson-ratio", "--wall-young-modulus", "--wall-poisson-ratio",
                       "--rigid-wall"});
        return options.positive("--contact-modulus", Dimension::pressure);
    }
    if (!options.has("--young-modulus"))
        throw InputError("neither is given",
                         "E* of the pair, or Young's modulus with --poisson-ratio and those of the wall")
            .at("--contact-modulus, --young-modulus");
    const ElasticBody particle = read_body(options, "--young-modulus", "--poisson-ratio");
    if (options.has("--rigid-wall")) {
        refuse_beside(options, "--rigid-wall", {"--wall-young-modulus", "--wall-poisson-ratio"});
        return at_place("--poisson-ratio", [&] { return contact_modulus(particle, RigidWall{}); });
    }
    if (!options.has("--wall-young-modulus"))
        throw InputError("neither is given", "Young's modulus of the wall, or --rigid-wall")
            .at("--wall-young-modulus, --rigid-wall");
    const ElasticBody wall = read_body(options, "--wall-young-modulus", "--wall-poisson-ratio");
    return at_place("--poisson-ratio, --wall-poisson-ratio", [&] { return contact_modulus(particle, wall); });
}

/// w, given or from both surface energies [J/m2].
double read_work_of_adhesion(const CommandOptions& options) {
    const auto energy = [&](const char* option) {
        return options.number(option, Dimension::energy_per_area);
    };
    if (options.has("--work-of-adhesion")) {
        refuse_beside(
            options, "--work-of-adhesion",
            {"--surface-energy", "--wall-surface-energy", "--interfacial-energy", "--adhesion-rule"});
        return energy("--work-of-adhesion");
    }
    if (!options.has("--surface-energy"))
        throw InputError("neither is given", "w of the pair, or both surface energies with --adhesion-rule")
            .at("--work-of-adhesion, --surface-energy");
    if (!options.has("--adhesion-rule"))
        throw InputError("is missing", joined(Names<AdhesionRule>::all)).at("--adhesion-rule");
    const auto rule =
        at_place("--adhesion-rule", [&] { return named<AdhesionRule>(options["--adhesion-rule"]); });
    SurfaceEnergies energies{.particle = energy("--surface-energy"), .wall = energy("--wall-surface-energy")};
    if (options.has("--interfacial-energy")) energies.interfacial = energy("--interfacial-energy");
    return at_place("--surface-energy, --wall-surface-energy, --interfacial-energy",
                    [&] { return work_of_adhesion(rule, energies); });
}

void run_contact_command(const CommandOptions& options, std::ostream& out) {
    CommandOptions typed = options;
    typed.text_of("--law") = "jkr";  // W_s is that of a JKR contact; all laws share the other properties
    typed.text_of("--contact-modulus") = shortest(read_contact_modulus(options));
    typed.text_of("--work-of-adhesion") = shortest(read_work_of_adhesion(options));
    const ContactChoice contact = read_contact(typed);
    const ContactPair& pair = contact.contact;
    const AdhesiveContact adhesive{.work_of_adhesion = pair.work_of_adhesion,
                                   .effective_radius = pair.effective_radius,
                                   .contact_modulus = pair.contact_modulus};
    const double energy = separation_energy(adhesive);
    const double velocity = std::sqrt(2 * energy / pair.mass);
    const double tabor = tabor_parameter(adhesive, usual_separation);
    const DampingChoice choice = read_damping_choice(options, pair);
    const bool damped =
        options.has("--damping") || choice.requested || is_damped(choice.damping, pair.parameters);
    const auto soft = read_softening(options, pair, damped ? std::optional(choice.damping) : std::nullopt);
    std::vector<Finding> doubts = options.doubts();
    std::vector<Finding> computed;
    const auto doubt_computed = [&](const char* option, const char* name, double value) {
        if (options.has(option)) return;
        if (const auto doubt = implausible_at(name, *plausible_range(name), {value}))
            computed.push_back(*doubt);
    };
    doubt_computed("--contact-modulus", "contact_modulus", pair.contact_modulus);
    doubt_computed("--work-of-adhesion", "work_of_adhesion", pair.work_of_adhesion);
    if (const auto doubt = outside_model(velocity)) computed.push_back(*doubt);
    constexpr double nearly_jkr = 1;  // from here on JKR is off by less than half
    if (tabor > 0 && tabor < dmt_limit)
        computed.push_back(
            {regime_code, Severity::doubt,
             fmt::format("Tabor parameter {:.3g} < 0.1: a hard contact, for which W_s and v_s, of a JKR "
                         "contact, are far too great; maugis-dugdale holds",
                         tabor)});
    else if (tabor > 0 && tabor < nearly_jkr)
        computed.push_back({regime_code, Severity::remark,
                            fmt::format("Tabor parameter {:.3g} < 1: W_s and v_s, of a JKR contact, are too "
                                        "great; maugis-dugdale holds",
                                        tabor)});
    TextList list;
    list.add("E*, contact modulus", readable(pair.contact_modulus, "Pa"));
    list.add("R*, effective radius", readable(pair.effective_radius, "m"));
    list.add("m, mass in motion", readable(pair.mass, "kg"));
    list.add("w, work of adhesion", readable(pair.work_of_adhesion, "J/m2"));
    list.add("W_s, separation energy", readable(energy, "J"));
    list.add("v_s, adhesion only",
             critical_velocity_text(
                 velocity, readable(velocity, "m/s") + ": below it adhesion captures without damping"));
    list.add("Tabor parameter", readable_number(tabor) + " (DMT holds below 0.1, JKR above 5)");
    if (damped) add_damping_lines(list, choice.damping, pair);
    if (soft) add_softened(list, *soft);
    Json at_rest = Json::object();
    add_static_contacts(options, contact, at_rest, list, computed);
    warn_of(computed);
    doubts.insert(doubts.end(), computed.begin(), computed.end());
    if (options.has("--json")) {
        Json json{{"contact_modulus", quantity_json(pair.contact_modulus, Dimension::pressure)},
                  {"effective_radius", quantity_json(pair.effective_radius, Dimension::length)},
                  {"mass", quantity_json(pair.mass, Dimension::mass)},
                  {"work_of_adhesion", quantity_json(pair.work_of_adhesion, Dimension::energy_per_area)},
                  {"separation_energy", quantity_json(energy, Dimension::energy)},
                  {"critical_velocity", quantity_json(velocity, Dimension::velocity)},
                  {"tabor_parameter", tabor}};
        if (damped) {
            json["damping_law"] = name_of(choice.damping.law);
            json["damping"] = quantity_json(choice.damping.coefficient, unit_of(choice.damping.law));
            add_further_damping(json, choice.damping, pair);
        }
        add_requested(json, choice);
        if (soft) json["softened"] = softened_json(*soft);
        json.update(at_rest);
        add_notes(json, doubts);
        out << write_json(json, Digits::seventeen);
        return;
    }
    out << list.text(0) << requested_text(choice);
}

}  // namespace

void add_contact_commands(const CommandLine& line) {
    Command contact = line.add("contact", "E*, R*, m, w, W_s and v_s of a sphere on a wall",
                               "ashimpact contact --diameter \"88 um\" --density \"2300 kg/m3\" "
                               "--young-modulus \"148 GPa\" --poisson-ratio 0.2 "
                               "--wall-young-modulus \"193 GPa\" --wall-poisson-ratio 0.29 "
                               "--work-of-adhesion \"0.3 J/m2\"",
                               run_contact_command);
    contact.add_sphere_options();
    contact.add("--partner-radius", "Q", "of a second sphere instead of a flat wall");
    contact.add("--partner-diameter", "Q", "of it, instead of its radius");
    contact.add("--partner-density", "Q", "of the second sphere");
    contact.add("--partner-mass", "Q", "of the second sphere, instead of its density");
    contact.add("--contact-modulus", "Q", "E* of the pair, instead of what follows");
    contact.add("--young-modulus", "Q", "of the sphere, \"148 GPa\"");
    contact.add("--poisson-ratio", "X", "of the sphere");
    contact.add("--wall-young-modulus", "Q", "of the wall, or of the second sphere");
    contact.add("--wall-poisson-ratio", "X", "of the wall, or of the second sphere");
    contact.add_flag("--rigid-wall", "the wall does not deform");
    contact.add("--work-of-adhesion", "Q", "w, \"0.3 J/m2\" (not a surface energy)");
    contact.add("--surface-energy", "Q", "of the sphere, from which w follows");
    contact.add("--wall-surface-energy", "Q", "of the wall");
    contact.add("--interfacial-energy", "Q", "of both, for the rule dupre");
    contact.add("--adhesion-rule", "NAME", "girifalco-good, dong2013, dupre: w from surface energies");
    contact.add("--roughness", "Q", "rms of both surfaces, reduces w (Rabinovich et al. 2000)");
    contact.add_damping_law_option();
    contact.add_damping_parameter_options();
    contact.add_damping_option();
    contact.add("--soften", "S",
                "also the constants with E* divided by S > 1 and the same e and v_c, for DEM codes");
    add_static_options(contact);
    contact.add_json_flag();

    Command impact = line.add("impact", "One impact of a sphere on a flat wall",
                              "ashimpact impact --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                              "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                              "--damping \"0.0141 kg/s\" --velocity \"2 m/s\"",
                              run_impact_command);
    impact.add_contact_options(true);
    impact.add_damping_option();
    impact.add("--velocity", "Q", "at first touch, \"2 m/s\"; normal to the wall unless --angle is given")
        ->required();
    impact.add("--angle", "Q", "from the normal, \"30 deg\"; --velocity is then that of the sphere");
    impact.add("--tangential-velocity", "Q", "along the wall, instead of --angle");
    impact.add("--friction", "MU", "coefficient of Coulomb friction, 0.1");
    impact.add("--spin", "Q", "\"1000 rad/s\"; positive where it adds to the slip (backspin)");
    impact.add_method_options();
    auto* trajectory =
        impact.add("--trajectory", "FILE", "write overlap, velocity and forces against time (CSV)");
    impact.add("--points", "INT", "number of points of the trajectory", "201")
        ->check(whole_number(2, 10'000'000))
        ->needs(trajectory);
    impact.add_json_flag();

    Command critical_velocity = line.add("critical-velocity", "The velocity below which a sphere is captured",
                                         "ashimpact critical-velocity --law brach-dunn --radius \"44 um\" "
                                         "--density \"2600 kg/m3\" --contact-modulus \"90 GPa\" "
                                         "--work-of-adhesion \"0.3 J/m2\" --damping \"0.0141 kg/s\"",
                                         run_critical_velocity_command);
    critical_velocity.add_contact_options(true);
    critical_velocity.add_damping_option();
    critical_velocity.add("--angle", "Q",
                          "from the normal, \"30 deg\": the critical velocity is then that of the sphere");
    critical_velocity.add_method_options();
    critical_velocity.add_json_flag();
}

}  // namespace ashimpact
