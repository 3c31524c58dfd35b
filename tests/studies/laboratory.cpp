// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/studies/laboratory.hpp"

#include <algorithm>
#include <cmath>

#include "solver/numeric/gsl/statistics.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::studies {

namespace {

/// a, b, c of eta = a e^2 + b e + c, 96 um, Table 2 [kg/s].
std::vector<double> table_2(Law law) {
    if (law == Law::of<Hertz>()) return {0.0104, -0.0229, 0.0155};
    if (law == Law::of<Dmt>()) return {0.0115, -0.0235, 0.0156};
    return {0.0101, -0.0213, 0.0149};
}

Impact ash(Law law, double diameter) {
    const double radius = 48e-6 * diameter;
    return {.law = law,
            .detachment = law == Law::of<Jkr>() ? Detachment::pull_off : Detachment::zero_overlap,
            .damping = {},
            .contact = {.mass = sphere_mass(radius, 2158.5),
                        .effective_radius = radius,
                        .contact_modulus = 90e9,
                        .work_of_adhesion = 0.2959},
            .velocity = 1.0};
}

double restitution_of(Impact impact, double velocity, double damping) {
    impact.velocity = velocity;
    impact.damping.coefficient = damping;
    const oracles::OracleResult result = oracles::time_domain_impact(impact);
    return result.rebound ? result.restitution.value : 0.0;
}

/// The velocity above which impacts rebound, by bisection between a capture and a rebound.
double threshold(const std::function<double(double)>& restitution, double captured, double rebounds) {
    while (rebounds > captured * (1.0 + 1e-6)) {
        const double middle = std::sqrt(captured * rebounds);
        (restitution(middle) > 0.0 ? rebounds : captured) = middle;
    }
    return std::sqrt(captured * rebounds);
}

constexpr int places = 70;

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

TrueCurve::TrueCurve(Law law, TrueDamping damping, double diameter) {
    const Impact impact = ash(law, diameter);
    const std::vector<double> abc = table_2(law);
    if (damping == TrueDamping::quadratic_in_restitution) {
        from_restitution(impact, abc);
        return;
    }
    const Impact nominal = ash(law, 1.0);
    const double unit = threshold([&](double v) { return restitution_of(nominal, v, abc[2]); }, 0.02, 20.0);
    const auto power = [=](double v) { return abc[2] * std::pow(v / unit, -0.35); };
    const auto bump = [=](double v) {
        return power(v) * (1.0 + 0.2 * std::exp(-0.5 * std::pow(std::log(v / (2.5 * unit)) / 0.3, 2)));
    };
    if (damping == TrueDamping::power_of_velocity)
        from_velocity(impact, power, unit);
    else
        from_velocity(impact, bump, unit);
}

void TrueCurve::from_restitution(const Impact& impact, const std::vector<double>& abc) {
    critical_velocity_ = threshold([&](double v) { return restitution_of(impact, v, abc[2]); }, 0.005, 50.0);
    velocity_ = {critical_velocity_};
    restitution_ = {0.0};
    double logarithm = std::log(critical_velocity_);
    for (int i = 1; i <= places; ++i) {
        const double e = 0.95 * std::pow(static_cast<double>(i) / places, 1.5);
        const double damping = (abc[0] * e + abc[1]) * e + abc[2];
        const auto excess = [&](double x) { return restitution_of(impact, std::exp(x), damping) - e; };
        double low = logarithm;
        double high = logarithm;
        while (excess(low) > 0.0) low -= 0.05;
        while (excess(high) < 0.0) high += 0.1;
        for (int k = 0; k < 22; ++k) {
            const double middle = 0.5 * (low + high);
            (excess(middle) < 0.0 ? low : high) = middle;
        }
        logarithm = 0.5 * (low + high);
        if (logarithm > std::log(12.0 * critical_velocity_)) break;
        velocity_.push_back(std::exp(logarithm));
        restitution_.push_back(e);
    }
}

void TrueCurve::from_velocity(const Impact& impact, const std::function<double(double)>& damping,
                              double near) {
    const auto restitution = [&](double v) { return restitution_of(impact, v, damping(v)); };
    critical_velocity_ = threshold(restitution, 0.1 * near, 10.0 * near);
    velocity_ = {critical_velocity_};
    restitution_ = {0.0};
    for (int i = 1; i <= 2 * places; ++i) {
        const double share = static_cast<double>(i) / (2 * places);
        velocity_.push_back(critical_velocity_ * (1.0 + 11.0 * share * share * share));
        restitution_.push_back(restitution(velocity_.back()));
    }
}

double TrueCurve::restitution(double velocity) const {
    if (velocity <= critical_velocity_) return 0.0;
    // The fastest branch: where v(e) folds back close to e = 0, e jumps.
    for (std::size_t i = velocity_.size() - 1; i > 0; --i) {
        if (velocity_[i - 1] > velocity) continue;
        const std::size_t j = i;
        if (velocity_[j] <= velocity_[j - 1]) continue;
        const double share = std::min(1.0, (velocity - velocity_[j - 1]) / (velocity_[j] - velocity_[j - 1]));
        return restitution_[j - 1] + share * (restitution_[j] - restitution_[j - 1]);
    }
    return restitution_.back();
}

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

Laboratories::Laboratories(const Row& row, Law law) : row_(row) {
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
