// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/comparison/reproduction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include <Eigen/Dense>

#include "core/text/error.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/run/dampings.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

// What is varied besides the choices of the case.
constexpr std::array other_from{0.02, 0.1};  ///< least restitution [1]
constexpr std::array other_to{0.3};          ///< greatest restitution [1]
constexpr std::array orders{2, 3};           ///< of the polynomial; the paper's is the second
constexpr double diameter_change = 1e-6;     ///< of the order of what a sieve leaves open [m]

/// A law whose velocity is varied, for the contact of a sample.
struct VariedLaw {
    LawChoice choice;
    const ContactPair& contact;
    const Reconstruction& plan;
    const Case& data;
};

/// The published fit that the points of a law come from, for its own contact.
std::optional<PublishedDamping> published_for(const VariedLaw& law) {
    Law source = law.choice.law;
    if (law.plan.damping_fits.find(source) == nullptr) source = Law::named(law.plan.reference);
    const DampingPolynomial* fit = law.plan.damping_fits.find(source);
    if (fit == nullptr) return std::nullopt;
    return PublishedDamping{source, law.data.detachment_of(source), law.contact, *fit};
}

/// Restitutions of a range with the dampings that give them at the velocities of the published fit; without
/// those that have no velocity or no damping, as in the run itself.
std::vector<DampingPoint> points_of(const VariedLaw& law, const PublishedDamping& published, double from,
                                    double to) {
    std::vector<DampingProblem> problems;
    for (int i = 0; i < law.plan.points; ++i) {
        const double e = from + (to - from) * i / (law.plan.points - 1);
        try {
            problems.push_back({.law = law.choice.law,
                                .detachment = law.choice.detachment,
                                .damping_law = DampingLaw::constant,
                                .contact = law.contact,
                                .velocity = reconstructed_velocity(published, e),
                                .restitution = e});
        } catch (const InputError&) {
            continue;
        }
    }
    const Eigen::ArrayXd near = near_dampings(problems);
    std::vector<DampingPoint> points;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        double damping = near[static_cast<Eigen::Index>(i)];
        try {
            if (std::isnan(damping)) damping = damping_from_restitution(problems[i]).damping.coefficient;
        } catch (const InputError&) {
            continue;
        }
        points.push_back({problems[i].restitution, damping, 0});
    }
    return points;
}

/// Damping at restitution 0 of the polynomial of least squares through points; none for too few.
std::optional<double> critical_damping_of(const std::vector<DampingPoint>& points, int order) {
    const auto rows = static_cast<Eigen::Index>(points.size());
    if (rows <= order) return std::nullopt;
    Eigen::MatrixXd powers(rows, order + 1);
    Eigen::VectorXd dampings(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const DampingPoint& point = points[static_cast<std::size_t>(i)];
        powers.row(i) = DampingPolynomial::powers(point.restitution, order).transpose();
        dampings[i] = point.damping;
    }
    return powers.colPivHouseholderQr().solve(dampings)[0];
}

std::optional<double> velocity_at(const LawChoice& choice, const ContactPair& contact, double damping) {
    if (!(damping > 0)) return std::nullopt;
    return critical_velocity({choice.law, choice.detachment, {DampingLaw::constant, damping}, contact},
                             Precision::standard)
        .value;
}

/// The velocities of one range of restitution, by every order.
std::vector<double> velocities_by_order(const VariedLaw& law, double from, double to) {
    const auto published = published_for(law);
    if (!published) return {};
    const std::vector<DampingPoint> points = points_of(law, *published, from, to);
    std::vector<double> velocities;
    for (const int order : orders)
        if (const auto damping = critical_damping_of(points, order))
            if (const auto velocity = velocity_at(law.choice, law.contact, *damping))
                velocities.push_back(*velocity);
    return velocities;
}

struct RestitutionRange {
    double from, to;
};

std::vector<RestitutionRange> ranges_around(const Reconstruction& plan) {
    std::vector<RestitutionRange> ranges{{plan.from, plan.to}};
    for (const double from : other_from) ranges.push_back({from, plan.to});
    for (const double to : other_to) ranges.push_back({plan.from, to});
    std::erase_if(ranges, [](const RestitutionRange& range) { return !(range.from < range.to); });
    return ranges;
}

/// The least and greatest velocity over ranges and orders, over that of the case's range and the first order.
std::optional<VelocitySpan> ratios_over_fits(const VariedLaw& law) {
    const auto by_range = in_parallel(ranges_around(law.plan), [&](const RestitutionRange& range) {
        return velocities_by_order(law, range.from, range.to);
    });
    if (by_range.empty() || by_range.front().empty()) return std::nullopt;
    const double own = by_range.front().front();
    VelocitySpan span{1, 1};
    for (const std::vector<double>& velocities : by_range)
        for (const double velocity : velocities) span.include(velocity / own);
    return span;
}

