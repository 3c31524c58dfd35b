#include <fmt/format.h>

#include "materials/base/error.hpp"
#include "pipeline/case/laws.hpp"
#include "pipeline/export/dem.hpp"
#include "pipeline/export/expected.hpp"

namespace ashimpact {

namespace {

constexpr double yade_tolerance = 1e-5;

/// YADE's `en` is Tsuji's damping cut at zero total force.
bool own_restitution(const ExportSubject& subject) {
    return subject.law.name() == "hertz" && subject.damping.law == DampingLaw::tsuji &&
           subject.detachment == Detachment::zero_force;
}

void require_yade(const ExportSubject& subject) {
    if (subject.damping.depends_on_velocity())
        throw InputError("YADE: it knows no damping that depends on the velocity of approach",
                         "damping that is the same at every velocity");
    if (subject.law.uses_work_of_adhesion() && subject.damping.law == DampingLaw::tsuji &&
        !subject.damping.is_zero())
        throw InputError(
            "YADE: Tsuji's damping with attraction is its `en` with `gamma`, whose restitution is off "
            "by a tenth (0.559 for 0.498) for a cause not known",
            "--damping-law constant or contact-radius, or law hertz");
    if (own_restitution(subject)) {
        if (subject.damping.exponent != 0)
            throw InputError("YADE: one `en` is for every size", "--damping-exponent 0");
        return;
    }
    if (const auto reason = added_forces_refusal(subject))
        throw InputError("YADE: " + *reason,
                         "hertz, dmt, brach-dunn with zero-overlap; hertz with --damping-law "
                         "tsuji --detachment zero-force");
}

/// e of the whole cloud: Tsuji's damping gives Hertz spheres the same one at any velocity and size.
std::string restitution_of(const ExportSubject& subject) {
    if (!own_restitution(subject)) return "None";
    return exact(solve_impact(impact_at(subject, subject.reference_diameter(), 1.0)).restitution);
}

}  // namespace

ExportFolder yade_folder(const ExportSubject& subject) {
    require_yade(subject);
    TemplateValues values = common_values(subject);
    values["damping_law"] = std::string(name_of(subject.damping.law));
    values["coefficient"] = exact(subject.damping.nodes.front().coefficient);
    values["exponent"] = exact(subject.damping.exponent);
    values["restitution"] = restitution_of(subject);
    values["command"] = "yade -n -x impacts.py >yade.log 2>&1 || { tail -n 20 yade.log >&2; exit 1; }";
    return {
        {"README.md", filled("yade/README.md", values)},
        {"impacts.py", filled("yade/impacts.py", values)},
        {"run.sh", filled("common/run_dem.sh", values)},
        unchanged("common/compare.py"),
        assumptions(
            subject,
            {"repulsion: YADE's Hertz-Mindlin; its wall has R* = R/2, young = 2 sqrt(2) E*, nu = 0",
             own_restitution(subject)
                 ? "damping: YADE's `en`, which is Tsuji's damping cut at zero total force"
                 : "attraction and damping: own forces by PyRunner while in contact, up to zero overlap"}),
        dem_expected(subject, "yade", "log.impacts", yade_tolerance)};
}

}  // namespace ashimpact
