// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/statistics/moments.hpp"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "solver/statistics/design.hpp"
#include "solver/statistics/propagation.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Numbers of an exponential distribution far from zero, where power sums would cancel.
std::vector<double> sample(std::size_t count, double offset) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = offset - std::log(unit_interval(random_bits(7, i, 0, RandomStream::points)[0]));
    return values;
}

long double central(const std::vector<double>& values, int power) {
    long double mean = 0;
    for (const double value : values) mean += value;
    mean /= static_cast<long double>(values.size());
    long double sum = 0;
    for (const double value : values) sum += std::pow(value - mean, static_cast<long double>(power));
    return sum;
}

void check_same(const Moments& moments, const std::vector<double>& values) {
    const auto near = [](long double value) {
        return doctest::Approx(static_cast<double>(value)).epsilon(1e-9);
    };
    CHECK(moments.count == values.size());
    CHECK(moments.second == near(central(values, 2)));
    CHECK(moments.third == near(central(values, 3)));
    CHECK(moments.fourth == near(central(values, 4)));
}

/// A sum that remembers in which order it was made.
struct Order {
    std::string text;
    void merge(const Order& other) { text = "(" + text + other.text + ")"; }
};

std::string order_of(unsigned chunks) {
    PairwiseMerge<Order> merge;
    for (unsigned i = 0; i < chunks; ++i) merge.add({std::string(1, static_cast<char>('a' + i))});
    return merge.total().text;
}

}  // namespace

TEST_CASE("moments from sums about a guess are those about the mean, wherever the guess lies") {
    const std::vector<double> values{1.0, 2.5, 2.75, 4.0, 9.0};
    const Moments whole = Moments::of(values);
    for (const double guess : {3.0, 3.85, 5.0}) {
        DeviationSums sums{.count = 5, .guess = guess, .minimum = 1.0, .maximum = 9.0};
        for (const double value : values) {
            const double d = value - guess;
            sums.first += d;
            sums.second += d * d;
            sums.third += d * d * d;
            sums.fourth += d * d * d * d;
        }
        const Moments moments = Moments::of(sums);
        CHECK(relative_difference(moments.mean, whole.mean) < 1e-14);
        CHECK(relative_difference(moments.second, whole.second) < 1e-13);
        CHECK(relative_difference(moments.third, whole.third) < 1e-12);
        CHECK(relative_difference(moments.fourth, whole.fourth) < 1e-12);
    }
}

TEST_CASE("moments agree with extended precision, also far from zero") {
    for (const double offset : {0.0, 1e6}) {
        const auto values = sample(10'000, offset);
        check_same(Moments::of(values), values);
    }
}

TEST_CASE("moments of parts make the moments of the whole") {
    const auto values = sample(5'000, 1e6);
    Moments merged;
    for (std::size_t first = 0; first < values.size();) {
        const std::size_t count = std::min(values.size() - first, first / 3 + 1);
        merged.merge(Moments::of(std::span(values).subspan(first, count)));
        merged.merge(Moments{});
        first += count;
    }
    check_same(merged, values);
    CHECK(merged.minimum == *std::min_element(values.begin(), values.end()));
    CHECK(merged.maximum == *std::max_element(values.begin(), values.end()));
    CHECK(merged.mean == doctest::Approx(Moments::of(values).mean).epsilon(1e-15));
}

TEST_CASE("an exponential distribution has variance 1, skewness 2, excess kurtosis 6") {
    const Moments moments = Moments::of(sample(400'000, 0));
    CHECK(moments.mean == doctest::Approx(1).epsilon(0.01));
    CHECK(moments.variance() == doctest::Approx(1).epsilon(0.02));
    CHECK(moments.skewness() == doctest::Approx(2).epsilon(0.03));
    CHECK(moments.excess_kurtosis() == doctest::Approx(6).epsilon(0.1));
}

TEST_CASE("chunks merge in the order of a binary tree") {
    CHECK(order_of(1) == "a");
    CHECK(order_of(4) == "((ab)(cd))");
    CHECK(order_of(7) == "(((ab)(cd))((ef)g))");
}

TEST_CASE("parts of the tree merged elsewhere make the same tree") {
    for (const std::vector<unsigned>& levels :
         {std::vector<unsigned>{1, 1, 2}, {2, 0, 0, 1}, {3}, {1, 0, 0, 2}}) {
        PairwiseMerge<Order> merge;
        char next = 'a';
        for (const unsigned level : levels) {
            PairwiseMerge<Order> part;
            for (unsigned i = 0; i < 1U << level; ++i) part.add({std::string(1, next++)});
            CHECK(part.nodes() == 1);
            merge.add(part.total(), level);
        }
        CHECK(merge.total().text == order_of(8));
    }
}

TEST_CASE("moments by group are those of the values picked one by one, but for numbers that are none") {
    std::vector<double> values = sample(2'003, 1e6);
    for (std::size_t i = 0; i < values.size(); i += 7) values[i] = std::nan("");
    for (std::size_t i = 0; i < values.size(); i += 5) values[i] = 0;
    for (const std::uint32_t groups : {1U, 3U, 16U, 18U}) {
        constexpr std::uint64_t first = 8'192 + 5;
        const std::vector<Moments> found = moments_by_group(values, groups, first);
        const std::vector<Moments> zeros = moments_of_zeros_by_group(values, groups, first);
        REQUIRE(found.size() == groups);
        REQUIRE(zeros.size() == groups);
        for (std::uint32_t group = 0; group < groups; ++group) {
            CAPTURE(groups);
            CAPTURE(group);
            std::vector<double> picked;
            std::vector<double> ones;
            for (std::size_t i = 0; i < values.size(); ++i) {
                if ((first + i) % groups != group || std::isnan(values[i])) continue;
                picked.push_back(values[i]);
                ones.push_back(values[i] == 0 ? 1 : 0);
            }
            check_same(found[group], picked);
            CHECK(found[group].mean == doctest::Approx(Moments::of(picked).mean).epsilon(1e-14));
            CHECK(found[group].minimum == Moments::of(picked).minimum);
            CHECK(found[group].maximum == Moments::of(picked).maximum);
            check_same(zeros[group], ones);
            CHECK(zeros[group].mean == doctest::Approx(Moments::of(ones).mean).epsilon(1e-14));
            CHECK(zeros[group].minimum == 0);
            CHECK(zeros[group].maximum == 1);
        }
    }
}

TEST_CASE("groups without values have no moments") {
    const std::vector<double> values{0.5, std::nan(""), 0.0};
    for (const auto& moments : {moments_by_group(values, 4, 1), moments_of_zeros_by_group(values, 4, 1)}) {
        CHECK(moments[1].count == 1);
        CHECK(moments[2].count == 0);
        CHECK(moments[3].count == 1);
        CHECK(moments[0].count == 0);
    }
}

// tests/pipeline/sweep/result_test.cpp has the indices of the Ishigami function.

TEST_CASE("a function that does not vary has no indices; one group gives no errors") {
    const std::vector<double> same(10, 3.0);
    const std::array constant{SobolSums::of({same, same, {same}})};
    CHECK(sobol_indices(constant).empty());

    const std::vector<double> a{1, 2, 3, 5};
    const std::vector<double> b{2, 7, 1, 8};
    const std::array one{SobolSums::of({a, b, {b}})};
    const auto indices = sobol_indices(one);
    REQUIRE(indices.size() == 1);
    CHECK_FALSE(indices[0].first_error.has_value());
}
