// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/present/export/codes/dem.hpp"
#include "pipeline/present/export/expected.hpp"
#include "solver/contact/sjkr.hpp"

namespace ashimpact {

namespace {

constexpr double yade_tolerance = 1e-5;

/// YADE's own damping is Tsuji's, cut at zero total force.
bool own_damping(const ExportSubject& subject) {
    return subject.law.name() == "hertz" && subject.damping.law == DampingLaw::tsuji &&
           subject.detachment == Detachment::zero_force;
}

void require_yade(const ExportSubject& subject) {
    if (subject.damping.depends_on_velocity())
        throw InputError("YADE: it knows no damping that depends on the velocity of approach",
                         "damping that is the same at every velocity");
    if (attracts(subject) && subject.damping.law == DampingLaw::tsuji && !subject.damping.is_zero())
        throw InputError(
            "YADE: Tsuji's damping with attraction is its `en` with `gamma`, whose restitution is off "
            "by a tenth (0.559 for 0.498) for a cause not known",
            "--damping-law constant or contact-radius, or law hertz");
    if (own_damping(subject)) {
        if (subject.damping.exponent != 0)
            throw InputError("YADE: one `betan` is for every size", "--damping-exponent 0");
        return;
    }
    if (const auto reason = added_forces_refusal(subject))
        throw InputError("YADE: " + *reason,
                         "hertz, dmt, brach-dunn, sjkr with zero-overlap; hertz with --damping-law "
                         "tsuji --detachment zero-force");
}

/// YADE's `betan`: its damping force is 2 betan sqrt(m dF/d(delta)) v with dF/d(delta) = (3/2) k sqrt(delta),
/// so that betan = c/sqrt(6). Its `en` would be a fit of betan (Thornton et al. 2013) that is off by some
/// 1e-4.
std::string damping_ratio_of(const ExportSubject& subject) {
    if (!own_damping(subject)) return "None";
    return exact(subject.damping.nodes.front().coefficient / std::sqrt(6.0));
}

}  // namespace

ExportFolder yade_folder(const ExportSubject& subject) {
    require_yade(subject);
    TemplateValues values = common_values(subject);
    values["damping_law"] = std::string(name_of(subject.damping.law));
    values["coefficient"] = exact(subject.damping.nodes.front().coefficient);
    values["exponent"] = exact(subject.damping.exponent);
    values["damping_ratio"] = damping_ratio_of(subject);
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
    return {
        {"README.md", filled("yade/README.md", values)},
        {"impacts.py", filled("yade/impacts.py", values)},
        {"run.sh", filled("common/run_dem.sh", values)},
        unchanged("common/compare.py"),
        assumptions(
            subject,
            {subject.partner
                 ? "repulsion: YADE's Hertz-Mindlin; young = 2 E*, nu = 0 for both spheres"
                 : "repulsion: YADE's Hertz-Mindlin; its wall has R* = R/2, young = 2 sqrt(2) E*, nu = 0",
             own_damping(subject)
                 ? "damping: YADE's `betan` = c/sqrt(6), which is Tsuji's damping cut at zero total force"
                 : "attraction and damping: own forces by O.forces.setPermF before each step while in "
                   "contact, up to zero overlap"}),
        dem_expected(subject,
                     {.code = "yade", .tolerance = yade_tolerance, .damping_lags = own_damping(subject)})};
}

}  // namespace ashimpact
