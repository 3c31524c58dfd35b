// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/moments.hpp"

#include <algorithm>
#include <array>

// This file once more for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/statistics/moments.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#ifndef ASHIMPACT_SOLVER_STATISTICS_MOMENTS_ONCE
#define ASHIMPACT_SOLVER_STATISTICS_MOMENTS_ONCE
namespace ashimpact {
namespace {

/// Values in rows of a fixed length, the last of which may be shorter.
struct Rows {
    std::span<const double> values;
    std::size_t length;
};

/// How many values of a column of rows are numbers, and how many of these are zero.
struct ZeroCount {
    double known;
    double zeros;
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

/// Rows that are added one by one before their sum joins that of all: rounding grows with their number.
constexpr std::size_t rows_together = 64;

/// As many neighbouring columns of rows as there are lanes.
class Columns {
  public:
    HWY_INLINE Columns(const Rows& rows, std::size_t start)
        : rows_(rows), start_(start), count_((rows.values.size() - start + rows.length - 1) / rows.length) {}

    [[nodiscard]] std::size_t count() const { return count_; }
    /// A row; not a number where there is no value. Lanes past the last column hold values of the next row.
    [[nodiscard]] HWY_INLINE Lanes row(std::size_t number) const {
        const Tag d;
        const std::size_t place = start_ + number * rows_.length;
        const std::size_t left = rows_.values.size() - place;
        if (left >= hn::Lanes(d)) return hn::LoadU(d, rows_.values.data() + place);
        HWY_ALIGN std::array<double, hn::MaxLanes(d)> padded;
        padded.fill(std::numeric_limits<double>::quiet_NaN());
        for (std::size_t i = 0; i < left; ++i) padded[i] = rows_.values[place + i];
        return hn::Load(d, padded.data());
    }

  private:
    Rows rows_;
    std::size_t start_;
    std::size_t count_;
};

/// Sums of columns. Each lane adds one column from its first row to its last, whatever the number of lanes.
template <std::size_t sums, class Add>
HWY_INLINE void add_rows(const Columns& columns, Lanes (&total)[sums], const Add& add) {
    const Tag d;
    for (Lanes& sum : total) sum = hn::Zero(d);
    for (std::size_t first = 0; first < columns.count(); first += rows_together) {
        Lanes part[sums];
        for (Lanes& sum : part) sum = hn::Zero(d);
        const std::size_t end = std::min(first + rows_together, columns.count());
        for (std::size_t i = first; i < end; ++i) add(columns.row(i), part);
        for (std::size_t k = 0; k < sums; ++k) total[k] = hn::Add(total[k], part[k]);
    }
}

HWY_INLINE Lanes one_if(hn::Mask<Tag> condition) {
    return hn::IfThenElseZero(condition, hn::Set(Tag(), 1.0));
}

template <class Sums>
HWY_INLINE void store(Lanes lanes, std::size_t count, Sums* out, double Sums::*member) {
    const Tag d;
    HWY_ALIGN std::array<double, hn::MaxLanes(d)> values;
    hn::Store(lanes, d, values.data());
    for (std::size_t i = 0; i < count; ++i) out[i].*member = values[i];
}

HWY_INLINE void add_deviations(const Columns& columns, std::size_t count, DeviationSums* out) {
    const Tag d;
    Lanes plain[2];
    add_rows(columns, plain, [](Lanes value, Lanes(&sum)[2]) HWY_ATTR {
        const auto known = hn::Eq(value, value);
        sum[0] = hn::Add(sum[0], one_if(known));
        sum[1] = hn::Add(sum[1], hn::IfThenElseZero(known, value));
    });
    const Lanes guess = hn::Div(plain[1], hn::Max(plain[0], hn::Set(d, 1.0)));
    const Lanes infinity = hn::Set(d, std::numeric_limits<double>::infinity());
    Lanes least = infinity;
    Lanes greatest = hn::Neg(infinity);
    Lanes powers[4];
    add_rows(columns, powers, [&](Lanes value, Lanes(&sum)[4]) HWY_ATTR {
        const auto known = hn::Eq(value, value);
        const Lanes deviation = hn::IfThenElseZero(known, hn::Sub(value, guess));
        const Lanes square = hn::Mul(deviation, deviation);
        sum[0] = hn::Add(sum[0], deviation);
        sum[1] = hn::Add(sum[1], square);
        sum[2] = hn::MulAdd(square, deviation, sum[2]);
        sum[3] = hn::MulAdd(square, square, sum[3]);
        least = hn::Min(least, hn::IfThenElse(known, value, infinity));
        greatest = hn::Max(greatest, hn::IfThenElse(known, value, hn::Neg(infinity)));
    });
    store(plain[0], count, out, &DeviationSums::count);
    store(guess, count, out, &DeviationSums::guess);
    store(powers[0], count, out, &DeviationSums::first);
    store(powers[1], count, out, &DeviationSums::second);
    store(powers[2], count, out, &DeviationSums::third);
    store(powers[3], count, out, &DeviationSums::fourth);
    store(least, count, out, &DeviationSums::minimum);
    store(greatest, count, out, &DeviationSums::maximum);
}

}  // namespace

/// Sums of all columns.
void sum_columns(const Rows& rows, DeviationSums* out) {
    const std::size_t width = hn::Lanes(Tag());
    const std::size_t columns = std::min(rows.length, rows.values.size());
    for (std::size_t start = 0; start < columns; start += width)
        add_deviations(Columns(rows, start), std::min(width, columns - start), out + start);
}

/// Counts of zeros in all columns.
void count_columns(const Rows& rows, ZeroCount* out) {
    const Tag d;
    const std::size_t width = hn::Lanes(d);
    const std::size_t columns = std::min(rows.length, rows.values.size());
    for (std::size_t start = 0; start < columns; start += width) {
        Lanes counts[2];
        add_rows(Columns(rows, start), counts, [&](Lanes value, Lanes(&sum)[2]) HWY_ATTR {
            sum[0] = hn::Add(sum[0], one_if(hn::Eq(value, value)));
            sum[1] = hn::Add(sum[1], one_if(hn::Eq(value, hn::Zero(d))));
        });
        const std::size_t count = std::min(width, columns - start);
        store(counts[0], count, out + start, &ZeroCount::known);
        store(counts[1], count, out + start, &ZeroCount::zeros);
    }
}

}  // namespace ashimpact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ashimpact {

namespace {

/// Sums over a part of the values, formed in turns in several places, so that one addition need not wait for
/// the one before.
struct PowerSums : DeviationSums {
    static constexpr std::size_t places = 4;
    static constexpr std::size_t longest = 128;  ///< part that is summed without halving it

