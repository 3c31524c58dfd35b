#include "pipeline/stages/stage.hpp"

#include <stdexcept>

#include "pipeline/case/case_reader.hpp"
#include "pipeline/stages/analytic.hpp"
#include "pipeline/stages/comparison.hpp"
#include "pipeline/stages/contact.hpp"
#include "pipeline/stages/critical_velocity.hpp"
#include "pipeline/stages/damping.hpp"
#include "pipeline/stages/fit.hpp"
#include "pipeline/stages/histories.hpp"
#include "pipeline/stages/modulus.hpp"
#include "pipeline/stages/read_case_artifact.hpp"
#include "pipeline/stages/restitution.hpp"

namespace ashimpact {

const Artifact& Artifacts::at(std::string_view file) const {
    for (const Artifact& artifact : artifacts_)
        if (artifact.file == file) return artifact;
    throw std::logic_error("a stage reads " + std::string(file) + ", which it does not list");
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
        {"modulus", "1-modulus.json", {case_artifact}, modulus_stage},
        {"contact", "2-contact.json", {case_artifact, "1-modulus.json"}, contact_stage},
        {"analytic", "3-analytic.json", {"2-contact.json"}, analytic_stage},
        {"restitution", "4-restitution.json", {case_artifact, "2-contact.json"}, restitution_stage},
        {"damping", "5-damping.json", {case_artifact, "2-contact.json", "4-restitution.json"}, damping_stage},
        {"fit",
         "6-fit.json",
         {case_artifact, "2-contact.json", "4-restitution.json", "5-damping.json"},
         fit_stage},
        {"critical-velocity",
         "7-critical-velocity.json",
         {case_artifact, "2-contact.json", "4-restitution.json", "6-fit.json"},
         critical_velocity_stage},
        {"histories",
         "8-histories.json",
         {case_artifact, "2-contact.json", "5-damping.json", "6-fit.json", "7-critical-velocity.json"},
         histories_stage},
        {"comparison",
         "comparison.json",
         {case_artifact, "1-modulus.json", "2-contact.json", "3-analytic.json", "6-fit.json",
          "7-critical-velocity.json", "8-histories.json"},
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
