// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/stage.hpp"

namespace ashimpact {

const std::vector<Stage>& stages() {
    static const std::vector<Stage> list{
        {"modulus",
         modulus_artifact,
         {case_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.modulus = modulus_stage(run.data, record);
         }},
        {"contact",
         contact_artifact,
         {case_artifact, modulus_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.contact = contact_stage(run.data, run.modulus, record);
         }},
        {"analytic",
         analytic_artifact,
         {contact_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.analytic = analytic_stage(run.contact, record);
         }},
        {"restitution",
         restitution_artifact,
         {case_artifact, contact_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.restitution = restitution_stage(run.data, run.contact, record);
         }},
        {"damping",
         damping_artifact,
         {case_artifact, contact_artifact, restitution_artifact},
         [](Run& run, ContactModels& models, StageRecord& record) {
             run.damping = damping_stage(run.data, run.contact, run.restitution, models, record);
         }},
        {"fit",
         fit_artifact,
         {case_artifact, contact_artifact, restitution_artifact, damping_artifact},
         [](Run& run, ContactModels& models, StageRecord& record) {
             run.fit = fit_stage(run.data, run.contact, run.restitution, run.damping, models, record);
         }},
        {"critical-velocity",
         critical_velocity_artifact,
         {case_artifact, modulus_artifact, contact_artifact, restitution_artifact, fit_artifact},
         [](Run& run, ContactModels& models, StageRecord& record) {
             run.critical_velocity = critical_velocity_stage(run.data, run.modulus, run.contact,
                                                             run.restitution, run.fit, models, record);
         }},
        {"histories",
         histories_artifact,
         {case_artifact, contact_artifact, damping_artifact, fit_artifact, critical_velocity_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.histories =
                 histories_stage(run.data, run.contact, run.damping, run.fit, run.critical_velocity, record);
         }},
        {"comparison",
         comparison_artifact,
         {case_artifact, modulus_artifact, contact_artifact, analytic_artifact, restitution_artifact,
          damping_artifact, fit_artifact, critical_velocity_artifact, histories_artifact},
         [](Run& run, ContactModels&, StageRecord& record) {
             run.comparison = comparison_stage(run, record);
         }},
    };
    return list;
}

void compute_stage(const Stage& stage, Run& run, ContactModels& models) {
    StageRecord record{.stage = std::string(stage.name), .file = std::string(stage.file)};
    stage.compute(run, models, record);
    run.records.push_back(std::move(record));
}

}  // namespace ashimpact
