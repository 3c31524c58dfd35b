// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/kernel.hpp"

#include <algorithm>

#include "solver/batch/kernels/laws.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/contact/registry.hpp"

namespace ashimpact::batch {

namespace {

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
    std::fill_n(task.state, task.count, PieceState::undecided);
}

}  // namespace

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

RestitutionTable& restitution_table(Law law, Detachment detachment, DampingLaw damping_law) {
    return RestitutionTable::of(kernels_of(law).numbers, detachment, damping_law);
}

}  // namespace ashimpact::batch
