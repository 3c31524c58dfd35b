// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/studies/laboratory.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/inference/critical_velocity_uncertainty.hpp"
#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact::studies {

namespace {

constexpr double told = 0.03;  ///< standard uncertainty of both velocities [m/s]
constexpr double size_scatter = 0.05;
constexpr double adhesion_scatter = 0.2;
constexpr double threshold_scatter = 0.1;
constexpr double scale_uncertainty = 0.03;
constexpr double slow = 0.1;  ///< rebounds that some laboratories lose [m/s]
constexpr int sizes = 21;

/// A velocity as the slope of positions, each read to a whole pixel.
double by_camera(test::Random& random, const Camera& camera, double velocity) {
    const double step = velocity / (camera.frame_rate * camera.pixel_size);
    const double start = random.uniform(0.0, 1.0);
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < camera.frames; ++i) {
        const double time = i - 0.5 * (camera.frames - 1);
        sum += time * std::floor(start + step * i);
        squares += time * time;
    }
    return sum / squares * camera.frame_rate * camera.pixel_size;
}

}  // namespace

const std::vector<Row>& rows() {
    using enum TrueDamping;
    constexpr Truth quadratic{quadratic_in_restitution};
    static const std::vector<Row> all{{"quadratic", quadratic, Flaw::none},
                                      {"v^-0.35", {power_of_velocity, -0.35}, Flaw::none},
                                      {"bump", {bump_in_velocity}, Flaw::none},
                                      {"2 % each, v^-0.35", {power_of_velocity, -0.35}, Flaw::proportional},
                                      {"camera", quadratic, Flaw::camera},
                                      {"nothing told", quadratic, Flaw::nothing_told},
                                      {"scatter of size", quadratic, Flaw::scatter_of_size},
                                      {"outliers", quadratic, Flaw::outliers},
                                      {"8 impacts", quadratic, Flaw::few},
                                      {"v^-1.2", {power_of_velocity, -1.2}, Flaw::none},
                                      {"v^-0.8", {power_of_velocity, -0.8}, Flaw::none},
                                      {"v^0", {power_of_velocity, 0.0}, Flaw::none},
                                      {"v^0.1", {power_of_velocity, 0.1}, Flaw::none},
                                      {"v^0.2", {power_of_velocity, 0.2}, Flaw::none, false},
                                      {"v^0.6", {power_of_velocity, 0.6}, Flaw::none, false},
                                      {"contact-radius", {contact_radius}, Flaw::none, false},
                                      {"hunt-crossley", {hunt_crossley}, Flaw::none, false},
                                      {"two terms", {two_terms, 10.0}, Flaw::none, false},
                                      {"sharp onset, e0 0.6", {sharp_onset, 0.6}, Flaw::none},
                                      {"sharp onset, e0 0.9", {sharp_onset, 0.9}, Flaw::none},
                                      {"Thornton-Ning", {thornton_ning, 0.5}, Flaw::none},
                                      {"sharp, 5 % outliers", {sharp_onset, 0.6}, Flaw::outliers},
                                      {"scatter of w", quadratic, Flaw::scatter_of_adhesion},
                                      {"scatter of v_c", quadratic, Flaw::scatter_of_threshold},
                                      {"slow ones lost", quadratic, Flaw::slow_lost},
                                      {"slow ones captured", quadratic, Flaw::slow_captured},
                                      {"no captures", quadratic, Flaw::no_captures},
                                      {"no captures, sharp", {sharp_onset, 0.6}, Flaw::no_captures},
                                      {"5 impacts", quadratic, Flaw::very_few},
                                      {"20,000 impacts", quadratic, Flaw::many},
                                      {"20,000 sharp", {sharp_onset, 0.6}, Flaw::many},
                                      {"scale 3 %", quadratic, Flaw::scale},
                                      {"w of twice", quadratic, Flaw::wrong_adhesion},
                                      {"oblique to 20", quadratic, Flaw::oblique}};
    return all;
}

namespace {

/// The contact as a laboratory states it, which may have measured twice the true w.
ContactPair stated_contact(const Row& row) {
    const double w = 0.2959 * (row.flaw == Flaw::wrong_adhesion ? 2.0 : 1.0);
    return random_contact({.diameter = {"diameter", 96e-6},
                           .density = RandomInput{"density", 2158.5},
                           .work_of_adhesion = {"work of adhesion", w},
                           .contact_modulus = RandomInput{"contact modulus", 90e9}})
        .nominal();
}

}  // namespace

ContactModel model_of(const Row& row, const Law& law, double critical_velocity) {
    return make_contact_model(law, law.default_detachment(), stated_contact(row),
                              {0.02 * critical_velocity, 40.0 * critical_velocity});
}

