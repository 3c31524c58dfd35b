// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solver/batch/batch_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include "solver/batch/kernels/kernel.hpp"
#include "solver/contact/thornton_ning.hpp"
#include "solver/motion/scale.hpp"
#include "tests/support/contact_cases.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::test {

namespace {

/// Evenly in the logarithm.
double scaled(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform(0.0, 1.0));
}

/// Yield pressure at which adhesion alone yields the contact [Pa].
double pressure_of_adhesive_yield(const Impacts& impacts, Eigen::Index i) {
    using Yielding = ThorntonNing<double>;
    const ContactPair pair{.mass = impacts.mass[i],
                           .effective_radius = impacts.effective_radius[i],
                           .contact_modulus = impacts.contact_modulus[i],
                           .work_of_adhesion = impacts.work_of_adhesion[i],
                           .yield_pressure = 1.0};
    const double length = pair.effective_radius;  // any
    return 0.5 * std::pow(Yielding::adhesion_number(pair, length), 2.0 / 3.0) /
           Yielding::yield_number(pair, length);
}

Impacts random_impacts(Law law, Detachment detachment, DampingLaw damping_law, Eigen::Index count,
                       double most_damping, Random& random) {
    Impacts impacts{.law = law, .detachment = detachment, .damping_law = damping_law};
    for (Eigen::ArrayXd* column : {&impacts.mass, &impacts.effective_radius, &impacts.contact_modulus,
                                   &impacts.work_of_adhesion, &impacts.damping, &impacts.velocity}) {
        column->resize(count);
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        const double radius = scaled(random, 5e-7, 1e-4);
        impacts.effective_radius[i] = radius;
        const double density = random.uniform(1500.0, 3000.0);
        impacts.mass[i] = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * density;
        impacts.contact_modulus[i] = scaled(random, 3e10, 1.5e11);
        impacts.work_of_adhesion[i] = scaled(random, 0.01, 1.0);
        if (law.is_plastic()) {
            impacts.yield_pressure.conservativeResize(count);
            impacts.yield_pressure[i] = pressure_of_adhesive_yield(impacts, i) * scaled(random, 1.2, 120.0);
        }
        for (const auto& [name, value] : parameters_like(impacts.work_of_adhesion[i])) {
            Eigen::ArrayXd& column = impacts.parameters[name];
            column.conservativeResize(count);
            column[i] = value;
        }
        impacts.velocity[i] = scaled(random, 0.01, 20.0);
        const Scale scale = Scale::of(impacts.at(i).contact, impacts.velocity[i]);
        impacts.damping[i] = scale.damping_coefficient(damping_law, random.uniform(0.0, most_damping));
    }
    return impacts;
}

std::vector<ParameterColumn> parameter_columns(const Impacts::Parameters& parameters) {
    std::vector<ParameterColumn> columns;
    for (const auto& [name, values] : parameters) columns.push_back({name, values});
    return columns;
}

ParameterValues<double> parameters_at(const Impacts::Parameters& parameters, Eigen::Index i) {
    ParameterValues<double> values;
    for (const auto& [name, column] : parameters) values.set(name, column[i]);
    return values;
}

Impacts::Parameters picked_parameters(const Impacts::Parameters& parameters,
                                      const std::vector<Eigen::Index>& places) {
    Impacts::Parameters picked;
    for (const auto& [name, column] : parameters) picked[name] = column(places);
    return picked;
}

bool same_bits(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

}  // namespace

ImpactBatch Impacts::batch() const {
    return {law,
            detachment,
            damping_law,
            {mass, effective_radius, contact_modulus, work_of_adhesion, yield_pressure,
             parameter_columns(parameters)},
            damping,
            velocity};
}

Impact Impacts::at(Eigen::Index i) const {
    return {law,
            detachment,
            {damping_law, damping[i]},
            {.mass = mass[i],
             .effective_radius = effective_radius[i],
             .contact_modulus = contact_modulus[i],
             .work_of_adhesion = work_of_adhesion[i],
             .yield_pressure = yield_pressure[yield_pressure.size() == 1 ? 0 : i],
             .parameters = parameters_at(parameters, i)},
            velocity[i]};
}

Impacts Impacts::picked(const std::vector<Eigen::Index>& places) const {
    const Eigen::ArrayXd yield = law.is_plastic() ? yield_pressure(places).eval() : yield_pressure;
    return {.law = law,
            .detachment = detachment,
            .damping_law = damping_law,
            .mass = mass(places),
            .effective_radius = effective_radius(places),
            .contact_modulus = contact_modulus(places),
            .work_of_adhesion = work_of_adhesion(places),
            .yield_pressure = yield,
            .damping = damping(places),
            .velocity = velocity(places),
            .parameters = picked_parameters(parameters, places)};
}

std::string name_of(const Impacts& impacts) {
    return name_of(ContactCase{impacts.law, impacts.damping_law, impacts.detachment});
}

std::vector<Impacts> random_impacts(Eigen::Index count, double most_damping, std::uint64_t seed) {
    Random random(seed);
    std::vector<Impacts> sets;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        for (const Detachment detachment : all_values<Detachment>) {
            if (refusal(law, detachment)) continue;
            for (const DampingLaw damping : all_values<DampingLaw>) {
                if (!batch::has_kernels(law, damping)) continue;
                sets.push_back(random_impacts(law, detachment, damping, count, most_damping, random));
            }
        }
    }
    return sets;
}

Impacts random_impacts_of(Law law, Eigen::Index count, double most_damping, std::uint64_t seed) {
    const std::vector<Impacts> sets = random_impacts(count, most_damping, seed);
    const auto last =
        std::find_if(sets.rbegin(), sets.rend(), [&](const Impacts& set) { return set.law == law; });
    if (last == sets.rend()) throw std::invalid_argument("no kernel for " + std::string(law.name()));
    return *last;
}

std::vector<BatchMethod> methods_of(const Impacts& impacts) {
    if (method_of_many(impacts.law, impacts.damping_law) == BatchMethod::integration)
        return {BatchMethod::integration};
    return {BatchMethod::integration, BatchMethod::table};
}

double bound_of(Law law) {
    return law.has_cohesive_zone() ? 1e-9 : 1e-12;
}

double conditioned_error(double restitution, const ImpactResult& reference) {
    const double depth = std::abs(reference.energy.minimum) / reference.energy.incident;
    return std::abs(restitution * restitution - reference.restitution * reference.restitution) /
           (1.0 + depth);
}

bool identical(const ImpactBatchResult& a, const ImpactBatchResult& b) {
    return (a.outcome == b.outcome).all() && same_bits(a.restitution, b.restitution) &&
           same_bits(a.contact_time, b.contact_time) && same_bits(a.approach_time, b.approach_time) &&
           same_bits(a.maximum_overlap, b.maximum_overlap);
}

}  // namespace ashimpact::test
