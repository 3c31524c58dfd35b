// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/normal_lanes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/normal_lanes.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ashimpact::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Lanes = hn::Vec<Tag>;

/// Coefficients of P(x)/Q(x) of degree 7, from the highest power.
struct Ratio {
    std::array<double, 8> above;
    std::array<double, 8> below;
};

// Wichura 1988: the middle, the tails, and the tails beyond a probability of exp(-25).
constexpr Ratio middle{
    {2.5090809287301226727e3, 3.3430575583588128105e4, 6.7265770927008700853e4, 4.5921953931549871457e4,
     1.3731693765509461125e4, 1.9715909503065514427e3, 1.3314166789178437745e2, 3.3871328727963666080e0},
    {5.2264952788528545610e3, 2.8729085735721942674e4, 3.9307895800092710610e4, 2.1213794301586595867e4,
     5.3941960214247511077e3, 6.8718700749205790830e2, 4.2313330701600911252e1, 1.0}};
constexpr Ratio tail{{7.74545014278341407640e-4, 2.27238449892691845833e-2, 2.41780725177450611770e-1,
                      1.27045825245236838258e0, 3.64784832476320460504e0, 5.76949722146069140550e0,
                      4.63033784615654529590e0, 1.42343711074968357734e0},
                     {1.05075007164441684324e-9, 5.47593808499534494600e-4, 1.51986665636164571966e-2,
                      1.48103976427480074590e-1, 6.89767334985100004550e-1, 1.67638483018380384940e0,
                      2.05319162663775882187e0, 1.0}};
constexpr Ratio far_tail{{2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3,
                          2.65321895265761230930e-2, 2.96560571828504891230e-1, 1.78482653991729133580e0,
                          5.46378491116411436990e0, 6.65790464350110377720e0},
                         {2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5,
                          7.86869131145613259100e-4, 1.48753612908506148525e-2, 1.36929880922735805310e-1,
                          5.99832206555887937690e-1, 1.0}};

/// The value of a ratio, known when this is compiled: its coefficients are parts of the instructions.
template <const Ratio& ratio>
HWY_INLINE Lanes value_at(Lanes x) {
    const Tag d;
    Lanes p = hn::Set(d, ratio.above[0]);
    Lanes q = hn::Set(d, ratio.below[0]);
#pragma GCC unroll 7
    for (std::size_t i = 1; i < ratio.above.size(); ++i) {
        p = hn::MulAdd(p, x, hn::Set(d, ratio.above[i]));
        q = hn::MulAdd(q, x, hn::Set(d, ratio.below[i]));
    }
    return hn::Div(p, q);
}

constexpr double middle_half = 0.425;
constexpr double far_from = 5.0;
constexpr double least_probability = 0x1p-1074;
constexpr double greatest_exponent = 705.0;

/// ln 2 = ln2_upper + ln2_lower; the first has few enough digits that its multiples are exact.
constexpr double ln2_upper = 0x1.62e42fefa38p-1;
constexpr double ln2_lower = 0x1.ef35793c7673p-45;

/// exp(x) for |x| <= ln(2)/2 as a polynomial, from the highest power; relative error 4e-18.
constexpr std::array<double, 12> exponential_series{2.4999953556339105e-08,
                                                    2.7630225530131983e-07,
                                                    2.755758665235538e-06,
                                                    2.4801493176265717e-05,
                                                    0.00019841269506389936,
                                                    0.0013888888943539056,
                                                    0.008333333333494454,
                                                    0.04166666666653059,
                                                    0.16666666666666413,
                                                    0.5000000000000011,
                                                    1.0,
                                                    1.0};

/// Values that are converted together: the tails among them, of few values, follow as one. A byte holds a
/// place.
constexpr std::size_t together = 256;
static_assert(hn::MaxLanes(Tag()) <= 8, "a byte holds the bits of a mask");
using Values = std::array<double, together + hn::MaxLanes(Tag())>;
using Places = std::array<std::uint8_t, together + 8>;

/// The numbers of the bits that are set in a byte, one after another in the bytes of a word as memory has
/// them.
constexpr std::array<std::uint64_t, 256> numbers_of_bits = [] {
    std::array<std::uint64_t, 256> all{};
    for (unsigned byte = 0; byte < all.size(); ++byte) {
        unsigned found = 0;
        for (unsigned bit = 0; bit < 8; ++bit)
            if ((byte >> bit & 1U) != 0) {
                const unsigned place = std::endian::native == std::endian::little ? found : 7 - found;
                all[byte] |= std::uint64_t{bit} << (8 * place);
                ++found;
            }
    }
    return all;
}();
constexpr std::uint64_t one_in_each_byte = 0x0101010101010101;

/// Standard normal quantiles of probabilities outside the middle.
HWY_INLINE Lanes tail_quantile(Lanes p) {
    const Tag d;
    const Lanes nearer = hn::Min(p, hn::Sub(hn::Set(d, 1.0), p));
    const Lanes beyond = hn::Max(nearer, hn::Set(d, least_probability));
    const Lanes root = hn::Sqrt(hn::Neg(hn::Log(d, beyond)));
    const Lanes split = hn::Set(d, far_from);
    Lanes out = value_at<tail>(hn::Sub(root, hn::Set(d, 1.6)));
    const auto is_far = hn::Gt(root, split);
    if (!hn::AllFalse(d, is_far)) out = hn::IfThenElse(is_far, value_at<far_tail>(hn::Sub(root, split)), out);
    return hn::CopySign(out, hn::Sub(p, hn::Set(d, 0.5)));
}

