#include "solver/damping_inversion.hpp"

#include "materials/error.hpp"
#include "solver/critical_velocity.hpp"
#include "solver/gsl/root.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace ashimpact {

namespace {

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

CriticalVelocity critical_with(const DampingProblem& problem, const RestitutionCurve& curve, double number) {
    return critical_velocity({problem.law, problem.detachment, curve.damping(number), problem.contact});
}

/// Smallest damping whose critical velocity reaches the impact velocity, to rounding and on the capturing
/// side.
double smallest_capturing(const DampingProblem& problem, RestitutionCurve& curve) {
    const auto excess = [&](double number) {
        const CriticalVelocity critical = critical_with(problem, curve, number);
        switch (critical.verdict) {
            case CaptureVerdict::always_captured:
                return 1.0;
            case CaptureVerdict::never_captured:
                return -1.0;
            case CaptureVerdict::finite:
                break;
        }
        return std::tanh(std::log(*critical.value / problem.velocity));
    };
    double number = gsl::brent(excess, 0.0, too_much(curve, std::numeric_limits<double>::min())).root;
    for (double nudge = 1e-15; curve.at<Extended>(number) > 0.0; nudge *= 2.0) number *= 1.0 + nudge;
    return number;
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
    const bool never_captures =
        target == 0.0 && critical_with(problem, curve, 1.0).verdict == CaptureVerdict::never_captured;
    if (!(target >= 0.0 && target <= greatest) || never_captures) {
        unreachable_restitution(problem, greatest, !never_captures);
    }
    const double number = target < greatest ? scaled_solution(problem, curve) : 0.0;
    return {.damping = curve.damping(number),
            .greatest_restitution = greatest,
            .impact = solve_impact(curve.impact(number)),
            .impacts = curve.impacts};
}

}  // namespace ashimpact
