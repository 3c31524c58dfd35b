// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace ashimpact {

/// Bins for values that are not negative, of constant width (absolute) or of constant relative width 2^-k
/// (relative). A relative bin is the exponent and the first k binary digits of a number; such bins cover
/// every positive number. Zero falls into no bin and is counted separately.
class Bins {
  public:
    /// [0, 1] in @p count equal bins.
    [[nodiscard]] static Bins absolute(std::uint32_t count) { return {count, 0}; }
    /// Bins of relative width 2^-@p digits, at most 20 digits.
    [[nodiscard]] static Bins relative(unsigned digits) { return {0, digits}; }

    [[nodiscard]] bool is_relative() const { return count_ == 0; }
    /// Number of absolute bins; 0 if they are relative.
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Width of a bin, absolute or relative to its lower edge [1].
    [[nodiscard]] double resolution() const;
    /// The bin of a positive value.
    [[nodiscard]] std::uint32_t bin_of(double value) const;
    /// Lower edge of a bin, the upper one of the bin before.
    [[nodiscard]] double edge(std::uint32_t bin) const;

  private:
    Bins(std::uint32_t count, unsigned digits) : count_(count), digits_(digits) {}

    std::uint32_t count_;
    unsigned digits_;
};

/// What a histogram has to know of values before it counts them.
struct PositiveRange {
    std::uint64_t zeros;
    std::uint64_t positive;
    double least;     ///< of the positive values; infinite if there are none
    double greatest;  ///< of all values, at least 0
};
[[nodiscard]] PositiveRange positive_range(std::span<const double> values);

/// Numbers of bins, several in each instruction, as bin_of() gives them; values that are not positive get the
/// bin of @p otherwise.
void find_bins(const Bins& bins, std::span<const double> values, double otherwise, std::uint32_t* numbers);

/// An interval in which a quantile of the counted values lies.
struct QuantileBounds {
    double lower;
    double upper;
};

/// Counts of values by bin. They are integers, so no order of counting or merging changes them.
class Histogram {
  public:
    /// Counts values; those that are not a number are left out.
    void count(const Bins& bins, std::span<const double> values);
    /// Counts numbers that are 0 or 1 in a single bin.
    void add_ones(std::uint64_t ones, std::uint64_t zeros);
    void merge(const Histogram& other);

    [[nodiscard]] std::uint64_t zeros() const { return zeros_; }
    /// The bins from the first to the last that holds a value; the first one's number is first().
    [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }
    [[nodiscard]] std::uint32_t first() const { return first_; }
    [[nodiscard]] std::uint64_t total() const {
        return std::accumulate(counts_.begin(), counts_.end(), zeros_);
    }

    /// Bounds of the quantile at @p probability: the least value such that at least this part of all values
    /// is not above it. Needs a value.
    [[nodiscard]] QuantileBounds quantile(const Bins& bins, double probability) const;

    template <class Archive>
    void transfer(Archive& archive) {
        archive(zeros_, first_, counts_);
    }

  private:
    void cover(std::uint32_t lowest, std::uint32_t highest);

    std::uint64_t zeros_ = 0;
    std::uint32_t first_ = 0;
    std::vector<std::uint64_t> counts_;
};

}  // namespace ashimpact
