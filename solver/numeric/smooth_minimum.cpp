#include "solver/numeric/smooth_minimum.hpp"

#include "materials/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

/// The function about a place as a parabola, in the directions of its curvatures.
class Parabola {
  public:
    Parabola(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& gradient)
        : eigen_(curvature), slopes_(eigen_.eigenvectors().transpose() * gradient) {}

    struct Step {
        Eigen::VectorXd shift;
        double decrease;  ///< of the parabola, positive
    };
    /// To where the parabola is least within a radius.
    [[nodiscard]] Step within(double radius) const {
        const Eigen::VectorXd& bends = eigen_.eigenvalues();
        const double flattest = bends.minCoeff();
        double more = flattest > 0.0 ? 0.0 : least_bend() - flattest;
        if (along(more).norm() > radius) {
            double less = more;
            for (more = std::max(more, least_bend()); along(more).norm() > radius; more *= 2.0) less = more;
            for (int i = 0; i < bisections; ++i) {
                const double middle = 0.5 * (less + more);
                (along(middle).norm() > radius ? less : more) = middle;
            }
        }
        const Eigen::VectorXd step = along(more);
        const double change = slopes_.dot(step) + 0.5 * step.dot(bends.cwiseProduct(step));
        return {eigen_.eigenvectors() * step, -change};
    }

  private:
    static constexpr int bisections = 30;

    [[nodiscard]] double least_bend() const {
        return 1e-8 * std::max(1.0, eigen_.eigenvalues().cwiseAbs().maxCoeff());
    }
    /// The step with all curvatures raised.
    [[nodiscard]] Eigen::VectorXd along(double raise) const {
        return -slopes_.cwiseQuotient((eigen_.eigenvalues().array() + raise).matrix());
    }

    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_;
    Eigen::VectorXd slopes_;
};

/// Symmetric rank-one update: the curvature along a step is what the gradients at its ends say.
void learn(Eigen::MatrixXd& curvature, const Eigen::VectorXd& step, const Eigen::VectorXd& gradient_change) {
    const Eigen::VectorXd miss = gradient_change - curvature * step;
    const double along = miss.dot(step);
    if (std::abs(along) > 1e-8 * miss.norm() * step.norm()) curvature += miss * miss.transpose() / along;
}

}  // namespace

SmoothMinimum minimise(const SmoothFunction& function, const Eigen::VectorXd& start,
                       const SmoothMinimumOptions& options) {
    constexpr double least_radius = 1e-9;
    constexpr int most_stalls = 3;  // steps taken back of which nothing much was expected
    SmoothFunction::Value here = function.evaluate(start);
    if (!std::isfinite(here.value) || !here.gradient.allFinite())
        throw ConvergenceError("minimisation: the function is not defined at the start");
    SmoothMinimum result{start, here.value, Eigen::MatrixXd::Identity(start.size(), start.size()), 1, false};
    double radius = options.first_step;
    int stalls = 0;
    while (true) {
        const auto [shift, decrease] = Parabola(result.curvature, here.gradient).within(radius);
        const bool unbound = shift.norm() < 0.99 * radius;
        result.converged = decrease <= options.tolerance && (unbound || radius >= options.first_step);
        if (result.converged || result.evaluations >= options.most_evaluations) return result;
        if (radius < least_radius || stalls >= most_stalls) break;
        SmoothFunction::Value there = function.evaluate(result.place + shift);
        ++result.evaluations;
        const double length = shift.norm();
        if (!std::isfinite(there.value) || !there.gradient.allFinite()) {
            radius = 0.25 * length;
            continue;
        }
        learn(result.curvature, shift, there.gradient - here.gradient);
        const double share = (here.value - there.value) / decrease;
        if (share < 0.25) radius = 0.25 * length;
        if (share > 0.75 && !unbound) radius *= 3.0;
        if (share < 1e-4) {
            if (decrease <= options.acceptable) ++stalls;
            continue;
        }
        result.place += shift;
        result.value = there.value;
        here = std::move(there);
    }
    result.converged =
        Parabola(result.curvature, here.gradient).within(options.first_step).decrease <= options.acceptable;
    return result;
}

}  // namespace ashimpact
