// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/damping_inversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

bool is_adhesive(const DampingProblem& problem) {
    return velocity_of_adhesion(problem.law, problem.contact) > 0.0;
}

/// Restitution as a function of the scaled damping coefficient.
class RestitutionByDamping {
  public:
    explicit RestitutionByDamping(const DampingProblem& problem)
        : problem_(problem), scale_(Scale::of(problem.contact, problem.velocity)) {}

    template <class Real>
    [[nodiscard]] Real at(double number) {
        ++impacts;
        if constexpr (std::is_same_v<Real, Extended>) return followed(number).restitution();
        return scaled_restitution<Real>(impact(number));
    }
    /// The impact itself.
    [[nodiscard]] ImpactResult result(double number) { return followed(number).result(impact(number)); }
    [[nodiscard]] Impact impact(double number) const {
        return {problem_.law, problem_.detachment, damping(number), problem_.contact, problem_.velocity};
    }
    [[nodiscard]] Damping damping(double number) const {
        return {problem_.damping_law, scale_.damping_coefficient(problem_.damping_law, number)};
    }

    /// The inverse of damping().
    [[nodiscard]] double number(double coefficient) const {
        return scale_.damping_number({problem_.damping_law, coefficient});
    }

    int impacts = 0;

  private:
    /// The impact in extended precision; the last one is kept, since a solution is checked and then reported.
    [[nodiscard]] const FollowedImpact& followed(double number) {
        if (!last_ || last_number_ != number) last_.emplace(impact(number));
        last_number_ = number;
        return *last_;
    }

    const DampingProblem& problem_;
    Scale scale_;
    double last_number_ = 0;
    std::optional<FollowedImpact> last_{};
};

[[noreturn]] void unreachable_restitution(const DampingProblem& problem, double greatest, bool reaches_zero) {
    const std::string text = fmt::format(
        "restitution {:g} cannot be reached by damping law '{}' with contact law '{}' at {:g} m/s",
        problem.restitution, name_of(problem.damping_law), problem.law.name(), problem.velocity);
    if (!(greatest > 0))
        throw InputError(text, "0, or a velocity at which the impact rebounds without damping");
    throw InputError(text, fmt::format("0 {} e <= {:.8g}", reaches_zero ? "<=" : "<", greatest));
}

/// Relative miss of a restitution up to which a damping gives it back, and miss of its square up to which
/// nobody would see it: next to capture the spacing of numbers allows no nearer one.
constexpr double most_miss = 1e-4;
constexpr double unseen_miss = 1e-12;

/// Refuses a restitution that the damping found misses: a deep well or a small restitution makes it fall by
/// more from one number to the next. @param number scaled damping found, @param found its restitution
void require_found(const DampingProblem& problem, RestitutionByDamping& curve, double number, double found,
                   double greatest) {
    const double miss = std::abs(found - problem.restitution);
    if (miss <= most_miss * problem.restitution) return;
    if (miss * (found + problem.restitution) <= unseen_miss) return;
    constexpr double next = 1e-15;
    const auto before = static_cast<double>(curve.at<Extended>(number * (1 - next)));
    const auto after = static_cast<double>(curve.at<Extended>(number * (1 + next)));
    const auto [least, most] = std::minmax({before, found, after});
    throw InputError(
        fmt::format(
            "restitution {:g} is lost in rounding: by dampings that differ by a part in 1e15 it goes from "
            "{:g} to {:g}",
            problem.restitution, least, most),
        fmt::format("{:g} < e <= {:.8g}", most, greatest));
}

/// Scaled damping that is certainly too much for @p restitution.
double too_much(RestitutionByDamping& curve, double restitution) {
    double number =
        1.2;  // captures every zero-overlap impact with constant damping: beta_c = 1.128 for Hertz
    while (curve.at<double>(number) >= restitution) {
        number *= 2.0;
        if (!std::isfinite(number)) throw ConvergenceError("damping inversion: restitution does not fall");
    }
    return number;
}

/// Whether enough damping captures the impact, so that restitution zero is reachable. It does not if the
/// contact ends by force; nor, without adhesion, if the damping vanishes with the contact radius and no
/// amount of it captures.
bool reaches_zero(const DampingProblem& problem) {
    return problem.detachment != Detachment::zero_force &&
           (is_adhesive(problem) || !vanishes_at_touch(problem.damping_law) ||
            std::isfinite(overdamped_squared(problem.damping_law)));
}

struct Bracket {
    double lower, upper;
};

/// A bracket about a damping that captures nearly alone, or from nothing to more than captures.
Bracket capturing_bracket(RestitutionByDamping& curve, const std::optional<double>& guess) {
    for (double margin = 1e-15; guess && margin < 1e-2; margin *= 8) {
        const Bracket bracket{*guess * (1 - margin), *guess * (1 + margin)};
        if (curve.at<Extended>(bracket.lower) > 0.0 && !(curve.at<Extended>(bracket.upper) > 0.0))
            return bracket;
    }
    return {0.0, too_much(curve, std::numeric_limits<double>::min())};
}

