// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/histogram.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "solver/statistics/design.hpp"

using namespace ashimpact;

namespace {

/// Restitution-like numbers: some zeros, the rest between 0 and 1.
std::vector<double> fractions(std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = std::max(0.0, 1.2 * unit_interval(random_bits(3, i, 0, RandomStream::points)[0]) - 0.2);
    return values;
}

/// Contact-time-like numbers over several decades.
std::vector<double> times(std::size_t count) {
    std::vector<double> values = fractions(count);
    for (double& value : values) value = 1e-8 * std::pow(10.0, 3 * value);
    return values;
}

double exact_quantile(std::vector<double> values, double probability) {
    std::sort(values.begin(), values.end());
    const auto rank = std::max(1.0, std::ceil(probability * static_cast<double>(values.size())));
    return values[static_cast<std::size_t>(rank) - 1];
}

constexpr std::array probabilities{0.0, 0.001, 0.05, 0.25, 0.5, 0.9, 0.9999, 1.0};

}  // namespace

TEST_CASE("quantiles of absolute bins hold the exact ones within one bin") {
    const Bins bins = Bins::absolute(1000);
    for (const std::size_t count : {1, 2, 17, 5000}) {
        const auto values = fractions(count);
        Histogram histogram;
        histogram.count(bins, values);
        CHECK(histogram.total() == count);
        for (const double p : probabilities) {
            const double exact = exact_quantile(values, p);
            const auto [lower, upper] = histogram.quantile(bins, p);
            CHECK(lower <= exact);
            CHECK(exact <= upper);
            CHECK(upper - lower <= 1.001 * bins.resolution());
            if (exact == 0) CHECK(upper == 0);
        }
    }
}

TEST_CASE("quantiles of relative bins hold the exact ones within their resolution, over decades") {
    const Bins bins = Bins::relative(7);
    const auto values = times(5000);
    Histogram histogram;
    histogram.count(bins, values);
    for (const double p : probabilities) {
        const double exact = exact_quantile(values, p);
        const auto [lower, upper] = histogram.quantile(bins, p);
        CHECK(lower <= exact);
        CHECK(exact < upper);
        CHECK((upper - lower) / lower <= 1.0 / 128);
    }
}

TEST_CASE("relative bins cover every positive number") {
    const Bins bins = Bins::relative(7);
    for (const double value : {5e-324, 2.2250738585072014e-308, 1e-9, 1.0, 1.7976931348623157e308}) {
        const auto bin = bins.bin_of(value);
        CHECK(bins.edge(bin) <= value);
        CHECK(bins.edge(bin + 1) > value);
    }
    CHECK(Bins::absolute(10).bin_of(1.0) == 9);
}

TEST_CASE("parts make the same histogram in any order; what is no number is left out") {
    const Bins bins = Bins::relative(5);
    auto values = times(1000);
    values[3] = std::nan("");
    values[4] = 0;
    Histogram whole;
    whole.count(bins, values);
    CHECK(whole.total() == 999);
    CHECK(whole.zeros() == 1);

    Histogram merged;
    for (const std::size_t part : {3, 1, 0, 2}) {
        Histogram piece;
        piece.count(bins, std::span(values).subspan(250 * part, 250));
        merged.merge(piece);
    }
    CHECK(merged.first() == whole.first());
    CHECK(merged.counts() == whole.counts());
    CHECK(merged.zeros() == whole.zeros());
}

TEST_CASE("merging nothing changes nothing") {
    Histogram histogram;
    histogram.merge(Histogram{});
    CHECK(histogram.total() == 0);
    CHECK(histogram.counts().empty());
}

TEST_CASE("bins found in lanes are those of single values") {
    std::vector<double> values = fractions(1'003);
    values[5] = 1.0;
    values[6] = std::nextafter(1.0, 0.0);
    values[7] = std::nan("");
    for (const Bins& bins : {Bins::absolute(1), Bins::absolute(1000), Bins::relative(7)}) {
        std::vector<std::uint32_t> found(values.size());
        find_bins(bins, values, 0.75, found.data());
        for (std::size_t i = 0; i < values.size(); ++i)
            CHECK(found[i] == bins.bin_of(values[i] > 0 ? values[i] : 0.75));
        Histogram histogram;
        histogram.count(bins, values);
        CHECK(histogram.total() == values.size() - 1);
    }
}
