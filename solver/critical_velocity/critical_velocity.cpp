// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/critical_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/damping/registry.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/numeric/gsl/solvers.hpp"

namespace ashimpact {

namespace {

/// Finds the critical impacts on the branches of a law.
struct Search {
    const CriticalVelocityProblem& problem;
    const Scale& scale;

    [[nodiscard]] bool damped() const { return is_damped(problem.damping, problem.contact.parameters); }
    template <class Real>
    [[nodiscard]] CriticalImpacts operator()(const Motion<Real>& motion) const {
        if (problem.detachment == Detachment::zero_force) return {CaptureVerdict::never_captured};
        const bool breaking_costs = motion.potential(*motion.end) > motion.potential(motion.touch);
        if (!damped() && !breaking_costs) return {CaptureVerdict::never_captured};
        if (velocity_of_adhesion(problem.law, problem.contact) == 0.0) {
            if (const auto verdict = verdict_without_adhesion(problem.damping, problem.contact))
                return {*verdict};
        }
        if (damped()) require_computable(scale.velocity);
        return critical_impacts(motion);
    }
    [[nodiscard]] CriticalImpacts operator()(const PlasticMotion<Extended>& motion) const {
        return critical_impacts(motion, problem.contact.effective_radius / scale.length);
    }
    [[nodiscard]] CriticalImpacts operator()(const CohesiveMotion& motion) const {
        const bool costs_nothing = problem.detachment == Detachment::zero_overlap;
        if (!damped() && costs_nothing) return {CaptureVerdict::never_captured};
        require_computable(std::max(scale.velocity, velocity_of_damping(problem.damping, problem.contact)));
        return critical_impacts(motion);
    }

