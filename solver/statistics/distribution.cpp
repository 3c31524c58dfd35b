// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/distribution.cpp"
#include <hwy/foreach_target.h>

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include "solver/numeric/gsl/statistics.hpp"

#ifndef ASHIMPACT_SOLVER_STATISTICS_DISTRIBUTION_ONCE
#define ASHIMPACT_SOLVER_STATISTICS_DISTRIBUTION_ONCE
namespace ashimpact {
namespace {

/// A part of the standard normal distribution between two cuts.
struct CutNormal {
    double lower;  ///< probability below the lower cut
    double width;  ///< probability between the cuts
    bool mirrored =
        false;  ///< both are those of the mirrored distribution, which keeps digits in the upper tail
};

/// A variable x with a normal x or ln x: x = offset + scale z, or x = scale exp(offset z), cut to [minimum,
/// maximum].
struct NormalScale {
    double offset;     ///< mean; of a logarithm its standard deviation
    double scale;      ///< standard deviation; of a logarithm the median of x
    bool logarithmic;  ///< whether ln x is normal
    double minimum;
    double maximum;
};

}  // namespace
}  // namespace ashimpact
#endif

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

/// Values that are converted together: the tails among them, of few values, follow as one.
constexpr std::size_t together = 256;
using Values = std::array<double, together + hn::MaxLanes(Tag())>;
using Places = std::array<std::uint64_t, together + hn::MaxLanes(Tag())>;

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

/// Finds the probabilities outside the middle, without branches, which chance would make costly.
/// @return how many they are; their places come first
HWY_INLINE std::size_t find_tails(const Values& values, std::size_t count, Places& places) {
    const Tag d;
    const hn::RebindToUnsigned<Tag> numbers;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Lanes q = hn::Sub(hn::Load(d, values.data() + i), hn::Set(d, 0.5));
        const auto is_tail = hn::RebindMask(numbers, hn::Gt(hn::Abs(q), hn::Set(d, middle_half)));
        found += hn::CompressStore(hn::Iota(numbers, i), is_tail, numbers, places.data() + found);
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

/// Replaces probabilities in (0, 1) by quantiles, several in each instruction: algorithm AS 241,
/// Wichura 1988; relative error below 4e-15. No bit of a value depends on the other ones.
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

namespace {

HWY_EXPORT(normal_quantiles);

void to_normal_quantiles(const CutNormal& cut, const NormalScale& scale, std::span<double> probabilities) {
    HWY_DYNAMIC_DISPATCH(normal_quantiles)(cut, scale, probabilities.data(), probabilities.size());
}

/// The standard normal distribution between two cuts.
CutNormal cut_normal(double lower, double upper) {
    // Probabilities round to 1 in the upper tail, so a range there is mirrored, which keeps its digits.
    const bool mirrored = lower > 0;
    const double below = gsl::normal_probability(mirrored ? -upper : lower);
    return {below, gsl::normal_probability(mirrored ? -lower : upper) - below, mirrored};
}

void convert(const Choice& choice, std::span<double> values) {
    const auto count = static_cast<double>(choice.values.size());
    for (double& value : values) value = choice.values[static_cast<std::size_t>(value * count)];
}

void convert(const Uniform& uniform, std::span<double> values) {
    Eigen::Map<Eigen::ArrayXd> all(values.data(), std::ssize(values));
    all = uniform.from + all * (uniform.to - uniform.from);
}

void convert(const LogUniform& uniform, std::span<double> values) {
    const double from = std::log(uniform.from);
    const double width = std::log(uniform.to) - from;
    for (double& value : values) value = std::clamp(std::exp(from + value * width), uniform.from, uniform.to);
}

void convert(const Normal& normal, std::span<double> values) {
    const auto standard = [&](double x) { return (x - normal.mean) / normal.standard_deviation; };
    to_normal_quantiles(cut_normal(standard(normal.minimum), standard(normal.maximum)),
                        {normal.mean, normal.standard_deviation, false, normal.minimum, normal.maximum},
                        values);
}

void convert(const LogNormal& normal, std::span<double> values) {
    const double spread = std::log(normal.geometric_standard_deviation);
    const auto standard = [&](double x) { return std::log(x / normal.median) / spread; };
    to_normal_quantiles(cut_normal(standard(normal.minimum), standard(normal.maximum)),
                        {spread, normal.median, true, normal.minimum, normal.maximum}, values);
}

void convert(const Triangular& triangular, std::span<double> values) {
    const double width = triangular.to - triangular.from;
    const double rising = triangular.mode - triangular.from;
    const double falling = triangular.to - triangular.mode;
    for (double& value : values)
        value = value * width < rising ? triangular.from + std::sqrt(value * width * rising)
                                       : triangular.to - std::sqrt((1 - value) * width * falling);
}

template <class Kind>
Support support(const Kind& kind) {
    if constexpr (requires { kind.from; }) {
        return {kind.from, kind.to};
    } else if constexpr (requires { kind.minimum; }) {
        return {kind.minimum, kind.maximum};
    } else {
        const auto [lowest, highest] = std::minmax_element(kind.values.begin(), kind.values.end());
        return {*lowest, *highest};
    }
}

/// @param place value at point 1, 2, ...; both ends are met exactly
template <class Place>
std::vector<double> points_between(double from, double to, int points, const Place& place) {
    std::vector<double> result(static_cast<std::size_t>(points), from);
    for (int i = 1; i < points; ++i) result[static_cast<std::size_t>(i)] = place(i);
    if (points > 1) result.back() = to;
    return result;
}

}  // namespace

Distribution normal_around(double value, double standard_uncertainty) {
    return Normal{.mean = value, .standard_deviation = standard_uncertainty};
}

Distribution lognormal_around(double value, double standard_uncertainty) {
    return LogNormal{.median = value, .geometric_standard_deviation = std::exp(standard_uncertainty / value)};
}

void to_quantiles(const Distribution& distribution, std::span<double> probabilities) {
    std::visit([&](const auto& kind) { convert(kind, probabilities); }, distribution);
}

Support support_of(const Distribution& distribution) {
    return std::visit([](const auto& kind) { return support(kind); }, distribution);
}

std::vector<double> linear_grid(double from, double to, int points) {
    return points_between(from, to, points, [&](int i) { return from + (to - from) * i / (points - 1); });
}

std::vector<double> logarithmic_grid(double from, double to, int points) {
    return points_between(from, to, points, [&](int i) {
        return from * std::pow(to / from, static_cast<double>(i) / (points - 1));
    });
}

}  // namespace ashimpact
#endif
