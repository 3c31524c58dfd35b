// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/kernel.hpp"

#include <algorithm>

#include "solver/batch/kernels/laws.hpp"
#include "solver/batch/tables/restitution_table.hpp"
#include "solver/contact/registry.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact::batch {

bool has_kernels(Law law, DampingLaw damping_law) {
    return has_one_number(damping_law) && law.visit<bool>([]<template <class> class L>() {
        return BatchLaws::index_of<L>() < BatchLaws::size;
    });
}

Kernels kernels_of(Law law, DampingLaw damping_law) {
    return law.visit<Kernels>([=]<template <class> class L>() -> Kernels {
        if constexpr (BatchLaws::index_of<L>() < BatchLaws::size)
            if (has_one_number(damping_law)) return law_kernels<L>();
        return {.impacts = [](const ImpactTask& t) { std::fill_n(t.end, t.count, LaneEnd::undecided); },
                .numbers = [](const NumberTask& t) { std::fill_n(t.end, t.count, LaneEnd::undecided); },
                .inversions = [](const InversionTask& t) { std::fill_n(t.found, t.count, std::uint8_t{0}); },
                .critical_velocities =
                    [](const CriticalTask& t) { std::fill_n(t.state, t.count, PieceState::undecided); }};
    });
}

RestitutionTable& restitution_table(Law law, Detachment detachment, DampingLaw damping_law) {
    return RestitutionTable::of(kernels_of(law, damping_law).numbers, detachment, damping_law);
}

}  // namespace ashimpact::batch
