// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/motion/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "core/error.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/maugis/cohesive_ringing.hpp"
#include "solver/motion/orbit.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

/// Turns a scaled state into a point.
using PointMaker = std::function<TrajectoryPoint(const MotionState<Extended>&)>;

/// One Taylor step of a followed impact.
struct Piece {
    std::shared_ptr<const PointMaker> point;
    MotionExpansion<Extended> expansion;
    Extended used;
    Extended end_time;
};

/// Keeps the pieces of a followed impact, one point maker for each branch. @tparam Sampler turns branch and
/// state into a point
template <class Sampler>
struct Recorder {
    const Sampler& sampler;
    std::vector<Piece> pieces{};
    const void* last = nullptr;

    template <class Branch>
    void operator()(const Branch& branch, const MotionExpansion<Extended>& x, Extended used) {
        const bool same = &branch == last;
        last = &branch;
        pieces.push_back({same ? pieces.back().point : maker(branch), x, used, value(x.time, used)});
    }

  private:
    template <class Branch>
    [[nodiscard]] std::shared_ptr<const PointMaker> maker(const Branch& branch) const {
        return std::make_shared<const PointMaker>(
            [this_sampler = sampler, branch](const MotionState<Extended>& s) {
                return this_sampler.at(branch, s);
            });
    }
};

/// The pieces of a captured particle's ringing after @p state, until it rests to 1 % or @p most pieces.
template <class Sampler>
void ring(const Motion<Extended>& motion, MotionState<Extended> state, std::size_t most,
          Recorder<Sampler>& record) {
    const MotionStepper<Extended> stepper(motion);
    record.last = nullptr;  // the branch may have moved
    const Extended rest = motion.potential(motion.equilibrium);
    const auto energy = [&](const MotionState<Extended>& s) {
        return s.velocity * s.velocity / 2 + motion.potential(s.position) - rest;
    };
    for (std::size_t i = 0; i < most && energy(state) > 0.5e-4_ext; ++i) {
        const MotionExpansion<Extended> x = stepper.expand(state);
        state = x.at(x.step);
        record(motion, x, x.step);
    }
}

/// Pseudo-time within the piece at which its time series reaches @p time.
Extended pseudo_time(const Piece& piece, Extended time) {
    if (time <= piece.expansion.time[0]) return 0;
    if (time >= piece.end_time) return piece.used;
    return sign_change<Extended>([&](Extended h) { return time - value(piece.expansion.time, h); },
                                 piece.used);
}

/// Turns scaled states into points with their forces.
class Sampler {
  public:
    Sampler(const Impact& impact, const Scale& scale) : law_(impact.law), scale_(scale) {
        adhesion_ = law_.visit<double>([&]<template <class> class L>() {
            return L<double>::adhesion_number(impact.contact, scale.length);
        });
    }

    [[nodiscard]] TrajectoryPoint at(const Motion<Extended>& motion, const MotionState<Extended>& s) const {
        const Extended u = motion.root_radius(s.position);
        const Extended force = motion.force(s.position);
        const Extended attraction = attraction_at(u, force);
        const auto newton = [&](Extended f) { return static_cast<double>(f) * scale_.force(); };
        return {.time = static_cast<double>(s.time) * scale_.time(),
                .overlap = static_cast<double>(motion.overlap(s.position)) * scale_.length,
                .velocity = static_cast<double>(s.velocity) * scale_.velocity,
                .contact_radius = static_cast<double>(u * u) * scale_.radius_length,
                .repulsive_force = newton(std::max(0.0_ext, force - attraction)),
                .attractive_force = newton(attraction),
                .damping_force = newton(motion.damping(s.position) * s.velocity)};
    }

  private:
    /// The law's attraction; that of a plastic law depends on the force, which tells its branches apart.
    [[nodiscard]] Extended attraction_at(Extended u, Extended force) const {
        const Extended adhesion = adhesion_;
        return law_.visit<Extended>([&]<template <class> class L>() -> Extended {
            if constexpr (requires(L<Extended> law) { law.attractive_force(u, force); })
                return L<Extended>{adhesion}.attractive_force(u, force);
            else if constexpr (has_polynomials<L>)
                return L<Extended>{adhesion}.attractive_force(u);
            else
                return 0;  // without adhesion, or it would have a cohesive zone
        });
    }

    Law law_;
    Scale scale_;
    double adhesion_;
};

/// The same for an impact with a cohesive zone: the repulsion is the Hertz part a^3, the rest attraction.
struct CohesiveSampler {
    Scale scale;

    template <class Branch>
    [[nodiscard]] TrajectoryPoint at(const Branch& branch, const MotionState<Extended>& s) const {
        const Extended a = branch.state(s.position).contact_radius();
        const Extended repulsion = a * a * a;
        const auto newton = [&](Extended f) { return static_cast<double>(f) * scale.force(); };
        return {.time = static_cast<double>(s.time) * scale.time(),
                .overlap = static_cast<double>(branch.overlap(s.position)) * scale.length,
                .velocity = static_cast<double>(s.velocity) * scale.velocity,
                .contact_radius = static_cast<double>(a) * scale.radius_length,
                .repulsive_force = newton(repulsion),
                .attractive_force = newton(std::min(0.0_ext, branch.force(s.position) - repulsion)),
                .damping_force = newton(branch.damping(s.position) * s.velocity)};
    }
};

std::vector<Piece> cohesive_pieces(const Impact& impact, std::size_t most) {
    const auto [scale, motion, velocity] = scaled_cohesive_impact(impact);
    const CohesiveSampler sampler{scale};
    Recorder<CohesiveSampler> record{sampler};
    const CohesiveOrbit followed = follow_cohesive(motion, velocity, record);
    if (followed.orbit.outcome == Outcome::capture) ring(motion, followed, velocity, most, record);
    return record.pieces;
}

/// The pieces of the impact, and of its ringing where it is captured.
std::vector<Piece> recorded(const Impact& impact, const Scale& scale, std::size_t most) {
    if (is_cohesive(impact.law, impact.contact)) return cohesive_pieces(impact, most);
    const Sampler sampler(impact, scale);
    Recorder<Sampler> record{sampler};
    if (can_yield(impact.law, impact.contact)) {
        const auto followed = follow_plastic(scaled_plastic_motion<Extended>(impact, scale), 1.0_ext, record);
        if (followed.orbit.outcome == Outcome::capture) ring(followed.path, followed.orbit.end, most, record);
        return record.pieces;
    }
    const auto motion = scaled_motion<Extended>(impact, scale);
    const Orbit<Extended> orbit = follow(motion, 1.0_ext, record);
    if (orbit.outcome == Outcome::capture) ring(motion, orbit.end, most, record);
    return record.pieces;
}

}  // namespace

std::vector<TrajectoryPoint> trajectory(const Impact& impact, int count) {
    validate(impact);
    if (count < 2) throw InputError("trajectory has " + std::to_string(count) + " points", "at least 2");
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const std::vector<Piece> pieces = recorded(impact, scale, static_cast<std::size_t>(count));
    const Extended last = pieces.back().end_time;
    std::vector<TrajectoryPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    std::size_t at = 0;
    for (int i = 0; i < count; ++i) {
        const Extended time = last * i / (count - 1);
        while (at + 1 < pieces.size() && pieces[at].end_time < time) ++at;
        const Piece& piece = pieces[at];
        points.push_back((*piece.point)(piece.expansion.at(pseudo_time(piece, time))));
    }
    return points;
}

}  // namespace ashimpact
