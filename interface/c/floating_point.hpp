#pragma once

#include <cfenv>

namespace ashimpact {

/// Floating point as the solver expects it, for the life of this object: nothing traps, results are rounded
/// to nearest and denormal numbers are kept. The caller's environment comes back with it, flags included:
/// codes such as OpenFOAM trap, others flush denormal numbers to zero.
class OwnFloatingPoint {
  public:
    OwnFloatingPoint() {
        std::feholdexcept(&callers_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~OwnFloatingPoint() { std::fesetenv(&callers_); }
    OwnFloatingPoint(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint& operator=(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint(OwnFloatingPoint&&) = delete;
    OwnFloatingPoint& operator=(OwnFloatingPoint&&) = delete;

  private:
    std::fenv_t callers_{};
};

}  // namespace ashimpact