  private:
    /// Refuses a velocity beyond the range of numbers, where there is no verdict to be had.
    static void require_computable(double velocity) {
        if (velocity > greatest_computable)
            throw InputError(
                "the critical velocity is " + outside_model_text() + ", beyond the range of numbers",
                "less damping");
        require_positive("the velocity that this damping captures", velocity, Dimension::velocity);
    }
};

/// The critical impacts, or the verdict without one, in SI units.
CriticalVelocity result_of(const CriticalImpacts& found, const Scale& scale) {
    if (found.impacts.empty()) return {.verdict = found.verdict};
    const auto joule = [&](Extended energy) { return static_cast<double>(energy) * scale.energy(); };
    const CriticalImpact& first = found.impacts.front();
    CriticalVelocity result;
    if (first.contact_time) result.contact_time = static_cast<double>(*first.contact_time) * scale.time();
    result.maximum_overlap = static_cast<double>(first.maximum_overlap) * scale.length;
    result.dissipated = joule(first.dissipated);
    result.plastic = joule(first.plastic);
    result.detachment_energy = joule(first.break_energy);
    for (const CriticalImpact& impact : found.impacts)
        result.crossings.push_back(static_cast<double>(impact.velocity) * scale.velocity);
    result.value = result.crossings.front();
    return result;
}

/// Whether double precision decides: by an impact within the range of numbers, or a verdict reached there.
bool is_certain(const CriticalImpacts& found) {
    return found.impacts.empty() ? found.certain : std::isfinite(found.impacts.front().velocity);
}

bool captured_at(const CriticalVelocityProblem& problem, double velocity) {
    return scaled_restitution<Extended>(
               {problem.law, problem.detachment, problem.damping, problem.contact, velocity}) == 0;
}

/// The crossing refined by forward impacts. Very strong damping draws orbits together, so that a backward
/// orbit loses digits that forward impacts keep.
double confirmed(const CriticalVelocityProblem& problem, double velocity) {
    double margin = 1e-11;
    const auto parts = [&](double lower, double upper) {
        return captured_at(problem, lower) != captured_at(problem, upper);
    };
    while (margin < 0.03 && !parts(velocity * (1 - margin), velocity * (1 + margin))) margin *= 10;
    if (margin == 1e-11 || margin >= 0.03) return velocity;
    double lower = velocity * (1 - margin);
    double upper = velocity * (1 + margin);
    const bool captured = captured_at(problem, lower);
    while (upper - lower > 1e-15 * upper) {
        const double middle = lower + (upper - lower) / 2;
        if (middle <= lower || middle >= upper) break;
        (captured_at(problem, middle) == captured ? lower : upper) = middle;
    }
    return upper;
}

/// Refines the crossings of a contact that can yield.
/// @throws InputError if no impact of positive energy gets there: the closure does not hold
void confirm(const CriticalVelocityProblem& problem, CriticalVelocity& result) {
    const bool first_exists = std::isfinite(*result.value);
    std::erase_if(result.crossings, [](double crossing) { return !std::isfinite(crossing); });
    for (double& crossing : result.crossings) crossing = confirmed(problem, crossing);
    if (first_exists) result.value = result.crossings.front();
    for (const double number :
         {*result.value, result.contact_time.value_or(0.0), result.maximum_overlap.value_or(0.0),
          result.dissipated, result.plastic, result.detachment_energy}) {
        if (std::isfinite(number)) continue;
        throw InputError(fmt::format("the critical impact lies outside the range of the plastic closure at a "
                                     "yield pressure of {:g} Pa",
                                     problem.contact.yield_pressure),
                         "a larger yield pressure or less adhesion, or the law jkr");
    }
}

}  // namespace

std::optional<CaptureVerdict> verdict_without_adhesion(const Damping& damping, const ContactPair& contact) {
    using Verdict = std::optional<CaptureVerdict>;
    // Damping that vanishes at touch but captures has the same scaled coefficient at every velocity.
    const Scale any = Scale::of_length(contact, contact.effective_radius);
    return RegisteredDampings::visit<Verdict>(damping.law, [&]<class D>() -> Verdict {
        const auto coefficients = coefficients_of<D>(damping.coefficient, contact.parameters);
        for (std::size_t k = 0; k < terms_of<D>; ++k)
            if (coefficients[k] != 0.0 && touch_shapes<D>()[k] != 0.0) return std::nullopt;
        return is_overdamped(damping.law, any.damping_number(damping)) ? CaptureVerdict::always_captured
                                                                       : CaptureVerdict::never_captured;
    });
}

CriticalVelocity critical_velocity(const CriticalVelocityProblem& problem, Precision precision) {
    const auto& [law, detachment, damping, contact] = problem;
    validate(Impact{law, detachment, damping, contact, 1.0});
    const bool yields = can_yield(law, contact);
    // Beside these the numbers of the scaled impact are of order one or less.
    const double unit = std::max({velocity_of_adhesion(law, contact), velocity_of_damping(damping, contact),
                                  yields ? yield_velocity(contact) : std::numeric_limits<double>::min()});
    const Impact impact{law, detachment, damping, contact, unit};
    if (precision == Precision::standard && !yields) {
        const bool cohesive = is_cohesive(law, contact);
        const Scale scale = Scale::of(contact, cohesive ? maugis_velocity(contact) : unit);
        const Search search{problem, scale};
        const CriticalImpacts found = cohesive ? search(scaled_cohesive_motion(impact, precision))
                                               : search(scaled_motion<double>(impact, scale));
        if (is_certain(found)) return result_of(found, scale);
    }
    const auto [scale, velocity, branches] = scaled_impact<Extended>(impact, Precision::extended);
    const CriticalImpacts found = std::visit(Search{problem, scale}, branches);
    CriticalVelocity result = result_of(found, scale);
    if (yields && result.value) confirm(problem, result);
    return result;
}

std::optional<double> capturing_damping(CriticalVelocityProblem problem, double velocity) {
    constexpr double reach = 1.3;
    const double guess = problem.damping.coefficient;
    const auto excess_by = [&](double damping, Precision precision) {
        problem.damping.coefficient = damping;
        const CriticalVelocity critical = critical_velocity(problem, precision);
        if (critical.value) return std::log(*critical.value / velocity);
        return critical.verdict == CaptureVerdict::never_captured ? -1.0 : 1.0;
    };
    const auto excess = [&](double damping) { return excess_by(damping, Precision::standard); };
    if (!(guess > 0) || excess(guess / reach) >= 0 || excess(guess * reach) <= 0) return std::nullopt;
    const double near = gsl::brent(excess, guess / reach, guess * reach, {.relative = 1e-8}).root;
    // The last step, by Newton's method, leaves the square of that and of the distance for the slope.
    constexpr double aside = 1e-4;
    const double slope = (excess(near * (1 + aside)) - excess(near * (1 - aside))) / (2 * aside * near);
    return near - excess_by(near, Precision::extended) / slope;
}

}  // namespace ashimpact
