// SPDX-License-Identifier: GPL-3.0-or-later
#include "interface/c/solve.hpp"

#include <algorithm>
#include <limits>

#include "interface/c/columns.hpp"
#include "interface/chunks.hpp"
#include "solver/batch/critical_batch.hpp"
#include "solver/batch/impact_batch.hpp"
#include "solver/batch/inversion_batch.hpp"

namespace ashimpact {

namespace {

/// Memory of this thread that calls use again, so that a single impact allocates nothing.
ColumnReader& reader_of_this_thread() {
    thread_local ColumnReader reader;
    return reader;
}

/// Copies results to the caller; a single one, of constants alone, to every place.
void write(const Eigen::ArrayXd& column, std::size_t first, std::size_t size, double* output) {
    if (output == nullptr) return;
    if (column.size() == 1) {
        std::fill_n(output + first, size, column[0]);
    } else {
        std::copy_n(column.data(), size, output + first);
    }
}

}  // namespace

void solve_impacts(const Call& call, const ImpactOutputs& outputs) {
    require_contact(call.parameters);
    require_column(call.parameters, Parameter::velocity);
    const bool turning_point = outputs.approach_time != nullptr || outputs.maximum_overlap != nullptr;
    const BatchOptions options{.turning_point = turning_point,
                               .contact_time = outputs.contact_time != nullptr,
                               .method = turning_point ? BatchMethod::integration : BatchMethod::table};
    ColumnReader& reader = reader_of_this_thread();
    thread_local ImpactBatchResult result;
    in_chunks(call.count, ColumnReader::capacity, [&](std::size_t first, std::size_t size) {
        reader.select(call.model.law, call.parameters, first, size);
        const ImpactBatch batch{.law = call.model.law,
                                .detachment = call.model.detachment,
                                .damping_law = call.model.damping_law,
                                .contact = reader.contact(),
                                .damping = reader.column(Parameter::damping),
                                .velocity = reader.column(Parameter::velocity)};
        ashimpact::solve_impacts(batch, result, options);
        write(result.restitution, first, size, outputs.restitution);
        write(result.contact_time, first, size, outputs.contact_time);
        write(result.approach_time, first, size, outputs.approach_time);
        write(result.maximum_overlap, first, size, outputs.maximum_overlap);
    });
}

void solve_critical_velocities(const Call& call, double* critical_velocity) {
    require_contact(call.parameters);
    ColumnReader& reader = reader_of_this_thread();
    in_chunks(call.count, ColumnReader::capacity, [&](std::size_t first, std::size_t size) {
        reader.select(call.model.law, call.parameters, first, size);
        CriticalVelocityBatchResult result =
            critical_velocities({.law = call.model.law,
                                 .detachment = call.model.detachment,
                                 .damping_law = call.model.damping_law,
                                 .contact = reader.contact(),
                                 .damping = reader.column(Parameter::damping)});
        for (Eigen::Index i = 0; i < result.value.size(); ++i) {
            if (result.verdict[i] == CaptureVerdict::never_captured) result.value[i] = 0.0;
            if (result.verdict[i] == CaptureVerdict::always_captured) {
                result.value[i] = std::numeric_limits<double>::infinity();
            }
        }
        write(result.value, first, size, critical_velocity);
    });
}

void solve_dampings(const Call& call, const DampingOutputs& outputs) {
    require_contact(call.parameters);
    require_column(call.parameters, Parameter::velocity);
    require_column(call.parameters, Parameter::restitution);
    ColumnReader& reader = reader_of_this_thread();
    in_chunks(call.count, ColumnReader::capacity, [&](std::size_t first, std::size_t size) {
        reader.select(call.model.law, call.parameters, first, size);
        const DampingBatchResult result =
            dampings_from_restitutions({.law = call.model.law,
                                        .detachment = call.model.detachment,
                                        .damping_law = call.model.damping_law,
                                        .contact = reader.contact(),
                                        .velocity = reader.column(Parameter::velocity),
                                        .restitution = reader.column(Parameter::restitution)});
        write(result.damping, first, size, outputs.damping);
        write(result.greatest_restitution, first, size, outputs.greatest_restitution);
    });
}

}  // namespace ashimpact
