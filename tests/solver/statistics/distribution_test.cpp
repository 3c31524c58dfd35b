// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "solver/numeric/gsl/statistics.hpp"
#include "solver/statistics/design.hpp"
#include "solver/statistics/histogram.hpp"
#include "solver/statistics/interval.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;

namespace {

double quantile(const Distribution& distribution, double probability) {
    std::array<double, 1> value{probability};
    to_quantiles(distribution, value);
    return value[0];
}

double normal_below(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

const auto relative = [](double value) { return doctest::Approx(value).epsilon(1e-12); };

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

TEST_CASE("quantiles are the inverse of what is below them, at fly-ash scale") {
    for (const double p : {1e-6, 0.02, 0.3, 0.5, 0.77, 0.999}) {
        CAPTURE(p);
        const double uniform = quantile(Uniform{22e-6, 44e-6}, p);
        CHECK((uniform - 22e-6) / 22e-6 == relative(p));
        const double logarithmic = quantile(LogUniform{1e-6, 1e-4}, p);
        CHECK(std::log(logarithmic / 1e-6) / std::log(100) == relative(p));
        CHECK(normal_below((quantile(Normal{90e9, 5e9}, p) - 90e9) / 5e9) == relative(p));
        const double size = quantile(LogNormal{44e-6, 1.5}, p);
        CHECK(normal_below(std::log(size / 44e-6) / std::log(1.5)) == relative(p));
        const Triangular triangular{0.1, 0.25, 0.4};
        const double x = quantile(triangular, p);
        const double below =
            x < 0.25 ? (x - 0.1) * (x - 0.1) / (0.3 * 0.15) : 1 - (0.4 - x) * (0.4 - x) / (0.3 * 0.15);
        CHECK(below == doctest::Approx(p).epsilon(1e-9));
    }
}

TEST_CASE("normal quantiles in lanes are those of GSL, over the whole range and one by one") {
    std::vector<double> probabilities;
    probabilities.reserve(2354 + 1429 + 32);
    for (int i = 0; i < 2354; ++i) probabilities.push_back(std::exp2(-1070 + std::log2(1.37) * i));
    for (int i = 0; i < 1429; ++i) probabilities.push_back(0.0003 + 0.0007 * i);
    for (int i = 0; i < 32; ++i) probabilities.push_back(1.0 - 0x1p-53 * std::pow(3.0, i));
    std::vector<double> together = probabilities;
    to_quantiles(Normal{0.0, 1.0}, together);
    std::vector<double> sizes = probabilities;
    to_quantiles(LogNormal{44e-6, 1.5}, sizes);
    for (std::size_t i = 0; i < probabilities.size(); ++i) {
        const double p = probabilities[i];
        CAPTURE(p);
        const double expected = gsl::normal_quantile(p);
        CHECK(std::abs(together[i] - expected) <= 4e-15 * std::max(std::abs(expected), 0x1p-10));
        CHECK(quantile(Normal{0.0, 1.0}, p) == together[i]);
        CHECK(sizes[i] == doctest::Approx(44e-6 * std::pow(1.5, expected)).epsilon(2e-14));
        CHECK(quantile(LogNormal{44e-6, 1.5}, p) == sizes[i]);
    }
}

TEST_CASE("log-normal quantiles of a spread that fills the range of numbers") {
    for (const double spread : {1e-3, 3.0, 40.0}) {
        for (int i = 0; i < 1370; ++i) {
            const double p = 0x1p-53 + 0.00073 * i;
            CAPTURE(spread);
            CAPTURE(p);
            const double exponent = std::log(std::exp(spread)) * quantile(Normal{0.0, 1.0}, p);
            const double expected = std::exp(exponent);
            const double rounding = 4e-16 * (1.0 + std::abs(exponent));
            CHECK(std::abs(quantile(LogNormal{1.0, std::exp(spread)}, p) / expected - 1.0) <= rounding);
        }
    }
}

TEST_CASE("a cut normal distribution keeps its shape between the cuts") {
    const Normal cut{2.0, 1.0, 1.5, 4.0};
    for (const double p : {0.001, 0.4, 0.9}) {
        const double value = quantile(cut, p);
        CHECK(value >= 1.5);
        CHECK(value <= 4.0);
        const double below =
            (normal_below(value - 2) - normal_below(-0.5)) / (normal_below(2) - normal_below(-0.5));
        CHECK(below == relative(p));
    }
    CHECK(quantile(Normal{0, 1, -3, 3}, 0.5) == doctest::Approx(0).epsilon(1e-15));
}

TEST_CASE("a cut far out in either tail keeps its digits") {
    // Beyond 10 standard deviations the tail falls like exp(-10 x), so half of it is below ln(2)/10.1 or so.
    const double upper = quantile(Normal{0, 1, 10, 50}, 0.5);
    const double lower = quantile(Normal{0, 1, -50, -10}, 0.5);
    CHECK(upper == relative(-lower));
    CHECK(std::erfc(upper / std::numbers::sqrt2) / std::erfc(10 / std::numbers::sqrt2) ==
          doctest::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a choice gives each value with the same probability") {
    const Choice choice{{3, 1, 2}};
    CHECK(quantile(choice, 1e-9) == 3);
    CHECK(quantile(choice, 0.34) == 1);
    CHECK(quantile(choice, 1 - 0x1p-53) == 2);
}

TEST_CASE("the support holds every value") {
    CHECK(support_of(Choice{{3, 1, 2}}).lowest == 1);
    CHECK(support_of(Choice{{3, 1, 2}}).highest == 3);
    CHECK(support_of(Normal{1, 2}).lowest == -INFINITY);
    CHECK(support_of(LogNormal{44e-6, 1.5}).lowest == 0);
    CHECK(support_of(Triangular{1, 2, 3}).highest == 3);
    const LogUniform logarithmic{0.1, 3};
    CHECK(quantile(logarithmic, 0x1p-53) >= 0.1);
    CHECK(quantile(logarithmic, 1 - 0x1p-53) <= 3);
}

TEST_CASE("grids meet both ends exactly") {
    CHECK(linear_grid(0.1, 0.7, 4).front() == 0.1);
    CHECK(linear_grid(0.1, 0.7, 4)[1] == relative(0.3));
    CHECK(linear_grid(0.1, 0.7, 4).back() == 0.7);
    CHECK(logarithmic_grid(1e-6, 1e-3, 4)[1] == relative(1e-5));
    CHECK(logarithmic_grid(1e-6, 1e-3, 4).back() == 1e-3);
    CHECK(linear_grid(5, 9, 1) == std::vector<double>{5});
}

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

using namespace ashimpact::test;

TEST_CASE("log-normal distributions together: one, its halves, and two far apart") {
    const double u = 0.1;
    const double quantile = confidence_quantile();
    const auto near = [](double value, double expected) {
        return relative_difference(value, expected) < 1e-10;
    };
    for (const auto& parts : {std::vector<LogNormalPart>{{std::log(2.0), 1.0}},
                              std::vector<LogNormalPart>{{std::log(2.0), 0.5}, {std::log(2.0), 0.5}}}) {
        const Interval one = interval_of(parts, u);
        CHECK(near(one.value, 2.0 * std::exp(0.5 * u * u)));
        CHECK(near(one.standard_uncertainty, one.value * std::sqrt(std::expm1(u * u))));
        CHECK(near(*one.lower, 2.0 * std::exp(-quantile * u)));
        CHECK(near(*one.upper, 2.0 * std::exp(quantile * u)));
    }
    // Each end is that of 5 % of one part.
    const Interval two = interval_of({{0.0, 0.5}, {5.0, 0.5}}, u);
    CHECK(near(*two.lower, std::exp(-u * gsl::normal_quantile(0.95))));
    CHECK(near(*two.upper, std::exp(5.0 + u * gsl::normal_quantile(0.95))));
    CHECK(near(two.value, 0.5 * (1.0 + std::exp(5.0)) * std::exp(0.5 * u * u)));
}
