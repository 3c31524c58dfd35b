// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/kernels/instruction_set.hpp"

#include <array>
#include <cstdint>
#include <string>

#include <hwy/highway.h>

#include "core/quantities/checks.hpp"

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
    for (const InstructionSet& set : known_sets) {
        if ((HWY_TARGETS & supported & set.target) != 0) present.push_back(set);
    }
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

}  // namespace ashimpact
