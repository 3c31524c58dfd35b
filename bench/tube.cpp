// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/tube.hpp"

#include <random>

#include <fmt/core.h>

#include "solver/deposition/deposition.hpp"

namespace ashimpact::bench {

namespace {

constexpr double density = 2300;    ///< [kg/m3]
constexpr double sticks_below = 2;  ///< critical velocity of every size [m/s]
constexpr std::size_t drawn_particles = 1'000'000;

/// Draws particles of a distribution and lets each arrive, by the curves of its class. @return those that
/// stay
std::size_t stay_of(const CrossedTube& tube, const std::vector<ClassImpaction>& classes) {
    std::vector<double> shares;
    for (const ClassImpaction& each : classes) shares.push_back(each.size.share);
    std::discrete_distribution<std::size_t> size(shares.begin(), shares.end());
    std::uniform_real_distribution<double> offset;
    std::mt19937_64 random(1);
    std::size_t stay = 0;
    for (std::size_t i = 0; i < drawn_particles; ++i) {
        const TubeImpaction& impaction = classes[size(random)].impaction;
        const double at = offset(random);
        if (impaction.any() && at < impaction.efficiency() &&
            impaction.at_offset(at).normal * tube.velocity < sticks_below)
            ++stay;
    }
    return stay;
}

}  // namespace

void print_tube(const Options& options) {
    const CrossedTube tube{.diameter = 0.038, .velocity = 12, .gas = air_at(1173.15)};
    const auto sizes = ParticleSizes::rosin_rammler(20e-6, 1.2).classes(80, tube.finest_arriving(density));
    std::vector<TubeParticle> particles;
    for (const SizeClass& size : sizes) particles.push_back(tube.particle(size.diameter(), density));
    const auto classes = impactions_on(tube, sizes, std::vector<double>(sizes.size(), density));
    std::size_t stay = 0;
    const auto rates = rates_of(
        {{"sizes", static_cast<double>(sizes.size()),
          [&] {
              for (const TubeParticle& each : particles) TubeImpaction{each};
          }},
         {"particles", static_cast<double>(drawn_particles), [&] { stay = stay_of(tube, classes); }}},
        options);
    fmt::print(
        "\na tube across a flow of ash: {:.0f} sizes/s (critical offset and curves), {:.2g} particles/s one "
        "by one, {} with {} sizes in {:.2f} s; {} stay\n",
        rates.at("sizes"), rates.at("particles"), drawn_particles, sizes.size(),
        static_cast<double>(sizes.size()) / rates.at("sizes") + drawn_particles / rates.at("particles"),
        stay);
}

}  // namespace ashimpact::bench
