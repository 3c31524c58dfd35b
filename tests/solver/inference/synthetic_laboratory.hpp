// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "solver/inference/impacts/measurement.hpp"
#include "solver/surrogate/contact_model.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::test {

/// A laboratory whose particles follow a known law and damping: what the statistics must find again.
struct SyntheticLaboratory {
    const ContactModel& model;
    std::function<double(double)> damping;  ///< eta(e_n) [kg/s]
    double slowest;                         ///< v_in are drawn evenly from here ... [m/s]
    double fastest;                         ///< ... to here [m/s]
    int impacts;
    Camera camera;

    [[nodiscard]] double critical_damping() const { return damping(0.0); }
    [[nodiscard]] double critical_velocity() const { return *model.critical_velocity(critical_damping()); }

    /// Restitution at a velocity: the impact with eta(e) gives e back.
    [[nodiscard]] double restitution(double velocity) const {
        if (model.damping(velocity, 0.0).value <= damping(0.0)) return 0.0;
        double lower = 0.0;
        double upper = 0.999 * model.greatest_restitution(velocity);
        for (int i = 0; i < 60; ++i) {
            const double e = 0.5 * (lower + upper);
            (model.damping(velocity, e).value > damping(e) ? lower : upper) = e;
        }
        return lower;
    }

    /// One series of measurements, a new one each time.
    [[nodiscard]] MeasurementSet measure(Random& random) const {
        const double u = camera.velocity_uncertainty();
        MeasurementSet set{.source = "synthetic", .points = {}};
        for (int i = 0; i < impacts; ++i) {
            const double velocity = random.uniform(slowest, fastest);
            const double rebound = velocity * restitution(velocity);
            Measurement point{.velocity = velocity + random.normal(u), .rebound = 0.0};
            if (rebound > 0.0) point.rebound = std::max(1e-6, rebound + random.normal(u));
            point.noise = VelocityNoise::of_velocities(u, u);
            set.points.push_back(point);
        }
        return set;
    }
};

}  // namespace ashimpact::test
