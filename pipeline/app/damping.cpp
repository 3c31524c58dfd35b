// SPDX-License-Identifier: GPL-3.0-or-later
#include <ostream>

#include "core/json/view.hpp"
#include "core/json/writer.hpp"
#include "core/text/error.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/impact_text.hpp"
#include "pipeline/app/measured_damping.hpp"
#include "pipeline/app/options/contact_options.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

Json damping_json(const Impact& impact, const DampingInversion& inversion) {
    Json json = impact_json(impact, inversion.impact);
    json["greatest_restitution"] = quantity_json(inversion.greatest_restitution, Dimension::fraction);
    return json;
}

void run_damping_command(const DampingOptions& options, std::ostream& out) {
    if (!options.impacts.empty()) {
        if (!options.velocity.empty() || !options.restitution.empty())
            throw InputError("a table of impacts and a single one are both given", "one of the two")
                .at("--impacts");
        run_measured_damping_command(options, out);
        return;
    }
    if (!options.frame_rate.empty() || !options.pixel_size.empty() || options.bin > 0 || options.frames > 0 ||
        !options.size_scatter.empty() || !options.sheet.empty())
        throw InputError("belong to a table of impacts", "--impacts FILE")
            .at("--frame-rate, --pixel-size, --frames, --size-scatter, --bin, --sheet");
    const ContactChoice choice = read_contact(options.contact);
    const DampingProblem problem{
        .law = choice.law,
        .detachment = choice.detachment,
        .damping_law = read_damping(options.contact).law,
        .contact = choice.contact,
        .velocity = read_positive_option("--velocity", options.velocity, Dimension::velocity),
        .restitution = read_option("--restitution", options.restitution, Dimension::fraction)};
    const DampingInversion inversion =
        at_place("--restitution", [&] { return damping_from_restitution(problem); });
    const Impact impact{.law = problem.law,
                        .detachment = problem.detachment,
                        .damping = inversion.damping,
                        .contact = problem.contact,
                        .velocity = problem.velocity};
    warn_of_regime(regime_of(impact, inversion.impact.maximum_overlap));
    out << (options.json ? write_json(damping_json(impact, inversion), Digits::seventeen)
                         : impact_text(impact, inversion.impact));
}

}  // namespace

void add_damping(const CommandLine& line) {
    auto [command, options] =
        line.add<DampingOptions>("damping", "The damping that gives back a measured restitution",
                                 "ashimpact damping --law dmt --radius \"44 um\" --density \"2600 kg/m3\" "
                                 "--contact-modulus \"90 GPa\" --work-of-adhesion \"0.3 J/m2\" "
                                 "--velocity \"2 m/s\" --restitution 0.2\n"
                                 "  (the same with --impacts impacts.csv instead of the last two)",
                                 run_damping_command);
    add_contact_options(*command, options->contact, ContactNeeds::required);
    add_text(*command, "--velocity", options->velocity, "Q", "at first touch, \"2 m/s\"");
    add_text(*command, "--restitution", options->restitution, "X",
             "e_n; 0: the smallest damping that captures");
    add_text(*command, "--impacts", options->impacts, "FILE",
             "instead of one impact a table of many (CSV, .xlsx, .ods), with a heading such as "
             "\"v_in [m/s], v_r "
             "[m/s]\": damping of each, fits, critical velocity with its interval");
    add_text(*command, "--sheet", options->sheet, "NAME", "of a spreadsheet with several tables");
    add_text(*command, "--frame-rate", options->frame_rate, "X", "of the camera, frames per second");
    add_text(*command, "--pixel-size", options->pixel_size, "Q", "of the camera, in the object, \"2 um\"");
    command
        ->add_option("--frames", options->frames, "positions that each velocity is the slope of; default 2")
        ->type_name("N")
        ->check(whole_number(2, 10'000));
    add_text(*command, "--size-scatter", options->size_scatter, "X",
             "relative standard deviation of single diameters, such as of a sieve, \"5 %\"");
    command->add_option("--order", options->order, "of the polynomial that is extrapolated; default 2")
        ->type_name("N")
        ->check(whole_number(1, 6));
    command->add_flag("--robust", options->robust, "bisquare weights in the extrapolated polynomial");
    command->add_option("--bin", options->bin, "rebounds to be put into one point")
        ->type_name("N")
        ->check(whole_number(1, 1'000'000));
    add_json_flag(*command, options->json);
}

}  // namespace ashimpact
