#include "solver/uncertainty/curve/curve_estimate.hpp"

#include "materials/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ashimpact {

namespace {

using Vector = CurvePosterior::Vector;
using Matrix = CurvePosterior::Matrix;

/// Standard deviations of the bend of g, and ln of their prior weights: smooth curves are likelier.
constexpr std::array roughnesses{0.012, 0.06, 0.3};
constexpr std::array log_weights{0.0, -0.5, -1.5};

/// Newton's method with all parameters free, or all but v_c; the Hessian is made positive by its eigenvalues.
struct Descent {
    const CurvePosterior& posterior;
    bool hold;

    [[nodiscard]] Matrix masked(Matrix hessian) const {
        for (int i = 0; i < CurvePosterior::size; ++i) {
            if (posterior.free(i) && !(hold && i == CurvePosterior::critical)) continue;
            hessian.row(i).setZero();
            hessian.col(i).setZero();
            hessian(i, i) = 1.0;
        }
        return hessian;
    }

    [[nodiscard]] Vector masked(Vector gradient) const {
        for (int i = 0; i < CurvePosterior::size; ++i)
            if (!posterior.free(i) || (hold && i == CurvePosterior::critical)) gradient[i] = 0.0;
        return gradient;
    }

    /// The Hessian with every eigenvalue raised to what the priors say at least.
    struct Inverse {
        Matrix inverse;
        double log_determinant;
    };
    [[nodiscard]] Inverse inverted(const Matrix& hessian) const {
        const Eigen::SelfAdjointEigenSolver<Matrix> solver(masked(hessian));
        const Vector values = solver.eigenvalues().cwiseAbs().cwiseMax(0.05);
        return {solver.eigenvectors() * values.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose(),
                values.array().log().sum()};
    }

