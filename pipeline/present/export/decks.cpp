// SPDX-License-Identifier: GPL-3.0-or-later
// LAMMPS and LIGGGHTS, which share their input language.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/present/export/folder.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

constexpr double captured_horizon = 8;   // Hertz contacts after which a captured sphere is still there
constexpr double rebound_horizon = 1.5;  // contacts
constexpr double slow_horizon = 4;       // near v_c, where a finite time step makes the contact longer
constexpr double slow_restitution = 0.02;
constexpr int captured_every = 50;    // steps between two rows of output; a rebound needs every step
constexpr int pair_every = 5;         // times as many: its steps are shorter
constexpr double cloud_steps = 200;   // of the shortest contact
constexpr double cloud_horizon = 6;   // of the longest contact
constexpr double soft_modulus = 5e6;  // below it LIGGGHTS requires `soft_particles yes` [Pa]

/// A code with the input language of LAMMPS.
struct DemCode {
    std::string_view name;     ///< LAMMPS
    std::string_view key;      ///< on the command line
    std::string_view program;  ///< lmp
    std::string_view command;  ///< that runs in.impacts
    std::string_view tried;    ///< version and package that were tried
    std::string_view setup;    ///< lines of the deck before the box: atom style, communication
    bool sets_mass;            ///< the deck sets the mass of a sphere; else its density
    double tolerance;
    std::span<const DemModel> walls;
    std::span<const DemModel> pairs;
    std::string_view pair_laws;     ///< for messages
    std::string_view soft_setup{};  ///< one more line of the deck where Young's modulus is below soft_modulus
};

constexpr std::array lammps_walls{
    DemModel{.law = "hertz", .name = "hertz", .damping = DampingLaw::constant},
    DemModel{.law = "dmt", .name = "dmt", .attracts = true, .damping = DampingLaw::constant},
    DemModel{.law = "brach-dunn", .name = "hertz", .damping = DampingLaw::constant},
    DemModel{.law = "sjkr", .name = "hertz", .damping = DampingLaw::constant},
    DemModel{.law = "jkr", .refusal = "LAMMPS of Debian 12 gives NaN for JKR on a wall past pull-off"}};
constexpr std::array lammps_pairs{
    DemModel{.law = "hertz", .name = "hertz", .damping = DampingLaw::constant},
    DemModel{.law = "dmt", .name = "dmt", .attracts = true, .damping = DampingLaw::constant},
    DemModel{.law = "jkr",
             .name = "jkr",
             .attracts = true,
             .damping = DampingLaw::constant,
             .end = Detachment::load_controlled,
             .end_words = "the greatest tension, load-controlled"}};
constexpr DemCode lammps{.name = "LAMMPS",
                         .key = "lammps",
                         .program = "lmp",
                         .command = "lmp -in in.impacts -log log.impacts -screen none -nocite",
                         .tried = "LAMMPS of 2022-01-06 (Debian 12: lammps), package GRANULAR",
                         .setup = "atom_style       sphere\n",
                         .sets_mass = true,
                         .tolerance = 1e-6,
                         .walls = lammps_walls,
                         .pairs = lammps_pairs,
                         .pair_laws = "hertz, dmt, or jkr with load-controlled; damping constant"};

constexpr std::array liggghts_walls{
    DemModel{.law = "hertz", .name = "hertz"}, DemModel{.law = "dmt", .name = "hertz"},
    DemModel{.law = "brach-dunn", .name = "hertz"}, DemModel{.law = "sjkr", .name = "hertz"},
    DemModel{
        .law = "jkr",
        .refusal = "LIGGGHTS has no JKR: its `cohesion sjkr` is an energy density times an area, law sjkr"}};
constexpr std::array liggghts_pairs{
    DemModel{.law = "hertz", .name = "edinburgh", .damping = DampingLaw::constant},
    DemModel{.law = "dmt", .name = "edinburgh", .attracts = true, .damping = DampingLaw::constant}};
