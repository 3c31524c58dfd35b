// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/text/error.hpp"
#include "pipeline/present/export/folder.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/damping/brach_dunn.hpp"

namespace ashimpact {

namespace {

/// Powers of the time step in the error of the restitution. Apart from a constant, the force begins and ends
/// with overlap^a, a the least power in it, and at such an end Verlet's steps leave an error of the power
/// 1 + a.
using Powers = std::array<double, 4>;
constexpr Powers smooth{2, 2.5, 3.5, 4};
constexpr Powers square_root{1.5, 2, 2.5, 3};
constexpr Powers fourth_root{1.25, 1.5, 2, 2.25};

/// The attraction of a law as a force of its own.
struct Attraction {
    std::string_view law;
    std::string (*formula)(const ContactPair&);  ///< on a sphere in contact, positive; null: none [N]
    std::string_view words;                      ///< for assumptions.md
    Powers powers = smooth;
};

constexpr std::array attractions{
    Attraction{.law = "hertz", .formula = nullptr, .words = ""},
    Attraction{.law = "dmt",
               .formula =
                   [](const ContactPair& contact) {
                       return fmt::format("2*PI*{}*c_ash_radius", exact(contact.work_of_adhesion));
                   },
               .words = "attraction 2 pi w R* while in contact, by `fix addforce`"},
    Attraction{.law = "brach-dunn",  // 2 pi f sqrt(R delta), f^3 = 6 w^2 R E*/pi
               .formula =
                   [](const ContactPair& contact) {
                       const double w = contact.work_of_adhesion;
                       return fmt::format("2*PI*({}*c_ash_radius/PI)^(1/3)*sqrt(c_ash_radius*v_ash_depth)",
                                          exact(6 * w * w * contact.contact_modulus));
                   },
               .words = "attraction 2 pi f sqrt(R* overlap), f = (6 w^2 R* E*/pi)^(1/3), by `fix addforce`",
               .powers = square_root},
    Attraction{.law = "sjkr",
               .formula =
                   [](const ContactPair& contact) {
                       return fmt::format("PI*{}*c_ash_radius*v_ash_depth",
                                          exact(contact.parameters[cohesion_energy_density]));
                   },
               .words =
                   "attraction pi k_c R* overlap, by `fix addforce`; `cohesion sjkr` of LIGGGHTS takes the "
                   "area in which sphere and wall intersect, pi (2 R overlap - overlap^2), and needs k_c/2 "
                   "for it"}};

/// Hertz' repulsion of a sphere in contact, as a formula [N].
std::string repulsion_formula(const ContactPair& contact) {
    return exact(4.0 / 3.0 * contact.contact_modulus) + "*sqrt(c_ash_radius*v_ash_depth)*v_ash_depth";
}

const Attraction* attraction_of(const ExportSubject& subject);

/// zeta_A/zeta_H of Brach & Dunn's damping, 0 of other damping laws [1].
double adhesion_share(const ExportSubject& subject) {
    const double coefficient = subject.damping.nodes.front().coefficient;
    if (has_one_number(subject.damping.law) || coefficient == 0) return 0;
    return BrachDunnDamping::coefficients(coefficient, subject.contact.parameters)[1] / coefficient;
}

/// Repulsion and attraction, each in its share of the first coefficient of Brach & Dunn's damping [N].
std::string damped_forces_formula(const ExportSubject& subject) {
    const Attraction& attraction = *attraction_of(subject);
    if (attraction.formula == nullptr) return repulsion_formula(subject.contact);
    return fmt::format("{} + {}*{}", repulsion_formula(subject.contact), exact(adhesion_share(subject)),
                       attraction.formula(subject.contact));
}

/// A damping as a force of its own.
struct AddedDamping {
    DampingLaw law;
    std::string (*factor)(const ExportSubject&);  ///< of the coefficient, as a formula
    Powers powers;
    Powers lagging;  ///< where the code takes the velocity of half a step ago
};

constexpr std::array dampings{
    AddedDamping{.law = DampingLaw::constant,
                 .factor = [](const ExportSubject& /*subject*/) { return std::string(); },
                 .powers = smooth,
                 .lagging = {1, 2, 3, 4}},
    AddedDamping{.law = DampingLaw::contact_radius,
                 .factor = [](const ExportSubject& /*subject*/) -> std::string {
                     return "*sqrt(c_ash_radius*v_ash_depth)";
                 },
                 .powers = square_root,
                 .lagging = {1, 2, 3, 4}},
    AddedDamping{.law = DampingLaw::tsuji,
                 .factor =
                     [](const ExportSubject& subject) {
                         return fmt::format("*sqrt(mass*{}*sqrt(c_ash_radius))*sqrt(sqrt(v_ash_depth))",
                                            exact(4.0 / 3.0 * subject.contact.contact_modulus));
                     },
                 .powers = fourth_root,
                 .lagging = {1, 2, 2.5, 3}},
    AddedDamping{
        .law = DampingLaw::hunt_crossley,
        .factor = [](const ExportSubject& subject) { return "*" + repulsion_formula(subject.contact); },
        .powers = smooth,
        .lagging = {1, 2, 3, 4}},
    AddedDamping{
        .law = DampingLaw::brach_dunn,
        .factor = [](const ExportSubject& subject) { return "*(" + damped_forces_formula(subject) + ")"; },
        .powers = square_root,
        .lagging = {1, 2, 3, 4}}};

/// The row of a table with that key, null without any.
template <class Rows, class Key, class Column>
auto* row_of(const Rows& rows, const Key& key, Column column) {
    const auto found = std::ranges::find(rows, key, column);
    return found == rows.end() ? nullptr : &*found;
}

const Attraction* attraction_of(const ExportSubject& subject) {
    return row_of(attractions, subject.law.name(), &Attraction::law);
}

const AddedDamping* damping_of(const ExportSubject& subject) {
    return row_of(dampings, subject.damping.law, &AddedDamping::law);
}

Powers powers_of(const ExportSubject& subject, const DemCheck& check) {
    const Attraction* attraction = attraction_of(subject);
    const Powers powers = attraction != nullptr ? attraction->powers : smooth;
    if (subject.damping.is_zero()) return powers;
    const AddedDamping& damping = *damping_of(subject);
    return check.damping_lags ? damping.lagging : std::min(powers, damping.powers);
}

/// Damping coefficient at the velocity f_ash_memory, a sum of ramps through the nodes, cut into lines.
std::string velocity_curve(const std::vector<DampingNode>& nodes) {
    constexpr std::size_t ramps_a_line = 6;
    std::string lines;
    std::string sum = exact(nodes.front().coefficient);
    double slope_before = 0;
    std::size_t part = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool last = i + 1 == nodes.size();
        const double slope = last ? 0
                                  : (nodes[i + 1].coefficient - nodes[i].coefficient) /
                                        (nodes[i + 1].velocity - nodes[i].velocity);
        sum += fmt::format(" + ({0})*(f_ash_memory>{1})*(f_ash_memory-{1})", exact(slope - slope_before),
                           exact(nodes[i].velocity));
        slope_before = slope;
        if ((i + 1) % ramps_a_line == 0 || last) {
            lines += fmt::format("variable         ash_curve{} atom \"{}\"\n", part, sum);
            sum = fmt::format("v_ash_curve{}", part++);
        }
    }
    return lines + fmt::format("variable         ash_curve atom \"{}\"\n", sum);
}

/// Keeps the velocity of approach of each particle during its contact, as f_ash_memory. A variable would be
/// parsed again at each use.
constexpr const char* impact_memory =
    "variable         ash_impact atom \"-vz\"\n"
    "run              0\n"
    "fix              ash_memory all store/state 1 v_ash_impact\n"
    "variable         ash_impact atom \"(v_ash_overlap<=0)*(-vz) + (v_ash_overlap>0)*f_ash_memory\"\n";

std::string damping_variable(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    std::string lines;
    std::string formula = exact(damping.nodes.front().coefficient);
    if (damping.depends_on_velocity()) {
        lines = impact_memory + velocity_curve(damping.nodes);
        formula = "v_ash_curve";
    }
    if (damping.exponent != 0)
        formula += fmt::format("*(2*c_ash_radius/{})^({})", exact(damping.reference_diameter),
                               exact(damping.exponent));
    formula += damping_of(subject)->factor(subject);
    return lines + fmt::format("variable         ash_damping atom \"{}\"\n", formula);
}

/// Makes the damping second order in the time step.
constexpr const char* lag_correction =
    "# Velocity Verlet gives the damping the velocity half a step back, as if the mass were m - eta dt/2. "
    "This force\n# takes the error out: it divides the forces that stand above it by 1 + eta dt/(2 m).\n"
    "variable         ash_share atom \"(v_ash_overlap>=0)*v_ash_damping*dt/(2*mass)\"\n"
    "variable         ash_lag atom \"fz/(1 + v_ash_share) - fz\"\n"
    "fix              ash_lag all addforce 0 0 v_ash_lag\n";

/// YADE's own damping is Tsuji's, cut at zero total force.
constexpr DemModel betan{
    .law = "hertz", .name = "betan", .damping = DampingLaw::tsuji, .end = Detachment::zero_force};

/// Whether betan is the whole contact, else Hertz with added forces. @throws InputError if neither can
bool takes_betan(const ExportSubject& subject) {
    const SizedDamping& damping = subject.damping;
    if (damping.depends_on_velocity())
        throw InputError("YADE: it knows no damping that depends on the velocity of approach",
                         "damping that is the same at every velocity");
    if (damping.law == betan.damping && subject.law.is_adhesive() && !damping.is_zero())
        throw InputError(
            "YADE: Tsuji's damping with attraction is its `en` with `gamma`, whose restitution is off "
            "by a tenth (0.559 for 0.498) for a cause not known",
            "--damping-law constant or contact-radius, or law hertz");
    if (damping.law == betan.damping && subject.law.name() == betan.law && subject.detachment == betan.end) {
        if (damping.exponent != 0)
            throw InputError("YADE: one `betan` is for every size", "--damping-exponent 0");
        return true;
    }
    if (const auto reason = added_forces_refusal(subject))
        throw InputError("YADE: " + *reason,
                         "hertz, dmt, brach-dunn, sjkr with zero-overlap; hertz with --damping-law "
                         "tsuji --detachment zero-force");
    return false;
}

}  // namespace

