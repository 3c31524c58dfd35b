// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

namespace ashimpact {

/// eta(e_n) = c0 + c1 e_n + c2 e_n^2 + ...; the paper's a, b, c are c2, c1, c0 (Dong et al. 2013, Table 2).
struct DampingPolynomial {
    Eigen::VectorXd coefficients;  ///< ascending powers [unit of the damping law]

    /// a e^2 + b e + c.
    [[nodiscard]] static DampingPolynomial quadratic(double a, double b, double c) {
        return {Eigen::Vector3d(c, b, a)};
    }
    bool operator==(const DampingPolynomial& other) const {
        return coefficients.size() == other.coefficients.size() && coefficients == other.coefficients;
    }

    [[nodiscard]] int order() const { return static_cast<int>(coefficients.size()) - 1; }
    /// eta [unit of the damping law].
    [[nodiscard]] double operator()(double restitution) const {
        double sum = 0.0;
        for (Eigen::Index i = coefficients.size() - 1; i >= 0; --i) sum = sum * restitution + coefficients[i];
        return sum;
    }
    /// d eta/de [unit of the damping law].
    [[nodiscard]] double slope(double restitution) const {
        double sum = 0.0;
        for (Eigen::Index i = coefficients.size() - 1; i >= 1; --i)
            sum = sum * restitution + static_cast<double>(i) * coefficients[i];
        return sum;
    }
    /// eta_c = eta(0), the critical damping of Table 3 [unit of the damping law].
    [[nodiscard]] double critical_damping() const { return coefficients[0]; }

    /// 1, e, e^2, ...: derivatives of eta by the coefficients [1].
    [[nodiscard]] static Eigen::VectorXd powers(double restitution, int order) {
        Eigen::VectorXd result(order + 1);
        double power = 1.0;
        for (int i = 0; i <= order; ++i, power *= restitution) result[i] = power;
        return result;
    }
};

}  // namespace ashimpact
