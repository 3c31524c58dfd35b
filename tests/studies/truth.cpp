// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/studies/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "materials/contact_properties.hpp"
#include "tests/oracles/time_domain.hpp"

namespace ashimpact::studies {

namespace {

using std::numbers::pi;

/// a, b, c of eta = a e^2 + b e + c, 96 um, Table 2 [kg/s].
std::vector<double> table_2(Law law) {
    if (law == Law::of<Hertz>()) return {0.0104, -0.0229, 0.0155};
    if (law == Law::of<Dmt>()) return {0.0115, -0.0235, 0.0156};
    return {0.0101, -0.0213, 0.0149};
}

Impact ash(Law law, const Particle& particle) {
    const double radius = 48e-6 * particle.diameter;
    return {.law = law,
            .detachment = law == Law::of<Jkr>() ? Detachment::pull_off : Detachment::zero_overlap,
            .damping = {},
            .contact = {.mass = sphere_mass(radius, 2158.5),
                        .effective_radius = radius,
                        .contact_modulus = 90e9,
                        .work_of_adhesion = 0.2959 * particle.adhesion},
            .velocity = 1.0};
}

double restitution_of(Impact impact, double velocity, double damping) {
    impact.velocity = velocity;
    impact.damping.coefficient = damping;
    const oracles::OracleResult result = oracles::time_domain_impact(impact);
    return result.rebound ? result.restitution.value : 0.0;
}

/// The constant damping that gives a restitution at a velocity, by bisection [kg/s].
double damping_of(const Impact& impact, double velocity, double restitution) {
    double low = 1e-6;
    double high = 1.0;
    while (high > low * (1.0 + 1e-6)) {
        const double middle = std::sqrt(low * high);
        (restitution_of(impact, velocity, middle) > restitution ? low : high) = middle;
    }
    return low;
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
constexpr double nominal_threshold = 1.27;  ///< v_c of the closed forms [m/s]

/// A damped contact in Hertzian units: overlap over that of the undamped impact, forces over its force.
class StateDamping {
  public:
    struct Coefficients {
        double radius = 0.0;      ///< eta = C a
        double repulsion = 0.0;   ///< zeta_H [s/m]
        double attraction = 0.0;  ///< zeta_A [s/m]
    };

    StateDamping(const Impact& impact, const Coefficients& damping) : impact_(impact), damping_(damping) {
        const double w = impact.contact.work_of_adhesion;
        const double modulus = impact.contact.contact_modulus;
        const double radius = impact.contact.effective_radius;
        stretch_ = impact.law == Law::of<Jkr>() ? std::sqrt(2 * pi * w / modulus) : 0.0;
        fold_ = std::cbrt(std::pow(stretch_ * radius / 4.0, 2));
        line_ = std::cbrt(6.0 * w * w * radius * modulus / pi);  // of Brach & Dunn [N/m]
    }

    /// By Runge and Kutta of fixed steps; 0 for a capture.
    [[nodiscard]] double restitution(double velocity) const {
        const double radius = impact_.contact.effective_radius;
        const double stiffness = 4.0 / 3.0 * impact_.contact.contact_modulus * std::sqrt(radius);
        // Slower particles are pulled in: their motion is no slower than that at about the adhesion velocity.
        const double pace = std::max(velocity, 0.3);
        const double step = 1e-3 * std::pow(impact_.contact.mass * pace * pace / stiffness, 0.4) / pace;
        const double end = overlap_of(fold_);
        State now{0.0, velocity};
        bool turned = false;
        for (int i = 0; i < 60'000; ++i) {
            const State before = now;
            now = stepped(now, step);
            if (!turned && now.velocity <= 0.0) turned = true;
            if (now.overlap <= end) {
                const double share = (before.overlap - end) / (before.overlap - now.overlap);
                const double squared =
                    (1.0 - share) * before.velocity * before.velocity + share * now.velocity * now.velocity;
                return std::sqrt(squared) / velocity;
            }
            if (turned && now.velocity > 0.0) return 0.0;
        }
        return 0.0;
    }

  private:
    struct State {
        double overlap;
        double velocity;
    };

    [[nodiscard]] double overlap_of(double a) const {
        return a * a / impact_.contact.effective_radius - stretch_ * std::sqrt(a);
    }
    [[nodiscard]] double contact_radius(double overlap) const {
        const double radius = impact_.contact.effective_radius;
        if (stretch_ == 0.0) return std::sqrt(radius * std::max(overlap, 0.0));
        if (overlap <= overlap_of(fold_)) return fold_;
        double a = std::sqrt(radius * std::max(overlap, 0.0)) + 4.0 * fold_;
        for (int i = 0; i < 60; ++i) {
            const double next =
                a - (overlap_of(a) - overlap) / (2.0 * a / radius - 0.5 * stretch_ / std::sqrt(a));
            if (!(next < a * (1.0 - 1e-14))) break;
            a = next;
        }
        return std::max(a, fold_);
    }
    [[nodiscard]] double acceleration(const State& state) const {
        const ContactPair& pair = impact_.contact;
        const double a = contact_radius(state.overlap);
        const double repulsion = 4.0 / 3.0 * pair.contact_modulus * a * a * a / pair.effective_radius;
        double attraction = 0.0;
        if (impact_.law == Law::of<Dmt>())
            attraction = 2.0 * pi * pair.work_of_adhesion * pair.effective_radius;
        if (impact_.law == Law::of<BrachDunn>()) attraction = 2.0 * pi * a * line_;
        if (impact_.law == Law::of<Jkr>())
            attraction = std::sqrt(8.0 * pi * pair.work_of_adhesion * pair.contact_modulus * a * a * a);
        const double eta =
            damping_.radius * a + damping_.repulsion * repulsion + damping_.attraction * attraction;
        return -(repulsion - attraction + eta * state.velocity) / pair.mass;
    }
    [[nodiscard]] State stepped(const State& y, double step) const {
        const State a{y.velocity, acceleration(y)};
        const auto moved = [&](const State& k, double by) {
            return State{y.overlap + by * k.overlap, y.velocity + by * k.velocity};
        };
        const auto slope = [&](const State& at) { return State{at.velocity, acceleration(at)}; };
        const State b = slope(moved(a, 0.5 * step));
        const State c = slope(moved(b, 0.5 * step));
        const State d = slope(moved(c, step));
        return {y.overlap + step / 6.0 * (a.overlap + 2.0 * b.overlap + 2.0 * c.overlap + d.overlap),
                y.velocity + step / 6.0 * (a.velocity + 2.0 * b.velocity + 2.0 * c.velocity + d.velocity)};
    }

    Impact impact_;
    Coefficients damping_;
    double stretch_;
    double fold_;
    double line_;
};

StateDamping::Coefficients coefficients_of(const Truth& truth, double size) {
    if (truth.damping == TrueDamping::contact_radius) return {.radius = size};
    if (truth.damping == TrueDamping::hunt_crossley) return {.repulsion = size};
    return {.repulsion = size, .attraction = truth.parameter * size};
}

/// e of Thornton & Ning 1998 (Powder Technol. 99:154), Eqs. 30, 44: a contact that yields at @p yield.
double yielding(double velocity, double yield) {
    if (velocity <= yield) return 1.0;
    const double y = yield / velocity;
    return std::sqrt(1.2 * std::sqrt(3.0) * (1.0 - y * y / 6.0)) *
           std::pow(y / (y + 2.0 * std::sqrt(1.2 - 0.2 * y * y)), 0.25);
}

}  // namespace

TrueCurve::TrueCurve(Law law, const Truth& truth, const Particle& particle) {
    const Impact impact = ash(law, particle);
    const std::vector<double> abc = table_2(law);
    switch (truth.damping) {
        case TrueDamping::quadratic_in_restitution:
            from_restitution(impact, abc);
            break;
        case TrueDamping::power_of_velocity:
        case TrueDamping::bump_in_velocity: {
            const Impact nominal = ash(law, {});
            const bool bump = truth.damping == TrueDamping::bump_in_velocity;
            const double power = bump ? -0.35 : truth.parameter;
            const double unit =
                threshold([&](double v) { return restitution_of(nominal, v, abc[2]); }, 0.02, 20.0);
            // Damping that rises faster than what captures would capture above v_c: it is that of e = 0.4 at
            // 5 m/s.
            const double scale =
                power > 0.15 ? damping_of(nominal, 5.0, 0.4) * std::pow(unit / 5.0, power) : abc[2];
            const auto damping = [=](double v) {
                const double hump =
                    bump ? 0.2 * std::exp(-0.5 * std::pow(std::log(v / (2.5 * unit)) / 0.3, 2)) : 0.0;
                return scale * std::pow(v / unit, power) * (1.0 + hump);
            };
            const auto restitution = [&](double v) { return restitution_of(impact, v, damping(v)); };
            double near = power > 0.15 ? 0.01 : unit;
            while (power > 0.15 && restitution(2.0 * near) == 0.0) near *= 2.0;
            from_velocity(restitution, near);
            break;
        }
        case TrueDamping::contact_radius:
        case TrueDamping::hunt_crossley:
        case TrueDamping::two_terms:
            from_state(law, truth, impact);
            break;
        case TrueDamping::sharp_onset:
            from_velocity(
                [&](double v) {
                    return truth.parameter *
                           std::sqrt(std::max(0.0, 1.0 - std::pow(nominal_threshold / v, 2)));
                },
                nominal_threshold);
            break;
        case TrueDamping::thornton_ning: {
            const double yield = truth.parameter * nominal_threshold;
            // Adhesion takes a fixed energy, that of the unloading of a contact that yielded at v_c.
            const double taken = nominal_threshold * yielding(nominal_threshold, yield);
            from_velocity(
                [&](double v) {
                    return std::sqrt(std::max(0.0, std::pow(yielding(v, yield), 2) - std::pow(taken / v, 2)));
                },
                nominal_threshold);
            break;
        }
    }
    scale_velocities(particle.threshold);
}

/// Damping that follows the state of the contact: the nominal particle has e = 0.55 at 4 v_c.
void TrueCurve::from_state(Law law, const Truth& truth, const Impact& impact) {
    constexpr double wanted = 0.55;
    const Impact nominal = ash(law, {});
    const auto onset_of = [](const StateDamping& damped) {
        const auto restitution = [&](double v) { return damped.restitution(v); };
        double captured = 1e-3;
        while (restitution(1.3 * captured) == 0.0 && captured < 50.0) captured *= 1.3;
        return threshold(restitution, captured, 1.3 * captured);
    };
    double low = 1e-6;
    double high = 1e6;
    while (high > low * 1.001) {
        const double size = std::sqrt(low * high);
        const StateDamping damped(nominal, coefficients_of(truth, size));
        (damped.restitution(4.0 * onset_of(damped)) > wanted ? low : high) = size;
    }
    const StateDamping damped(impact, coefficients_of(truth, low));
    from_velocity([&](double v) { return damped.restitution(v); }, onset_of(damped));
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

void TrueCurve::from_velocity(const Curve& restitution, double near) {
    critical_velocity_ = threshold(restitution, 0.1 * near, 10.0 * near);
    velocity_ = {critical_velocity_};
    restitution_ = {0.0};
    for (int i = 1; i <= 2 * places; ++i) {
        const double share = static_cast<double>(i) / (2 * places);
        velocity_.push_back(critical_velocity_ * (1.0 + 11.0 * share * share * share));
        restitution_.push_back(restitution(velocity_.back()));
    }
}

void TrueCurve::scale_velocities(double factor) {
    critical_velocity_ *= factor;
    for (double& velocity : velocity_) velocity *= factor;
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

}  // namespace ashimpact::studies