constexpr DemCode liggghts{.name = "LIGGGHTS",
                           .key = "liggghts",
                           .program = "liggghts",
                           .command = "liggghts -in in.impacts -log log.impacts -screen none -echo none",
                           .tried = "LIGGGHTS-PUBLIC 3.8.0 (Debian 12: liggghts)",
                           .setup =
                               "hard_particles   yes                            # Young's moduli above "
                               "1e9 Pa\natom_style       granular\ncommunicate      single vel yes\n",
                           .sets_mass = false,
                           .tolerance = 1e-5,
                           .walls = liggghts_walls,
                           .pairs = liggghts_pairs,
                           .pair_laws = "hertz, dmt; damping constant",
                           .soft_setup =
                               "soft_particles   yes                            # Young's moduli below "
                               "5e6 Pa\n"};

/// The model of a wall. @throws InputError for what neither it nor added forces can do, with the reason
const DemModel& wall_model(const ExportSubject& subject, const DemCode& code) {
    const DemModel* model = model_of(code.walls, subject.law);
    if (model != nullptr && !model->refusal.empty())
        throw InputError(std::string(model->refusal), "hertz, dmt, brach-dunn, sjkr").at("--law");
    const auto reason = added_forces_refusal(subject);
    // Friction acts on the force of the model, which with friction has to be the repulsion alone.
    if (!reason && model != nullptr && model->attracts && subject.friction > 0)
        return *model_of(code.walls, Law::named("hertz"));
    if (!reason && model != nullptr) return *model;
    throw InputError(fmt::format("{}: {}", code.name, reason.value_or("its walls lack the law")),
                     "hertz, dmt, brach-dunn, sjkr with zero-overlap; any damping law");
}

/// The model of two spheres. @throws InputError with the reason if it lacks something of the contact
const DemModel& pair_model(const ExportSubject& subject, const DemCode& code) {
    const auto refuse = [&](const std::string& reason) {
        throw InputError(fmt::format("{}: its contact of two spheres {}", code.name, reason),
                         std::string(code.pair_laws));
    };
    const DemModel* model = model_of(code.pairs, subject.law);
    if (model == nullptr) refuse(fmt::format("knows no {}", subject.law.name()));
    const bool elastic_end = model->end == Detachment::zero_overlap &&
                             subject.detachment == Detachment::zero_force && subject.is_undamped();
    if (subject.detachment != model->end && !elastic_end)
        refuse(fmt::format("ends at {}, not at {}", model->end_words, name_of(subject.detachment)));
    if (subject.is_undamped()) return *model;
    if (subject.depends_on_velocity()) refuse("knows no damping that depends on the velocity of approach");
    if (subject.damping_law != model->damping)
        refuse(fmt::format("has no damping {} with its coefficient", name_of(subject.damping_law)));
    if (subject.exponent != 0 && !subject.one_size())
        refuse("has one damping for every size, which is --damping-exponent 0");
    return *model;
}

/// The damping of a pair [kg/s]; 0: none.
double pair_damping(const ExportSubject& subject) {
    return ash_at(subject, subject.from_diameter).damping(0);
}

/// Whether the model of a wall has the damping itself: one coefficient for every size and velocity, and no
/// friction, which would act on the damping, too.
bool damps_itself(const DemModel& model, const ExportSubject& subject) {
    return subject.damping_law == model.damping && subject.friction == 0 && !subject.depends_on_velocity() &&
           subject.exponent == 0;
}

AddedForces added_to(const DemModel& model, const ExportSubject& subject) {
    return {.attraction = subject.law.is_adhesive() && !model.attracts,
            .damping = !damps_itself(model, subject) && !subject.is_undamped()};
}

double hertz_time(const ExportSubject& subject, const ExpectedImpact& impact) {
    return hertz_contact_time(contact_at(subject, impact.diameter), impact.velocity);
}

