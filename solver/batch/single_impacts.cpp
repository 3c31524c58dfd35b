#include "solver/batch/single_impacts.hpp"

#include "solver/batch/admissibility.hpp"
#include "solver/batch/critical_batch.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/batch/task.hpp"

#include <limits>

namespace ashimpact {

namespace {

/// The inputs of one problem; they refer to the numbers of @p contact.
batch::Inputs inputs_of(Law law, const ContactPair& contact) {
    batch::Inputs inputs{.mass = {&contact.mass, true},
                         .effective_radius = {&contact.effective_radius, true},
                         .contact_modulus = {&contact.contact_modulus, true},
                         .work_of_adhesion = {&contact.work_of_adhesion, true},
                         .yield_pressure = {&contact.yield_pressure, true}};
    for (const LawParameter& parameter : law.parameters()) {
        for (const auto& entry : contact.parameters) {
            if (entry.first != parameter.name) continue;
            inputs.parameters.parameter[inputs.parameters.count] = &parameter;
            inputs.parameters.values[inputs.parameters.count++] = {&entry.second, true};
        }
    }
    return inputs;
}

}  // namespace

SingleImpacts::SingleImpacts(Law law, Detachment detachment, DampingLaw damping_law)
    : law_(law), detachment_(detachment), damping_law_(damping_law) {
    batch::require_admissible(law, detachment);
    if (!batch::has_kernels(law)) return;
    table_ = &batch::RestitutionTable::of(law, detachment, damping_law);
    kernels_ = batch::kernels_of(law);
}

std::optional<double> SingleImpacts::restitution(const ContactPair& contact, double damping,
                                                 double velocity) const {
    if (table_ == nullptr) return std::nullopt;
    batch::Inputs inputs = inputs_of(law_, contact);
    inputs.damping = {&damping, true};
    inputs.velocity = {&velocity, true};
    if (batch::admissible_count(inputs, 1) == 0) return std::nullopt;
    batch::LaneEnd end = batch::LaneEnd::undecided;
    double restitution = 0.0;
    double contact_time = 0.0;
    const batch::ImpactTask task{.damping_law = damping_law_,
                                 .detachment = detachment_,
                                 .with_contact_time = false,
                                 .turning_point = false,
                                 .table = table_,
                                 .count = 1,
                                 .inputs = inputs,
                                 .end = &end,
                                 .restitution = &restitution,
                                 .contact_time = &contact_time,
                                 .approach_time = nullptr,
                                 .maximum_overlap = nullptr};
    kernels_.impacts(task);
    if (!batch::is_possible_end(task, 0)) return std::nullopt;
    return restitution;
}

std::optional<double> SingleImpacts::critical_velocity(const ContactPair& contact, double damping) const {
    batch::Inputs inputs = inputs_of(law_, contact);
    inputs.damping = {&damping, true};
    if (batch::admissible_count(inputs, 1) == 0) return std::nullopt;
    const auto critical =
        critical_velocity_without_integration({law_, detachment_, {damping_law_, damping}, contact});
    if (!critical) return std::nullopt;
    switch (critical->verdict) {
        case CaptureVerdict::never_captured:
            return 0.0;
        case CaptureVerdict::always_captured:
            return std::numeric_limits<double>::infinity();
        case CaptureVerdict::finite:
            break;
    }
    return critical->value;
}

}  // namespace ashimpact
