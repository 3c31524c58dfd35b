#include "solver/contact/hertz.hpp"

#include "solver/batch/kernel.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/batch/kernels/hertz.cpp"
#include <hwy/foreach_target.h>

#include "solver/batch/lanes/impacts-inl.hpp"
#include "solver/batch/lanes/inversions-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

void hertz_impacts(const batch::ImpactTask& task) {
    solve_law<Hertz>(task);
}
void hertz_numbers(const batch::NumberTask& task) {
    solve_law_numbers<Hertz>(task);
}
void hertz_inversions(const batch::InversionTask& task) {
    invert_law<Hertz>(task);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(hertz_impacts);
HWY_EXPORT(hertz_numbers);
HWY_EXPORT(hertz_inversions);

batch::Kernels batch::hertz_kernels() {
    return {HWY_DYNAMIC_DISPATCH(hertz_impacts), HWY_DYNAMIC_DISPATCH(hertz_numbers),
            HWY_DYNAMIC_DISPATCH(hertz_inversions)};
}

}  // namespace ashimpact
#endif
