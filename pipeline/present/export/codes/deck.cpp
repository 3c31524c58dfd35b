// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/codes/deck.hpp"

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/case/laws.hpp"

namespace ashimpact {

namespace {

/// A sphere of the deck; numbers or variables.
struct SphereWords {
    int atom;
    std::string diameter;
    std::string mass;
    std::string density;
};

std::string sphere_lines(const DemCode& code, const SphereWords& sphere) {
    return fmt::format("set              atom {0} diameter {1}\nset              atom {0} {2} {3}\n",
                       sphere.atom, sphere.diameter, code.sets_mass ? "mass" : "density",
                       code.sets_mass ? sphere.mass : sphere.density);
}

std::string body_lines(const ExportSubject& subject, const DemCode& code) {
    std::string ash = sphere_lines(
        code, {.atom = 1, .diameter = "${diameter}", .mass = "${mass}", .density = exact(subject.density)});
    if (!subject.partner) return ash;
    const auto [radius, mass] = *subject.partner;
    return "create_atoms     1 single 0 0 ${partner_z} units box\n" + ash +
           sphere_lines(code, {.atom = 2,
                               .diameter = exact(2 * radius),
                               .mass = exact(mass),
                               .density = exact(sphere_density(radius, mass))});
}

}  // namespace

ExportFolder deck_folder(const ExportSubject& subject, const DemCode& code, const Deck& deck,
                         TemplateValues values) {
    const bool pair = subject.partner.has_value();
    if (pair) {
        values["partner_radius"] = readable(subject.partner->radius, "m");
        values["partner_mass"] = readable(subject.partner->mass, "kg");
    }
    // A pair has no `ash_lag`, so that its steps have to be shorter for the same error; they cost less, too.
    values["resolutions"] = pair ? "10000 15000 22500 33750 50000" : "2000 3000 4500 6750 10000";
    values["coarsest"] = pair ? "10000" : "2000";
    values["finest"] = pair ? "50000" : "10000";
    values["code"] = code.name;
    values["program"] = code.program;
    values["command"] = code.command;
    values["tried"] = code.tried;
    values["setup"] = code.setup;
    values["bodies"] = body_lines(subject, code);
    values["contact"] = deck.contact;
    values["title"] = pair ? "of two spheres, the contact of ash_pair.in" : "on the wall of ash_wall.in";
    values["position"] = pair ? "z[1]-z[2]" : "z[1]";
    values["speed"] = pair ? "vz[1]-vz[2]" : "vz[1]";
    values["place"] = pair ? "partner_z" : "ash_wall_z";
    ExportFolder folder{
        {"README.md", filled(pair ? "common/README_pair.md" : "common/README_dem.md", values)},
        impact_variables(subject),
        {"in.impacts", filled("common/in.impacts", values)},
        {"run.sh", filled("common/run_dem.sh", values)},
        unchanged("common/compare.py")};
    folder.insert(folder.end(), deck.files.begin(), deck.files.end());
    folder.push_back(assumptions(subject, deck.conversions));
    folder.push_back(dem_expected(subject, deck.check));
    return folder;
}

double pair_damping(const ExportSubject& subject) {
    return subject.damping.coefficient(subject.from_diameter, 0);
}

void require_pair_contact(const ExportSubject& subject, const DemCode& code, bool also_jkr) {
    const std::string_view law = subject.law.name();
    const SizedDamping& damping = subject.damping;
    const auto refuse = [&](const std::string& reason) {
        throw InputError(fmt::format("{}: its contact of two spheres {}", code.name, reason),
                         also_jkr ? "hertz, dmt, or jkr with load-controlled; damping constant"
                                  : "hertz, dmt; damping constant");
    };
    const bool jkr = also_jkr && law == "jkr";
    if (law != "hertz" && law != "dmt" && !jkr) refuse(fmt::format("knows no {}", law));
    const bool elastic_end = subject.detachment == Detachment::zero_force && damping.is_zero();
    if (jkr && subject.detachment != Detachment::load_controlled)
        refuse(fmt::format("ends at the greatest tension, load-controlled, not at {}",
                           name_of(subject.detachment)));
    if (!jkr && subject.detachment != Detachment::zero_overlap && !elastic_end)
        refuse(fmt::format("ends at zero overlap, not at {}", name_of(subject.detachment)));
    if (damping.is_zero()) return;
    if (damping.depends_on_velocity()) refuse("knows no damping that depends on the velocity of approach");
    if (damping.law != DampingLaw::constant)
        refuse(fmt::format("has no damping {} with its coefficient", name_of(damping.law)));
    if (damping.exponent != 0 && !subject.one_size())
        refuse("has one damping for every size, which is --damping-exponent 0");
}

}  // namespace ashimpact
