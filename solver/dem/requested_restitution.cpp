// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/dem/requested_restitution.hpp"

#include <cmath>
#include <numbers>

#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/scale.hpp"

namespace ashimpact {

namespace {

/// |ln e|/sqrt(ln^2 e + pi^2), the damping ratio of a linear spring with that restitution [1].
double linear_ratio(double e) {
    return -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
}

/// The polynomial by which LAMMPS fits the figure of Tsuji et al. 1992 (`damping tsuji` in its manual).
double lammps_coefficient(double e) {
    return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/// gamma(e) of Thornton, Cummins & Cleary 2013 (Powder Technol. 233:30), Eq. B7: the damping ratio of a Hertz
/// contact whose force is cut where it would attract, F_d = 2 gamma sqrt(m dF/d(delta)) v.
double yade_coefficient(double e) {
    if (e == 1) return 0;
    constexpr std::array h{-6.918798, -16.41105, 146.8049,  -796.4559, 2928.711,
                           -7206.864, 11494.29,  -11342.18, 6276.757,  -1489.915};
    double alpha = 0;
    for (std::size_t i = h.size(); i-- > 0;) alpha = e * (alpha + h.at(i));
    const double gamma = std::sqrt(1 / (1 - (1 + e) * (1 + e) * std::exp(alpha)) - 1);
    return std::sqrt(6.0) * gamma;  // dF/d(delta) = (3/2) k sqrt(delta)
}

double delivered(double coefficient, Detachment end) {
    const ContactPair any{.mass = 1, .effective_radius = 1, .contact_modulus = 1, .work_of_adhesion = 0};
    return solve_impact({.law = Law::without_attraction(),
                         .detachment = end,
                         .damping = {DampingLaw::tsuji, coefficient},
                         .contact = any,
                         .velocity = 1})
        .restitution;
}

}  // namespace

bool restitution_depends_on_velocity(DampingLaw law, const ContactPair& contact) {
    return RegisteredDampings::visit<bool>(law, [&]<class D>() {
        return D::units(Scale::of(contact, 1.0)) != D::units(Scale::of(contact, 2.0));
    });
}

Damping damping_without_adhesion(DampingLaw law, Detachment end, const ContactPair& contact, double velocity,
                                 double restitution) {
    return damping_from_restitution({.law = Law::without_attraction(),
                                     .detachment = end,
                                     .damping_law = law,
                                     .contact = contact,
                                     .velocity = velocity,
                                     .restitution = restitution})
        .damping;
}

std::array<CodeRestitution, 4> restitution_in_codes(double requested) {
    // LIGGGHTS: 2 sqrt(5/6) b sqrt(S_n m) with S_n = 2 E* a = (3/2) k sqrt(delta), and MFiX:
    // 2 b sqrt(m k) delta^(1/4), with b = linear_ratio().
    const double ratio = linear_ratio(requested);
    std::array codes{CodeRestitution{"LAMMPS 20220106", "hertz/material with damping tsuji",
                                     lammps_coefficient(requested), Detachment::zero_overlap, 0},
                     CodeRestitution{"LIGGGHTS 3.8", "coefficientRestitution of model hertz",
                                     std::sqrt(5.0) * ratio, Detachment::zero_overlap, 0},
                     CodeRestitution{"YADE 2023.02", "en of MindlinPhys", yade_coefficient(requested),
                                     Detachment::zero_force, 0},
                     CodeRestitution{"MFiX-DEM", "DES_EN_INPUT of the Hertzian model", 2 * ratio,
                                     Detachment::zero_overlap, 0}};
    for (CodeRestitution& code : codes) code.restitution = delivered(code.coefficient, code.end);
    return codes;
}

}  // namespace ashimpact
