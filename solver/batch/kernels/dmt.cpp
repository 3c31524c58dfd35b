#include "solver/contact/dmt.hpp"

#include "solver/batch/kernel.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/kernels/dmt.cpp"
#include <hwy/foreach_target.h>

#include "solver/batch/lanes/impacts-inl.hpp"
#include "solver/batch/lanes/inversions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

void dmt_impacts(const batch::ImpactTask& task) {
    solve_law<Dmt>(task);
}
void dmt_numbers(const batch::NumberTask& task) {
    solve_law_numbers<Dmt>(task);
}
void dmt_inversions(const batch::InversionTask& task) {
    invert_law<Dmt>(task);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(dmt_impacts);
HWY_EXPORT(dmt_numbers);
HWY_EXPORT(dmt_inversions);

batch::Kernels batch::dmt_kernels() {
    return {HWY_DYNAMIC_DISPATCH(dmt_impacts), HWY_DYNAMIC_DISPATCH(dmt_numbers),
            HWY_DYNAMIC_DISPATCH(dmt_inversions)};
}

}  // namespace ashimpact
#endif
