// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/task.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "core/checks.hpp"
#include "core/error.hpp"
#include "solver/batch/kernels/laws.hpp"
#include "solver/batch/range_lanes.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/registry.hpp"

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

/// How many values of a column are in a range, until the first that is not; at most count.
std::size_t count_until(const Input& column, std::size_t count, const Range& range) {
    if (column.values == nullptr) return count;
    if (column.single) return range.holds(column.values[0]) ? count : 0;
    return count_within(range, column.values, count);
}

void leave_undecided(const ImpactTask& task) {
    std::fill_n(task.end, task.count, LaneEnd::undecided);
}

void leave_undecided_numbers(const NumberTask& task) {
    std::fill_n(task.end, task.count, LaneEnd::undecided);
}

void leave_unsearched(const InversionTask& task) {
    std::fill_n(task.found, task.count, std::uint8_t{0});
}

void leave_unread(const CriticalTask& task) {
    std::fill_n(task.verdict, task.count, TableVerdict::undecided);
}

}  // namespace

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

bool FirstFault::check(const Inputs& chunk, std::size_t first, std::size_t count) {
    const std::size_t i = admissible_count(chunk, count);
    if (i == count) return true;
    std::size_t known = place_;
    while (first + i < known && !place_.compare_exchange_weak(known, first + i)) {
        // another thread changed place_: compare with its new value
    }
    return false;
}

void FirstFault::raise(const std::function<void(std::size_t)>& refuse) const {
    if (place_ == none) return;
    try {
        refuse(place_);
    } catch (const InputError& error) {
        throw error.at("impact " + std::to_string(place_));
    }
}

bool has_kernels(Law law) {
    return law.visit<bool>(
        []<template <class> class L>() { return BatchLaws::index_of<L>() < BatchLaws::size; });
}

Kernels kernels_of(Law law) {
    return law.visit<Kernels>([]<template <class> class L>() -> Kernels {
        if constexpr (BatchLaws::index_of<L>() < BatchLaws::size) return law_kernels<L>();
        return {leave_undecided, leave_undecided_numbers, leave_unsearched, leave_unread};
    });
}

}  // namespace ashimpact::batch
