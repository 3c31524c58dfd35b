// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/law.hpp"
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
    [[nodiscard]] double critical_velocity() const {
        return *model.critical_velocity_anywhere(critical_damping());
    }

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

/// A true damping curve for the 96 um sample of Dong et al. 2013.
enum class TrueDamping {
    quadratic,    ///< the law's row of Table 2; that of Brach-Dunn for laws without one
    exponential,  ///< c (0.35 + 0.65 exp(-2.4 e))
    bent,         ///< c (1 - 0.7 e - 0.2 tanh(4 e) + 0.2 e^2)
};

/// The contact of the 96 um sample.
inline const ContactPair ash_pair{.mass = sphere_mass(48e-6, 2158.5),
                                  .effective_radius = 48e-6,
                                  .contact_modulus = 90e9,
                                  .work_of_adhesion = 0.2959};

/// The laws with and without adhesion whose damping can be found from impacts.
inline const std::array fitted_laws{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()};

/// Impacts by v_in and v_r. @param u standard uncertainty of both; 0: not known
[[nodiscard]] MeasurementSet set_of(const std::vector<std::pair<double, double>>& impacts, double u = 0.0);

/// A map of a law for ash_pair, around the velocities of its impacts.
[[nodiscard]] ContactModel ash_model(Law law);

/// 60 impacts between 0.6 and 3 times v_c, seen by the paper's camera (80,000 frames/s) with pixels of 8 um
/// and 5 frames for each velocity: 0.058 m/s.
[[nodiscard]] SyntheticLaboratory ash_laboratory(const ContactModel& model, TrueDamping damping);

}  // namespace ashimpact::test
