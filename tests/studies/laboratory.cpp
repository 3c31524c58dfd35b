// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/studies/laboratory.hpp"

#include <algorithm>
#include <cmath>

#include "solver/numeric/gsl/statistics.hpp"

namespace ashimpact::studies {

namespace {

constexpr double told = 0.03;  ///< standard uncertainty of both velocities [m/s]
constexpr double size_scatter = 0.05;
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
    static const std::vector<Row> all{{"quadratic", quadratic_in_restitution, Flaw::none},
                                      {"v^-0.35", power_of_velocity, Flaw::none},
                                      {"bump", bump_in_velocity, Flaw::none},
                                      {"2 % each, v^-0.35", power_of_velocity, Flaw::proportional},
                                      {"camera", quadratic_in_restitution, Flaw::camera},
                                      {"nothing told", quadratic_in_restitution, Flaw::nothing_told},
                                      {"scatter of size", quadratic_in_restitution, Flaw::scatter_of_size},
                                      {"outliers", quadratic_in_restitution, Flaw::outliers},
                                      {"8 impacts", quadratic_in_restitution, Flaw::few}};
    return all;
}

Laboratories::Laboratories(const Row& row, oracles::Law law) : row_(row) {
    if (row.flaw != Flaw::scatter_of_size) {
        curves_.emplace_back(law, row.damping);
        return;
    }
    for (int i = 0; i < sizes; ++i) {
        const double z = gsl::normal_quantile((i + 0.5) / sizes);
        curves_.emplace_back(law, row.damping, 1.0 + size_scatter * z);
    }
    nominal_ = sizes / 2;
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
    const double u = proportional ? 0.02 * velocity : told;
    const double rebound_u = proportional ? 0.02 * std::max(rebound, 1e-3) : told;
    Measurement point{.velocity = velocity + random.normal(u), .rebound = 0.0};
    // The particle is seen to leave, so that a reading of zero or below is written as a very small one.
    if (rebound > 0.0) point.rebound = std::max(1e-6, rebound + random.normal(rebound_u));
    if (row_.flaw == Flaw::outliers && random.uniform(0.0, 1.0) < 0.05)
        point.rebound = random.uniform(0.0, point.velocity);
    if (row_.flaw != Flaw::nothing_told && row_.flaw != Flaw::scatter_of_size)
        point.noise = proportional ? VelocityNoise::of_velocities(0.02 * point.velocity,
                                                                  0.02 * std::max(point.rebound, 1e-3))
                                   : VelocityNoise::of_velocities(told, told);
    return point;
}

MeasurementSet Laboratories::measure(test::Random& random) const {
    const double critical = critical_velocity();
    const int impacts = row_.flaw == Flaw::few ? 8 : static_cast<int>(random.uniform(15.0, 61.0));
    const bool evenly = random.uniform(0.0, 1.0) < 0.5;
    MeasurementSet set{.source = "laboratory", .points = {}};
    while (static_cast<int>(set.points.size()) < impacts) {
        const double velocity = evenly ? random.uniform(0.3 * critical, 8.0 * critical)
                                       : 0.3 * critical * std::exp(random.uniform(0.0, std::log(8.0 / 0.3)));
        const Measurement point = seen(random, velocity, velocity * particle(random).restitution(velocity));
        if (point.velocity > 0.0) set.points.push_back(point);
    }
    return row_.flaw == Flaw::camera ? with_camera(std::move(set), camera_) : set;
}

}  // namespace ashimpact::studies