const DemModel* model_of(std::span<const DemModel> models, const Law& law) {
    return row_of(models, law.name(), &DemModel::law);
}

std::optional<std::string> added_forces_refusal(const ExportSubject& subject) {
    if (attraction_of(subject) == nullptr) return fmt::format("its walls know no {}", subject.law.name());
    const bool zero_force = subject.detachment == Detachment::zero_force;
    if (subject.detachment != Detachment::zero_overlap && !zero_force)
        return fmt::format("its walls let go at zero overlap, not at {}", name_of(subject.detachment));
    if (damping_of(subject) == nullptr)
        return fmt::format("it has no damping law {}", name_of(subject.damping.law));
    if (zero_force && !subject.damping.is_zero())
        return "its walls do not let go where the force of contact and damping is zero; zero-overlap does it";
    return std::nullopt;
}

std::string added_force_lines(const ExportSubject& subject, AddedForces added) {
    const bool damped = !subject.damping.is_zero();
    if (!added.attraction && !damped) return "";
    std::string lines =
        "compute          ash_radius all property/atom radius\n"
        "variable         ash_overlap atom \"c_ash_radius - z + v_ash_wall_z\"\n"
        "variable         ash_depth atom \"v_ash_overlap*(v_ash_overlap>0)\"\n";
    if (damped) lines += damping_variable(subject);
    std::string force = added.damping ? "-v_ash_damping*vz" : "";
    if (added.attraction) {
        lines += fmt::format("variable         ash_attraction atom \"{}\"\n",
                             attraction_of(subject)->formula(subject.contact));
        force += (force.empty() ? "-" : " - ") + std::string("v_ash_attraction");
    }
    if (!force.empty())
        lines += fmt::format("variable         ash_force atom \"(v_ash_overlap>=0)*({})\"\n", force) +
                 "fix              ash_force all addforce 0 0 v_ash_force\n";
    if (damped) lines += lag_correction;
    return lines;
}

