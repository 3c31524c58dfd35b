// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/oblique/oblique_batch.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/text/error.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/batch/problems.hpp"
#include "solver/motion/trajectory.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t tangential_chunk = 256;

double at(const Column& column, std::size_t i) {
    return column[column.size() == 1 ? 0 : static_cast<Eigen::Index>(i)];
}

/// The impulse that friction acts on; the attraction counts where without it the sphere would slide
/// throughout. @param needed impulse of the push at which the slip just ends [N s]
double push_of(const Impact& impact, double restitution, double needed) {
    const double net = impact.contact.mass * (1 + restitution) * impact.velocity;
    if (net >= needed || !impact.law.is_adhesive()) return net;
    try {
        return net + attraction_impulse(impact);
    } catch (const InputError&) {  // at the edge of capture, where the two solvers may disagree
        return net;
    }
}

}  // namespace

void solve_tangential(const ImpactBatch& normal, const double* restitution, std::size_t count,
                      const TangentialColumns& tangential, const TangentialOutputs& outputs, int threads) {
    const batch::Problems problems = batch::problems_of(
        normal.law, normal.detachment, normal.damping_law, normal.contact,
        {{&batch::Inputs::damping, normal.damping}, {&batch::Inputs::velocity, normal.velocity}});
    const auto solve = [&](std::size_t i) {
        const double mu = at(tangential.friction, i);
        const TangentialMotion before{at(tangential.velocity, i), at(tangential.spin, i)};
        require_tangential(before, mu);
        const auto set = [i](double* column, double value) {
            if (column != nullptr) column[i] = value;
        };
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        if (!(restitution[i] > 0)) {
            for (double* column :
                 {outputs.velocity, outputs.spin, outputs.rebound_angle, outputs.impulse_ratio})
                set(column, none);
            set(outputs.restitution, before.velocity == 0 ? none : 0);
            set(outputs.regime, static_cast<double>(SlidingRegime::captured));
            return;
        }
        const Impact impact = problems.impact(i);
        const double mass = impact.contact.mass;
        const ContactBodies bodies{
            .sphere = {at(tangential.sphere_radius, i), at(tangential.sphere_mass, i)}};
        const double slip = before.velocity + bodies.sphere.radius * before.spin;
        const double push =
            mu > 0 && slip != 0 ? push_of(impact, restitution[i], rolling_impulse(mass, slip) / mu) : 0;
        const TangentialRebound rebound = tangential_rebound(bodies, mass, before, mu, push);
        const ReboundRatios ratios =
            rebound_ratios(before, rebound, mass, impact.velocity, restitution[i] * impact.velocity);
        set(outputs.velocity, rebound.after.velocity);
        set(outputs.spin, rebound.after.spin);
        set(outputs.restitution, ratios.tangential_restitution.value_or(none));
        set(outputs.rebound_angle, ratios.rebound_angle);
        set(outputs.impulse_ratio, ratios.impulse_ratio);
        set(outputs.regime, static_cast<double>(rebound.regime));
    };
    batch::for_chunks(count, tangential_chunk, threads, [&](std::size_t first, std::size_t size) {
        for (std::size_t i = first; i < first + size; ++i) {
            try {
                solve(i);
            } catch (const InputError& error) {
                throw InputError(error.problem(), error.allowed()).at("impact " + std::to_string(i));
            }
        }
    });
}

}  // namespace ashimpact
