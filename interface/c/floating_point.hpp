// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <optional>

#if defined(__x86_64__) && defined(__GNUC__)
#define ASHIMPACT_SSE_AND_X87 1
#include <xmmintrin.h>
#else
#define ASHIMPACT_SSE_AND_X87 0
#endif

namespace ashimpact {

/// Floating point as the solver expects it, for the life of this object: nothing traps, results are rounded
/// to nearest and denormal numbers are kept. The caller's environment comes back with it, flags included:
/// codes such as OpenFOAM trap, others flush denormal numbers to zero.
class CompleteFloatingPoint {
  public:
    CompleteFloatingPoint() {
        std::feholdexcept(&callers_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~CompleteFloatingPoint() { std::fesetenv(&callers_); }
    CompleteFloatingPoint(const CompleteFloatingPoint&) = delete;
    CompleteFloatingPoint& operator=(const CompleteFloatingPoint&) = delete;
    CompleteFloatingPoint(CompleteFloatingPoint&&) = delete;
    CompleteFloatingPoint& operator=(CompleteFloatingPoint&&) = delete;

  private:
    std::fenv_t callers_{};
};

#if ASHIMPACT_SSE_AND_X87

/// The same on x86-64. Saving and loading the whole environment takes as long as an impact from a table does,
/// for the sake of the x87 unit's flags. They are clear in most callers, and are then cleared again instead.
class OwnFloatingPoint {
  public:
    OwnFloatingPoint() {
        if ((x87_status() & x87_flags) != 0) {
            complete_.emplace();
            return;
        }
        sse_ = _mm_getcsr();
        _mm_setcsr(default_sse);
        x87_ = x87_control();
        if (x87_ != default_x87) set_x87_control(default_x87);
    }
    ~OwnFloatingPoint() {
        if (complete_) return;
        if ((x87_status() & x87_flags) != 0) __asm__ volatile("fnclex");
        if (x87_ != default_x87) set_x87_control(x87_);
        _mm_setcsr(sse_);
    }
    OwnFloatingPoint(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint& operator=(const OwnFloatingPoint&) = delete;
    OwnFloatingPoint(OwnFloatingPoint&&) = delete;
    OwnFloatingPoint& operator=(OwnFloatingPoint&&) = delete;

  private:
    static constexpr unsigned short default_x87 = 0x037F;  ///< as FE_DFL_ENV has it
    static constexpr unsigned int default_sse = 0x1F80;
    static constexpr unsigned short x87_flags = 0x7F;  ///< of exceptions, and of a stack fault

    static unsigned short x87_control() {
        unsigned short control = 0;
        __asm__ volatile("fnstcw %0" : "=m"(control));
        return control;
    }
    static void set_x87_control(unsigned short control) { __asm__ volatile("fldcw %0" : : "m"(control)); }
    static unsigned short x87_status() {
        unsigned short status = 0;
        __asm__ volatile("fnstsw %0" : "=am"(status));
        return status;
    }

    unsigned int sse_ = 0;
    unsigned short x87_ = default_x87;
    std::optional<CompleteFloatingPoint> complete_{};
};

#else
using OwnFloatingPoint = CompleteFloatingPoint;
#endif

}  // namespace ashimpact
