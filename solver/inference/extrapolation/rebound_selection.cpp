// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/extrapolation/rebound_selection.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/numeric/gsl/fit.hpp"
#include "solver/numeric/least_median.hpp"

namespace ashimpact {

namespace {

constexpr double reach = 0.995;  ///< of the greatest restitution: the upper end of any curve
constexpr double beyond = 0.02;  ///< how far a curve extends above the greatest measured restitution

bool above_reach(const Measurement& point) {
    if (!point.noise) return point.rebound >= point.velocity;
    const double variance = point.noise->incident + point.noise->rebound - 2.0 * point.noise->covariance;
    return point.rebound - point.velocity > 3.0 * std::sqrt(variance);
}

/// The greatest median of five neighbours in velocity, which no outlier reaches alone.
double greatest_common_restitution(std::vector<Measurement> rebounds) {
    std::sort(rebounds.begin(), rebounds.end(),
              [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; });
    double greatest = 0.0;
    for (std::size_t i = 0; i < rebounds.size(); ++i) {
        const std::size_t first = std::min(i, rebounds.size() - std::min<std::size_t>(5, rebounds.size()));
        std::vector<double> around;
        for (std::size_t j = first; j < std::min(first + 5, rebounds.size()); ++j)
            around.push_back(rebounds[j].restitution());
        const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
        std::nth_element(around.begin(), middle, around.end());
        greatest = std::max(greatest, *middle);
    }
    return greatest;
}

}  // namespace

ReboundSelection select_rebounds(const ContactModel& model, const MeasurementSet& set, bool robust) {
    ReboundSelection selection{
        .data = {{}, {}, 0.0}, .indices = {}, .excluded = {}, .noise_known = set.has_noise()};
    double greatest = 0.0;
    double fastest = 0.0;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Measurement& point = set.points[i];
        if (point.captured()) continue;
        if (above_reach(point)) {
            selection.excluded.push_back({i, Exclusion::above_reach});
            continue;
        }
        selection.indices.push_back(i);
        selection.data.rebounds.push_back(point);
        if (!point.noise) selection.data.rebounds.back().noise = VelocityNoise{1.0, 1.0};
        greatest = std::max(greatest, point.restitution());
        fastest = std::max(fastest, point.velocity);
    }
    selection.data.weights.assign(selection.indices.size(), 1.0);
    if (robust) greatest = greatest_common_restitution(selection.data.rebounds);
    if (!selection.indices.empty()) {
        selection.data.greatest_restitution =
            std::min(greatest + beyond, reach * model.greatest_restitution(fastest));
    }
    return selection;
}

void require_enough(const ReboundSelection& selection, const MeasurementSet& set, int order) {
    std::set<double> distinct;
    const auto needed = static_cast<std::size_t>(order) + (selection.noise_known ? 1 : 2);
    for (const Measurement& point : selection.data.rebounds) {
        distinct.insert(point.restitution());
        if (distinct.size() >= needed) return;
    }
    std::string problem = std::to_string(distinct.size()) + " distinct restitutions of " +
                          std::to_string(selection.data.rebounds.size()) +
                          " rebounds for a damping curve of order " + std::to_string(order);
    if (!selection.noise_known) problem += " with unknown uncertainties";
    throw InputError(problem, "at least " + std::to_string(needed)).at(FileName{set.source});
}

Eigen::VectorXd starting_coefficients(const ContactModel& model, const RestitutionData& data, int order,
                                      bool robust) {
    const auto rows = static_cast<Eigen::Index>(data.rebounds.size());
    Eigen::MatrixXd design(rows, order + 1);
    Eigen::VectorXd damping(rows);
    std::vector<const Measurement*> rebounds;
    for (const Measurement& rebound : data.rebounds) rebounds.push_back(&rebound);
    if (robust)  // so that the order of the file does not matter
        std::sort(rebounds.begin(), rebounds.end(), [](const Measurement* a, const Measurement* b) {
            return std::pair(a->velocity, a->rebound) < std::pair(b->velocity, b->rebound);
        });
    constexpr std::size_t chunk = 1000;
    batch::for_chunks(rebounds.size(), chunk, 0, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) {
            const Measurement& point = *rebounds[i];
            const double most = reach * model.greatest_restitution(point.velocity);
            const double e = std::min(point.restitution(), most);
            const auto row = static_cast<Eigen::Index>(i);
            design.row(row) = DampingPolynomial::powers(e, order).transpose();
            damping[row] = model.damping(point.velocity, e).value;
        }
    });
    const auto is_curve = [&](const Eigen::VectorXd& coefficients) {
        return RestitutionCurve::implied_by(model, {coefficients}, data.greatest_restitution).has_value();
    };
    if (robust)
        if (auto start = least_median(design, damping, is_curve)) return *start;
    for (int lower = order; lower >= 0; --lower) {
        Eigen::VectorXd start = Eigen::VectorXd::Zero(order + 1);
        start.head(lower + 1) = gsl::fit_linear(design.leftCols(lower + 1), damping, {}).parameters;
        if (is_curve(start)) return start;
    }
    throw ConvergenceError("no damping curve through the measurements could be started");
}

}  // namespace ashimpact
