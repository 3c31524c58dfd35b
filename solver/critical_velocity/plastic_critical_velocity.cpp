// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/numeric/gsl/search.hpp"

namespace ashimpact {

namespace {

/// Ratio of successive greatest contacts (in u) searched for a change of verdict.
constexpr double scan_ratio = 1.02;

/// The arrival at rest after unloading from a greatest contact.
struct Unloading {
    Motion<Extended> motion;
    std::optional<Arrival> arrival{};
    std::optional<MotionState<Extended>> turn{};
};

/// The arrival of an impact that turns at @p u, with work and time counted from there.
Arrival arrival_from(const Unloading& unloading, double u) {
    const Motion<Extended>& motion = unloading.motion;
    constexpr double near = 1e-9;
    const auto& turn = unloading.turn;
    if (turn && std::abs(motion.root_radius(turn->position) / u - 1) < near) {
        Arrival arrival = *unloading.arrival;
        arrival.dissipated_after -= turn->dissipation;
        if (arrival.time_after) *arrival.time_after -= turn->time;
        return arrival;
    }
    // Damping draws the orbits together until backward they either turn far below u or escape. Forward they
    // are the same orbit, whose work is the fall of the potential.
    const MotionState<Extended> start{.position = motion.coordinate(u)};
    Orbit<Extended> orbit;
    const Unobserved unobserved;
    Legs(orbit, unobserved).rebound(motion, start, CaptureTest<Extended>(motion));
    return {.state = orbit.end,
            .dissipated_after = motion.potential(start.position) - motion.potential(*motion.end),
            .time_after = orbit.end.time};
}

class PlasticCapture {
  public:
    explicit PlasticCapture(const PlasticMotion<Extended>& motion) : motion_(motion) {}

    /// How far beyond the greatest contact @p u the orbit that just arrives at the end would have to turn:
    /// positive if an impact that turns at u is captured, negative if it rebounds.
    [[nodiscard]] double margin(double u) const {
        const Unloading unloading = from(u);
        if (!unloading.arrival) return motion_.elastic().overdamped ? 1.0 : -1.0;
        if (!unloading.turn) return 1.0;
        return static_cast<double>(unloading.motion.root_radius(unloading.turn->position) / u - 1);
    }

    /// The impact that turns at @p u and arrives at the end at rest.
    [[nodiscard]] CriticalImpact impact_through(double u) const {
        const Unloading unloading = from(u);
        const Motion<Extended>& loading = motion_.loading();
        const Motion<Extended>& elastic = motion_.elastic();
        const Extended yield = motion_.yield();
        MotionState<Extended> state{.position = loading.coordinate(u)};
        Extended plastic_work = 0;
        if (u > yield) {
            state = back_to(loading, state, loading.coordinate(yield));
            plastic_work =
                motion_.loading_potential(u) - unloading.motion.potential(unloading.motion.coordinate(u));
        }
        if (!motion_.yields_at_touch()) {
            state.position = elastic.coordinate(std::min<Extended>(yield, u));
            state = back_to(elastic, state, elastic.touch);
        }
        return critical_impact(arrival_from(unloading, u), state, plastic_work,
                               unloading.motion.potential(*unloading.motion.end) - motion_.touch_potential(),
                               loading.overlap(loading.coordinate(u)));
    }

  private:
    [[nodiscard]] Unloading from(double u) const {
        Unloading unloading{u > motion_.yield() ? motion_.unloading(u) : motion_.elastic()};
        unloading.arrival = critical_arrival(unloading.motion);
        if (unloading.arrival)
            unloading.turn =
                back_to_turn(unloading.motion, unloading.arrival->state, unloading.motion.equilibrium);
        return unloading;
    }

    const PlasticMotion<Extended>& motion_;
};

/// Every greatest contact, in u, at which captured and rebounding impacts meet, ascending.
std::vector<double> critical_contacts(const PlasticCapture& capture, double yield, double farthest) {
    std::vector<double> contacts;
    double lower = yield;
    double margin = capture.margin(lower);
    if (margin < 0.0 && margin > -1.0) contacts.push_back(lower * (1.0 + margin));  // on the elastic branch
    while (lower < farthest) {
        const double u = lower * scan_ratio;
        const double next = capture.margin(u);
        if ((next > 0.0) != (margin > 0.0))
            contacts.push_back(gsl::brent([&](double x) { return capture.margin(x); }, lower, u).root);
        lower = u;
        margin = next;
    }
    return contacts;
}

}  // namespace

CriticalImpacts critical_impacts(const PlasticMotion<Extended>& motion, Extended farthest) {
    const PlasticCapture capture(motion);
    const Motion<Extended>& loading = motion.loading();
    const auto yield = static_cast<double>(motion.yield());
    double farthest_contact = yield;
    while (loading.overlap(loading.coordinate(farthest_contact)) < farthest) farthest_contact *= scan_ratio;
    CriticalImpacts found;
    for (const double u : critical_contacts(capture, yield, farthest_contact))
        found.impacts.push_back(capture.impact_through(u));
    if (found.impacts.empty())
        found.verdict =
            capture.margin(yield) > 0.0 ? CaptureVerdict::always_captured : CaptureVerdict::never_captured;
    return found;
}

}  // namespace ashimpact
