// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/problems.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/problems.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

/// How many values are in a range, in steps of a few registers, until the first step with one that is not.
std::size_t steps_within(const batch::Range& range, const double* values, std::size_t count) {
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<double> d;
    constexpr std::size_t registers = 4;  // with one branch for all of them
    const auto least = hn::Set(d, range.least);
    const auto greatest = hn::Set(d, range.greatest);
    const auto other = hn::Set(d, range.or_zero ? 0.0 : range.least);
    const auto within = [&](std::size_t i) HWY_ATTR {
        const auto value = hn::LoadU(d, values + i);
        return hn::Or(hn::And(hn::Ge(value, least), hn::Le(value, greatest)), hn::Eq(value, other));
    };
    const std::size_t width = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + registers * width <= count; i += registers * width) {
        const auto first = hn::And(within(i), within(i + width));
        const auto second = hn::And(within(i + 2 * width), within(i + 3 * width));
        if (!hn::AllTrue(d, hn::And(first, second))) break;
    }
    return i;
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {
namespace {

HWY_EXPORT(steps_within);

/// How many values are in a range, until the first that is not; at most @p count. Several values are looked
/// at in each instruction.
std::size_t count_within(const batch::Range& range, const double* values, std::size_t count) {
    std::size_t i = HWY_DYNAMIC_DISPATCH(steps_within)(range, values, count);
    while (i < count && range.holds(values[i])) ++i;
    return i;
}

}  // namespace
}  // namespace ashimpact

