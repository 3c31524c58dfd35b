// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/scaled_impacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/text/error.hpp"
#include "solver/batch/inversion_batch.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/follow.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/velocity_scales.hpp"
#include "solver/numeric/gsl/search.hpp"

namespace ashimpact {

namespace {

/// The pair in place of all others: mass, radius, stiffness and work of adhesion are 1.
constexpr ContactPair unit_pair{
    .mass = 1.0, .effective_radius = 1.0, .contact_modulus = 0.75, .work_of_adhesion = 1.0};

/// The unit pair with any values of the law's own parameters: scaled impacts do not depend on them.
ContactPair unit_pair_of(Law law) {
    ContactPair pair = unit_pair;
    pair.parameters = typical_parameters(law);
    return pair;
}

Impact impact_at(const ScaledImpacts& impacts, double damping_number, double velocity) {
    const Scale scale = Scale::of(unit_pair, velocity);
    const double coefficient = scale.damping_coefficient(DampingLaw::constant, damping_number);
    return {.law = impacts.law(),
            .detachment = impacts.detachment(),
            .damping = {DampingLaw::constant, coefficient},
            .contact = unit_pair_of(impacts.law()),
            .velocity = velocity};
}

CriticalVelocity critical_of(const Impact& impact) {
    return critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
}

/// Root of a decreasing function near a guess. The bracket is widened until the sign changes.
double falling_root(const std::function<double(double)>& function, const ScaledImpacts::Search& search) {
    double lower = std::max(0.0, search.guess - search.width);
    double upper = search.guess + search.width;
    for (double width = search.width; lower > 0.0 && function(lower) <= 0.0; width *= 4.0) {
        upper = lower;
        lower = std::max(0.0, lower - 4.0 * width);
    }
    for (double width = search.width; function(upper) > 0.0; width *= 4.0) {
        if (!(upper < 1e6)) throw ConvergenceError("restitution does not fall with damping");
        lower = upper;
        upper += 4.0 * width;
    }
    return gsl::brent(function, lower, upper, {.relative = 0.0, .absolute = search.tolerance}).root;
}

}  // namespace

ScaledImpacts::ScaledImpacts(Law law, Detachment detachment)
    : law_(law),
      detachment_(detachment),
      adhesion_velocity_(velocity_of_adhesion(law, unit_pair_of(law))),
      lowest_(-std::numeric_limits<double>::infinity()) {
    validate(impact_at(*this, 0.1, 1.0));
    if (critical_of(impact_at(*this, 0.1, 1.0)).verdict == CaptureVerdict::never_captured) {
        throw InputError("law '" + std::string(law.name()) + "' with " + std::string(name_of(detachment)) +
                             " detachment never captures",
                         admissible_detachments(law));
    }
    const CriticalVelocity undamped = critical_of(impact_at(*this, 0.0, 1.0));
    if (undamped.value) lowest_ = std::log(*undamped.value / adhesion_velocity_);
}

double ScaledImpacts::velocity(double x) const {
    return adhesive() ? adhesion_velocity_ * std::exp(x) : 1.0;
}

double ScaledImpacts::restitution(double damping_number, double x) const {
    return restitution_of(impact_at(*this, damping_number, velocity(x)));
}

double ScaledImpacts::greatest_restitution(double x) const {
    return std::sqrt(std::max(0.0, -std::expm1(2.0 * (lowest_ - x))));
}

double ScaledImpacts::contact_time(double damping_number, double x) const {
    const Impact impact = impact_at(*this, damping_number, velocity(x));
    const auto motion = scaled_motion<double>(impact, Scale::of(unit_pair, impact.velocity));
    return follow<double>(motion, 1.0).end.time;
}

double ScaledImpacts::damping_number(double restitution, double x, const Search& search) const {
    if (restitution > 0.0) {
        return falling_root([&](double number) { return this->restitution(number, x) - restitution; },
                            search);
    }
    return falling_root(
        [&](double number) {
            const CriticalVelocity critical = critical_of(impact_at(*this, number, velocity(x)));
            return critical.value ? std::log(velocity(x) / *critical.value) : 1.0;
        },
        search);
}

ImpactList ScaledImpacts::columns(const Eigen::ArrayXd& damping_number, const Eigen::ArrayXd& x) const {
    std::vector<Impact> impacts;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        impacts.push_back(impact_at(*this, damping_number[i], velocity(x[i])));
    return ImpactList(impacts);
}

Eigen::ArrayXd ScaledImpacts::damping_numbers(const Eigen::ArrayXd& restitution,
                                              const Eigen::ArrayXd& x) const {
    const ImpactList columns_of_ones = columns(Eigen::ArrayXd::Ones(x.size()), x);
    const ImpactBatch ones = columns_of_ones.batch();
    const auto found = dampings_from_restitutions(
        {law_, detachment_, ones.damping_law, ones.contact, ones.velocity, restitution});
    return found.damping / ones.damping;
}

Eigen::ArrayXd ScaledImpacts::contact_times(const Eigen::ArrayXd& damping_number,
                                            const Eigen::ArrayXd& x) const {
    const auto solved = solve_impacts(columns(damping_number, x).batch(), {.turning_point = false});
    return solved.contact_time /
           x.unaryExpr([this](double each) { return Scale::of(unit_pair, velocity(each)).time(); });
}

}  // namespace ashimpact
