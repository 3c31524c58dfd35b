// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <type_traits>

namespace ashimpact::gsl {

/// A function that GSL calls through its C interface, through which no exception may pass. The first
/// exception is kept, later calls return a substitute without calling the function, and rethrow() throws the
/// exception again outside of GSL.
template <class Function>
struct Guarded {
    const Function& function;
    std::exception_ptr error{};

    /// Returns call(); @p substitute if this call or an earlier one threw.
    template <class Call>
    auto value_of(Call&& call, std::invoke_result_t<Call&> substitute) -> std::invoke_result_t<Call&> {
        if (error) return substitute;
        try {
            return call();
        } catch (...) {
            error = std::current_exception();
            return substitute;
        }
    }
    /// @throws what the function has thrown, if anything
    void rethrow() const {
        if (error) std::rethrow_exception(error);
    }
};

}  // namespace ashimpact::gsl
