#include "solver/critical_velocity/critical_velocity_curve.hpp"

#include <cmath>
#include <string>

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/motion/velocity_scales.hpp"

namespace ashimpact {

namespace {

/// Enough for 1e-9 in v_c over a factor of two in damping.
constexpr int curve_degree = 8;

double solved(Law law, Detachment detachment, const ContactPair& contact, double damping) {
    const CriticalVelocity critical =
        critical_velocity({law, detachment, {DampingLaw::constant, damping}, contact});
    if (critical.value) return *critical.value;
    throw InputError("there is no finite critical velocity at damping " + shortest(damping) +
                     " kg/s: " + std::string(name_of(critical.verdict)));
}

}  // namespace

CriticalVelocityCurve::CriticalVelocityCurve(Law law, Detachment detachment, const ContactPair& contact,
                                             double damping, double factor)
    : law_(law), adhesive_(velocity_of_adhesion(law, contact) > 0.0) {
    if (can_yield(law, contact))
        throw InputError("law '" + std::string(law.name()) + "' with a finite yield pressure has a history",
                         "a law without one");
    if (!law.self_similar())
        throw InputError(
            "the critical velocities of law '" + std::string(law.name()) + "' are no function of one number",
            "a law whose are");
    const double middle = logarithmic_damping(contact, damping);
    const double half = adhesive_ ? std::log(factor) : 0.0;
    axis_ = {middle - half, middle + half, adhesive_ ? curve_degree : 0};
    Eigen::VectorXd values(axis_.degree + 1);
    for (int i = 0; i <= axis_.degree; ++i) {
        const double shift = adhesive_ ? axis_.node(i) - middle : 0.0;
        const double velocity = solved(law, detachment, contact, damping * std::exp(shift));
        values[i] = std::log(velocity / velocity_unit(contact));
    }
    if (!adhesive_) values[0] -= 5.0 * middle;
    coefficients_ = adhesive_ ? Eigen::VectorXd(axis_.analysis() * values) : values;
}

double CriticalVelocityCurve::velocity_unit(const ContactPair& contact) const {
    return adhesive_ ? velocity_of_adhesion(law_, contact) : 1.0;
}

double CriticalVelocityCurve::logarithmic_damping(const ContactPair& contact, double damping) const {
    const Damping constant{DampingLaw::constant, damping};
    return 0.2 * std::log(velocity_of_damping(constant, contact) / velocity_unit(contact));
}

double CriticalVelocityCurve::operator()(const ContactPair& contact, double damping) const {
    const double x = logarithmic_damping(contact, damping);
    if (!adhesive_) return std::exp(coefficients_[0] + 5.0 * x);
    const ChebyshevBasis basis(axis_, x);
    return velocity_unit(contact) * std::exp(basis.value.dot(coefficients_));
}

}  // namespace ashimpact