/// impacts.in: the impacts as index variables; ash_wall_z or partner_z last.
ExportFile impact_variables(const ExportSubject& subject) {
    const auto impacts = expected_impacts(subject);
    std::string text = "# The impacts of expected.json; SI units.\n";
    const auto list = [&](std::string_view name, const auto& value) {
        text += fmt::format("variable         {} index", name);
        for (const ExpectedImpact& impact : impacts) text += " " + value(impact);
        text += "\n";
    };
    std::size_t number = 0;
    list("number", [&](const ExpectedImpact&) { return std::to_string(++number); });
    list("diameter", [](const ExpectedImpact& each) { return exact(each.diameter); });
    list("mass", [&](const ExpectedImpact& each) { return exact(particle_mass(subject, each.diameter)); });
    list("velocity", [](const ExpectedImpact& each) { return exact(each.velocity); });
    if (subject.friction > 0)
        list("sideways", [](const ExpectedImpact& each) { return exact(each.tangential_velocity); });
    list("contact_time", [&](const ExpectedImpact& each) {
        return exact(each.contact_time.value_or(hertz_time(subject, each)));
    });
    list("horizon", [](const ExpectedImpact& each) {  // steps to run, in contacts
        return exact(each.outcome == Outcome::capture      ? captured_horizon
                     : each.restitution < slow_restitution ? slow_horizon
                                                           : rebound_horizon);
    });
    list("every", [&](const ExpectedImpact& each) {
        return std::to_string((each.outcome == Outcome::capture ? captured_every : 1) *
                              (subject.partner ? pair_every : 1));
    });
    list(subject.partner ? "partner_z" : "ash_wall_z", [&](const ExpectedImpact& each) {
        if (!subject.partner) return exact(-each.diameter / 2);
        // Two spheres touch only where they are closer than the sum of their radii.
        const double touching = each.diameter / 2 + subject.partner->radius;
        return exact(-touching * (1 - 2 * std::numeric_limits<double>::epsilon()));
    });
    return {"impacts.in", text};
}

/// Values of the decks: box, skin, time step of the cloud.
TemplateValues deck_values(const ExportSubject& subject) {
    double fastest = 0;
    double shortest_contact = std::numeric_limits<double>::infinity();
    double longest_contact = 0;
    for (const ExpectedImpact& each : expected_impacts(subject)) {
        fastest = std::max(fastest, each.velocity);
        shortest_contact = std::min(shortest_contact, each.contact_time.value_or(shortest_contact));
        longest_contact =
            std::max({longest_contact, each.contact_time.value_or(0), hertz_time(subject, each)});
    }
    if (!std::isfinite(shortest_contact)) shortest_contact = longest_contact;
    TemplateValues values = common_values(subject);
    const double size = subject.to_diameter + (subject.partner ? 2 * subject.partner->radius : 0);
    const double steps = std::ceil(cloud_horizon * longest_contact / shortest_contact * cloud_steps);
    values.merge(TemplateValues{{"box", exact(5 * size)},
                                {"skin", exact(0.05 * subject.from_diameter)},
                                {"shortest", readable(shortest_contact, "s")},
                                {"fastest", exact(fastest)},
                                {"time_step", exact(shortest_contact / cloud_steps)},
                                {"steps", fmt::format("{:.0f}", steps)},
                                {"cloud_box", exact(100 * size)},
                                {"cloud_top", exact(1000 * size)},
                                {"young_modulus", exact(2 * subject.reference().contact.contact_modulus)}});
    return values;
}

/// Lines for a sphere of the deck; numbers or variables.
std::string sphere_lines(const DemCode& code, int atom, const std::string& diameter, const std::string& mass,
                         const std::string& density) {
    return fmt::format("set              atom {0} diameter {1}\nset              atom {0} {2} {3}\n", atom,
                       diameter, code.sets_mass ? "mass" : "density", code.sets_mass ? mass : density);
}

std::string body_lines(const ExportSubject& subject, const DemCode& code) {
    const std::string ash =
        sphere_lines(code, 1, "${diameter}", "${mass}", exact(subject.reference().density));
    if (!subject.partner) return ash;
    const auto [radius, mass] = *subject.partner;
    return "create_atoms     1 single 0 0 ${partner_z} units box\n" + ash +
           sphere_lines(code, 2, exact(2 * radius), exact(mass), exact(sphere_density(radius, mass)));
}