/// Finds the probabilities outside the middle. @return how many they are; their places come first
HWY_INLINE std::size_t find_tails(const Values& values, std::size_t count, Places& places) {
    const Tag d;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Lanes q = hn::Sub(hn::Load(d, values.data() + i), hn::Set(d, 0.5));
        std::array<std::uint8_t, 8> bits{};  // StoreMaskBits() may write as many
        hn::StoreMaskBits(d, hn::Gt(hn::Abs(q), hn::Set(d, middle_half)), bits.data());
        // The places of all lanes at once, without branches, which chance would make costly.
        const std::uint64_t here = numbers_of_bits[bits[0]] + i * one_in_each_byte;
        std::memcpy(places.data() + found, &here, sizeof here);
        found += static_cast<std::size_t>(std::popcount(bits[0]));
    }
    return found;
}

/// Replaces probabilities by standard normal quantiles.
HWY_INLINE void to_quantiles(Values& values, std::size_t count) {
    const Tag d;
    Places places;
    const std::size_t found = find_tails(values, count, places);
    HWY_ALIGN Values tails;
    for (std::size_t i = 0; i < found; ++i) tails[i] = values[places[i]];
    hn::StoreU(hn::Set(d, 0.5), d, tails.data() + found);
    for (std::size_t i = 0; i < found; i += hn::Lanes(d))
        hn::Store(tail_quantile(hn::Load(d, tails.data() + i)), d, tails.data() + i);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Lanes q = hn::Sub(hn::Load(d, values.data() + i), hn::Set(d, 0.5));
        const Lanes r = hn::NegMulAdd(q, q, hn::Set(d, middle_half * middle_half));
        hn::Store(hn::Mul(q, value_at<middle>(r)), d, values.data() + i);
    }
    for (std::size_t i = 0; i < found; ++i) values[places[i]] = tails[i];
}

/// exp(x) for |x| up to greatest_exponent, where it is a normal number: half an ulp and 1e-17 of it.
HWY_INLINE Lanes exponential(Lanes x) {
    const Tag d;
    const hn::RebindToUnsigned<Tag> bits;
    // A number added to one of this size is rounded to an integer, in the last digits of the sum.
    const Lanes rounder = hn::Set(d, 0x1.8p52);
    const Lanes rounded = hn::MulAdd(x, hn::Set(d, 1.4426950408889634074), rounder);
    const Lanes halvings = hn::Sub(rounded, rounder);
    Lanes r = hn::NegMulAdd(halvings, hn::Set(d, ln2_upper), x);
    r = hn::NegMulAdd(halvings, hn::Set(d, ln2_lower), r);
    Lanes sum = hn::Set(d, exponential_series[0]);
#pragma GCC unroll 11
    for (std::size_t i = 1; i < exponential_series.size(); ++i)
        sum = hn::MulAdd(sum, r, hn::Set(d, exponential_series[i]));
    return hn::BitCast(d, hn::Add(hn::BitCast(bits, sum), hn::ShiftLeft<52>(hn::BitCast(bits, rounded))));
}

HWY_INLINE Lanes scaled(const CutNormal& cut, const NormalScale& scale, Lanes z) {
    const Tag d;
    if (cut.mirrored) z = hn::Neg(z);
    const Lanes offset = hn::Set(d, scale.offset);
    const Lanes unit = hn::Set(d, scale.scale);
    Lanes x;
    if (scale.logarithmic) {
        const Lanes most = hn::Set(d, greatest_exponent);
        x = hn::Mul(unit, exponential(hn::Min(hn::Max(hn::Mul(offset, z), hn::Neg(most)), most)));
    } else {
        x = hn::MulAdd(unit, z, offset);
    }
    return hn::Min(hn::Max(x, hn::Set(d, scale.minimum)), hn::Set(d, scale.maximum));
}

/// Converts at most as many values as are converted together, in whole registers.
HWY_INLINE void convert(const CutNormal& cut, const NormalScale& scale, double* values, std::size_t count) {
    const Tag d;
    const std::size_t width = hn::Lanes(d);
    HWY_ALIGN Values work;
    for (std::size_t i = 0; i < count; i += width) {
        Lanes p = hn::LoadU(d, values + i);
        if (cut.mirrored) p = hn::Sub(hn::Set(d, 1.0), p);
        hn::Store(hn::MulAdd(p, hn::Set(d, cut.width), hn::Set(d, cut.lower)), d, work.data() + i);
    }
    to_quantiles(work, count);
    for (std::size_t i = 0; i < count; i += width)
        hn::StoreU(scaled(cut, scale, hn::Load(d, work.data() + i)), d, values + i);
}

}  // namespace

void normal_quantiles(const CutNormal& cut, const NormalScale& scale, double* values, std::size_t count) {
    std::size_t i = 0;
    for (; i + together <= count; i += together) convert(cut, scale, values + i, together);
    if (i == count) return;
    const std::size_t left = count - i;
    const std::size_t width = hn::Lanes(Tag());
    Values rest;
    rest.fill(0.5);  // beyond the values, up to a whole register
    std::copy_n(values + i, left, rest.begin());
    convert(cut, scale, rest.data(), (left + width - 1) / width * width);
    std::copy_n(rest.begin(), left, values + i);
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

HWY_EXPORT(normal_quantiles);

void to_normal_quantiles(const CutNormal& cut, const NormalScale& scale, std::span<double> probabilities) {
    HWY_DYNAMIC_DISPATCH(normal_quantiles)(cut, scale, probabilities.data(), probabilities.size());
}

}  // namespace ashimpact
#endif