    /// One step, shortened until it descends; whether it did.
    bool step(Vector& place, double& value, const Vector& direction) const {
        double length = 1.0;
        for (int i = 0; i < 10; ++i, length *= 0.35) {
            const Vector trial = place + length * direction;
            const double there = posterior(trial);
            if (there >= value) continue;
            place = trial;
            value = there;
            return true;
        }
        return false;
    }
};

struct Mode {
    Vector place;
    double value;  ///< -ln posterior
    double log_determinant;
    Matrix inverse;
    Matrix hessian{};
};

Vector limited(Vector direction) {
    const double most = direction.cwiseAbs().maxCoeff();
    return most > 0.7 ? Vector(direction * (0.7 / most)) : direction;
}

Mode find_mode(const CurvePosterior& posterior, const Vector& start) {
    const Descent descent{posterior, false};
    Mode mode{start, posterior(start), 0.0, Matrix::Identity()};
    constexpr int steps_a_hessian = 3;
    for (int i = 0; i < 20; ++i) {
        const auto curvature = posterior.curvature(mode.place);
        const auto inverse = descent.inverted(curvature.hessian);
        mode.hessian = curvature.hessian;
        mode.inverse = inverse.inverse;
        mode.log_determinant = inverse.log_determinant;
        Vector gradient = descent.masked(curvature.gradient);
        for (int k = 0; k < steps_a_hessian; ++k) {
            if (k > 0) gradient = descent.masked(posterior.gradient(mode.place));
            const Vector direction = -(inverse.inverse * gradient);
            const double promise = -gradient.dot(direction);
            if (promise < (k == 0 ? 1e-2 : 1e-3)) {
                if (k < 2) return mode;
                break;
            }
            if (!descent.step(mode.place, mode.value, limited(direction))) {
                if (k == 0) return mode;
                break;
            }
        }
    }
    return mode;
}

/// ln of the marginal density of ln v_c, at places that grow outward from the mode.
struct Marginal {
    std::vector<double> place;
    std::vector<double> value;
};

/// The best of all other parameters at one v_c.
struct Conditional {
    Vector place;
    double value;
};

Conditional conditional(const CurvePosterior& posterior, const Descent& descent, const Matrix& inverse,
                        const Vector& start) {
    Conditional best{start, posterior(start)};
    for (int i = 0; i < 6; ++i) {
        const Vector gradient = descent.masked(posterior.gradient(best.place));
        const Vector direction = -(inverse * gradient);
        if (-gradient.dot(direction) < 3e-2) break;
        if (!descent.step(best.place, best.value, limited(direction))) break;
    }
    return best;
}

Marginal marginal_of(const CurvePosterior& posterior, const Mode& mode, double lower, double upper) {
    constexpr double drop = 5.5;
    const int a = CurvePosterior::critical;
    const Descent descent{posterior, true};
    const double deviation = std::clamp(std::sqrt(mode.inverse(a, a)), 1e-6, 0.5);
    const Vector along = mode.inverse.col(a) / mode.inverse(a, a);
    const auto center = descent.inverted(mode.hessian);
    struct Point {
        double place;
        double value;
    };
    std::vector<Point> points{{mode.place[a], -mode.value - 0.5 * center.log_determinant}};
    const double top = points.front().value;
    double best = top;
    for (const double sign : {-1.0, 1.0}) {
        Conditional here{mode.place, mode.value};
        Matrix inverse = center.inverse;
        double log_determinant = center.log_determinant;
        double growth = 0.0;  // of the logarithm of the determinant, a unit of ln v_c
        double measured_at = mode.place[a];
        double step = 0.8 * deviation;
        double before = top;
        for (int i = 1; i <= 16; ++i) {
            Vector next = here.place + sign * step * along;
            next[a] = here.place[a] + sign * step;
            if (next[a] < lower || next[a] > upper) break;
            here = conditional(posterior, descent, inverse, next);
            if (i % 3 == 2) {
                const auto there = descent.inverted(posterior.curvature(here.place).hessian);
                growth = (there.log_determinant - log_determinant) / (here.place[a] - measured_at);
                for (Point& point : points)
                    if ((point.place - measured_at) * sign > 1e-12 && i == 2)
                        point.value -= 0.5 * growth * (point.place - measured_at);
                inverse = there.inverse;
                log_determinant = there.log_determinant;
                measured_at = here.place[a];
            }
            const double determinant = log_determinant + growth * (here.place[a] - measured_at);
            const double value = -here.value - 0.5 * determinant;
            points.push_back({here.place[a], value});
            best = std::max(best, value);
            if (value < best - drop) break;
            if (before - value < 0.3) step *= 1.5;
            before = value;
        }
    }
    std::sort(points.begin(), points.end(), [](const Point& x, const Point& y) { return x.place < y.place; });
    Marginal result;
    for (const Point& point : points) {
        result.place.push_back(point.place);
        result.value.push_back(point.value);
    }
    return result;
}

/// ln density between the places by cubic Hermite interpolation; beyond them it falls as fast as before.
double interpolated(const Marginal& marginal, double x) {
    const auto& p = marginal.place;
    const auto& v = marginal.value;
    const std::size_t n = p.size();
    if (n == 1) return x == p[0] ? v[0] : -1e300;
    if (x < p.front() || x > p.back()) return -1e300;
    const auto above = static_cast<std::size_t>(std::upper_bound(p.begin(), p.end() - 1, x) - p.begin());
    const std::size_t j = std::max<std::size_t>(above, 1);
    const std::size_t i = j - 1;
    const auto slope = [&](std::size_t k) {
        if (k == 0) return (v[1] - v[0]) / (p[1] - p[0]);
        if (k == n - 1) return (v[n - 1] - v[n - 2]) / (p[n - 1] - p[n - 2]);
        const double left = (v[k] - v[k - 1]) / (p[k] - p[k - 1]);
        const double right = (v[k + 1] - v[k]) / (p[k + 1] - p[k]);
        return (left * (p[k + 1] - p[k]) + right * (p[k] - p[k - 1])) / (p[k + 1] - p[k - 1]);
    };
    const double h = p[j] - p[i];
    const double t = (x - p[i]) / h;
    return v[i] * (1 + 2 * t) * (1 - t) * (1 - t) + v[j] * t * t * (3 - 2 * t) +
           h * (slope(i) * t * (1 - t) * (1 - t) - slope(j) * t * t * (1 - t));
}

std::array<double, 4> summary_of(const std::vector<Marginal>& marginals) {
    double lower = 1e300;
    double upper = -1e300;
    double best = -1e300;
    for (const Marginal& m : marginals) {
        lower = std::min(lower, m.place.front());
        upper = std::max(upper, m.place.back());
        best = std::max(best, *std::max_element(m.value.begin(), m.value.end()));
    }
    constexpr int cells = 2000;
    const double step = (upper - lower) / cells;
    std::vector<double> cumulative(cells + 1, 0.0);
    double mean = 0.0;
    double square = 0.0;
    for (int i = 0; i < cells; ++i) {
        const double x = lower + (i + 0.5) * step;
        double density = 0.0;
        for (const Marginal& m : marginals) density += std::exp(interpolated(m, x) - best);
        cumulative[static_cast<std::size_t>(i) + 1] = cumulative[static_cast<std::size_t>(i)] + density;
        mean += density * x;
        square += density * x * x;
    }
    const double total = cumulative.back();
    const auto quantile = [&](double probability) {
        const auto found = std::lower_bound(cumulative.begin() + 1, cumulative.end(), probability * total);
        const auto i = static_cast<double>(found - cumulative.begin());
        const double part = (probability * total - *(found - 1)) / std::max(1e-300, *found - *(found - 1));
        return lower + (i - 1.0 + part) * step;
    };
    const double tail = 0.5 * (1.0 - confidence);
    mean /= total;
    return {quantile(0.5), quantile(tail), quantile(1.0 - tail),
            std::sqrt(std::max(0.0, square / total - mean * mean))};
}

}  // namespace