/// The contact of a particle whose diameter differs, of the same density.
ContactPair resized(SampleContact contact, double change) {
    contact.radius.value += 0.5 * change;
    contact.mass.value = sphere_mass(contact.radius.value, contact.density.value());
    contact.effective_radius.value =
        contact.partner ? effective_radius(contact.radius.value, contact.partner->radius.value)
                        : contact.radius.value;
    return pair_of(contact);
}

VelocitySpan over_laws(const SampleComparison& sample, double own) {
    VelocitySpan span{own, own};
    for (const auto& [law, of] : sample.laws)
        if (law.is_adhesive() && of.velocity) span.include(of.velocity->value);
    return span;
}

VelocitySpan over_diameters(const LawChoice& choice, const SampleContact& contact, double damping,
                            double own) {
    VelocitySpan span{own, own};
    for (const double change : {-diameter_change, diameter_change})
        if (const auto velocity = velocity_at(choice, resized(contact, change), damping))
            span.include(*velocity);
    return span;
}

bool is_reproduced(const SampleComparison& sample) {
    return sample.reported && sample.reported->basis == ReportedBasis::reproduction && sample.reported->law &&
           sample.reported->velocity;
}

ReproducedSample reproduced(const Run& run, std::size_t i, const SampleComparison& sample) {
    const Law law = *sample.reported->law;
    const double own = sample.reported->velocity->value;
    const SampleContact& contact = run.contact.samples[i];
    const double damping = run.critical_velocity.samples[i].laws.find(law)->damping;
    ReproducedSample result{
        .name = sample.name,
        .laws = over_laws(sample, own),
        .diameter = over_diameters({law, run.data.detachment_of(law)}, contact, damping, own)};
    const Sample& source = run.data.samples[i];
    const auto* plan = source.restitution ? std::get_if<Reconstruction>(&*source.restitution) : nullptr;
    if (plan == nullptr) return result;
    const Law varied = law.similar();
    const LawChoice choice{varied, varied == law ? run.data.detachment_of(law) : varied.default_detachment()};
    result.fits = ratios_over_fits({choice, contact.pair, *plan, run.data});
    if (result.fits) *result.fits = {own * result.fits->least, own * result.fits->greatest};
    return result;
}

/// How far a law is from the measured velocities of the reproduced samples.
JointTest joint_test(Law law, const std::vector<SampleComparison>& samples) {
    std::vector<double> squares;
    for (const SampleComparison& sample : samples) {
        const LawComparison* of = sample.laws.find(law);
        if (!is_reproduced(sample) || !sample.measured || of == nullptr || !of->velocity) continue;
        const Quantity& measured = sample.measured->quantity;
        const double u = std::hypot(of->velocity->standard_uncertainty.value_or(0),
                                    measured.standard_uncertainty.value_or(0));
        if (!(u > 0)) continue;
        squares.push_back(std::pow((of->velocity->value - measured.value) / u, 2));
    }
    std::ranges::sort(squares);  // so that the sum does not depend on the order of the samples
    return {std::accumulate(squares.begin(), squares.end(), 0.0), squares.size()};
}

/// The values with others, sorted, each once.
std::vector<double> with_others(std::vector<double> values, std::span<const double> others) {
    values.insert(values.end(), others.begin(), others.end());
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

std::optional<Reproduction> reproduction_of(const Run& run, const std::vector<SampleComparison>& samples) {
    Reproduction reproduction{.diameter_change = diameter_change, .orders = {orders.begin(), orders.end()}};
    std::vector<double> from;
    std::vector<double> to;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (!is_reproduced(samples[i])) continue;
        reproduction.samples.push_back(reproduced(run, i, samples[i]));
        if (const auto& source = run.data.samples[i].restitution)
            if (const auto* plan = std::get_if<Reconstruction>(&*source)) {
                from.push_back(plan->from);
                to.push_back(plan->to);
            }
    }
    if (reproduction.samples.empty()) return std::nullopt;
    for (const LawChoice& choice : run.data.laws)
        if (const JointTest test = joint_test(choice.law, samples); test.samples > 0)
            reproduction.joint_tests.set(choice.law, test);
    reproduction.from = with_others(std::move(from), other_from);
    reproduction.to = with_others(std::move(to), other_to);
    return reproduction;
}

}  // namespace ashimpact
