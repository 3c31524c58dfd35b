// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "pipeline/present/export/codes/codes.hpp"
#include "pipeline/present/export/codes/dem.hpp"
#include "solver/contact/sjkr.hpp"

namespace ashimpact {

namespace {

/// YADE's own damping is Tsuji's, cut at zero total force.
constexpr DemModel betan{
    .law = "hertz", .name = "betan", .damping = DampingLaw::tsuji, .end = Detachment::zero_force};

/// Whether that model has all of the contact; else Hertz's repulsion and added forces do it.
/// @throws InputError for a subject that neither can do
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

ExportFolder yade_folder(const ExportSubject& subject, const TableImage& /*image*/) {
    const bool own = takes_betan(subject);
    const double coefficient = subject.damping.nodes.front().coefficient;
    TemplateValues values = common_values(subject);
    values["damping_law"] = std::string(name_of(subject.damping.law));
    values["coefficient"] = exact(coefficient);
    values["exponent"] = exact(subject.damping.exponent);
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