/// Smallest damping that captures, by bisection down to neighbouring numbers.
double smallest_capturing(const DampingProblem& problem, RestitutionByDamping& curve,
                          const std::optional<double>& guess) {
    const double limit = overdamped_squared(problem.damping_law);
    const bool known =
        std::isfinite(limit) && !is_adhesive(problem) && !can_yield(problem.law, problem.contact);
    if (known) return std::sqrt(limit);  // exactly; just below, rebounds are too slow for any arithmetic
    auto [lower, upper] = capturing_bracket(curve, guess);
    while (true) {
        const double middle = lower + (upper - lower) / 2.0;
        if (middle <= lower || middle >= upper) return upper;
        (curve.at<Extended>(middle) > 0.0 ? lower : upper) = middle;
    }
}

constexpr double spacing = 2 * std::numeric_limits<double>::epsilon();

/// The root in a bracket to the spacing of numbers, with restitution in extended precision: the loss may be
/// so small, or restitution so steep, that double precision does not resolve it.
double solution_within(RestitutionByDamping& curve, double target, double lower, double upper) {
    const auto miss = [&](double number) { return static_cast<double>(curve.at<Extended>(number) - target); };
    return gsl::brent(miss, lower, upper, {.relative = spacing}).root;
}

/// The root to the spacing of numbers: by a step of Newton's method in double precision and some in extended
/// precision, the last one so short that the error of the slope is lost in rounding. None if they are not
/// enough, since restitution is too steep or too flat there.
std::optional<double> mended(RestitutionByDamping& curve, double target, double near) {
    const double step = 1e-6 * near;
    const double at_near = curve.at<double>(near);
    const double slope = (at_near - curve.at<double>(near - step)) / step;
    if (!(slope < 0.0)) return std::nullopt;
    // Relative error of the slope: by curvature, next to capture, where e^2 is straight, and by rounding.
    const double fall = step * -slope;
    const double slope_error = fall / target + spacing / fall;
    double number = near - (at_near - target) / slope;
    for (int i = 0; i < 3; ++i) {
        const Extended move = (target - curve.at<Extended>(number)) / slope;
        const double length = std::abs(static_cast<double>(move));
        number = static_cast<double>(number + move);
        if (length <= spacing * number || length * slope_error <= 0.01 * spacing * number) return number;
    }
    return std::nullopt;
}

/// A narrow bracket of the damping for law maugis-dugdale, whose impacts take a hundred times as long as
/// those of law jkr, and mostly need nearly the same damping; none for other laws, or where it does not.
std::optional<Bracket> bracket_by_jkr(const DampingProblem& problem, RestitutionByDamping& curve) {
    if (!is_cohesive(problem.law, problem.contact)) return std::nullopt;
    DampingProblem similar = problem;
    similar.law = problem.law.similar();
    RestitutionByDamping other(similar);
    if (other.at<double>(0.0) <= problem.restitution) return std::nullopt;
    const double guess =
        gsl::brent([&](double number) { return other.at<double>(number) - problem.restitution; }, 0.0,
                   too_much(other, problem.restitution), {.relative = 1e-4})
            .root;
    for (const double margin : {0.02, 0.3}) {
        const Bracket bracket{guess * (1 - margin), guess * (1 + margin)};
        const bool holds = curve.at<double>(bracket.lower) > problem.restitution &&
                           curve.at<double>(bracket.upper) < problem.restitution;
        if (holds) return bracket;
    }
    return std::nullopt;
}

/// @param guess scaled damping next to the solution
double scaled_solution(const DampingProblem& problem, RestitutionByDamping& curve,
                       const std::optional<double>& guess) {
    const double target = problem.restitution;
    if (target == 0.0) return smallest_capturing(problem, curve, guess);
    if (guess)
        if (const auto solution = mended(curve, target, *guess)) return *solution;
    const auto near = bracket_by_jkr(problem, curve);
    const double most = near ? near->upper : too_much(curve, target);
    if (!near && curve.at<double>(0.0) <= target) return solution_within(curve, target, 0.0, most);
    const auto miss = [&](double number) { return curve.at<double>(number) - target; };
    const double root = gsl::brent(miss, near ? near->lower : 0.0, most).root;
    if (const auto solution = mended(curve, target, root)) return *solution;
    double margin = 1e-12;
    for (int widened = 0; widened < 6; ++widened, margin *= 100) {
        const double lower = root * (1 - margin);
        const double upper = root * (1 + margin);
        if (curve.at<Extended>(lower) > target && curve.at<Extended>(upper) <= target)
            return solution_within(curve, target, lower, upper);
    }
    return solution_within(curve, target, 0.0, most);
}

}  // namespace

DampingInversion damping_from_restitution(const DampingProblem& problem, std::optional<double> near) {
    validate(Impact{
        problem.law, problem.detachment, {problem.damping_law, 0.0}, problem.contact, problem.velocity});
    RestitutionByDamping curve(problem);
    const double target = problem.restitution;
    const double greatest = undamped_restitution(curve.impact(0.0));
    const bool reachable = target > 0.0 ? target <= greatest : target == 0.0 && reaches_zero(problem);
    if (!reachable) unreachable_restitution(problem, greatest, reaches_zero(problem));
    if (near) near = curve.number(*near);
    // In single precision, so that it is the same by all instruction sets, whose batches differ in rounding.
    if (near && target > 0.0) near = static_cast<float>(*near);
    const double number = target < greatest ? scaled_solution(problem, curve, near) : 0.0;
    const ImpactResult impact = curve.result(number);
    require_found(problem, curve, number, impact.restitution, greatest);
    return {.damping = curve.damping(number),
            .greatest_restitution = greatest,
            .impact = impact,
            .impacts = curve.impacts};
}

}  // namespace ashimpact
