// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

namespace ashimpact::gsl {

/// A matrix in the order of GSL's, row by row.
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The entries of a GSL vector, read and written in place.
[[nodiscard]] inline auto view_of(gsl_vector* vector) {
    using Stride = Eigen::InnerStride<>;
    return Eigen::Map<Eigen::VectorXd, 0, Stride>(vector->data, static_cast<Eigen::Index>(vector->size),
                                                  Stride(static_cast<Eigen::Index>(vector->stride)));
}
[[nodiscard]] inline auto view_of(const gsl_vector* vector) {
    using Stride = Eigen::InnerStride<>;
    return Eigen::Map<const Eigen::VectorXd, 0, Stride>(vector->data, static_cast<Eigen::Index>(vector->size),
                                                        Stride(static_cast<Eigen::Index>(vector->stride)));
}

/// The entries of a GSL matrix, read and written in place.
[[nodiscard]] inline auto view_of(gsl_matrix* matrix) {
    using Stride = Eigen::OuterStride<>;
    return Eigen::Map<RowMajor, 0, Stride>(matrix->data, static_cast<Eigen::Index>(matrix->size1),
                                           static_cast<Eigen::Index>(matrix->size2),
                                           Stride(static_cast<Eigen::Index>(matrix->tda)));
}
[[nodiscard]] inline auto view_of(const gsl_matrix* matrix) {
    using Stride = Eigen::OuterStride<>;
    return Eigen::Map<const RowMajor, 0, Stride>(matrix->data, static_cast<Eigen::Index>(matrix->size1),
                                                 static_cast<Eigen::Index>(matrix->size2),
                                                 Stride(static_cast<Eigen::Index>(matrix->tda)));
}

}  // namespace ashimpact::gsl
