// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/present/export/folder.hpp"
#include "solver/contact/sjkr.hpp"
#include "solver/damping/brach_dunn.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact {

namespace {

/// Powers of the time step in the error of the restitution. Apart from a constant, the force begins and ends
/// with overlap^a, a the least power in it, and at such an end Verlet's steps leave an error of the power
/// 1 + a.
using Powers = std::array<double, 4>;
constexpr Powers smooth{2, 2.5, 3.5, 4};
constexpr Powers square_root{1.5, 2, 2.5, 3};
constexpr Powers fourth_root{1.25, 1.5, 2, 2.25};

/// Powers of the overlap in the velocity of a sphere that leaves, by the same least power.
Powers end_powers_of(const Powers& powers) {
    if (powers == fourth_root) return {1, 1.25, 2, 2.25};
    if (powers == square_root) return {1, 1.5, 2, 2.5};
    return {1, 2, 2.5, 3};
}

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

/// zeta_A of Brach & Dunn's damping, which goes with zeta_H or is the same for every size and velocity; 0 of
/// other damping laws.
struct AdhesionDamping {
    double ratio = 0;  ///< zeta_A/zeta_H [1]
    double own = 0;    ///< [s/m]
};

AdhesionDamping adhesion_damping_of(const ExportSubject& subject) {
    const auto& parameters = subject.reference().contact.parameters;
    if (has_one_number(subject.damping_law)) return {};
    if (parameters.has(adhesion_damping_ratio)) return {.ratio = parameters[adhesion_damping_ratio]};
    return {.own = BrachDunnDamping::coefficients(0, parameters)[1]};
}

/// Brach & Dunn's damping behind its first coefficient, which may be that of repulsion alone [N].
std::string brach_dunn_formula(const ExportSubject& subject) {
    const ContactPair& contact = subject.reference().contact;
    const Attraction& attraction = *attraction_of(subject);
    if (attraction.formula == nullptr) return "*" + repulsion_formula(contact);
    const auto [ratio, own] = adhesion_damping_of(subject);
    if (own != 0)
        return fmt::format("*{} + {}*{}", repulsion_formula(contact), exact(own),
                           attraction.formula(contact));
    return fmt::format("*({} + {}*{})", repulsion_formula(contact), exact(ratio),
                       attraction.formula(contact));
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
                                            exact(4.0 / 3.0 * subject.reference().contact.contact_modulus));
                     },
                 .powers = fourth_root,
                 .lagging = {1, 2, 2.5, 3}},
    AddedDamping{
        .law = DampingLaw::hunt_crossley,
        .factor =
            [](const ExportSubject& subject) { return "*" + repulsion_formula(subject.reference().contact); },
        .powers = smooth,
        .lagging = {1, 2, 3, 4}},
    AddedDamping{.law = DampingLaw::brach_dunn,
                 .factor = [](const ExportSubject& subject) { return brach_dunn_formula(subject); },
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
    return row_of(dampings, subject.damping_law, &AddedDamping::law);
}

/// Powers of the forces, whatever velocity the code damps with.
Powers force_powers(const ExportSubject& subject) {
    const Attraction* attraction = attraction_of(subject);
    const Powers powers = attraction != nullptr ? attraction->powers : smooth;
    return subject.is_undamped() ? powers : std::min(powers, damping_of(subject)->powers);
}

Powers powers_of(const ExportSubject& subject, const DemCheck& check) {
    return check.damping_lags && !subject.is_undamped() ? damping_of(subject)->lagging
                                                        : force_powers(subject);
}

double square(double x) {
    return x * x;
}

/// Damping at the place f_ash_place, which is t^2, a sum of ramps through the nodes, cut into lines.
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
                                        (square(nodes[i + 1].t) - square(nodes[i].t));
        sum += fmt::format(" + ({0})*(f_ash_place>{1})*(f_ash_place-{1})", exact(slope - slope_before),
                           exact(square(nodes[i].t)));
        slope_before = slope;
        if ((i + 1) % ramps_a_line == 0 || last) {
            lines += fmt::format("variable         ash_curve{} atom \"{}\"\n", part, sum);
            sum = fmt::format("v_ash_curve{}", part++);
        }
    }
    return lines + fmt::format("variable         ash_curve atom \"{}\"\n", sum);
}

/// ln v_c as a polynomial of x = (ln d - middle)/half.
struct ThresholdFit {
    double middle = 0;
    double half = 1;
    Eigen::VectorXd powers{};
};

