// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/damping.hpp"

#include <ostream>

#include "core/error.hpp"
#include "core/json/writer.hpp"
#include "pipeline/app/commands/impact.hpp"
#include "pipeline/app/commands/measured_damping.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

Json damping_json(const Impact& impact, const DampingInversion& inversion) {
    Json json = impact_json(impact, inversion.impact);
    json["greatest_restitution"] = quantity_json(inversion.greatest_restitution, Dimension::fraction);
    return json;
}

}  // namespace

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

}  // namespace ashimpact
