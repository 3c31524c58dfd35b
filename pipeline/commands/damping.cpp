#include "pipeline/commands/damping.hpp"

#include <ostream>

#include "pipeline/commands/impact.hpp"
#include "pipeline/json/quantity_json.hpp"
#include "pipeline/json/writer.hpp"
#include "solver/damping_inversion.hpp"

namespace ashimpact {

namespace {

Json damping_json(const Impact& impact, const DampingInversion& inversion) {
    Json json = impact_json(impact, inversion.impact);
    json["greatest_restitution"] = quantity_json(inversion.greatest_restitution, Dimension::fraction);
    return json;
}

}  // namespace

void run_damping_command(const DampingOptions& options, std::ostream& out) {
    const ContactChoice choice = read_contact(options.contact);
    const DampingProblem problem{
        .law = choice.law,
        .detachment = choice.detachment,
        .damping_law = read_damping(options.contact).law,
        .contact = choice.contact,
        .velocity = read_option("--velocity", options.velocity, Dimension::velocity),
        .restitution = read_option("--restitution", options.restitution, Dimension::fraction)};
    const DampingInversion inversion = damping_from_restitution(problem);
    const Impact impact{.law = problem.law,
                        .detachment = problem.detachment,
                        .damping = inversion.damping,
                        .contact = problem.contact,
                        .velocity = problem.velocity};
    out << (options.json ? write_json(damping_json(impact, inversion), Digits::seventeen)
                         : impact_text(impact, inversion.impact));
}

}  // namespace ashimpact
