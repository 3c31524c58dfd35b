// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/text/error.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/velocity_scales.hpp"

namespace ashimpact {

namespace {

constexpr int most_iterations = 60;

std::string names_of_self_similar_laws() {
    std::string names;
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (!Law::at(i).self_similar()) continue;
        if (!names.empty()) names += ", ";
        names += Law::at(i).name();
    }
    return names;
}

void require_memoryless(Law law, const ContactPair& contact) {
    if (is_self_similar(law, contact)) return;
    if (!law.self_similar())
        throw InputError("damping cannot be found from impacts with law '" + std::string(law.name()) +
                             "', whose adhesion has a range of its own",
                         names_of_self_similar_laws());
    throw InputError("law '" + std::string(law.name()) + "' with a finite yield pressure has a history",
                     "a law without one for fits of damping");
}

}  // namespace

ContactModel::ContactModel(std::shared_ptr<const RestitutionMap> map, const ContactPair& contact)
    : map_(std::move(map)), contact_(contact) {
    validate(contact);
    require_memoryless(map_->law(), contact);
    velocity_unit_ = map_->adhesive() ? velocity_of_adhesion(map_->law(), contact) : 1.0;
    if (!(velocity_unit_ > 0.0)) throw InputError("work_of_adhesion is 0 J/m2", "> 0 for an adhesive law");
    damping_unit_ = std::pow(contact.mass, 0.6) * std::pow(hertz_stiffness(contact), 0.4);
}

VelocityRange ContactModel::range() const {
    return {velocity_unit_ * std::exp(map_->range().lower), velocity_unit_ * std::exp(map_->range().upper)};
}

DampingAt ContactModel::damping(double velocity, double restitution) const {
    const DampingNumber number = map_->damping_number(restitution, x_of(velocity));
    const double unit = damping_unit_ * std::pow(velocity, 0.2);
    return {.value = unit * number.value,
            .by_restitution = unit * number.by_restitution,
            .by_velocity = unit / velocity * (0.2 * number.value + number.by_x)};
}

std::optional<VelocityAt> ContactModel::velocity(double restitution, double damping,
                                                 std::optional<double> guess) const {
    // ln eta(v, e) rises with ln v: Newton's method, kept within a bracket that only shrinks.
    double lower = map_->range().lower;
    double upper = map_->range().upper;
    if (restitution > 0.0 &&
        restitution < 1.0) {  // below this velocity even an undamped impact has less restitution
        const double undamped = map_->lowest() - 0.5 * std::log1p(-restitution * restitution);
        lower = std::max(lower, undamped);
    }
    const double wanted = std::log(damping / damping_unit_) - 0.2 * std::log(velocity_unit_);
    double x = std::isfinite(lower) ? 0.5 * (lower + upper) : 0.0;
    if (guess) x = std::clamp(x_of(*guess), lower, upper);
    for (int i = 0; i < most_iterations; ++i) {
        const DampingNumber number = map_->damping_number(restitution, x);
        const bool positive = number.value > 0.0;
        const double miss = positive ? 0.2 * x + std::log(number.value) - wanted : -1.0;
        const double slope = 0.2 + number.by_x / number.value;
        if (std::abs(miss) < 1e-7) {  // one more Newton step leaves an error of its square
            const double value = velocity_unit_ * std::exp(x - miss / slope);
            return VelocityAt{value, value / (damping * slope)};
        }
        (miss < 0.0 ? lower : upper) = x;
        const double newton = x - miss / slope;
        x = positive && newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (!(x > lower && x < upper)) break;
    }
    return std::nullopt;
}

std::optional<double> ContactModel::critical_velocity_anywhere(double damping) const {
    if (!(damping > 0.0)) return std::nullopt;
    if (const auto read = velocity(0.0, damping)) return read->value;
    return ashimpact::critical_velocity(
               {map_->law(), map_->detachment(), {DampingLaw::constant, damping}, contact_})
        .value;
}

double ContactModel::restitution(double velocity, double damping) const {
    if (damping >= this->damping(velocity, 0.0).value) return 0.0;
    return rebound_restitution(velocity, damping,
                               {.guess = 0.5 * greatest_restitution(velocity), .tolerance = 1e-14});
}

double ContactModel::rebound_restitution(double velocity, double damping, const Search& search) const {
    double lower = 0.0;
    double upper = greatest_restitution(velocity);
    double e = std::min(std::max(search.guess, 1e-9), 0.999999 * upper);
    for (int i = 0; i < most_iterations; ++i) {
        const DampingAt at = this->damping(velocity, e);
        (at.value > damping ? lower : upper) = e;
        const double newton = e - (at.value - damping) / at.by_restitution;
        const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (std::abs(next - e) <= search.tolerance) return next;
        e = next;
    }
    return e;
}

double ContactModel::contact_time(double velocity, double restitution) const {
    const double length = std::pow(contact_.mass * velocity * velocity / hertz_stiffness(contact_), 0.4);
    return map_->contact_time(restitution, x_of(velocity)) * length / velocity;
}

std::shared_ptr<const RestitutionMap> make_restitution_map(Law law, Detachment detachment,
                                                           const ContactPair& contact,
                                                           VelocityRange velocities) {
    validate(contact);
    require_memoryless(law, contact);
    const double unit = velocity_of_adhesion(law, contact);
    if (unit == 0.0)
        return std::make_shared<RestitutionMap>(Law::without_attraction(), Detachment::zero_overlap,
                                                velocities);
    return std::make_shared<RestitutionMap>(
        law, detachment, VelocityRange{std::log(velocities.lower / unit), std::log(velocities.upper / unit)});
}

ContactModel make_contact_model(Law law, Detachment detachment, const ContactPair& contact,
                                VelocityRange velocities) {
    return {make_restitution_map(law, detachment, contact, velocities), contact};
}

}  // namespace ashimpact
