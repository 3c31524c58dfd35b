#include "solver/contact/sjkr.hpp"

#include "solver/batch/kernel.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/kernels/sjkr.cpp"
#include <hwy/foreach_target.h>

#include "solver/batch/lanes/impacts-inl.hpp"
#include "solver/batch/lanes/inversions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

void sjkr_impacts(const batch::ImpactTask& task) {
    solve_law<Sjkr>(task);
}
void sjkr_numbers(const batch::NumberTask& task) {
    solve_law_numbers<Sjkr>(task);
}
void sjkr_inversions(const batch::InversionTask& task) {
    invert_law<Sjkr>(task);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(sjkr_impacts);
HWY_EXPORT(sjkr_numbers);
HWY_EXPORT(sjkr_inversions);

batch::Kernels batch::sjkr_kernels() {
    return {HWY_DYNAMIC_DISPATCH(sjkr_impacts), HWY_DYNAMIC_DISPATCH(sjkr_numbers),
            HWY_DYNAMIC_DISPATCH(sjkr_inversions)};
}

}  // namespace ashimpact
#endif