CurveEstimate estimate_curve(const RestitutionTable& table, const std::vector<RecordedImpact>& impacts,
                             const CurvePrior& prior, const std::vector<double>& starts) {
    struct Found {
        double roughness;
        Mode mode;
    };
    std::vector<Found> found;
    for (const double roughness : roughnesses) {
        const CurvePosterior posterior(table, impacts, prior, roughness);
        std::vector<Vector> places;
        if (found.empty()) {
            for (const double v : starts) places.push_back(posterior.start(std::log(v)));
            std::sort(places.begin(), places.end(),
                      [&](const Vector& a, const Vector& b) { return posterior(a) < posterior(b); });
            places.resize(std::min<std::size_t>(places.size(), 2));
        } else {
            places.push_back(found.back().mode.place);
        }
        Mode best{{}, std::numeric_limits<double>::infinity(), 0.0, {}};
        for (const Vector& place : places) {
            const Mode mode = find_mode(posterior, place);
            if (mode.value < best.value) best = mode;
        }
        found.push_back({roughness, best});
    }
    const auto weight = [&](const Found& f) {
        const auto at = std::find(roughnesses.begin(), roughnesses.end(), f.roughness);
        return log_weights[static_cast<std::size_t>(at - roughnesses.begin())];
    };
    const auto evidence = [&](const Found& f) { return weight(f) - f.mode.value - 0.5 * f.mode.log_determinant; };
    const auto likeliest = *std::max_element(found.begin(), found.end(), [&](const Found& a, const Found& b) {
        return evidence(a) < evidence(b);
    });
    if (!(likeliest.mode.value < 1e9)) throw ConvergenceError("no curve of damping explains the impacts");
    const double lower = table.lower() + 1e-6;
    const double upper = table.upper() - 1e-6;
    std::vector<Marginal> marginals;
    for (const Found& f : found) {
        if (evidence(f) < evidence(likeliest) - 3.5) continue;
        const CurvePosterior posterior(table, impacts, prior, f.roughness);
        marginals.push_back(marginal_of(posterior, f.mode, lower, upper));
        for (double& value : marginals.back().value) value += weight(f);
    }
    const auto [median, low, high, deviation] = summary_of(marginals);
    const auto damping = [&](double x) { return std::exp(table.log_capture_damping(x)); };
    const CurvePosterior posterior(table, impacts, prior, likeliest.roughness);
    double fastest = -1e300;
    for (const RecordedImpact& impact : impacts) fastest = std::max(fastest, std::log(impact.velocity));
    const double slope = (table.log_capture_damping(high) - table.log_capture_damping(low)) / std::max(1e-12, high - low);
    return {.critical_velocity = {std::exp(median), std::exp(median) * deviation, std::exp(low), std::exp(high)},
            .critical_damping = {damping(median), damping(median) * slope * deviation, damping(low), damping(high)},
            .parameters = likeliest.mode.place,
            .roughness = likeliest.roughness,
            .scatter = posterior.scatter_of(likeliest.mode.place),
            .fastest = fastest};
}

}  // namespace ashimpact
