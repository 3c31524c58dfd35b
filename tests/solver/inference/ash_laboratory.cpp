// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solver/inference/ash_laboratory.hpp"

#include <array>
#include <cmath>

namespace ashimpact::test {

namespace {

/// a, b, c of eta = a e^2 + b e + c, 96 um, Table 2 [kg/s].
std::array<double, 3> table_2(Law law) {
    if (law == Law::of<Hertz>()) return {0.0104, -0.0229, 0.0155};
    if (law == Law::of<Dmt>()) return {0.0115, -0.0235, 0.0156};
    return {0.0101, -0.0213, 0.0149};
}

std::function<double(double)> true_damping(Law law, TrueDamping damping) {
    const auto [a, b, c] = table_2(law);
    switch (damping) {
        case TrueDamping::exponential:
            return [c = c](double e) { return c * (0.35 + 0.65 * std::exp(-2.4 * e)); };
        case TrueDamping::bent:
            return [c = c](double e) { return c * (1.0 - 0.7 * e - 0.2 * std::tanh(4.0 * e) + 0.2 * e * e); };
        case TrueDamping::quadratic:
            break;
    }
    return [a = a, b = b, c = c](double e) { return (a * e + b) * e + c; };
}

}  // namespace

MeasurementSet set_of(const std::vector<std::pair<double, double>>& impacts, double u) {
    MeasurementSet set{.source = "lab", .points = {}};
    for (const auto& [velocity, rebound] : impacts) {
        set.points.push_back({.velocity = velocity, .rebound = rebound});
        if (u > 0.0) set.points.back().noise = VelocityNoise::of_velocities(u, u);
    }
    return set;
}

ContactModel ash_model(Law law) {
    return make_contact_model(law, law.default_detachment(), ash_pair, {0.01, 30.0});
}

SyntheticLaboratory ash_laboratory(const ContactModel& model, TrueDamping damping) {
    SyntheticLaboratory laboratory{
        .model = model,
        .damping = true_damping(model.map().law(), damping),
        .slowest = 0.0,
        .fastest = 0.0,
        .impacts = 60,
        .camera = {.frame_rate = 80e3, .pixel_size = 8e-6, .frames = 5},
    };
    laboratory.slowest = 0.6 * laboratory.critical_velocity();
    laboratory.fastest = 3.0 * laboratory.critical_velocity();
    return laboratory;
}

}  // namespace ashimpact::test
