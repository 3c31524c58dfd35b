// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/contact_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ashimpact::oracles {

using std::numbers::pi;

namespace {

double stretch(const ImpactCase& impact) {
    return std::sqrt(2 * pi * impact.work_of_adhesion / impact.contact_modulus);
}

double jkr_overlap(const ImpactCase& impact, double contact_radius) {
    return contact_radius * contact_radius / impact.radius - stretch(impact) * std::sqrt(contact_radius);
}

// dx/da = 0
double fold_contact_radius(const ImpactCase& impact) {
    return std::cbrt(std::pow(stretch(impact) * impact.radius / 4, 2));
}

// F = -(3/2) pi w R, where a controlled load would pull the surfaces apart
double load_controlled_contact_radius(const ImpactCase& impact) {
    return std::cbrt(9 * pi * impact.work_of_adhesion * impact.radius * impact.radius /
                     (8 * impact.contact_modulus));
}

double end_of_contact(const ImpactCase& impact) {
    switch (impact.detachment) {
        case Detachment::zero_overlap:
        case Detachment::zero_force:
            return 0;
        case Detachment::pull_off:
            return jkr_overlap(impact, fold_contact_radius(impact));
        case Detachment::load_controlled:
            return jkr_overlap(impact, load_controlled_contact_radius(impact));
    }
    throw std::logic_error("unknown detachment");
}

}  // namespace

ContactForce::ContactForce(const ImpactCase& impact)
    : law_(impact.law),
      radius_(impact.radius),
      contact_modulus_(impact.contact_modulus),
      work_of_adhesion_(impact.work_of_adhesion),
      stiffness_(4.0 / 3.0 * impact.contact_modulus * std::sqrt(impact.radius)),
      constant_pull_(2 * pi * impact.work_of_adhesion * impact.radius),
      radius_pull_(2 * pi * std::sqrt(impact.radius) *
                   std::cbrt(6 * impact.work_of_adhesion * impact.work_of_adhesion * impact.radius *
                             impact.contact_modulus / pi)),
      stretch_(stretch(impact)),
      fold_overlap_(jkr_overlap(impact, fold_contact_radius(impact))),
      end_overlap_(end_of_contact(impact)),
      overlap_scale_(std::pow(impact.mass * impact.velocity * impact.velocity / stiffness_, 0.4)),
      time_scale_(overlap_scale_ / impact.velocity) {}

double ContactForce::operator()(double overlap) const {
    if (law_ == Law::jkr) return jkr_force(overlap);
    const double x = std::max(overlap, 0.0);
    const double hertz = stiffness_ * x * std::sqrt(x);
    if (law_ == Law::dmt) return hertz - constant_pull_;
    if (law_ == Law::brach_dunn) return hertz - radius_pull_ * std::sqrt(x);
    return hertz;
}

double ContactForce::hertz_slope(double overlap) const {
    return 1.5 * stiffness_ * std::sqrt(std::max(overlap, 0.0));
}

double ContactForce::jkr_force(double overlap) const {
    const double a = jkr_contact_radius(std::max(overlap, fold_overlap_));
    const double cube = a * a * a;
    return 4.0 / 3.0 * contact_modulus_ * cube / radius_ -
           std::sqrt(8 * pi * work_of_adhesion_ * contact_modulus_ * cube);
}

// Newton from above: x(a) is convex and rising on the stable branch, so the iterates fall to the root.
double ContactForce::jkr_contact_radius(double overlap) const {
    double a = std::sqrt(radius_ * std::max(overlap, 0.0)) + std::cbrt(std::pow(stretch_ * radius_, 2));
    for (int i = 0; i < 100; ++i) {
        const double root = std::sqrt(a);
        const double excess = a * a / radius_ - stretch_ * root - overlap;
        const double slope = 2 * a / radius_ - stretch_ / (2 * root);
        const double next = a - excess / slope;
        if (!(next < a) || slope <= 0) break;
        a = next;
    }
    return a;
}

}  // namespace ashimpact::oracles
