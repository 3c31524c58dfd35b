#include "solver/batch/task.hpp"

#include "materials/base/checks.hpp"
#include "materials/base/error.hpp"
#include "solver/batch/kernels/laws.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace ashimpact::batch {

namespace {

bool positive(const Input& column, std::size_t i) {
    return column.values == nullptr || is_computable(column.at(i));
}

bool not_negative(const Input& column, std::size_t i) {
    return column.values == nullptr || column.at(i) == 0.0 || is_computable(column.at(i));
}

/// A restitution has no dimension, so it needs no range against overflow.
bool finite_ratio(const Input& column, std::size_t i) {
    return column.values == nullptr || (column.at(i) >= 0.0 && std::isfinite(column.at(i)));
}

/// A yield pressure is infinite if the contact never yields.
bool positive_or_infinite(const Input& column, std::size_t i) {
    return column.values == nullptr || column.at(i) > 0.0;
}

/// As require_allowed().
bool allowed(const ParameterInputs& in, std::size_t i) {
    for (std::size_t k = 0; k < in.count; ++k) {
        const LawParameter& parameter = *in.parameter[k];
        const bool fits = parameter.may_be_zero ? not_negative(in.values[k], i) : positive(in.values[k], i);
        if (!fits || in.values[k].at(i) > parameter.greatest) return false;
    }
    return true;
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

bool admissible(const Inputs& in, std::size_t i) {
    return positive(in.mass, i) && positive(in.effective_radius, i) && positive(in.contact_modulus, i) &&
           not_negative(in.work_of_adhesion, i) && positive_or_infinite(in.yield_pressure, i) &&
           not_negative(in.damping, i) && positive(in.velocity, i) && finite_ratio(in.restitution, i) &&
           allowed(in.parameters, i);
}

bool FirstFault::check(const Inputs& chunk, std::size_t first, std::size_t count) {
    std::size_t i = 0;
    while (i < count && admissible(chunk, i)) ++i;
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
    return std::find(BatchLaws::names.begin(), BatchLaws::names.end(), law.name()) != BatchLaws::names.end();
}

Kernels kernels_of(Law law) {
    const auto place = std::find(BatchLaws::names.begin(), BatchLaws::names.end(), law.name());
    if (place == BatchLaws::names.end()) return {leave_undecided, leave_undecided_numbers, leave_unsearched};
    return BatchLaws::visit<Kernels>(static_cast<std::size_t>(place - BatchLaws::names.begin()),
                                     []<template <class> class L>() { return law_kernels<L>(); });
}

}  // namespace ashimpact::batch