std::vector<std::string> added_force_conversions(const ExportSubject& subject, AddedForces added,
                                                 std::vector<std::string> lines) {
    if (added.attraction) lines.emplace_back(attraction_of(subject)->words);
    if (added.damping)
        lines.emplace_back("damping force -eta v on the normal velocity while in contact, by `fix addforce`");
    if (added.damping && subject.damping.depends_on_velocity())
        lines.emplace_back(
            "eta follows the velocity of approach, which `fix store/state` keeps for as long as the contact "
            "lasts");
    return lines;
}

ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check) {
    Json more{{"log", "log.impacts"}, {"powers", powers_of(subject, check)}, {"tolerance", check.tolerance}};
    if (check.free_flight) more["end"] = "free-flight";
    return expected_json(subject, check.code, more);
}

ExportFolder yade_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    const bool own = takes_betan(subject);
    const double coefficient = subject.damping.nodes.front().coefficient;
    TemplateValues values = common_values(subject);
    values["damping_law"] = std::string(name_of(subject.damping.law));
    values["coefficient"] = exact(coefficient);
    values["exponent"] = exact(subject.damping.exponent);
    values["adhesion_damping_ratio"] = exact(adhesion_share(subject));
    // The force of `betan` is 2 betan sqrt(m dF/d(delta)) v with dF/d(delta) = (3/2) k sqrt(delta), so that
    // betan = c/sqrt(6). `en` would be a fit of betan (Thornton et al. 2013) that is off by some 1e-4.
    values["damping_ratio"] = own ? exact(coefficient / std::sqrt(6.0)) : "None";
    values["cohesion_energy_density"] = exact(
        subject.law.takes(cohesion_energy_density) ? subject.contact.parameters[cohesion_energy_density] : 0);
    values["partner"] = subject.partner ? fmt::format("({}, {})", exact(subject.partner->radius),
                                                      exact(subject.partner->mass))
                                        : "None";
    values["own_scene"] =
        subject.partner
            ? "call `ash_forces(pairs)` before each step, with the pairs (ash, partner) of bodies."
            : "call `ash_forces()` before each step; the wall is z = 0.";
    values["command"] = "yade -n -x impacts.py >yade.log 2>&1 || { tail -n 20 yade.log >&2; exit 1; }";
    return {{"README.md", filled("yade/README.md", values)},
            {"impacts.py", filled("yade/impacts.py", values)},
            {"run.sh", filled("common/run_dem.sh", values)},
            unchanged("common/compare.py"),
            assumptions(
                subject,
                {subject.partner
                     ? "repulsion: YADE's Hertz-Mindlin; young = 2 E*, nu = 0 for both spheres"
                     : "repulsion: YADE's Hertz-Mindlin; its wall has R* = R/2, young = 2 sqrt(2) E*, nu = 0",
                 own ? "damping: YADE's `betan` = c/sqrt(6), which is Tsuji's damping cut at zero total force"
                     : "attraction and damping: own forces by O.forces.setPermF before each step while in "
                       "contact, up to zero overlap"}),
            dem_expected(subject, {.code = "yade", .tolerance = 1e-5, .damping_lags = own})};
}

}  // namespace ashimpact
