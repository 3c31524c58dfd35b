// SPDX-License-Identifier: GPL-3.0-or-later
// Prints, for every law with a batch kernel, how many additions, multiplications and multiply-adds of the
// power-series and leapfrog kind one impact takes: "law damping-law count". Divisions and roots are not
// counted.

#include <iostream>

#include <hwy/highway.h>

#include "solver/batch/lanes/follow-inl.hpp"
#include "solver/contact/registry.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/scale.hpp"
#include "tests/solver/batch/batch_sample.hpp"

namespace ashimpact::HWY_NAMESPACE {
namespace {

/// Lanes that are alike do not wait for each other: what is counted is what an impact needs.
template <template <class> class L, class Damping>
double operations_an_impact(const test::Impacts& impacts) {
    operation_count = 0;
    for (Eigen::Index i = 0; i < impacts.size(); ++i) {
        const Impact impact = impacts.at(i);
        const Scale scale = Scale::of(impact.contact, impact.velocity);
        Block block;
        for (std::size_t lane = 0; lane < block_size; ++lane) {
            block.adhesion[lane] = L<double>::adhesion_number(impact.contact, scale.length);
            block.damping[lane] = scale.damping_number(impact.damping);
            block.yield_number[lane] = ThorntonNing<double>::yield_number(impact.contact, scale.length);
        }
        follow<Form<L, Damping>>(block, impact.detachment, Goal::end);
    }
    return static_cast<double>(operation_count) / static_cast<double>(impacts.size()) /
           static_cast<double>(block_size);
}

template <template <class> class L>
void print(const test::Impacts& impacts) {
    const double count = RegisteredDampings::visit<double>(
        impacts.damping_law, [&]<class Damping>() { return operations_an_impact<L, Damping>(impacts); });
    std::cout << impacts.law.name() << ' ' << name_of(impacts.damping_law) << ' ' << count << '\n';
}

}  // namespace
}  // namespace ashimpact::HWY_NAMESPACE

int main() {
    using namespace ashimpact;
    for (const test::Impacts& impacts : test::random_impacts(500, 1.0, 42)) {
        if (impacts.detachment != impacts.law.default_detachment()) continue;
        impacts.law.visit<void>([&]<template <class> class L>() {
            if constexpr (has_polynomials<L>) HWY_NAMESPACE::print<L>(impacts);
        });
    }
}
