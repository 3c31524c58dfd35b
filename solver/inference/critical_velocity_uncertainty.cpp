// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/critical_velocity_uncertainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "solver/batch/batch.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"

namespace ashimpact {

namespace {

/// Takes the next value, in the order in which the inputs were added.
double next(std::span<const double>& values) {
    const double value = values.front();
    values = values.subspan(1);
    return value;
}

RandomInput random_input(const UncertainInput& input) {
    return {.name = input.what,
            .value = input.value,
            .standard_uncertainty = input.standard_uncertainty,
            .distribution = input.positive ? lognormal_around : normal_around,
            .factor = input.group};
}

double stable_poisson_ratio(double value) {
    return std::clamp(value, -0.99, 0.5);
}

/// Properties of a particle at the inputs that were drawn last. Each row of a propagation takes those of its
/// first points many times. Not thread-safe: each propagation has its own.
class DrawnParticles {
  public:
    /// The properties at the next values.
    [[nodiscard]] const ParticleProperties& at(const ParticleInputs& inputs,
                                               std::span<const double>& values) {
        const std::span<const double> own = values.first(inputs.list().size());
        values = values.subspan(own.size());
        auto entry = std::ranges::find_if(
            last_, [&](const Entry& each) { return each.filled && std::ranges::equal(each.inputs, own); });
        if (entry == last_.end()) {
            entry = last_.end() - 1;
            *entry = {{own.begin(), own.end()}, inputs.drawn(own), true};
        }
        std::rotate(last_.begin(), entry, entry + 1);  // the oldest one is the last
        return last_.front().properties;
    }

  private:
    struct Entry {
        std::vector<double> inputs{};
        ParticleProperties properties{};
        bool filled = false;
    };
    std::array<Entry, 3> last_{};
};

/// The contact modulus of a particle whose Poisson ratio, unless mixed, and wall have the next values.
double contact_modulus_at(const RandomParticle& particle, const PorousModuli& moduli,
                          std::span<const double>& values) {
    const double ratio = particle.poisson_ratio ? next(values) : moduli.poisson_ratio.value();
    const ElasticBody body{moduli.young_modulus, stable_poisson_ratio(ratio)};
    if (!particle.wall) return contact_modulus(body, RigidWall{});
    ElasticBody wall{.young_modulus = next(values), .poisson_ratio = 0.0};
    wall.poisson_ratio = stable_poisson_ratio(next(values));
    return contact_modulus(body, wall);
}

/// Draws coefficients of the damping curve from standard normal numbers: the first one with the asymmetry of
/// its interval, the others by their correlation with it and their remaining scatter.
class CurveSampler {
  public:
    explicit CurveSampler(const DampingCurveFit& fit) : best_(fit.damping.coefficients) {
        const Eigen::Index others = best_.size() - 1;
        const double quantile = confidence_quantile();
        const double deviation = std::sqrt(fit.covariance(0, 0));
        const Interval& interval = fit.critical_damping;
        below_ = interval.lower ? (interval.value - *interval.lower) / quantile : deviation;
        above_ = interval.upper ? (*interval.upper - interval.value) / quantile : deviation;
        along_ = fit.covariance.col(0) / fit.covariance(0, 0);
        const Eigen::MatrixXd rest =
            fit.covariance.bottomRightCorner(others, others) -
            fit.covariance(0, 0) * along_.tail(others) * along_.tail(others).transpose();
        const Eigen::LDLT<Eigen::MatrixXd> split(rest);
        const Eigen::VectorXd root = split.vectorD().cwiseMax(0.0).cwiseSqrt();
        scatter_ = split.transpositionsP().transpose() * Eigen::MatrixXd(split.matrixL()) * root.asDiagonal();
    }

