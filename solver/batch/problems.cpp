// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/problems.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/range_lanes.hpp"
#include "solver/contact/law_parameters.hpp"

namespace ashimpact::batch {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Range positive{least_computable, greatest_computable};
constexpr Range not_negative{least_computable, greatest_computable, true};

/// A restitution has no dimension, so it needs no range against overflow.
constexpr Range finite_ratio{0.0, std::numeric_limits<double>::max()};

/// A yield pressure is infinite if the contact never yields.
constexpr Range positive_or_infinite{std::numeric_limits<double>::denorm_min(), infinity};

/// What require_allowed() lets a parameter be.
Range range_of(const LawParameter& parameter) {
    return {least_computable, std::min(greatest_computable, parameter.greatest), parameter.may_be_zero};
}

Input input_of(const Column& column) {
    return {column.data(), column.size() == 1};
}

/// How many values of a column are in a range, until the first that is not; at most count.
std::size_t count_until(const Input& column, std::size_t count, const Range& range) {
    if (column.values == nullptr) return count;
    if (column.single) return range.holds(column.values[0]) ? count : 0;
    return count_within(range, column.values, count);
}

/// The columns of the parameters that a law takes. @throws InputError where one is missing
ParameterInputs parameter_inputs(Law law, const ContactColumns& contact) {
    const auto column_of = [&](const LawParameter& parameter) {
        return std::find_if(contact.parameters.begin(), contact.parameters.end(),
                            [&](const ParameterColumn& column) { return column.name == parameter.name; });
    };
    const auto is_given = [&](const LawParameter& parameter) {
        return column_of(parameter) != contact.parameters.end();
    };
    if (const auto fault = parameter_fault(law, is_given))
        throw InputError(fault->problem(), fault->allowed());
    ParameterInputs inputs;
    for (const LawParameter& parameter : law.parameters()) {
        if (!is_given(parameter)) continue;
        inputs.parameter[inputs.count] = &parameter;
        inputs.values[inputs.count++] = input_of(column_of(parameter)->values);
    }
    return inputs;
}

/// The InputError of an inadmissible problem.
void refuse(const Problems& batch, std::size_t place) {
    try {
        validate(batch.impact(place));
        throw InputError("restitution is " + std::to_string(batch.inputs.restitution.at(place)),
                         "0 <= e < 1");
    } catch (const InputError& error) {
        throw error.at("impact " + std::to_string(place));
    }
}

}  // namespace

ContactPair Problems::contact(std::size_t i) const {
    ContactPair pair{.mass = inputs.mass.at(i),
                     .effective_radius = inputs.effective_radius.at(i),
                     .contact_modulus = inputs.contact_modulus.at(i),
                     .work_of_adhesion = inputs.work_of_adhesion.at(i),
                     .yield_pressure = inputs.yield_pressure.at(i)};
    const ParameterInputs& own = inputs.parameters;
    for (std::size_t k = 0; k < own.count; ++k)
        pair.parameters.set(own.parameter[k]->name, own.values[k].at(i));
    return pair;
}

Problems problems_of(Law law, Detachment detachment, DampingLaw damping_law, const ContactColumns& contact,
                     std::initializer_list<OwnColumn> own) {
    static constexpr double one = 1.0;
    require_admissible(law, detachment);
    std::vector<NamedColumn> names;
    for (const OwnColumn& column : own) names.push_back({column.name, column.values.size()});
    Problems problems{
        law, detachment, damping_law, static_cast<std::size_t>(common_size(contact, names)), {}};
    problems.inputs = {.mass = input_of(contact.mass),
                       .effective_radius = input_of(contact.effective_radius),
                       .contact_modulus = input_of(contact.contact_modulus),
                       .work_of_adhesion = input_of(contact.work_of_adhesion),
                       .yield_pressure = input_of(contact.yield_pressure),
                       .damping = {&one, true},
                       .velocity = {&one, true},
                       .restitution = {&one, true},
                       .parameters = parameter_inputs(law, contact)};
    for (const OwnColumn& column : own) problems.inputs.*column.input = input_of(column.values);
    return problems;
}

Inputs inputs_of(Law law, const ContactPair& contact) {
    Inputs inputs{.mass = {&contact.mass, true},
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

std::size_t admissible_count(const Inputs& in, std::size_t count) {
    for (const Input* column : {&in.mass, &in.effective_radius, &in.contact_modulus, &in.velocity})
        count = count_until(*column, count, positive);
    for (const Input* column : {&in.work_of_adhesion, &in.damping})
        count = count_until(*column, count, not_negative);
    count = count_until(in.yield_pressure, count, positive_or_infinite);
    count = count_until(in.restitution, count, finite_ratio);
    for (std::size_t k = 0; k < in.parameters.count; ++k)
        count = count_until(in.parameters.values[k], count, range_of(*in.parameters.parameter[k]));
    return count;
}

void require_admissible(Law law, Detachment detachment) {
    constexpr std::size_t ends = all_values<Detachment>.size();
    static const auto reasons = [] {
        std::array<std::optional<std::string>, Law::count() * ends> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = refusal(Law::at(i / ends), static_cast<Detachment>(i % ends));
        return all;
    }();
    const auto& reason = reasons[law.index() * ends + static_cast<std::size_t>(detachment)];
    if (reason) throw InputError(*reason, admissible_detachments(law));
}

std::int64_t solve_in_chunks(const Problems& batch, int threads,
                             const std::function<std::int64_t(const Problems&, std::size_t)>& solve) {
    std::atomic<std::size_t> first_fault = batch.count;
    std::atomic<std::int64_t> scalar = 0;
    for_chunks(batch.count, most_impacts, threads, [&](std::size_t first, std::size_t size) {
        const Problems chunk = batch.part(first, size);
        const std::size_t admissible = admissible_count(chunk.inputs, size);
        if (admissible == size) {
            scalar += solve(chunk, first);
            return;
        }
        std::size_t known = first_fault;
        while (first + admissible < known && !first_fault.compare_exchange_weak(known, first + admissible)) {
            // another thread changed it: compare with its new value
        }
    });
    if (first_fault < batch.count) refuse(batch, first_fault);
    return scalar;
}

RestitutionTable* table_for(BatchMethod method, const Problems& problems) {
    if (method == BatchMethod::integration) return nullptr;
    return &restitution_table(problems.law, problems.detachment, problems.damping_law);
}

bool is_possible_end(const ImpactTask& task, std::size_t i) {
    if (task.end[i] == LaneEnd::undecided) return false;
    if (task.end[i] == LaneEnd::capture) return true;
    const double e = task.restitution[i];
    const bool damped = task.inputs.damping.at(i) > 0.0;
    if (!(e > 0.0 && (damped ? e < 1.0 : e <= 1.0))) return false;
    const double time = task.contact_time[i];
    return !task.with_contact_time || (time > 0.0 && std::isfinite(time));
}

}  // namespace ashimpact::batch
