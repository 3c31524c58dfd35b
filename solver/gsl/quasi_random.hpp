#pragma once

#include <memory>
#include <span>
#include <string_view>

namespace ashimpact::gsl {

/// A quasi-random sequence in the unit cube (GSL qrng): Sobol up to 40 dimensions, reverse Halton beyond.
class QuasiRandom {
  public:
    static constexpr int most_dimensions = 1229;

    /// @throws ConvergenceError for more than most_dimensions
    explicit QuasiRandom(int dimensions);
    ~QuasiRandom();
    QuasiRandom(QuasiRandom&&) noexcept;
    QuasiRandom& operator=(QuasiRandom&&) noexcept;

    /// The next point into @p point, one number a dimension, in (0, 1).
    void next(std::span<double> point);
    [[nodiscard]] std::string_view name() const;

  private:
    struct Sequence;
    std::unique_ptr<Sequence> sequence_;
};

}  // namespace ashimpact::gsl
