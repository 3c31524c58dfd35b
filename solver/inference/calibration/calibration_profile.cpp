// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/calibration/calibration_profile.hpp"

#include <algorithm>
#include <cmath>

#include "core/text/error.hpp"
#include "solver/inference/calibration/calibration_objective.hpp"

namespace ashimpact {

namespace {

constexpr double furthest = 10.0;  ///< factor from the best value to which a profile is followed
constexpr double strong = 0.95;    ///< correlation from which two constants are called traded

std::string name_of(const CalibratedConstant& constant) {
    std::string name(name_of(constant.quantity));
    if (constant.sample) name += " of sample " + std::to_string(*constant.sample + 1);
    return name;
}

std::string statement_of(const CalibrationSummary& summary, std::size_t constant,
                         const ConstantProfile& profile) {
    std::string text =
        name_of(summary.constants[constant]) + " is not identifiable: the observations bound it ";
    text += profile.interval.lower   ? "only from below"
            : profile.interval.upper ? "only from above"
                                     : "not at all";
    for (std::size_t i = 0; i < profile.traded_with.size(); ++i)
        text += (i == 0 ? "; it is traded with " : ", ") + name_of(summary.constants[profile.traded_with[i]]);
    return text;
}

/// Interval of one logarithm. The search for the others starts from their last values.
Interval logarithmic_interval(const CalibrationObjective& objective, const Eigen::VectorXd& best,
                              Eigen::Index constant, double deviation) {
    const double least = objective.residuals(best).squaredNorm();
    const auto profile = [&](double value) {
        Eigen::VectorXd start = best;
        start[constant] = value;
        if (best.size() == 1) return objective.residuals(start).squaredNorm() - least;
        return objective.fit(start, constant).chi_squared - least;
    };
    const double range = std::log(furthest);
    return profile_interval(profile, {.best = best[constant],
                                      .deviation = std::min(deviation, 0.2 * range),
                                      .least = best[constant] - range,
                                      .greatest = best[constant] + range});
}

}  // namespace

std::vector<ConstantProfile> profile_constants(const CalibrationProblem& problem,
                                               const CalibrationSummary& summary,
                                               const std::function<void(std::size_t done)>& on_profile) {
    const auto count = static_cast<Eigen::Index>(summary.constants.size());
    Eigen::VectorXd best(count);
    for (Eigen::Index i = 0; i < count; ++i)
        best[i] = std::log(summary.constants[static_cast<std::size_t>(i)].value);
    const CalibrationObjective objective(problem, best);
    std::vector<ConstantProfile> profiles;
    for (Eigen::Index i = 0; i < count; ++i) {
        const CalibratedConstant& constant = summary.constants[static_cast<std::size_t>(i)];
        const double deviation = constant.standard_uncertainty / constant.value;
        const Interval logarithm = logarithmic_interval(objective, best, i, deviation);
        ConstantProfile profile{.interval = {constant.value, constant.value * logarithm.standard_uncertainty},
                                .identifiable = logarithm.lower && logarithm.upper,
                                .traded_with = {},
                                .statement = {}};
        if (logarithm.lower) profile.interval.lower = std::exp(*logarithm.lower);
        if (logarithm.upper) profile.interval.upper = std::exp(*logarithm.upper);
        for (Eigen::Index j = 0; j < count; ++j)
            if (j != i && std::abs(summary.correlation(i, j)) > strong)
                profile.traded_with.push_back(static_cast<std::size_t>(j));
        if (!profile.identifiable)
            profile.statement = statement_of(summary, static_cast<std::size_t>(i), profile);
        profiles.push_back(std::move(profile));
        if (on_profile) on_profile(profiles.size());
    }
    return profiles;
}

}  // namespace ashimpact
