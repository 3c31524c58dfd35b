// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/critical_velocity/plastic_critical_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/velocity_scales.hpp"
#include "solver/numeric/gsl/root.hpp"

namespace ashimpact {

namespace {

constexpr double scan_ratio =
    1.02;  ///< of successive greatest contacts (in u) searched for a change of verdict

/// The arrival at rest after unloading from a greatest contact.
struct Unloading {
    Motion<Extended> motion;
    std::optional<Arrival> arrival;
    std::optional<MotionState<Extended>> turn;
};

class PlasticCapture {
  public:
    PlasticCapture(const CriticalVelocityProblem& problem, const Scale& scale)
        : overdamped_(is_overdamped(problem.damping.law, scale.damping_number(problem.damping))),
          scale_(scale),
          motion_(scaled_plastic_motion<Extended>(
              {problem.law, problem.detachment, problem.damping, problem.contact, scale.velocity}, scale)) {}

    [[nodiscard]] const PlasticMotion<Extended>& motion() const { return motion_; }

    /// How far beyond the greatest contact @p u the orbit that just arrives at the end would have to turn:
    /// positive if an impact that turns at u is captured, negative if it rebounds.
    [[nodiscard]] double margin(double u) {
        const Unloading unloading = from(u);
        if (!unloading.arrival) return overdamped_ ? 1.0 : -1.0;
        if (!unloading.turn) return 1.0;
        return static_cast<double>(unloading.motion.root_radius(unloading.turn->position) / u - 1);
    }

    /// The impact that turns at @p u and arrives at the end at rest.
    [[nodiscard]] CriticalVelocity impact_through(double u) {
        const Unloading unloading = from(u);
        const Motion<Extended>& loading = motion_.loading();
        const Motion<Extended>& elastic = motion_.elastic();
        const Extended yield = std::min<Extended>(motion_.yield(), u);
        MotionState<Extended> state{.position = loading.coordinate(u)};
        Extended plastic_work = 0;
        if (u > motion_.yield()) {
            state = back_to(loading, state, loading.coordinate(motion_.yield()), steps);
            plastic_work =
                motion_.loading_potential(u) - unloading.motion.potential(unloading.motion.coordinate(u));
        }
        if (!motion_.yields_at_touch()) {
            state.position = elastic.coordinate(yield);
            state = back_to(elastic, state, elastic.touch, steps);
        }
        const Extended unloaded = unloading.arrival->dissipated_after - unloading.turn->dissipation;
        const Extended dissipated = unloaded - state.dissipation;
        const Extended released =
            unloading.motion.potential(*unloading.motion.end) - motion_.touch_potential();
        CriticalVelocity result;
        if (const auto after = unloading.arrival->time_after)
            result.contact_time =
                static_cast<double>(*after - unloading.turn->time - state.time) * scale_.time();
        result.value =
            static_cast<double>(std::sqrt(2 * (dissipated + plastic_work + released))) * scale_.velocity;
        result.maximum_overlap = static_cast<double>(loading.overlap(loading.coordinate(u))) * scale_.length;
        result.dissipated = static_cast<double>(dissipated) * scale_.energy();
        result.plastic = static_cast<double>(plastic_work) * scale_.energy();
        result.detachment_energy = static_cast<double>(released) * scale_.energy();
        return result;
    }

    int steps = 0;

  private:
    [[nodiscard]] Unloading from(double u) {
        Unloading unloading{u > motion_.yield() ? motion_.unloading(u) : motion_.elastic(), {}, {}};
        unloading.arrival = critical_arrival(unloading.motion);
        if (unloading.arrival)
            unloading.turn = back_to_turn(unloading.motion, unloading.arrival->state, steps);
        return unloading;
    }

    bool overdamped_;  ///< captures, whatever the radius of the flattened sphere
    Scale scale_;
    PlasticMotion<Extended> motion_;
};

/// Greatest contact, in u, at an overlap of R*: beyond it no law here holds.
double farthest_contact(const PlasticMotion<Extended>& motion, const CriticalVelocityProblem& problem,
                        const Scale& scale) {
    const double overlap = problem.contact.effective_radius / scale.length;
    double u = static_cast<double>(motion.yield());
    while (motion.loading().overlap(motion.loading().coordinate(u)) < overlap) u *= scan_ratio;
    return u;
}

/// Every greatest contact at which captured and rebounding impacts meet, ascending.
std::vector<double> critical_contacts(PlasticCapture& capture, double farthest) {
    std::vector<double> contacts;
    double lower = static_cast<double>(capture.motion().yield());
    double margin = capture.margin(lower);
    if (margin < 0.0 && margin > -1.0) contacts.push_back(lower * (1.0 + margin));  // on the elastic branch
    while (lower < farthest) {
        const double u = lower * scan_ratio;
        const double next = capture.margin(u);
        if ((next > 0.0) != (margin > 0.0)) {
            contacts.push_back(gsl::brent([&](double x) { return capture.margin(x); }, lower, u).root);
        }
        lower = u;
        margin = next;
    }
    return contacts;
}

bool captured_at(const CriticalVelocityProblem& problem, double velocity) {
    const Impact impact{problem.law, problem.detachment, problem.damping, problem.contact, velocity};
    return scaled_restitution<Extended>(impact, Scale::of(problem.contact, velocity)) == 0;
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

/// Refuses a critical contact that no impact of positive energy reaches: the closure does not hold there.
[[noreturn]] void refuse_outside(const CriticalVelocityProblem& problem) {
    std::ostringstream what;
    what << "the critical impact lies outside the range of the plastic closure at a yield pressure of "
         << problem.contact.yield_pressure << " Pa";
    throw InputError(what.str(), "a larger yield pressure or less adhesion, or the law jkr");
}

}  // namespace

CriticalVelocity plastic_critical_velocity(const CriticalVelocityProblem& problem) {
    const Scale scale = Scale::of(
        problem.contact,
        std::max({velocity_of_adhesion(problem.law, problem.contact),
                  velocity_of_damping(problem.damping, problem.contact), yield_velocity(problem.contact)}));
    PlasticCapture capture(problem, scale);
    const std::vector<double> contacts =
        critical_contacts(capture, farthest_contact(capture.motion(), problem, scale));
    if (contacts.empty()) {
        const bool captured = capture.margin(static_cast<double>(capture.motion().yield())) > 0.0;
        return {.verdict = captured ? CaptureVerdict::always_captured : CaptureVerdict::never_captured};
    }
    CriticalVelocity result = capture.impact_through(contacts.front());
    if (!std::isfinite(*result.value)) refuse_outside(problem);
    for (const double u : contacts) {
        const double crossing = *capture.impact_through(u).value;
        if (std::isfinite(crossing)) result.crossings.push_back(confirmed(problem, crossing));
    }
    result.value = result.crossings.front();
    result.steps = capture.steps;
    for (const double number :
         {*result.value, result.contact_time.value_or(0.0), result.maximum_overlap.value_or(0.0),
          result.dissipated, result.plastic, result.detachment_energy})
        if (!std::isfinite(number)) refuse_outside(problem);
    return result;
}

}  // namespace ashimpact
