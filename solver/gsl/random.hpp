#pragma once

#include <memory>

namespace ashimpact::gsl {

/// Pseudo-random numbers of a fixed seed (GSL mt19937): the same on every machine.
class Random {
  public:
    explicit Random(unsigned long seed);
    ~Random();
    Random(Random&&) noexcept;
    Random& operator=(Random&&) noexcept;

    /// A number in [lower, upper).
    [[nodiscard]] double uniform(double lower, double upper);
    /// A normal number of mean zero.
    [[nodiscard]] double normal(double deviation);

  private:
    struct Generator;
    std::unique_ptr<Generator> generator_;
};

}  // namespace ashimpact::gsl
