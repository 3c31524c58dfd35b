#include "solver/damping_inversion.hpp"

#include "materials/error.hpp"
#include "solver/gsl/root.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"
#include "solver/velocity_scales.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace ashimpact {

namespace {

bool is_adhesive(const DampingProblem& problem) {
    return velocity_of_adhesion(problem.law, problem.contact) > 0.0;
}

/// Restitution as a function of the scaled damping coefficient.
class RestitutionCurve {
  public:
    explicit RestitutionCurve(const DampingProblem& problem)
        : problem_(problem), scale_(Scale::of(problem.contact, problem.velocity)) {}

    template <class Real>
    [[nodiscard]] double at(double number) {
        ++impacts;
        return scaled_restitution<Real>(impact(number), scale_);
    }
    [[nodiscard]] Impact impact(double number) const {
        return {problem_.law, problem_.detachment, damping(number), problem_.contact, problem_.velocity};
    }
    [[nodiscard]] Damping damping(double number) const {
        return {problem_.damping_law, scale_.damping_coefficient(problem_.damping_law, number)};
    }

    int impacts = 0;

  private:
    const DampingProblem& problem_;
    Scale scale_;
};

[[noreturn]] void unreachable_restitution(const DampingProblem& problem, double greatest, bool reaches_zero) {
    std::ostringstream problem_text;
    problem_text << "restitution " << problem.restitution << " cannot be reached by damping law '"
                 << name_of(problem.damping_law) << "' with contact law '" << problem.law.name() << "' at "
                 << problem.velocity << " m/s";
    std::ostringstream allowed;
    allowed.precision(8);
    allowed << (reaches_zero ? "0 <= e <= " : "0 < e <= ") << greatest;
    throw InputError(problem_text.str(), allowed.str());
}

/// Scaled damping that is certainly too much for @p restitution.
double too_much(RestitutionCurve& curve, double restitution) {
    double number =
        1.2;  // captures every zero-overlap impact with constant damping: beta_c = 1.128 for Hertz
    while (curve.at<double>(number) >= restitution) {
        number *= 2.0;
        if (!std::isfinite(number)) throw ConvergenceError("damping inversion: restitution does not fall");
    }
    return number;
}

/// Newton-like polish in extended precision: the double-precision root is good to about 1e-13 in restitution.
double polished(RestitutionCurve& curve, double number, double restitution) {
    const double miss = curve.at<Extended>(number) - restitution;
    if (std::abs(miss) <= 1e-15) return number;
    const double nudged = number * (1.0 + 1e-6);
    const double slope = (curve.at<Extended>(nudged) - restitution - miss) / (nudged - number);
    const double better = number - miss / slope;
    const bool usable = slope < 0.0 && std::abs(better - number) < 1e-9 * number;
    return usable && std::abs(curve.at<Extended>(better) - restitution) < std::abs(miss) ? better : number;
}

/// Whether enough of the damping captures the impact, so that restitution zero is reachable: not where the
/// contact ends by force, nor where without adhesion the damping vanishes with the contact radius.
bool reaches_zero(const DampingProblem& problem) {
    return problem.detachment != Detachment::zero_force &&
           (problem.damping_law != DampingLaw::contact_radius || is_adhesive(problem));
}

/// Smallest damping that captures, by bisection down to neighbouring numbers.
double smallest_capturing(const DampingProblem& problem, RestitutionCurve& curve) {
    const bool linear = problem.damping_law == DampingLaw::tsuji && !is_adhesive(problem) &&
                        !can_yield(problem.law, problem.contact);
    if (linear) return std::sqrt(5.0);  // exactly; just below, rebounds are too slow for any arithmetic
    double lower = 0.0;
    double upper = too_much(curve, std::numeric_limits<double>::min());
    while (true) {
        const double middle = lower + (upper - lower) / 2.0;
        if (middle <= lower || middle >= upper) return upper;
        (curve.at<Extended>(middle) > 0.0 ? lower : upper) = middle;
    }
}

double scaled_solution(const DampingProblem& problem, RestitutionCurve& curve) {
    const double target = problem.restitution;
    if (target == 0.0) return smallest_capturing(problem, curve);
    const auto miss = [&](double number) { return curve.at<double>(number) - target; };
    return polished(curve, gsl::brent(miss, 0.0, too_much(curve, target)).root, target);
}

}  // namespace

DampingInversion damping_from_restitution(const DampingProblem& problem) {
    RestitutionCurve curve(problem);
    validate(curve.impact(0.0));
    const double target = problem.restitution;
    const double greatest = curve.at<Extended>(0.0);
    const bool reachable = target > 0.0 ? target <= greatest : target == 0.0 && reaches_zero(problem);
    if (!reachable) unreachable_restitution(problem, greatest, reaches_zero(problem));
    const double number = target < greatest ? scaled_solution(problem, curve) : 0.0;
    return {.damping = curve.damping(number),
            .greatest_restitution = greatest,
            .impact = solve_impact(curve.impact(number)),
            .impacts = curve.impacts};
}

}  // namespace ashimpact