EstimateOptions options_of(const Row& row) {
    EstimateOptions options;
    if (row.flaw == Flaw::scale) options.scale_uncertainty = scale_uncertainty;
    return options;
}

Laboratories::Laboratories(const Row& row, Law law) : row_(row) {
    const auto share = [&](double z) -> Particle {
        if (row.flaw == Flaw::scatter_of_size) return {.diameter = 1.0 + size_scatter * z};
        if (row.flaw == Flaw::scatter_of_adhesion) return {.adhesion = std::exp(adhesion_scatter * z)};
        return {.threshold = std::exp(threshold_scatter * z)};
    };
    if (!scatters()) {
        curves_.emplace_back(law, row.truth);
    } else {
        for (int i = 0; i < sizes; ++i)
            curves_.emplace_back(law, row.truth, share(gsl::normal_quantile((i + 0.5) / sizes)));
        nominal_ = sizes / 2;
    }
    noise_ = std::min(told, 0.025 * critical_velocity());
}

bool Laboratories::scatters() const {
    return row_.flaw == Flaw::scatter_of_size || row_.flaw == Flaw::scatter_of_adhesion ||
           row_.flaw == Flaw::scatter_of_threshold;
}

const TrueCurve& Laboratories::particle(test::Random& random) const {
    const auto last = static_cast<double>(curves_.size());
    return curves_[std::min(curves_.size() - 1, static_cast<std::size_t>(random.uniform(0.0, last)))];
}

Measurement Laboratories::seen(test::Random& random, double velocity, double rebound) const {
    if (row_.flaw == Flaw::camera) {
        const double seen_velocity = by_camera(random, camera_, velocity);
        return {.velocity = seen_velocity,
                .rebound = rebound > 0.0 ? by_camera(random, camera_, rebound) : 0.0};
    }
    const bool proportional = row_.flaw == Flaw::proportional;
    const double u = proportional ? 0.02 * velocity : noise_;
    const double rebound_u = proportional ? 0.02 * std::max(rebound, 1e-3) : noise_;
    Measurement point{.velocity = velocity + random.normal(u), .rebound = 0.0};
    // The particle is seen to leave, so that a reading of zero or below is written as a very small one.
    if (rebound > 0.0) point.rebound = std::max(1e-6, rebound + random.normal(rebound_u));
    if (row_.flaw == Flaw::outliers && random.uniform(0.0, 1.0) < 0.05)
        point.rebound = random.uniform(0.0, point.velocity);
    if (row_.flaw == Flaw::slow_captured && point.rebound < slow) point.rebound = 0.0;
    if (row_.flaw != Flaw::nothing_told && !scatters())
        point.noise = proportional ? VelocityNoise::of_velocities(0.02 * point.velocity,
                                                                  0.02 * std::max(point.rebound, 1e-3))
                                   : VelocityNoise::of_velocities(noise_, noise_);
    return point;
}

std::size_t Laboratories::impacts(test::Random& random) const {
    switch (row_.flaw) {
        case Flaw::few:
            return 8;
        case Flaw::very_few:
            return 5;
        case Flaw::many:
            return 20'000;
        default:
            return static_cast<std::size_t>(random.uniform(15.0, 61.0));
    }
}

bool Laboratories::is_lost(const Measurement& point) const {
    if (point.velocity <= 0.0) return true;
    if (row_.flaw == Flaw::slow_lost) return point.rebound > 0.0 && point.rebound < slow;
    return row_.flaw == Flaw::no_captures && point.captured();
}

MeasurementSet Laboratories::measure(test::Random& random) const {
    const double critical = critical_velocity();
    const std::size_t impacts = this->impacts(random);
    const bool evenly = random.uniform(0.0, 1.0) < 0.5;
    const double factor = row_.flaw == Flaw::scale ? std::exp(random.normal(scale_uncertainty)) : 1.0;
    MeasurementSet set{.source = "laboratory", .points = {}};
    while (set.points.size() < impacts) {
        const double velocity = evenly ? random.uniform(0.3 * critical, 8.0 * critical)
                                       : 0.3 * critical * std::exp(random.uniform(0.0, std::log(8.0 / 0.3)));
        // Only the normal component takes part in the impact; the tangential one is seen before and after.
        const double angle =
            row_.flaw == Flaw::oblique ? random.uniform(0.0, 20.0 * std::numbers::pi / 180.0) : 0.0;
        const double normal = velocity * std::cos(angle);
        const double rebound = normal * particle(random).restitution(normal);
        const double speed = rebound > 0.0 ? std::hypot(rebound, velocity * std::sin(angle)) : 0.0;
        Measurement point = seen(random, factor * velocity, factor * speed);
        if (!is_lost(point)) set.points.push_back(point);
    }
    return row_.flaw == Flaw::camera ? with_camera(std::move(set), camera_) : set;
}

}  // namespace ashimpact::studies
