// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/sized_ash.hpp"

#include <algorithm>
#include <cmath>

#include "solver/contact/law_parameters.hpp"

namespace ashimpact {

namespace {

double linear(double from, double to, double share) {
    return from == to ? from : from + share * (to - from);  // equal values stay so, infinite ones too
}

}  // namespace

double place_above(double velocity, double critical) {
    return std::asinh(std::sqrt(std::max(0.0, velocity / critical - 1)));
}

double velocity_at_place(double t, double critical) {
    return critical * (1 + std::sinh(t) * std::sinh(t));
}

double DampingCurve::operator()(double t) const {
    const auto above = std::ranges::lower_bound(nodes, t, {}, &DampingNode::t);
    if (above == nodes.begin()) return nodes.front().coefficient;
    if (above == nodes.end()) return nodes.back().coefficient;
    const DampingNode& below = *std::prev(above);
    const double from = below.t * below.t;
    const double share = (t * t - from) / (above->t * above->t - from);
    return below.coefficient + share * (above->coefficient - below.coefficient);
}

bool DampingCurve::is_zero() const {
    return std::ranges::all_of(nodes, [](const DampingNode& node) { return node.coefficient == 0; });
}

double AshBetween::density() const {
    return linear(lower->density, upper->density, share);
}

double AshBetween::damping(double t) const {
    const double below = lower->damping(t);
    if (share == 0) return factor * below;
    const double above = upper->damping(t);
    if (!(below > 0 && above > 0)) return factor * linear(below, above, share);
    return factor * below * std::pow(above / below, share);
}

ContactPair AshBetween::materials() const {
    ContactPair contact = lower->contact;
    const ContactPair& other = upper->contact;
    contact.contact_modulus = linear(contact.contact_modulus, other.contact_modulus, share);
    contact.work_of_adhesion = linear(contact.work_of_adhesion, other.work_of_adhesion, share);
    contact.yield_pressure = linear(contact.yield_pressure, other.yield_pressure, share);
    for (const LawParameter& parameter : law_parameters())
        if (contact.parameters.has(parameter))
            contact.parameters.set(parameter.name,
                                   linear(contact.parameters[parameter], other.parameters[parameter], share));
    return contact;
}

std::size_t piece_of(const std::vector<AshSize>& sizes, double diameter) {
    if (sizes.size() == 1) return 0;
    const auto above = std::ranges::upper_bound(sizes, diameter, {}, &AshSize::diameter);
    // The last size belongs to the piece below it, so that its own values hold exactly.
    if (above == sizes.end() && diameter == sizes.back().diameter) return sizes.size() - 1;
    return static_cast<std::size_t>(above - sizes.begin());
}

AshBetween ash_between(const std::vector<AshSize>& sizes, double exponent, double diameter,
                       std::size_t piece) {
    const auto beyond = [&](const AshSize& size) {
        const double factor =
            exponent == 0 || diameter == size.diameter ? 1.0 : std::pow(diameter / size.diameter, exponent);
        return AshBetween{&size, &size, 0, factor};
    };
    if (piece == 0) return beyond(sizes.front());
    if (piece == sizes.size()) return beyond(sizes.back());
    const AshSize& lower = sizes[piece - 1];
    const AshSize& upper = sizes[piece];
    if (diameter == lower.diameter) return {&lower, &lower, 0, 1};
    if (diameter == upper.diameter) return {&upper, &upper, 0, 1};
    return {&lower, &upper, std::log(diameter / lower.diameter) / std::log(upper.diameter / lower.diameter),
            1};
}

}  // namespace ashimpact
