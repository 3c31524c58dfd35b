// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/multiply_add.hpp"

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/multiply_add.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::int64_t multiply_adds_here(std::int64_t rounds) {
    const hn::ScalableTag<double> tag;
    const auto factor = hn::Set(tag, 0.999999);
    const auto term = hn::Set(tag, 1e-6);
    // Twelve chains with values of their own: alike, the compiler would compute one for all.
    const auto start = [&](double x) HWY_ATTR { return hn::Set(tag, x); };
    auto a0 = start(0.10), a1 = start(0.11), a2 = start(0.12), a3 = start(0.13), a4 = start(0.14);
    auto a5 = start(0.15), a6 = start(0.16), a7 = start(0.17), a8 = start(0.18), a9 = start(0.19);
    auto a10 = start(0.20), a11 = start(0.21);
    for (std::int64_t i = 0; i < rounds; ++i) {
        a0 = hn::MulAdd(a0, factor, term);
        a1 = hn::MulAdd(a1, factor, term);
        a2 = hn::MulAdd(a2, factor, term);
        a3 = hn::MulAdd(a3, factor, term);
        a4 = hn::MulAdd(a4, factor, term);
        a5 = hn::MulAdd(a5, factor, term);
        a6 = hn::MulAdd(a6, factor, term);
        a7 = hn::MulAdd(a7, factor, term);
        a8 = hn::MulAdd(a8, factor, term);
        a9 = hn::MulAdd(a9, factor, term);
        a10 = hn::MulAdd(a10, factor, term);
        a11 = hn::MulAdd(a11, factor, term);
    }
    const auto sum =
        hn::Add(hn::Add(hn::Add(hn::Add(a0, a1), hn::Add(a2, a3)), hn::Add(hn::Add(a4, a5), hn::Add(a6, a7))),
                hn::Add(hn::Add(a8, a9), hn::Add(a10, a11)));
    [[maybe_unused]] volatile double used = hn::GetLane(sum);
    return rounds * 12 * static_cast<std::int64_t>(hn::Lanes(tag));
}

}  // namespace ashimpact::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact::bench {

HWY_EXPORT(multiply_adds_here);

std::int64_t multiply_adds(std::int64_t rounds) {
    return HWY_DYNAMIC_DISPATCH(multiply_adds_here)(rounds);
}

}  // namespace ashimpact::bench
#endif
