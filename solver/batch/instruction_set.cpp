#include "solver/batch/instruction_set.hpp"

#include "materials/error.hpp"

#include <hwy/highway.h>

#include <string>

namespace ashimpact {

std::vector<std::string_view> instruction_sets() {
    std::vector<std::string_view> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
    return names;
}

void use_instruction_set(std::string_view name) {
    hwy::SetSupportedTargetsForTest(0);
    std::string known;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name == hwy::TargetName(target)) {
            hwy::SetSupportedTargetsForTest(target);
            hwy::GetChosenTarget().Update(target);
            return;
        }
        if (!known.empty()) known += ", ";
        known += hwy::TargetName(target);
    }
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    if (!name.empty()) throw InputError("unknown instruction set '" + std::string(name) + "'", known);
}

}  // namespace ashimpact
