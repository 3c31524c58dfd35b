#include "solver/contact/brach_dunn.hpp"

#include "solver/batch/kernel.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/kernels/brach_dunn.cpp"
#include <hwy/foreach_target.h>

#include "solver/batch/lanes/impacts-inl.hpp"
#include "solver/batch/lanes/inversions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

void brach_dunn_impacts(const batch::ImpactTask& task) {
    solve_law<BrachDunn>(task);
}
void brach_dunn_numbers(const batch::NumberTask& task) {
    solve_law_numbers<BrachDunn>(task);
}
void brach_dunn_inversions(const batch::InversionTask& task) {
    invert_law<BrachDunn>(task);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(brach_dunn_impacts);
HWY_EXPORT(brach_dunn_numbers);
HWY_EXPORT(brach_dunn_inversions);

batch::Kernels batch::brach_dunn_kernels() {
    return {HWY_DYNAMIC_DISPATCH(brach_dunn_impacts), HWY_DYNAMIC_DISPATCH(brach_dunn_numbers),
            HWY_DYNAMIC_DISPATCH(brach_dunn_inversions)};
}

}  // namespace ashimpact
#endif