/// What a folder for such a code has beside the common files.
struct Deck {
    std::string contact;                   ///< lines of in.impacts: the contact and the integrator
    ExportFolder files;                    ///< that these lines include, and examples
    std::vector<std::string> conversions;  ///< for assumptions.md
};

/// All files of a deck. @param values from deck_values(), with those that only this code has
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
    values["setup"] =
        std::string(2 * subject.reference().contact.contact_modulus < soft_modulus ? code.soft_setup : "") +
        std::string(code.setup);
    values["bodies"] = body_lines(subject, code);
    values["contact"] = deck.contact;
    values["title"] = pair ? "of two spheres, the contact of ash_pair.in" : "on the wall of ash_wall.in";
    values["position"] = pair ? "z[1]-z[2]" : "z[1]";
    values["speed"] = pair ? "vz[1]-vz[2]" : "vz[1]";
    values["place"] = pair ? "partner_z" : "ash_wall_z";
    const bool rubs = subject.friction > 0;
    values["sideways"] = rubs ? "${sideways}" : "0";
    values["sideways_name"] = rubs ? "sideways " : "";
    values["along"] = rubs
                          ? "compute          ash_spin all property/atom omegay\n"
                            "variable         along equal vx[1]\nvariable         spin equal -c_ash_spin[1]\n"
                          : "";
    values["along_names"] = rubs ? " v_along v_spin" : "";
    ExportFolder folder{
        {"README.md", filled(pair ? "common/README_pair.md" : "common/README_dem.md", values)},
        impact_variables(subject),
        {"in.impacts", filled("common/in.impacts", values)},
        {"run.sh", filled("common/run_dem.sh", values)},
        unchanged("common/compare.py")};
    folder.insert(folder.end(), deck.files.begin(), deck.files.end());
    folder.push_back(assumptions(subject, deck.conversions));
    folder.push_back(
        dem_expected(subject, {.code = code.key,
                               .tolerance = code.tolerance,
                               .damping_lags = pair,
                               .free_flight = subject.detachment == Detachment::load_controlled}));
    return folder;
}

/// The model's name and coefficients in LAMMPS. It takes half of w as surface energy; E = 2 E* with nu = 0 is
/// E* on a wall, whose effective modulus is E/(2(1 - nu)), and between spheres, where it is E/(2(1 - nu^2)).
std::string lammps_model(const DemModel& model, const ContactPair& contact, double damping) {
    if (!model.attracts)
        return fmt::format("{} {} {}", model.name, exact(4.0 / 3.0 * contact.contact_modulus),
                           exact(damping));
    return fmt::format("{} {} {} 0 {}", model.name, exact(2 * contact.contact_modulus), exact(damping),
                       exact(contact.work_of_adhesion / 2));
}

std::string lammps_conversion(const DemModel& model, std::string_view body, std::string_view modulus) {
    if (!model.attracts) return fmt::format("`{}`: K_n = (4/3) E*", model.name);
    return fmt::format(
        "`{}`: E = 2 E* with nu = 0, since {} takes {} as effective modulus; surface energy gamma = w/2",
        model.name, body, modulus);
}

/// K_t of a tangential spring K_t a [Pa]; the normal stiffness is 2 E* a.
double tangential_modulus(const ExportSubject& subject) {
    return tangential_stiffness_ratio * 2 * subject.reference().contact.contact_modulus;
}