namespace ashimpact::batch {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Range positive{least_computable, greatest_computable};
constexpr Range not_negative{least_computable, greatest_computable, true};

/// 1: no damping.
constexpr Range restitutions{0.0, 1.0};

/// A yield pressure is infinite if the contact never yields.
constexpr Range positive_or_infinite{std::numeric_limits<double>::denorm_min(), infinity};

struct InputField {
    std::string_view name;
    Input Inputs::*input;
    Range range;
};

constexpr std::array<InputField, 8> fields{{{"mass", &Inputs::mass, positive},
                                            {"effective_radius", &Inputs::effective_radius, positive},
                                            {"contact_modulus", &Inputs::contact_modulus, positive},
                                            {"work_of_adhesion", &Inputs::work_of_adhesion, not_negative},
                                            {"yield_pressure", &Inputs::yield_pressure, positive_or_infinite},
                                            {"damping", &Inputs::damping, not_negative},
                                            {"velocity", &Inputs::velocity, positive},
                                            {"restitution", &Inputs::restitution, restitutions}}};

/// Calls @p visit(name, input, range) for each input, present or not: contacts, their parameters, the others.
template <class AnyInputs, class Visit>
void for_each_input(AnyInputs& inputs, const Visit& visit) {
    const auto visit_fields = [&](std::span<const InputField> some) {
        for (const InputField& field : some) visit(field.name, inputs.*field.input, field.range);
    };
    constexpr std::size_t of_contacts = 5;
    visit_fields(std::span(fields).first(of_contacts));
    for (std::size_t k = 0; k < inputs.parameter_count; ++k) {
        auto& [parameter, values] = inputs.parameters[k];  // within what require_allowed() accepts
        visit(parameter->name, values,
              Range{least_computable, std::min(greatest_computable, parameter->greatest),
                    parameter->may_be_zero});
    }
    visit_fields(std::span(fields).subspan(of_contacts));
}

Input input_of(const Column& column) {
    return {column.data(), static_cast<std::size_t>(column.size())};
}

/// The parameters that two laws take; the inputs of kernels point to them.
const std::vector<LawParameter>& parameters_for(Law law, DampingLaw damping_law) {
    static const auto all = [] {
        std::vector<std::vector<LawParameter>> found;
        for (std::size_t i = 0; i < Law::count(); ++i)
            for (const DampingLaw damping : all_values<DampingLaw>)
                found.push_back(parameters_of(Law::at(i), damping));
        return found;
    }();
    return all[law.index() * all_values<DampingLaw>.size() + static_cast<std::size_t>(damping_law)];
}

/// Adds the columns of the parameters that laws take. @throws InputError where one is missing
void add_parameters(Law law, DampingLaw damping_law, const ContactColumns& contact, Inputs& inputs) {
    const std::vector<LawParameter>& parameters = parameters_for(law, damping_law);
    const auto column_of = [&](const LawParameter& parameter) {
        return std::ranges::find(contact.parameters, parameter.name, &ParameterColumn::name);
    };
    const auto is_given = [&](const LawParameter& parameter) {
        return column_of(parameter) != contact.parameters.end();
    };
    if (const auto fault = parameter_fault(parameters, is_given))
        throw InputError(fault->problem(), fault->allowed());
    for (const LawParameter& parameter : parameters)
        if (is_given(parameter))
            inputs.parameters[inputs.parameter_count++] = {&parameter,
                                                           input_of(column_of(parameter)->values)};
}

/// The common length of all columns with more than one value; 1 if there is no such column.
/// @throws InputError if two lengths differ
std::size_t common_size(const Inputs& inputs) {
    std::string_view longest;
    std::size_t size = 1;
    for_each_input(inputs, [&](std::string_view name, const Input& column, const Range&) {
        if (column.size == 1) return;
        if (longest.empty()) {
            longest = name;
            size = column.size;
        }
        if (column.size != size)
            throw InputError(
                "column " + std::string(name) + " has " + std::to_string(column.size) + " values",
                "1, or " + std::to_string(size) + " as column " + std::string(longest));
    });
    return size;
}

/// The InputError of an inadmissible problem.
void refuse(const Problems& batch, std::size_t place) {
    try {
        validate(batch.impact(place));
        throw InputError("restitution is " + std::to_string(batch.inputs.restitution.at(place)),
                         "0 <= e <= 1");
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
    for (std::size_t k = 0; k < inputs.parameter_count; ++k)
        pair.parameters.set(inputs.parameters[k].parameter->name, inputs.parameters[k].values.at(i));
    return pair;
}

Problems Problems::part(std::size_t first, std::size_t size) const {
    Problems chunk = *this;
    chunk.count = size;
    for_each_input(chunk.inputs, [&](std::string_view, Input& column, const Range&) {
        if (column.size != 1) column.values += first;
    });
    return chunk;
}

Problems problems_of(Law law, Detachment detachment, DampingLaw damping_law, const ContactColumns& contact,
                     std::initializer_list<OwnColumn> own) {
    static constexpr double one = 1.0;
    require_admissible(law, detachment);
    Inputs inputs{.mass = input_of(contact.mass),
                  .effective_radius = input_of(contact.effective_radius),
                  .contact_modulus = input_of(contact.contact_modulus),
                  .work_of_adhesion = input_of(contact.work_of_adhesion),
                  .yield_pressure = input_of(contact.yield_pressure),
                  .damping = {&one, 1},
                  .velocity = {&one, 1},
                  .restitution = {&one, 1}};
    for (const OwnColumn& column : own) inputs.*column.input = input_of(column.values);
    add_parameters(law, damping_law, contact, inputs);
    return {law, detachment, damping_law, common_size(inputs), inputs};
}

Inputs inputs_of(Law law, DampingLaw damping_law, const ContactPair& contact) {
    Inputs inputs{.mass = {&contact.mass, 1},
                  .effective_radius = {&contact.effective_radius, 1},
                  .contact_modulus = {&contact.contact_modulus, 1},
                  .work_of_adhesion = {&contact.work_of_adhesion, 1},
                  .yield_pressure = {&contact.yield_pressure, 1}};
    for (const LawParameter& parameter : parameters_for(law, damping_law))
        for (const auto& entry : contact.parameters)
            if (entry.first == parameter.name)
                inputs.parameters[inputs.parameter_count++] = {&parameter, {&entry.second, 1}};
    return inputs;
}

std::size_t admissible_count(const Inputs& in, std::size_t count) {
    for_each_input(in, [&](std::string_view, const Input& column, const Range& range) {
        if (column.size == 1) {
            if (!range.holds(column.values[0])) count = 0;
        } else if (column.size > 1) {
            count = count_within(range, column.values, count);
        }
    });
    return count;
}

void require_admissible(Law law, Detachment detachment) {
    if (const auto& reason = refusal(law, detachment)) throw InputError(*reason, admissible_detachments(law));
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
    if (!has_tables(problems.law, problems.damping_law))
        throw InputError("method 'table': law '" + std::string(problems.law.name()) + "' with damping law '" +
                             std::string(name_of(problems.damping_law)) + "' has no table",
                         "integration");
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
#endif
