// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/stage.hpp"

#include <algorithm>
#include <stdexcept>

#include "pipeline/case/case_reader.hpp"
#include "pipeline/run/analytic.hpp"
#include "pipeline/run/comparison.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/critical_velocity.hpp"
#include "pipeline/run/damping.hpp"
#include "pipeline/run/fit.hpp"
#include "pipeline/run/histories.hpp"
#include "pipeline/run/modulus.hpp"
#include "pipeline/run/read_case_artifact.hpp"
#include "pipeline/run/restitution.hpp"

namespace ashimpact {

const Artifact& Artifacts::at(std::string_view file) const {
    for (const Artifact& artifact : artifacts_)
        if (artifact.file == file) return artifact;
    throw std::logic_error("a stage reads " + std::string(file) + ", which it does not list");
}

bool Artifacts::has(std::string_view file) const {
    return std::any_of(artifacts_.begin(), artifacts_.end(),
                       [&](const Artifact& each) { return each.file == file; });
}

const std::string& Artifacts::place_of(std::string_view file) const {
    const Artifact& artifact = at(file);
    if (!artifact.place.empty()) return artifact.place;
    for (const Artifact& each : artifacts_)
        if (each.file == case_artifact && !each.place.empty())
            return each.place;  // what it was computed from
    return artifact.file;
}

const std::vector<Stage>& stages() {
    static const std::vector<Stage> list{
        {"modulus", modulus_artifact, {case_artifact}, modulus_stage},
        {"contact", contact_artifact, {case_artifact, modulus_artifact}, contact_stage},
        {"analytic", analytic_artifact, {contact_artifact}, analytic_stage},
        {"restitution", restitution_artifact, {case_artifact, contact_artifact}, restitution_stage},
        {"damping", damping_artifact, {case_artifact, contact_artifact, restitution_artifact}, damping_stage},
        {"fit",
         fit_artifact,
         {case_artifact, contact_artifact, restitution_artifact, damping_artifact},
         fit_stage},
        {"critical-velocity",
         critical_velocity_artifact,
         {case_artifact, contact_artifact, restitution_artifact, fit_artifact},
         critical_velocity_stage},
        {"histories",
         histories_artifact,
         {case_artifact, contact_artifact, damping_artifact, fit_artifact, critical_velocity_artifact},
         histories_stage},
        {"comparison",
         comparison_artifact,
         {case_artifact, modulus_artifact, contact_artifact, analytic_artifact, damping_artifact,
          fit_artifact, critical_velocity_artifact, histories_artifact},
         comparison_stage},
    };
    return list;
}

Case read_case_artifact(const Artifacts& artifacts) {
    return artifacts.read(case_artifact, [](const View& result) {
        InputFiles none = InputFiles::beside({});
        return read_case(result, PhaseCatalogue({}), none);
    });
}

}  // namespace ashimpact