ExportFolder lammps_pair_folder(const ExportSubject& subject) {
    const DemModel& model = pair_model(subject, lammps);
    const bool breaks = model.end == Detachment::load_controlled;
    const std::string file =
        softening_comment(subject) +
        fmt::format(
            "# Ash and its partner: law {}, contact ends at {}. Needs `pair_style granular` and the "
            "variables\n"
            "# ash_type and partner_type. `damping velocity` must stand there: the default, viscoelastic, is "
            "another law.\n{}pair_coeff       ${{ash_type}} ${{partner_type}} {} tangential {} damping "
            "velocity\n",
            subject.law.name(), name_of(subject.detachment),
            breaks ? "# Under jkr this version ends in an error with `linear_nohistory`.\n" : "",
            lammps_model(model, subject.reference().contact, pair_damping(subject)),
            breaks ? "linear_history 0 0 0" : "linear_nohistory 0 0");
    std::vector<std::string> conversions{
        lammps_conversion(model, "a pair", "E/(2(1 - nu^2))"),
        "R* and m* are those that LAMMPS makes of the radii and masses of both"};
    if (!subject.is_undamped())
        conversions.emplace_back(
            "`damping velocity` with eta in kg/s: F_d = -eta v of the relative velocity, as here");
    TemplateValues values = deck_values(subject);
    values["own_input"] =
        "`pair_style granular`, then `include ash_pair.in` with both types in `ash_type` and `partner_type`.";
    return deck_folder(subject, lammps,
                       {.contact = "comm_modify      vel yes cutoff " + values["skin"] +
                                   "\npair_style       granular\nvariable         ash_type index 1\n"
                                   "variable         partner_type index 1\ninclude          ash_pair.in\n"
                                   "fix              integrate all nve/sphere\n",
                        .files = {{"ash_pair.in", file}},
                        .conversions = conversions},
                       values);
}

/// The coefficient of restitution c by which `model edinburgh` knows the damping eta:
/// eta = 2 sqrt(m* k) L/sqrt(L^2 + pi^2), L = -ln c, k = (4/3) E* sqrt(R*). It is not e.
double edinburgh_restitution(const ExportSubject& subject, const ContactPair& contact) {
    const double greatest = 2 * std::sqrt(contact.mass * hertz_stiffness(contact));
    const double share = pair_damping(subject) / greatest;
    if (share >= 1)
        throw InputError(
            "LIGGGHTS: no coefficient of restitution of its `model edinburgh` gives that damping",
            "less than " + exact(greatest) + " kg/s")
            .at("--damping");
    return std::exp(-std::numbers::pi * share / std::sqrt(1 - share * share));
}

ExportFolder liggghts_pair_folder(const ExportSubject& subject) {
    const DemModel& model = pair_model(subject, liggghts);
    if (!subject.one_size() && (model.attracts || !subject.is_undamped()))
        throw InputError(
            "LIGGGHTS: its `model edinburgh` takes attraction and damping as numbers of two types, which are "
            "others for each size",
            "one size, or hertz without damping")
            .at("--from-diameter, --to-diameter");
    TemplateValues values = deck_values(subject);
    values["own_input"] = "`include ash_pair.in`; with more than one type its lists want more entries.";
    const ContactPair contact = contact_at(subject, subject.from_diameter);
    const double pull_off =
        model.attracts ? 2 * std::numbers::pi * contact.work_of_adhesion * contact.effective_radius : 0.0;
    values["restitution"] = exact(edinburgh_restitution(subject, contact));
    values["pull_off_force"] = exact(-pull_off);
    return deck_folder(
        subject, liggghts,
        {.contact = "neigh_modify     delay 0\ninclude          ash_pair.in\n"
                    "fix              integrate all nve/sphere\n",
         .files = {{"ash_pair.in", filled("liggghts/ash_pair.in", values)}},
         .conversions = {"`model edinburgh` with overlapExponent 1.5, UnloadingStiffness 1 and limitForce "
                         "off: Hertz with constant damping and constant attraction; youngsModulus 2 E* with "
                         "nu = 0 for both",
                         "coefficientRestitution c gives eta = 2 sqrt(m* k) L/sqrt(L^2 + pi^2), L = -ln c, "
                         "k = (4/3) E* sqrt(R*); it is not e",
                         "pullOffForce = -2 pi w R* under dmt"}},
        values);
}

}  // namespace

