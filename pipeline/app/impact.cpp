// SPDX-License-Identifier: GPL-3.0-or-later
#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/view.hpp"
#include "core/json/writer.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/impact_text.hpp"
#include "pipeline/files/file.hpp"
#include "solver/motion/explicit_scheme.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

struct ImpactOptions {
    ContactOptions contact;
    std::string velocity;
    std::string method = "taylor";  ///< or "paper-explicit", Eqs. 31-34 of Dong et al. 2013
    std::string time_step;          ///< of the explicit method; empty: 10000 steps a Hertz contact
    std::string trajectory;         ///< CSV file to write; empty: none
    int points = 201;               ///< of the trajectory
    bool json = false;
};

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

/// How an impact was solved: 0 for the time step of the exact method.
struct Solution {
    ImpactResult result;
    double time_step;
};

Solution solve(const ImpactOptions& options, const Impact& impact) {
    constexpr double steps = 1e4;
    if (options.method == "taylor") {
        if (!options.time_step.empty())
            throw InputError("belongs to the explicit method", "--method paper-explicit").at("--time-step");
        return {solve_impact(impact), 0};
    }
    if (options.method != "paper-explicit")
        throw InputError("unknown method " + in_quotes(options.method), "taylor, paper-explicit")
            .at("--method");
    if (!options.trajectory.empty())
        throw InputError("is written by the exact method alone", "--method taylor").at("--trajectory");
    validate(impact);
    const double time_step = options.time_step.empty()
                                 ? explicit_time_step(impact, steps)
                                 : read_positive_option("--time-step", options.time_step, Dimension::time);
    return at_place("--method, --time-step", [&] {
        return Solution{solve_impact_explicit(impact, {.time_step = time_step}), time_step};
    });
}

void run_impact_command(const ImpactOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options.contact);
    const Impact impact{
        .law = choice.law,
        .detachment = choice.detachment,
        .damping = read_damping(options.contact),
        .contact = choice.contact,
        .velocity = read_positive_option("--velocity", options.velocity, Dimension::velocity)};
    const auto [result, time_step] = solve(options, impact);
    warn_of_regime(regime_of(impact, result.maximum_overlap));
    if (!options.trajectory.empty()) {
        const auto points = trajectory(impact, options.points);
        write_file(options.trajectory, trajectory_csv(points));
        spdlog::info("{}: {} points", options.trajectory, points.size());
    }
    if (!options.json) {
        out << impact_text(impact, result);
        return;
    }
    Json json = impact_json(impact, result);
    json["method"] = options.method;
    if (time_step > 0) json["time_step"] = quantity_json(time_step, Dimension::time);
    out << write_json(json, Digits::seventeen);
}

}  // namespace

void add_impact(const CommandLine& line) {
    auto [command, options] =
        line.add<ImpactOptions>("impact", "One normal impact of a sphere on a flat wall",
                                "ashimpact impact --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                                "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                                "--damping \"0.0141 kg/s\" --velocity \"2 m/s\"",
                                run_impact_command);
    add_contact_options(*command, options->contact, ContactNeeds::required);
    add_damping_option(*command, options->contact);
    command->add_option("--velocity", options->velocity, "at first touch, \"2 m/s\"")
        ->required()
        ->type_name("Q");
    command
        ->add_option("--method", options->method,
                     "taylor (exact) or paper-explicit (the paper's scheme, first order in the time step)")
        ->capture_default_str()
        ->type_name("NAME");
    add_text(*command, "--time-step", options->time_step, "Q",
             "of paper-explicit; default: 10000 steps a contact");
    auto* trajectory = add_text(*command, "--trajectory", options->trajectory, "FILE",
                                "write overlap, velocity and forces against time (CSV)");
    command->add_option("--points", options->points, "number of points of the trajectory")
        ->capture_default_str()
        ->check(whole_number(2, 10'000'000))
        ->needs(trajectory);
    add_json_flag(*command, options->json);
}

}  // namespace ashimpact