/// By values at Chebyshev nodes. @throws InputError where v_c(d) is not smooth
ThresholdFit threshold_fit(const ExportSubject& subject) {
    constexpr double accuracy = 1e-10;  // of v_c; e near v_c is more sensitive by two orders
    constexpr int least_degree = 6;
    constexpr int greatest_degree = 24;
    const auto logarithm = [&](double ln_d) {
        const double diameter = std::clamp(std::exp(ln_d), subject.from_diameter, subject.to_diameter);
        return std::log(threshold_at(subject, diameter).value.value_or(0));
    };
    ThresholdFit fit{.middle = std::log(subject.reference().diameter), .half = 1, .powers = {}};
    if (subject.one_size()) {
        fit.middle = std::log(subject.from_diameter);
        fit.powers = Eigen::VectorXd::Constant(1, logarithm(fit.middle));
        return fit;
    }
    const double lower = std::log(subject.from_diameter);
    const double upper = std::log(subject.to_diameter);
    fit.middle = 0.5 * (lower + upper);
    fit.half = 0.5 * (upper - lower);
    for (int degree = least_degree; degree <= greatest_degree; degree += 3) {
        const ChebyshevAxis axis{lower, upper, degree};
        Eigen::VectorXd values(degree + 1);
        for (int i = 0; i <= degree; ++i) values[i] = logarithm(axis.node(i));
        fit.powers = chebyshev_by_powers(degree + 1) * (axis.analysis() * values);
        double error = 0;
        for (int i = 0; i < degree; ++i) {
            const double place = 0.5 * (axis.node(i) + axis.node(i + 1));
            const double x = (place - fit.middle) / fit.half;
            double sum = 0;
            for (Eigen::Index k = fit.powers.size() - 1; k >= 0; --k) sum = sum * x + fit.powers[k];
            error = std::max(error, std::abs(sum - logarithm(place)));
        }
        if (error <= accuracy) return fit;
    }
    throw InputError("the critical velocity is not smooth enough over the sizes for a formula",
                     "a shorter range of diameters, or --at for one damping at every velocity")
        .at("--from-diameter, --to-diameter");
}

/// Keeps the place of the velocity of approach of each particle during its contact, as f_ash_place. What a
/// variable refers to is parsed again at each use, so that fixes hold the values.
std::string place_lines(const ExportSubject& subject) {
    const ThresholdFit fit = threshold_fit(subject);
    std::string lines =
        "# The damping follows v_in/v_c, by f_ash_place = asinh(sqrt(v_in/v_c - 1))^2.\nrun              0\n";
    std::string critical = exact(std::exp(fit.powers[0]));
    if (!subject.one_size()) {
        std::string formula = exact(fit.powers[fit.powers.size() - 1]);
        for (Eigen::Index k = fit.powers.size() - 2; k >= 0; --k)
            formula = fmt::format("({} + v_ash_size*{})", exact(fit.powers[k]), formula);
        lines += fmt::format(
            "variable         ash_size atom \"(ln(2*c_ash_radius) - ({}))/{}\"\n"
            "variable         ash_critical atom \"exp({})\"\n"
            "fix              ash_critical all store/state 1 v_ash_critical\n",
            exact(fit.middle), exact(fit.half), formula);
        critical = "f_ash_critical";
    }
    constexpr std::string_view place = "ln(sqrt(v_ash_excess) + sqrt(v_ash_excess + 1))^2";
    return lines +
           fmt::format(
               "variable         ash_excess atom \"(-vz>{0})*(-vz/{0} - 1)\"\n"
               "variable         ash_place atom \"{1}\"\n"
               "fix              ash_place all store/state 1 v_ash_place\n"
               "variable         ash_place atom \"(v_ash_overlap<=0)*{1} + (v_ash_overlap>0)*f_ash_place\"\n",
               critical, place);
}

std::string damping_variable(const ExportSubject& subject) {
    const AshSize& ash = subject.reference();
    std::string lines;
    std::string formula = exact(ash.damping.critical());
    if (subject.depends_on_velocity()) {
        lines = place_lines(subject) + velocity_curve(ash.damping.nodes) +
                "fix              ash_curve all store/state 1 v_ash_curve\n";
        formula = "f_ash_curve";
    }
    if (subject.exponent != 0)
        formula += fmt::format("*(2*c_ash_radius/{})^({})", exact(ash.diameter), exact(subject.exponent));
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
    const bool tsuji = subject.damping_law == betan.damping;
    if (tsuji && subject.law.name() == betan.law && subject.detachment == betan.end) {
        if (subject.exponent != 0)
            throw InputError("YADE: one `betan` is for every size", "--damping-exponent 0");
        if (subject.friction > 0)
            throw InputError(
                "YADE: its `betan` ends at zero force, where the spring along the wall is still loaded",
                "--detachment zero-overlap with --friction");
        return true;
    }
    if (const auto reason = added_forces_refusal(subject))
        throw InputError("YADE: " + *reason,
                         "hertz, dmt, brach-dunn, sjkr with zero-overlap; hertz with --damping-law "
                         "tsuji --detachment zero-force");
    return false;
}

/// Nodes of the damping for impacts.py, (t^2, coefficient).
std::string yade_nodes(const ExportSubject& subject) {
    std::string list;
    for (const DampingNode& node : subject.reference().damping.nodes)
        list += fmt::format("{}({}, {})", list.empty() ? "" : ", ", exact(square(node.t)),
                            exact(node.coefficient));
    return "[" + list + "]";
}

