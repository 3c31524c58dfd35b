#include "solver/trajectory.hpp"

#include "materials/error.hpp"
#include "solver/orbit.hpp"
#include "solver/scaled_impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace ashimpact {

namespace {

/// One Taylor step of a followed impact.
struct Piece {
    MotionExpansion<Extended> expansion;
    Extended used;
    Extended end_time;
};

/// The pieces of a captured particle's ringing after @p state, until it rests to 1 % or @p most pieces.
void ring(const Motion<Extended>& motion, MotionState<Extended> state, std::size_t most,
          std::vector<Piece>& pieces) {
    const MotionStepper<Extended> stepper(motion);
    const Extended rest = motion.potential(motion.equilibrium);
    const auto energy = [&](const MotionState<Extended>& s) {
        return s.velocity * s.velocity / 2 + motion.potential(s.position) - rest;
    };
    for (std::size_t i = 0; i < most && energy(state) > 0.5e-4L; ++i) {
        const MotionExpansion<Extended> x = stepper.expand(state);
        state = x.at(x.step);
        pieces.push_back({x, x.step, state.time});
    }
}

/// Pseudo-time within the piece at which its time series reaches @p time.
Extended pseudo_time(const Piece& piece, Extended time) {
    if (time <= piece.expansion.time[0]) return 0;
    if (time >= piece.end_time) return piece.used;
    return sign_change<Extended>([&](Extended h) { return time - value(piece.expansion.time, h); },
                                 piece.used);
}

class Sampler {
  public:
    Sampler(const Impact& impact, const Motion<Extended>& motion, const Scale& scale)
        : law_(impact.law), motion_(motion), scale_(scale) {
        adhesion_ = law_.visit<double>([&]<template <class> class L>() {
            return L<double>::adhesion_number(impact.contact, scale.length);
        });
    }

    [[nodiscard]] TrajectoryPoint at(const MotionState<Extended>& s) const {
        const Extended u = motion_.root_radius(s.position);
        const Extended attraction = law_.visit<Extended>(
            [&]<template <class> class L>() { return L<Extended>{Extended(adhesion_)}.attractive_force(u); });
        const Extended force = motion_.force(s.position);
        const auto newton = [&](Extended f) { return static_cast<double>(f) * scale_.force(); };
        return {.time = static_cast<double>(s.time) * scale_.time(),
                .overlap = static_cast<double>(motion_.overlap(s.position)) * scale_.length,
                .velocity = static_cast<double>(s.velocity) * scale_.velocity,
                .contact_radius = static_cast<double>(u * u) * scale_.radius_length,
                .repulsive_force = newton(std::max(0.0L, force - attraction)),
                .attractive_force = newton(attraction),
                .damping_force = newton(motion_.damping(s.position) * s.velocity)};
    }

  private:
    Law law_;
    const Motion<Extended>& motion_;
    const Scale& scale_;
    double adhesion_;
};

}  // namespace

std::vector<TrajectoryPoint> trajectory(const Impact& impact, int count) {
    validate(impact);
    if (count < 2) throw InputError("trajectory has " + std::to_string(count) + " points", "at least 2");
    const Scale scale = Scale::of(impact.contact, impact.velocity);
    const Motion<Extended> motion = scaled_motion<Extended>(impact, scale);
    std::vector<Piece> pieces;
    const Orbit<Extended> orbit =
        follow(motion, 1.0L, [&](const auto&, const MotionExpansion<Extended>& x, Extended used) {
            pieces.push_back({x, used, value(x.time, used)});
        });
    if (orbit.outcome == Outcome::capture) ring(motion, orbit.end, static_cast<std::size_t>(count), pieces);

    const Sampler sampler(impact, motion, scale);
    const Extended last = pieces.back().end_time;
    std::vector<TrajectoryPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    std::size_t at = 0;
    for (int i = 0; i < count; ++i) {
        const Extended time = last * i / (count - 1);
        while (at + 1 < pieces.size() && pieces[at].end_time < time) ++at;
        points.push_back(sampler.at(pieces[at].expansion.at(pseudo_time(pieces[at], time))));
    }
    return points;
}

}  // namespace ashimpact
