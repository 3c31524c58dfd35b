// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/time_domain.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "core/text/error.hpp"
#include "tests/oracles/contact_force.hpp"
#include "tests/support/ode.hpp"

namespace ashimpact::oracles {

namespace {

constexpr double relative_tolerance = 1e-13;
constexpr double loss = 100 * relative_tolerance;  // over the some hundred steps of an impact
constexpr double patience = 400;                   // in Hertz times

enum class Clock { time, velocity, root_of_overlap_left, net_force };

// time [s], overlap [m], velocity [m/s]
struct Motion {
    using State = std::array<double, 3>;

    const ContactForce& force;
    double mass;
    double damping;
    const Clock& clock;

    [[nodiscard]] double net_force(const State& y) const { return force(y[1]) + damping * y[2]; }

    // dt / d(clock)
    [[nodiscard]] double pace(double x, const State& y, double acceleration) const {
        switch (clock) {
            case Clock::time:
                return 1;
            case Clock::velocity:
                return 1 / acceleration;
            case Clock::root_of_overlap_left:
                return 2 * x / y[2];
            case Clock::net_force:
                return 1 / (force.hertz_slope(y[1]) * y[2] + damping * acceleration);
        }
        return std::nan("");
    }

    State operator()(double x, const State& y) const {
        const double acceleration = -net_force(y) / mass;
        const double rate = pace(x, y, acceleration);
        return {rate, rate * y[2], rate * acceleration};
    }
};

class Integration {
  public:
    using State = Motion::State;

    explicit Integration(const ImpactCase& impact)
        : force_(impact),
          motion_{force_, impact.mass, impact.damping, clock_},
          ode_(motion_,
               {relative_tolerance,
                {relative_tolerance * force_.time_scale(), relative_tolerance * force_.overlap_scale(),
                 relative_tolerance * impact.velocity}}),
          zero_force_(impact.detachment == Detachment::zero_force),
          incident_velocity_(impact.velocity) {}

    ImpactResult run() {
        State now{0, 0, incident_velocity_};
        const double horizon = patience * force_.time_scale();
        double t = 0;
        double stride = 1e-3 * force_.time_scale();
        std::optional<State> turned;
        while (t < horizon) {
            const State before = now;
            ode_.step(t, horizon, stride, now);
            now[0] = t;
            if (!turned) {
                if (now[2] > 0) continue;
                if (at_rest(before)) break;  // so damped that it never turned
                turned = until(Clock::velocity, before[2], 0, before);
                now = *turned;
                t = now[0];
                ode_.restart();
                continue;
            }
            if (const auto end = end_of_contact(before, now)) return rebound(*turned, *end);
            if (now[2] > 0) break;
        }
        return capture(turned.value_or(now)[1]);
    }

  private:
    State until(Clock clock, double from, double to, State state) {
        clock_ = clock;
        ode_.integrate(from, to, state);
        clock_ = Clock::time;
        return state;
    }

    std::optional<State> end_of_contact(const State& before, const State& now) {
        if (zero_force_) {
            if (motion_.net_force(now) > 0) return std::nullopt;
            return until(Clock::net_force, motion_.net_force(before), 0, before);
        }
        const double end = force_.end_overlap();
        if (least_overlap(before, now) > end) return std::nullopt;
        return until(Clock::root_of_overlap_left, std::sqrt(before[1] - end), 0, before);
    }

    // In equilibrium, where the sign of the velocity is noise.
    [[nodiscard]] bool at_rest(const State& state) const {
        const double little = 1e-9 * incident_velocity_;
        return std::abs(state[2]) < little &&
               std::abs(motion_.net_force(state) / motion_.mass) * force_.time_scale() < little;
    }

    // A sphere may leave and be pulled back within one step.
    double least_overlap(const State& before, const State& now) {
        return now[2] > 0 && !at_rest(before) ? until(Clock::velocity, before[2], 0, before)[1] : now[1];
    }

    [[nodiscard]] ImpactResult rebound(const State& turned, const State& end) const {
        const double restitution = -end[2] / incident_velocity_;
        return {.rebound = true,
                .restitution = {restitution, loss},
                .contact_time = {end[0], loss * end[0]},
                .maximum_overlap = {turned[1], loss * turned[1]}};
    }

    static ImpactResult capture(double maximum_overlap) {
        ImpactResult result;
        result.maximum_overlap = {maximum_overlap, loss * maximum_overlap};
        return result;
    }

    Clock clock_ = Clock::time;
    ContactForce force_;
    Motion motion_;
    test::Ode<3, Motion> ode_;
    bool zero_force_;
    double incident_velocity_;
};

}  // namespace

ImpactResult time_domain_impact(const ImpactCase& impact) {
    return Integration(impact).run();
}

double time_domain_critical_velocity(const ImpactCase& impact) {
    double captured = 1e-6;
    double rebounds = 1e3;
    const auto rebound_at = [&](double velocity) {
        return time_domain_impact(at_velocity(impact, velocity)).rebound;
    };
    if (rebound_at(captured) || !rebound_at(rebounds))
        throw ConvergenceError("no critical velocity in 1e-6..1e3 m/s");
    while (rebounds > captured * (1 + 1e-9)) {
        const double middle = std::sqrt(captured * rebounds);
        (rebound_at(middle) ? rebounds : captured) = middle;
    }
    return std::sqrt(captured * rebounds);
}

}  // namespace ashimpact::oracles