/// Middle, half width and coefficients of threshold_fit() for impacts.py; None without need of them.
std::string yade_threshold(const ExportSubject& subject) {
    if (!subject.depends_on_velocity()) return "None";
    const ThresholdFit fit = threshold_fit(subject);
    std::string list;
    for (const double power : fit.powers) list += (list.empty() ? "" : ", ") + exact(power);
    return fmt::format("({}, {}, [{}])", exact(fit.middle), exact(fit.half), list);
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
        return fmt::format("it has no damping law {}", name_of(subject.damping_law));
    if (zero_force && !subject.is_undamped())
        return "its walls do not let go where the force of contact and damping is zero; zero-overlap does it";
    return std::nullopt;
}

std::string added_force_lines(const ExportSubject& subject, AddedForces added) {
    const bool damped = !subject.is_undamped();
    if (!added.attraction && !damped) return "";
    std::string lines =
        "compute          ash_radius all property/atom radius\n"
        "variable         ash_overlap atom \"c_ash_radius - z + v_ash_wall_z\"\n"
        "variable         ash_depth atom \"v_ash_overlap*(v_ash_overlap>0)\"\n";
    if (damped) lines += damping_variable(subject);
    std::string force = added.damping ? "-v_ash_damping*vz" : "";
    if (added.attraction) {
        lines += fmt::format("variable         ash_attraction atom \"{}\"\n",
                             attraction_of(subject)->formula(subject.reference().contact));
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
    if (added.damping && subject.depends_on_velocity())
        lines.emplace_back(
            "eta follows the velocity of approach over v_c, which `fix store/state` keeps for as long as the "
            "contact lasts");
    return lines;
}

std::string friction_conversion(const ExportSubject& subject) {
    return fmt::format(
        "friction {}: a spring along the wall, {} times as stiff as the contact normal to it, that slips "
        "where its force "
        "exceeds the friction of the repulsion; nothing resists rolling, so that a sphere that stays rolls "
        "on",
        shortest(subject.friction), shortest(tangential_stiffness_ratio));
}

ExportFile dem_expected(const ExportSubject& subject, const DemCheck& check) {
    Json more{{"log", "log.impacts"},
              {"powers", powers_of(subject, check)},
              {"end_powers", end_powers_of(force_powers(subject))},
              {"tolerance", check.tolerance}};
    if (check.free_flight) more["end"] = "free-flight";
    if (subject.friction > 0) more["tangential_tolerance"] = dem_tangential_tolerance;
    return expected_json(subject, check.code, more);
}

ExportFolder yade_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    const bool own = takes_betan(subject);
    const double coefficient = subject.reference().damping.critical();
    TemplateValues values = common_values(subject);
    values["damping_law"] = std::string(name_of(subject.damping_law));
    values["exponent"] = exact(subject.exponent);
    values["adhesion_damping_ratio"] = exact(adhesion_damping_of(subject).ratio);
    values["adhesion_damping"] = exact(adhesion_damping_of(subject).own);
    // The force of `betan` is 2 betan sqrt(m dF/d(delta)) v with dF/d(delta) = (3/2) k sqrt(delta), so that
    // betan = c/sqrt(6). `en` would be a fit of betan (Thornton et al. 2013) that is off by some 1e-4.
    values["damping_ratio"] = own ? exact(coefficient / std::sqrt(6.0)) : "None";
    values["cohesion_energy_density"] =
        exact(subject.law.takes(cohesion_energy_density)
                  ? subject.reference().contact.parameters[cohesion_energy_density]
                  : 0);
    values["nodes"] = yade_nodes(subject);
    values["threshold"] = yade_threshold(subject);
    values["partner"] = subject.partner ? fmt::format("({}, {})", exact(subject.partner->radius),
                                                      exact(subject.partner->mass))
                                        : "None";
    values["own_scene"] =
        subject.partner
            ? "call `ash_forces(pairs)` before each step, with the pairs (ash, partner) of bodies."
            : "call `ash_forces()` before each step; the wall is z = 0.";
    values["tangential_ratio"] = exact(tangential_stiffness_ratio);
    values["command"] = "yade -n -x impacts.py >yade.log 2>&1 || { tail -n 20 yade.log >&2; exit 1; }";
    std::vector<std::string> conversions{
        subject.partner
            ? "repulsion: YADE's Hertz-Mindlin; young = 2 E*, nu = 0 for both spheres"
            : "repulsion: YADE's Hertz-Mindlin; its wall has R* = R/2, young = 2 sqrt(2) E*, nu = 0",
        own ? "damping: YADE's `betan` = c/sqrt(6), which is Tsuji's damping cut at zero total force"
            : "attraction and damping: own forces by O.forces.setPermF before each step while in "
              "contact, up to zero overlap"};
    if (subject.friction > 0) conversions.push_back(friction_conversion(subject));
    return {{"README.md", filled("yade/README.md", values)},
            {"impacts.py", filled("yade/impacts.py", values)},
            {"run.sh", filled("common/run_dem.sh", values)},
            unchanged("common/compare.py"),
            assumptions(subject, conversions),
            dem_expected(subject, {.code = "yade", .tolerance = 1e-5, .damping_lags = own})};
}

}  // namespace ashimpact