    [[nodiscard]] Eigen::Index size() const { return best_.size(); }
    [[nodiscard]] Eigen::VectorXd coefficients(std::span<const double> normal) const {
        const double shift = normal[0] * (normal[0] < 0.0 ? below_ : above_);
        Eigen::VectorXd result = best_ + shift * along_;
        const Eigen::Index others = size() - 1;
        result.tail(others) += scatter_ * Eigen::Map<const Eigen::VectorXd>(normal.data() + 1, others);
        return result;
    }

  private:
    Eigen::VectorXd best_;
    Eigen::VectorXd along_;
    Eigen::MatrixXd scatter_;
    double below_ = 0.0;
    double above_ = 0.0;
};

/// Distance in x = ln(v/V_a) from a place on the fitted curve within which most draws are.
constexpr double usual_distance = 1.0;

/// Inverts a measured curve v_r(v_in) again for another contact.
class Rereading {
  public:
    Rereading(const DampingCurveFit& fit, const ContactModel& model)
        : model_(model), order_(fit.damping.order()) {
        const double lower = fit.restitutions[0];  // where the curve was measured
        greatest_ = std::min(fit.restitutions[1], 0.99);
        const ChebyshevAxis axis{lower, greatest_, 3 * (order_ + 1)};
        Eigen::MatrixXd powers(axis.degree + 1, order_ + 1);
        for (int i = 0; i <= axis.degree; ++i) {
            sections_.emplace_back(model.shared_map(), axis.node(i), VelocityRange{0.0, 0.0});
            powers.row(i) = DampingPolynomial::powers(axis.node(i), order_).transpose();
        }
        to_coefficients_ = powers.completeOrthogonalDecomposition().pseudoInverse();
        fitted_ = velocities(fit.damping.coefficients);
        for (std::size_t i = 0; i < fitted_.size(); ++i) {
            const double x = model.x_of(fitted_[i]);
            sections_[i] = RestitutionSection(model.shared_map(), sections_[i].restitution(),
                                              {x - usual_distance, x + usual_distance});
        }
    }

    /// Velocities of the places on the curve of some damping; empty where there is none.
    [[nodiscard]] std::vector<double> velocities(const Eigen::VectorXd& coefficients) const {
        const DampingPolynomial damping{coefficients};
        const double at_capture = damping(0.0);
        if (!(at_capture > 0.0) || !model_.velocity(0.0, at_capture)) return {};
        std::vector<double> result;
        for (std::size_t i = 0; i < sections_.size(); ++i) {
            const double eta = damping(sections_[i].restitution());
            if (!(eta > 0.0)) return {};
            std::optional<double> guess;  // from the fitted curve, moved as the places before
            const auto moved = [&](std::size_t place) { return result[place] / fitted_[place]; };
            if (!fitted_.empty())
                guess = fitted_[i] * (i == 0 ? 1.0 : i == 1 ? moved(0) : 2.0 * moved(i - 1) - moved(i - 2));
            const auto velocity = model_.velocity(sections_[i], eta, guess);
            if (!velocity) return {};
            result.push_back(velocity->value);
        }
        return result;
    }
    /// eta_c that another contact reads from these places.
    [[nodiscard]] double critical_damping(const ContactModel& other,
                                          const std::vector<SharedVelocity>& velocities) const {
        Eigen::VectorXd damping(static_cast<Eigen::Index>(velocities.size()));
        for (std::size_t i = 0; i < velocities.size(); ++i)
            damping[static_cast<Eigen::Index>(i)] = other.damping_coefficient(velocities[i], sections_[i]);
        return to_coefficients_.row(0).dot(damping);
    }

