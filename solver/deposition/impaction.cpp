// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/deposition/impaction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "core/text/error.hpp"
#include "solver/numeric/gsl/solvers.hpp"
#include "solver/numeric/number.hpp"

namespace ashimpact {

namespace {

constexpr double path_tolerance = 1e-10;    ///< of one step, relative and in radii
constexpr double longest_path_step = 0.25;  ///< in distances from the axis, so that no step skips the tube
constexpr double nearest_start = 40;        ///< of a path [radii]
constexpr double start_error = 1e-7;        ///< of the offset, relative
constexpr int most_path_steps = 1'000'000;
constexpr double least_offset = 1e-5;  ///< critical offsets below count as 0
constexpr double offset_accuracy = 1e-10;
constexpr int paths = 32;  ///< beside the first

/// Position and velocity [radii, U].
using PathState = std::array<double, 4>;
using PathStepper = boost::numeric::odeint::runge_kutta_fehlberg78<PathState>;

double distance_of(const PathState& state) {
    return std::sqrt(state[0] * state[0] + state[1] * state[1]);
}
/// Distance times its rate of change.
double opening_of(const PathState& state) {
    return state[0] * state[2] + state[1] * state[3];
}

/// Velocity of the gas, u - iv = 1 - 1/z^2.
std::array<double, 2> gas_at(double x, double y) {
    const double squared = x * x + y * y;
    const double share = 1 / (squared * squared);
    return {1 - (x * x - y * y) * share, -2 * x * y * share};
}

/// The motion of a particle that drag alone accelerates.
class PathMotion {
  public:
    explicit PathMotion(const TubeParticle& particle) : particle_(particle) {}

    void operator()(const PathState& state, PathState& rate, double /*time*/) const {
        const auto [u, v] = gas_at(state[0], state[1]);
        const double slip_x = u - state[2];
        const double slip_y = v - state[3];
        const double reynolds = particle_.reynolds * std::sqrt(slip_x * slip_x + slip_y * slip_y);
        const double drag = particle_.drag.factor(reynolds) / particle_.stokes;
        rate = {state[2], state[3], drag * slip_x, drag * slip_y};
    }

