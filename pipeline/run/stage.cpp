// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/stage.hpp"

#include "pipeline/run/analytic.hpp"
#include "pipeline/run/comparison.hpp"
#include "pipeline/run/contact.hpp"
#include "pipeline/run/critical_velocity.hpp"
#include "pipeline/run/damping.hpp"
#include "pipeline/run/fit.hpp"
#include "pipeline/run/histories.hpp"
#include "pipeline/run/modulus.hpp"
#include "pipeline/run/restitution.hpp"

namespace ashimpact {

namespace {

void compute_modulus(Run& run, ContactModels& /*models*/, StageRecord& record) {
    run.modulus = modulus_stage(run.data, record);
}

void compute_contact(Run& run, ContactModels& /*models*/, StageRecord& record) {
    run.contact = contact_stage(run.data, run.modulus, record);
}

void compute_analytic(Run& run, ContactModels& /*models*/, StageRecord& record) {
    run.analytic = analytic_stage(run.contact, record);
}

void compute_restitution(Run& run, ContactModels& /*models*/, StageRecord& record) {
    run.restitution = restitution_stage(run.data, run.contact, record);
}

void compute_damping(Run& run, ContactModels& models, StageRecord& record) {
    run.damping = damping_stage(run.data, run.contact, run.restitution, models, record);
}

void compute_fit(Run& run, ContactModels& models, StageRecord& record) {
    run.fit = fit_stage(run.data, run.contact, run.restitution, run.damping, models, record);
}

void compute_critical_velocity(Run& run, ContactModels& models, StageRecord& record) {
    run.critical_velocity =
        critical_velocity_stage(run.data, run.modulus, run.contact, run.restitution, run.fit, models, record);
}

void compute_histories(Run& run, ContactModels& /*models*/, StageRecord& record) {
    run.histories =
        histories_stage(run.data, run.contact, run.damping, run.fit, run.critical_velocity, record);
}

void compute_comparison(Run& run, ContactModels& /*models*/, StageRecord& record) {
    std::vector<const StageRecord*> reasons;
    for (const std::string_view file : {fit_artifact, damping_artifact})
        if (const StageRecord* before = run.record(file)) reasons.push_back(before);
    run.comparison = comparison_stage(
        run.data,
        {run.modulus, run.contact, run.analytic, run.damping, run.fit, run.critical_velocity, run.histories},
        reasons, record);
}

}  // namespace

const std::vector<Stage>& stages() {
    static const std::vector<Stage> list{
        {"modulus", modulus_artifact, {case_artifact}, compute_modulus},
        {"contact", contact_artifact, {case_artifact, modulus_artifact}, compute_contact},
        {"analytic", analytic_artifact, {contact_artifact}, compute_analytic},
        {"restitution", restitution_artifact, {case_artifact, contact_artifact}, compute_restitution},
        {"damping",
         damping_artifact,
         {case_artifact, contact_artifact, restitution_artifact},
         compute_damping},
        {"fit",
         fit_artifact,
         {case_artifact, contact_artifact, restitution_artifact, damping_artifact},
         compute_fit},
        {"critical-velocity",
         critical_velocity_artifact,
         {case_artifact, modulus_artifact, contact_artifact, restitution_artifact, fit_artifact},
         compute_critical_velocity},
        {"histories",
         histories_artifact,
         {case_artifact, contact_artifact, damping_artifact, fit_artifact, critical_velocity_artifact},
         compute_histories},
        {"comparison",
         comparison_artifact,
         {case_artifact, modulus_artifact, contact_artifact, analytic_artifact, damping_artifact,
          fit_artifact, critical_velocity_artifact, histories_artifact},
         compute_comparison},
    };
    return list;
}

void compute_stage(const Stage& stage, Run& run, ContactModels& models) {
    StageRecord record{.stage = std::string(stage.name), .file = std::string(stage.file)};
    stage.compute(run, models, record);
    run.records.push_back(std::move(record));
}

}  // namespace ashimpact
