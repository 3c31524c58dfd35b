// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/single_impacts.hpp"

#include <limits>

#include "solver/batch/batch.hpp"
#include "solver/batch/problems.hpp"

namespace ashimpact {

SingleImpacts::SingleImpacts(Law law, Detachment detachment, DampingLaw damping_law)
    : law_(law), detachment_(detachment), damping_law_(damping_law) {
    batch::require_admissible(law, detachment);
    if (!law.self_similar() || law.is_plastic() || !has_tables(law, damping_law))
        return;  // others: squares too dear for one impact
    table_ = &batch::restitution_table(law, detachment, damping_law);
    kernels_ = batch::kernels_of(law, damping_law);
}

std::optional<double> SingleImpacts::restitution(const ContactPair& contact, double damping,
                                                 double velocity) const {
    if (table_ == nullptr) return std::nullopt;
    batch::Inputs inputs = batch::inputs_of(law_, damping_law_, contact);
    inputs.damping = {&damping, 1};
    inputs.velocity = {&velocity, 1};
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
    batch::Inputs inputs = batch::inputs_of(law_, damping_law_, contact);
    inputs.damping = {&damping, 1};
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
