// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <type_traits>

#include <Eigen/Core>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include "core/text/error.hpp"

namespace ashimpact::gsl {

/// Switches GSL's aborting error handler off; every wrapper here calls it and checks the status instead.
inline void quiet() {
    static const auto previous = gsl_set_error_handler_off();
    static_cast<void>(previous);
}

/// @throws ConvergenceError "<what>: <why>" unless @p status is GSL_SUCCESS
inline void check(int status, const char* what) {
    if (status == GSL_SUCCESS) return;
    // GSL's own messages for these are for programmers: "problem with user-supplied function".
    const bool undefined = status == GSL_EBADFUNC || status == GSL_EFAILED || status == GSL_ENOPROG;
    throw ConvergenceError(std::string(what) + ": " +
                           (undefined
                                ? "the function has no finite value there, or the search gets no further"
                                : gsl_strerror(status)));
}

/// An object of GSL's with the function that frees it.
template <class T>
using Owner = std::unique_ptr<T, void (*)(T*)>;

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

/// A matrix in the order of GSL's, row by row.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

[[nodiscard]] inline Eigen::Index index_of(std::size_t size) {
    return static_cast<Eigen::Index>(size);
}

/// The entries of a GSL vector, read and written in place.
[[nodiscard]] inline auto view_of(gsl_vector* vector) {
    using Stride = Eigen::InnerStride<>;
    return Eigen::Map<Eigen::VectorXd, 0, Stride>(vector->data, index_of(vector->size),
                                                  Stride(index_of(vector->stride)));
}
[[nodiscard]] inline auto view_of(const gsl_vector* vector) {
    using Stride = Eigen::InnerStride<>;
    return Eigen::Map<const Eigen::VectorXd, 0, Stride>(vector->data, index_of(vector->size),
                                                        Stride(index_of(vector->stride)));
}

/// The entries of a GSL matrix, read and written in place.
[[nodiscard]] inline auto view_of(gsl_matrix* matrix) {
    using Stride = Eigen::OuterStride<>;
    return Eigen::Map<RowMajor, 0, Stride>(matrix->data, index_of(matrix->size1), index_of(matrix->size2),
                                           Stride(index_of(matrix->tda)));
}
[[nodiscard]] inline auto view_of(const gsl_matrix* matrix) {
    using Stride = Eigen::OuterStride<>;
    return Eigen::Map<const RowMajor, 0, Stride>(matrix->data, index_of(matrix->size1),
                                                 index_of(matrix->size2), Stride(index_of(matrix->tda)));
}

}  // namespace ashimpact::gsl