ExportFolder lammps_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    if (subject.partner) return lammps_pair_folder(subject);
    const DemModel& model = wall_model(subject, lammps);
    const AddedForces added = added_to(model, subject);
    const double damping = damps_itself(model, subject) ? subject.reference().damping.critical() : 0;
    const std::string file =
        softening_comment(subject) +
        fmt::format(
            "# Ash on the wall z = ash_wall_z: law {}, contact ends at zero overlap. Needs the variable "
            "ash_wall_z.\n# `damping velocity` must stand there: the default, viscoelastic, is another law. "
            "E = 2 E* and nu = 0: the\n# effective modulus of a wall is E/(2(1 - nu)) in this version. Its "
            "surface energy is w/2.\nfix              ash_wall all wall/gran granular {} tangential "
            "{} damping velocity zplane ${{ash_wall_z}} NULL\n",
            subject.law.name(), lammps_model(model, subject.reference().contact, damping),
            subject.friction > 0
                ? fmt::format("mindlin {} 0 {}", exact(tangential_modulus(subject)), exact(subject.friction))
                : "linear_nohistory 0 0") +
        added_force_lines(subject, added);
    std::vector<std::string> conversions{lammps_conversion(model, "its wall", "E/(2(1 - nu))"),
                                         "R* is the radius of the sphere: the wall is flat"};
    if (damping > 0) conversions.emplace_back("`damping velocity` with eta in kg/s: F_d = -eta v, as here");
    if (subject.friction > 0) conversions.push_back(friction_conversion(subject));
    TemplateValues values = deck_values(subject);
    values["cloud_words"] = "`in.cloud` throws many sizes at that wall. ";
    return deck_folder(
        subject, lammps,
        {.contact = "pair_style       none\ncomm_modify      cutoff " + values["skin"] +
                    "\nfix              integrate all nve/sphere\ninclude          ash_wall.in\n",
         .files = {{"ash_wall.in", file}, {"in.cloud", filled("lammps/in.cloud", values)}},
         .conversions = added_force_conversions(subject, added, std::move(conversions))},
        values);
}

ExportFolder liggghts_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    if (subject.partner) return liggghts_pair_folder(subject);
    const DemModel& model = wall_model(subject, liggghts);
    const bool rubs = subject.friction > 0;
    const AddedForces added = added_to(model, subject);
    const std::string file =
        softening_comment(subject) +
        fmt::format(
            "# Ash on the wall z = ash_wall_z: law {}, contact ends at zero overlap. Needs the variable "
            "ash_wall_z, and\n# ash_material.in before. The wall gives the Hertz repulsion alone.\n"
            "fix              ash_wall all wall/gran model {} primitive type 1 zplane ${{ash_wall_z}}\n",
            subject.law.name(),
            rubs ? "hertz/stiffness tangential history" : fmt::format("{} tangential off", model.name)) +
        added_force_lines(subject, added);
    TemplateValues values = deck_values(subject);
    values["cloud_words"] = "";
    values["stiffness"] = "";
    if (rubs)
        values["stiffness"] = fmt::format(
            "# The repulsion of `hertz` by its stiffness, and a spring along the wall.\n"
            "fix              ash_normal all property/global kn peratomtypepair 1 {}\n"
            "fix              ash_tangential all property/global kt peratomtypepair 1 {}\n"
            "fix              ash_no_gamman all property/global gamman peratomtypepair 1 0\n"
            "fix              ash_no_gammat all property/global gammat peratomtypepair 1 0\n",
            exact(4.0 / 3.0 * subject.reference().contact.contact_modulus),
            exact(tangential_modulus(subject)));
    std::vector<std::string> conversions{
        "`model hertz` with youngsModulus 2 E* and nu = 0 for sphere and wall: effective modulus E*",
        "coefficientRestitution 1: no damping of the code's own, which would follow another law",
        "R* is the radius of the sphere: the wall is flat"};
    if (rubs) conversions.push_back(friction_conversion(subject));
    return deck_folder(
        subject, liggghts,
        {.contact = "neigh_modify     delay 0\ninclude          ash_material.in\n"
                    "fix              integrate all nve/sphere\ninclude          ash_wall.in\n",
         .files = {{"ash_material.in", filled("liggghts/ash_material.in", values)}, {"ash_wall.in", file}},
         .conversions = added_force_conversions(subject, added, std::move(conversions))},
        values);
}

}  // namespace ashimpact
