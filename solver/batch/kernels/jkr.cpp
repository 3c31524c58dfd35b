#include "solver/contact/jkr.hpp"

#include "solver/batch/kernel.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/kernels/jkr.cpp"
#include <hwy/foreach_target.h>

#include "solver/batch/lanes/impacts-inl.hpp"
#include "solver/batch/lanes/inversions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

void jkr_impacts(const batch::ImpactTask& task) {
    solve_law<Jkr>(task);
}
void jkr_numbers(const batch::NumberTask& task) {
    solve_law_numbers<Jkr>(task);
}
void jkr_inversions(const batch::InversionTask& task) {
    invert_law<Jkr>(task);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(jkr_impacts);
HWY_EXPORT(jkr_numbers);
HWY_EXPORT(jkr_inversions);

batch::Kernels batch::jkr_kernels() {
    return {HWY_DYNAMIC_DISPATCH(jkr_impacts), HWY_DYNAMIC_DISPATCH(jkr_numbers),
            HWY_DYNAMIC_DISPATCH(jkr_inversions)};
}

}  // namespace ashimpact
#endif