    void add(double value, double centre) {
        const double deviation = value - centre;
        const double square = deviation * deviation;
        first += deviation;
        second += square;
        third += square * deviation;
        fourth += square * square;
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
    }
    void merge(const PowerSums& other) {
        first += other.first;
        second += other.second;
        third += other.third;
        fourth += other.fourth;
        minimum = std::min(minimum, other.minimum);
        maximum = std::max(maximum, other.maximum);
    }

    /// By halves: rounding grows with the logarithm of the number of values.
    [[nodiscard]] static PowerSums of(std::span<const double> values, double centre) {
        if (values.size() > longest) {
            PowerSums sums = of(values.first(values.size() / 2), centre);
            sums.merge(of(values.subspan(values.size() / 2), centre));
            return sums;
        }
        std::array<PowerSums, places> parts;
        std::size_t i = 0;
        for (; i + places <= values.size(); i += places)
            for (std::size_t k = 0; k < places; ++k) parts[k].add(values[i + k], centre);
        for (std::size_t k = 0; i < values.size(); ++i, ++k) parts[k].add(values[i], centre);
        for (std::size_t k = 1; k < places; ++k) parts[0].merge(parts[k]);
        return parts[0];
    }
};

double sum_of(std::span<const double> values) {
    constexpr std::size_t places = PowerSums::places;
    if (values.size() > PowerSums::longest)
        return sum_of(values.first(values.size() / 2)) + sum_of(values.subspan(values.size() / 2));
    std::array<double, places> parts{};
    std::size_t i = 0;
    for (; i + places <= values.size(); i += places)
        for (std::size_t k = 0; k < places; ++k) parts[k] += values[i + k];
    for (std::size_t k = 0; i < values.size(); ++i, ++k) parts[k] += values[i];
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
}

HWY_EXPORT(sum_columns);
HWY_EXPORT(count_columns);

/// Columns that fill the lanes of every instruction set: few groups have several columns each.
constexpr std::uint32_t least_columns = 16;

std::uint32_t columns_of(std::uint32_t groups) {
    return groups * ((least_columns + groups - 1) / groups);
}

/// Moments of a number that is 1 for some of @p count values and 0 for the others.
Moments moments_of_ones(double count, double ones) {
    Moments moments;
    if (count == 0) return moments;
    const double zeros = count - ones;
    const double above = zeros / count;  // deviation of a 1 from the mean
    const double below = ones / count;   // of a 0, with the other sign
    moments.count = static_cast<std::uint64_t>(count);
    moments.mean = below;
    moments.second = ones * above;  // since above + below = 1
    moments.third = moments.second * (above - below);
    moments.fourth = moments.second * (above * above * above + below * below * below);
    moments.minimum = zeros > 0 ? 0 : 1;
    moments.maximum = ones > 0 ? 1 : 0;
    return moments;
}

}  // namespace

Moments Moments::of(std::span<const double> values) {
    if (values.empty()) return {};
    const auto count = static_cast<double>(values.size());
    const double guess = sum_of(values) / count;
    PowerSums sums = PowerSums::of(values, guess);
    sums.count = count;
    sums.guess = guess;
    return of(sums);
}

Moments Moments::of(const DeviationSums& sums) {
    Moments moments;
    if (sums.count == 0) return moments;
    const double shift = sums.first / sums.count;  // of the mean from its guess: a rounding
    moments.count = static_cast<std::uint64_t>(sums.count);
    moments.mean = sums.guess + shift;
    moments.second = sums.second - shift * sums.first;
    moments.third = sums.third - shift * (3 * sums.second - 2 * shift * sums.first);
    moments.fourth =
        sums.fourth - shift * (4 * sums.third - shift * (6 * sums.second - 3 * shift * sums.first));
    moments.minimum = sums.minimum;
    moments.maximum = sums.maximum;
    return moments;
}

void Moments::merge(const Moments& other) {
    if (other.count == 0) return;
    if (count == 0) {
        *this = other;
        return;
    }
    const auto na = static_cast<double>(count);
    const auto nb = static_cast<double>(other.count);
    const double n = na + nb;
    const double delta = other.mean - mean;
    const double a = na / n;
    const double b = nb / n;
    const double square = delta * delta;
    fourth += other.fourth + square * square * na * b * (a * a - a * b + b * b) +
              6 * square * (a * a * other.second + b * b * second) +
              4 * delta * (a * other.third - b * third);
    third += other.third + square * delta * na * b * (a - b) + 3 * delta * (a * other.second - b * second);
    second += other.second + square * na * b;
    mean += delta * b;
    count += other.count;
    minimum = std::min(minimum, other.minimum);
    maximum = std::max(maximum, other.maximum);
}

std::vector<Moments> moments_by_group(std::span<const double> values, std::uint32_t groups,
                                      std::uint64_t first) {
    const std::uint32_t columns = columns_of(groups);
    std::vector<DeviationSums> sums(columns);
    HWY_DYNAMIC_DISPATCH(sum_columns)({values, columns}, sums.data());
    std::vector<Moments> moments(groups);
    for (std::uint32_t column = 0; column < columns; ++column)
        moments[(first + column) % groups].merge(Moments::of(sums[column]));
    return moments;
}

std::vector<Moments> moments_of_zeros_by_group(std::span<const double> values, std::uint32_t groups,
                                               std::uint64_t first) {
    const std::uint32_t columns = columns_of(groups);
    std::vector<ZeroCount> counts(columns, {0, 0});
    HWY_DYNAMIC_DISPATCH(count_columns)({values, columns}, counts.data());
    std::vector<ZeroCount> sums(groups, {0, 0});
    for (std::uint32_t column = 0; column < columns; ++column) {
        sums[(first + column) % groups].known += counts[column].known;
        sums[(first + column) % groups].zeros += counts[column].zeros;
    }
    std::vector<Moments> moments;
    moments.reserve(sums.size());
    for (const ZeroCount& sum : sums) moments.push_back(moments_of_ones(sum.known, sum.zeros));
    return moments;
}

}  // namespace ashimpact
#endif
