// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace ashimpact {

/// Sums of powers of the deviations of some values from a guess of their mean.
struct DeviationSums {
    double count = 0;
    double guess = 0;
    double first = 0;
    double second = 0;
    double third = 0;
    double fourth = 0;
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -std::numeric_limits<double>::infinity();
};

/// Count, extremes and central moments of some values. Moments of parts give the moments of the whole,
/// without the cancellation that power sums suffer: Pebay 2008, SAND2008-6212; Chan, Golub & LeVeque 1983 for
/// the variance.
struct Moments {
    std::uint64_t count = 0;
    double mean = 0;
    double second = 0;  ///< sum of the squared deviations from the mean
    double third = 0;   ///< sum of their cubes
    double fourth = 0;  ///< sum of their fourth powers
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -std::numeric_limits<double>::infinity();

    /// Moments of values, in two passes with pairwise sums.
    [[nodiscard]] static Moments of(std::span<const double> values);
    /// Moments from sums about a guess of the mean, which is near it.
    [[nodiscard]] static Moments of(const DeviationSums& sums);

    /// Makes these the moments of these values and those of @p other.
    void merge(const Moments& other);

    /// Unbiased variance; needs two values.
    [[nodiscard]] double variance() const { return second / static_cast<double>(count - 1); }
    /// Skewness m3/m2^(3/2) and excess kurtosis m4/m2^2 - 3 [1]; need a variance that is not zero.
    [[nodiscard]] double skewness() const {
        return std::sqrt(static_cast<double>(count)) * third / (second * std::sqrt(second));
    }
    [[nodiscard]] double excess_kurtosis() const {
        return static_cast<double>(count) * fourth / (second * second) - 3;
    }

    template <class Archive>
    void transfer(Archive& archive) {
        archive(count, mean, second, third, fourth, minimum, maximum);
    }
};

/// Sum of function(0), ..., function(count - 1) by halves: rounding grows with the logarithm of their number.
template <class Function>
[[nodiscard]] double pairwise_sum(std::size_t first, std::size_t count, const Function& function) {
    if (count > 128)
        return pairwise_sum(first, count / 2, function) +
               pairwise_sum(first + count / 2, count - count / 2, function);
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += function(i);
    return sum;
}

/// Moments of each group of values, several groups in each instruction. Value i belongs to group
/// (first + i) % groups; values that are not a number are left out.
[[nodiscard]] std::vector<Moments> moments_by_group(std::span<const double> values, std::uint32_t groups,
                                                    std::uint64_t first);

/// Moments by group of a number that is 1 where a value is zero and 0 where it is not.
[[nodiscard]] std::vector<Moments> moments_of_zeros_by_group(std::span<const double> values,
                                                             std::uint32_t groups, std::uint64_t first);

/// Merges the sums of chunks in the order of a fixed binary tree, keeping at most one node of each level.
///
/// Floating-point sums depend on their order. Here the order depends on the number of chunks alone: chunks 2i
/// and 2i + 1 merge, then pairs of such pairs, and so on, whoever computed them. A part of 2^level chunks
/// that begins at a multiple of 2^level is a node of that tree and may be merged elsewhere first.
/// @tparam Sums has merge(const Sums&) and transfer(archive)
template <class Sums>
class PairwiseMerge {
  public:
    /// Adds the next node: 2^@p level chunks, next after those added before.
    void add(Sums sums, unsigned level = 0) {
        nodes_.push_back({level, std::move(sums)});
        while (nodes_.size() > 1 && nodes_[nodes_.size() - 2].level == nodes_.back().level) {
            const Node right = std::move(nodes_.back());
            nodes_.pop_back();
            nodes_.back().sums.merge(right.sums);
            ++nodes_.back().level;
        }
    }

    /// Everything added so far, merged; needs one node.
    [[nodiscard]] Sums total() const {
        Sums total = nodes_.back().sums;
        for (std::size_t i = nodes_.size() - 1; i-- > 0;) {
            Sums left = nodes_[i].sums;
            left.merge(total);
            total = std::move(left);
        }
        return total;
    }

    [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }

    template <class Archive>
    void transfer(Archive& archive) {
        archive(nodes_);
    }

  private:
    struct Node {
        unsigned level = 0;
        Sums sums;

        template <class Archive>
        void transfer(Archive& archive) {
            archive(level, sums);
        }
    };
    std::vector<Node> nodes_;
};

}  // namespace ashimpact
