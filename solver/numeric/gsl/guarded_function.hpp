// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>

#include <gsl/gsl_math.h>

namespace ashimpact::gsl {

/// A function of one number for GSL's C interface, through which no exception may pass. The first exception
/// is kept, later calls return a substitute without calling the function, and rethrow() throws the exception
/// again outside of GSL.
class GuardedFunction {
  public:
    /// @param function must outlive this object
    /// @param substitute value that GSL gets in place of an exception [unit of the function]
    GuardedFunction(const std::function<double(double)>& function, double substitute)
        : function_(function), substitute_(substitute) {}

    /// The function as GSL takes it; it refers to this object.
    [[nodiscard]] gsl_function for_gsl() { return {&call, this}; }
    [[nodiscard]] bool failed() const { return error_ != nullptr; }
    /// @throws what the function has thrown, if anything
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    static double call(double x, void* self) { return static_cast<GuardedFunction*>(self)->value(x); }
    double value(double x) {
        if (error_) return substitute_;
        try {
            return function_(x);
        } catch (...) {
            error_ = std::current_exception();
            return substitute_;
        }
    }

    const std::function<double(double)>& function_;
    double substitute_;
    std::exception_ptr error_{};
};

}  // namespace ashimpact::gsl