  private:
    TubeParticle particle_;
};

TubePassage passage_at(const PathState& state, bool arrives) {
    const double distance = distance_of(state);
    TubePassage passage{.arrives = arrives,
                        .angle = std::atan2(state[1], -state[0]),
                        .tangent = (state[1] * state[2] - state[0] * state[3]) / distance};
    if (arrives)
        passage.normal = -opening_of(state) / distance;
    else
        passage.gap = distance - 1;
    return passage;
}

/// The start of a path: the asymptotic solution far upstream in powers of S/distance. The gas there is
/// pushed aside with 2 y/|x|^3; a particle lags behind by S times the rate of that, 6 S y/x^4, so its offset
/// on the streamlines shrinks by 2 S/|x|^3 of itself. The next term, 6 S^2/x^4, is neglected.
PathState path_start_of(const TubeParticle& particle, double offset) {
    const double stokes = particle.stokes;
    const double x = -std::max(nearest_start, std::pow(6 * stokes * stokes / start_error, 0.25));
    const double streamline = offset * (1 + 2 * stokes / (x * x * x));
    double y = offset;
    for (int i = 0; i < 4; ++i) y = streamline / (1 - 1 / (x * x + y * y));
    const auto [u, v] = gas_at(x, y);
    return {x, y, u, v - 6 * stokes * y / (x * x * x * x)};
}

/// The error of a step over that allowed.
double excess_of(const PathState& error, const PathState& state) {
    double excess = 1e-10;
    for (std::size_t k = 0; k < error.size(); ++k)
        excess = std::max(excess, std::abs(error[k]) / (path_tolerance * (1 + std::abs(state[k]))));
    return excess;
}

}  // namespace

TubePassage tube_passage(const TubeParticle& particle, double offset) {
    const PathMotion motion(particle);
    PathStepper stepper;
    PathState state = path_start_of(particle, offset);
    PathState closest = state;
    double next = 0.1 * std::min(1.0, particle.stokes);
    for (int i = 0; i < most_path_steps; ++i) {
        const PathState before = state;
        double end = std::min(next, longest_path_step * distance_of(before));
        PathState error{};
        stepper.do_step(motion, before, 0.0, state, end, error);
        const double excess = excess_of(error, state);
        next = end * std::clamp(0.9 * std::pow(excess, -1.0 / 8), 0.2, 5.0);
        if (excess > 1) {
            state = before;
            continue;
        }
        const auto after = [&](double part) {
            PathState reached = before;
            stepper.do_step(motion, reached, 0.0, part);
            return reached;
        };
        const bool turns = opening_of(before) < 0 && opening_of(state) >= 0;
        if (turns) end = sign_change<double>([&](double part) { return opening_of(after(part)); }, end);
        const PathState nearest = turns ? after(end) : state;
        if (distance_of(nearest) < 1)
            return passage_at(
                after(sign_change<double>([&](double part) { return distance_of(after(part)) - 1; }, end)),
                true);
        if (distance_of(nearest) < distance_of(closest)) closest = nearest;
        // Behind the front half neither gas nor inertia brings a receding particle back.
        if (state[0] >= 0 && opening_of(state) >= 0) return passage_at(closest, false);
    }
    throw ConvergenceError("a particle does not pass the tube: its Stokes number is " +
                           std::to_string(particle.stokes));
}

TubeImpaction::TubeImpaction(const TubeParticle& particle) {
    if (particle.stokes <= least_stokes) return;
    // Linear in the distance from the critical offset on both sides of it.
    const auto excess = [&](double offset) {
        const TubePassage passage = tube_passage(particle, offset);
        return passage.arrives ? -passage.normal * passage.normal : passage.gap;
    };
    if (excess(least_offset) >= 0) return;
    critical_offset_ =
        excess(1) <= 0 ? 1 : gsl::brent(excess, least_offset, 1, {.relative = offset_accuracy}).root;
    std::vector<double> tangents;
    for (int i = 0; i <= paths; ++i) {
        const double place = std::numbers::pi / 2 * i / paths;
        const TubePassage passage = tube_passage(particle, critical_offset_ * std::sin(place));
        places_.push_back(place);
        normals_.push_back(i == paths ? 0 : passage.normal);
        tangents.push_back(passage.tangent);
        angles_.push_back(passage.angle);
    }
    normal_.emplace(places_, normals_);
    tangent_.emplace(places_, tangents);
    angle_.emplace(places_, angles_);
}

TubePassage TubeImpaction::at_offset(double offset) const {
    const double place = std::asin(std::clamp(offset / critical_offset_, 0.0, 1.0));
    return {.arrives = true,
            .angle = (*angle_)(place),
            .normal = (*normal_)(place),
            .tangent = (*tangent_)(place)};
}

double TubeImpaction::offset_of_angle(double angle) const {
    if (!any() || angle <= angles_.front()) return 0;
    if (angle >= angles_.back()) return critical_offset_;
    const auto above = std::ranges::upper_bound(angles_, angle) - angles_.begin();
    const double from = places_[static_cast<std::size_t>(above - 1)];
    const double place =
        from + sign_change<double>([&](double part) { return (*angle_)(from + part) - angle; },
                                   places_[static_cast<std::size_t>(above)] - from);
    return critical_offset_ * std::sin(place);
}

std::vector<OffsetRange> TubeImpaction::slower_than(double normal) const {
    std::vector<OffsetRange> ranges;
    constexpr double least = 1e-12;  // their share is some 1e-24
    if (!(normal > least)) return ranges;
    const auto add = [&](double from, double to) {
        if (!ranges.empty() && ranges.back().to == from)
            ranges.back().to = to;
        else
            ranges.push_back({from, to});
    };
    const auto offset = [&](double place) { return critical_offset_ * std::sin(place); };
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
        const bool begins = normals_[i] < normal;
        const bool ends = normals_[i + 1] < normal;
        if (!begins && !ends) continue;
        double crossing = places_[i];
        if (begins != ends)
            crossing += sign_change<double>([&](double part) { return (*normal_)(crossing + part) - normal; },
                                            places_[i + 1] - crossing);
        add(offset(begins ? places_[i] : crossing), offset(ends ? places_[i + 1] : crossing));
    }
    return ranges;
}

}  // namespace ashimpact
