// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/kernel.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <hwy/highway.h>

#include "core/quantities/checks.hpp"
#include "solver/batch/kernels/laws.hpp"
#include "solver/batch/tables/law_tables.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/registry.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

struct InstructionSet {
    std::int64_t target;
    std::string_view name;
};

constexpr std::array<InstructionSet, 3> known_sets{
    {{HWY_AVX3, "avx512"}, {HWY_AVX2, "avx2"}, {HWY_STATIC_TARGET, "baseline"}}};

std::vector<InstructionSet> present_sets() {
    const std::int64_t supported = hwy::SupportedTargets() | HWY_STATIC_TARGET;
    std::vector<InstructionSet> present;
    for (const InstructionSet& set : known_sets)
        if ((HWY_TARGETS & supported & set.target) != 0) present.push_back(set);
    return present;
}

}  // namespace

std::vector<std::string_view> instruction_sets() {
    std::vector<std::string_view> names;
    for (const InstructionSet& set : present_sets()) names.push_back(set.name);
    return names;
}

void use_instruction_set(std::string_view name) {
    std::vector<std::string> names;
    for (const InstructionSet& set : present_sets()) {
        if (name == set.name) {
            hwy::GetChosenTarget().Update(set.target);
            return;
        }
        names.emplace_back(set.name);
    }
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    if (!name.empty()) throw unknown_name("instruction set", name, names);
}

namespace batch {

bool has_kernels(Law law, DampingLaw damping_law) {
    return has_one_number(damping_law) && law.visit<bool>([]<template <class> class L>() {
        return BatchLaws::index_of<L>() < BatchLaws::size;
    });
}

void find_transition_parameters(const Inputs& in, std::size_t count, double* out) {
    const auto same_as_before = [&](std::size_t i) {
        const auto same = [i](const Input& column) {
            return column.size == 1 || column.values[i] == column.values[i - 1];
        };
        return same(in.effective_radius) && same(in.contact_modulus) && same(in.work_of_adhesion) &&
               std::all_of(in.parameters.begin(), in.parameters.begin() + in.parameter_count,
                           [&](const ParameterInput& parameter) { return same(parameter.values); });
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0 && same_as_before(i)) {
            out[i] = out[i - 1];
            continue;
        }
        ContactPair pair{.mass = in.mass.at(i),
                         .effective_radius = in.effective_radius.at(i),
                         .contact_modulus = in.contact_modulus.at(i),
                         .work_of_adhesion = in.work_of_adhesion.at(i)};
        for (std::size_t k = 0; k < in.parameter_count; ++k)
            pair.parameters.set(in.parameters[k].parameter->name, in.parameters[k].values.at(i));
        const double lambda = pair.work_of_adhesion > 0.0 ? stated_transition_parameter(pair) : 0.0;
        out[i] = is_computed_transition(lambda) ? lambda : std::numeric_limits<double>::quiet_NaN();
    }
}

namespace {

/// Leaves all impacts to the scalar solver, their turns too.
void leave_undecided(const ImpactTask& task) {
    std::fill_n(task.end, task.count, LaneEnd::undecided);
    if (task.turning_point)
        std::fill_n(task.maximum_overlap, task.count, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Kernels kernels_of(Law law, DampingLaw damping_law) {
    return law.visit<Kernels>([=]<template <class> class L>() -> Kernels {
        if constexpr (BatchLaws::index_of<L>() < BatchLaws::size)
            if (has_one_number(damping_law)) return law_kernels<L>();
        return {.impacts = leave_undecided,
                .numbers = [](const NumberTask& t) { std::fill_n(t.end, t.count, LaneEnd::undecided); },
                .inversions = [](const InversionTask& t) { std::fill_n(t.found, t.count, std::uint8_t{0}); },
                .critical_velocities =
                    [](const CriticalTask& t) { std::fill_n(t.state, t.count, PieceState::undecided); }};
    });
}

RestitutionTable& restitution_table(Law law, Detachment detachment, DampingLaw damping_law) {
    return RestitutionTable::of(kernels_of(law, damping_law).numbers, detachment, damping_law);
}

}  // namespace batch

}  // namespace ashimpact