  private:
    ContactModel model_;
    int order_;
    double greatest_;
    std::vector<RestitutionSection> sections_;  ///< of the restitutions of the places
    std::vector<double> fitted_{};              ///< velocities on the fitted curve
    Eigen::MatrixXd to_coefficients_;
};

/// Draws a critical damping from a standard normal number. The logarithm is normal on each side of the value,
/// so that the interval has its ends, or the standard uncertainty where an end is missing.
class DampingSampler {
  public:
    explicit DampingSampler(const Interval& damping) : value_(damping.value) {
        const auto width = [&](const std::optional<double>& end) {
            return end && *end > 0 ? std::abs(std::log(*end / value_)) / confidence_quantile()
                                   : damping.standard_uncertainty / value_;
        };
        below_ = width(damping.lower);
        above_ = width(damping.upper);
    }
    [[nodiscard]] RandomInput input() const {
        return {.name = fit_factor, .value = 0, .standard_uncertainty = below_ + above_ > 0 ? 1.0 : 0.0};
    }
    [[nodiscard]] double damping(double normal) const {
        return value_ * std::exp(normal * (normal < 0 ? below_ : above_));
    }

  private:
    double value_;
    double below_;
    double above_;
};

/// A curve of damping that was drawn, with its places in velocity.
struct DrawnCurve {
    std::vector<double> key;
    Eigen::VectorXd coefficients;
    std::vector<SharedVelocity> velocities;
};

void require_same(const ContactPair& a, const ContactPair& b) {
    const auto differ = [](double x, double y) { return std::abs(x - y) > 1e-6 * std::abs(y); };
    const auto same_parameter = [&](const auto& x, const auto& y) {
        return x.first == y.first && !differ(x.second, y.second);
    };
    if (differ(a.mass, b.mass) || differ(a.effective_radius, b.effective_radius) ||
        differ(a.contact_modulus, b.contact_modulus) || differ(a.work_of_adhesion, b.work_of_adhesion) ||
        !std::ranges::is_permutation(a.parameters, b.parameters, same_parameter))
        throw InputError("the uncertain contact is not the one of the fit",
                         "inputs whose values give the contact of the model");
}

}  // namespace

ContactPair RandomContact::nominal() const {
    std::vector<double> values;
    for (const RandomInput& input : inputs) values.push_back(input.value);
    return contact(values);
}

RandomContact random_contact(const SphereInContact& sphere) {
    const int ways = (sphere.particle ? 1 : 0) + (sphere.contact_modulus ? 1 : 0);
    if (ways != 1) throw InputError("the modulus is given in " + std::to_string(ways) + " ways", "one");
    if (!sphere.density && !sphere.particle)
        throw InputError("the density is not given", "it, or the phases of the particle");
    RandomContact result;
    const auto add = [&](const std::optional<RandomInput>& input) {
        if (input) result.inputs.push_back(*input);
    };
    add(sphere.diameter);
    add(sphere.density);
    add(sphere.work_of_adhesion);
    add(sphere.roughness);
    add(sphere.contact_modulus);
    if (const auto& particle = sphere.particle) {
        for (const UncertainInput& input : particle->inputs.list()) add(random_input(input));
        add(particle->poisson_ratio);
        if (particle->wall) {
            add(particle->wall->young_modulus);
            add(particle->wall->poisson_ratio);
        }
    }
    if (sphere.partner) {
        add(sphere.partner->diameter);
        add(sphere.partner->mass);
    }
    for (const auto& [parameter, input] : sphere.parameters) add(input);
    result.contact = [sphere = SphereInContact(sphere),
                      particles = DrawnParticles()](std::span<const double> values) mutable {
        const double radius = 0.5 * next(values);
        double density = sphere.density ? next(values) : 0.0;
        ContactPair pair{.mass = 0.0,
                         .effective_radius = radius,
                         .contact_modulus = 0.0,
                         .work_of_adhesion = next(values),
                         .yield_pressure = sphere.yield_pressure,
                         .parameters = sphere.other_parameters};
        const double roughness = sphere.roughness ? next(values) : 0.0;
        if (sphere.particle) {
            const ParticleProperties properties = particles.at(sphere.particle->inputs, values);
            if (!sphere.density) density = properties.density;
            pair.contact_modulus = contact_modulus_at(*sphere.particle, properties.moduli, values);
        } else {
            pair.contact_modulus = next(values);
        }
        pair.mass = sphere_mass(radius, density);
        if (sphere.partner) {
            const double partner = 0.5 * next(values);
            const double given = next(values);
            pair.effective_radius = effective_radius(radius, partner);
            pair.mass =
                effective_mass(pair.mass, sphere.partner->by_density ? sphere_mass(partner, given) : given);
        }
        if (sphere.roughness)
            pair.work_of_adhesion *= roughness_reduction(pair.effective_radius, {.rms = roughness});
        for (const auto& [parameter, input] : sphere.parameters)
            pair.parameters.set(parameter.name, next(values));
        return pair;
    };
    return result;
}

Propagation propagate_critical_velocity(const DampingCurveFit& fit, const ContactModel& model,
                                        const RandomContact& contact, DampingUnderChange change,
                                        const PropagationOptions& options) {
    require_same(contact.nominal(), model.contact());
    const auto contact_of = contact.contact;  // with draws of its own
    const CurveSampler sampler(fit);
    const Rereading rereading(fit, model);
    std::vector<RandomInput> inputs;
    for (Eigen::Index i = 0; i < sampler.size(); ++i)
        inputs.push_back({.name = "c" + std::to_string(i),
                          .value = 0.0,
                          .standard_uncertainty = 1.0,
                          .factor = fit_factor});
    inputs.insert(inputs.end(), contact.inputs.begin(), contact.inputs.end());
    const auto count = static_cast<std::size_t>(sampler.size());
    std::array<DrawnCurve, 2> last;  // each row of the propagation uses two curves many times
    std::size_t oldest = 0;
    const auto curve_of = [&](std::span<const double> normal) -> const DrawnCurve& {
        for (const DrawnCurve& curve : last)
            if (std::ranges::equal(curve.key, normal)) return curve;
        DrawnCurve& entry = last[oldest];
        oldest = 1 - oldest;
        entry.key.assign(normal.begin(), normal.end());
        entry.coefficients = sampler.coefficients(normal);
        entry.velocities.clear();
        if (change == DampingUnderChange::reread)
            for (const double velocity : rereading.velocities(entry.coefficients))
                entry.velocities.push_back(SharedVelocity::of(velocity));
        return entry;
    };
    std::optional<double> near;  // from which the searches for each draw begin
    if (fit.critical_velocity.value > 0) near = fit.critical_velocity.value;
    const auto critical = [&](std::span<const double> values) -> std::optional<double> {
        const DrawnCurve& entry = curve_of(values.first(count));
        const ContactModel other(model.shared_map(), contact_of(values.subspan(count)));
        if (change == DampingUnderChange::held)
            return other.critical_velocity_anywhere(entry.coefficients[0], near);
        if (entry.velocities.empty()) return std::nullopt;
        return other.critical_velocity_anywhere(rereading.critical_damping(other, entry.velocities), near);
    };
    return propagate(inputs, critical, options);
}

Propagation propagate_critical_velocity(Law law, Detachment detachment, const Interval& critical_damping,
                                        const RandomContact& contact, const PropagationOptions& options) {
    const CriticalVelocity nominal = tabulated_critical_velocity(
        {law, detachment, {DampingLaw::constant, critical_damping.value}, contact.nominal()});
    if (!nominal.value)
        throw InputError("there is no finite critical velocity at the values of the inputs: " +
                         std::string(name_of(nominal.verdict)));
    const auto contact_of = contact.contact;  // with draws of its own
    const DampingSampler sampler(critical_damping);
    std::vector<RandomInput> inputs{sampler.input()};
    inputs.insert(inputs.end(), contact.inputs.begin(), contact.inputs.end());
    const auto problem_at = [&](std::span<const double> values) -> CriticalVelocityProblem {
        return {law,
                detachment,
                {DampingLaw::constant, sampler.damping(values[0])},
                contact_of(values.subspan(1))};
    };
    const auto critical = [&](std::span<const double> values) {
        return critical_velocity_of_many(problem_at(values)).value;
    };
    return propagate(inputs, critical, options);
}

}  // namespace ashimpact
