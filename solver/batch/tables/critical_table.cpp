// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/critical_table.hpp"

#include <cmath>
#include <tuple>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

constexpr int degree = CriticalPolynomial::terms - 1;
constexpr double tolerance = 1e-12;  ///< of ln(work/beta), in its last coefficients

/// An adhesive pair. Its values do not matter: scaled, v_c is the same for every pair.
ContactPair sample_pair(Law law) {
    return {.mass = 1e-9,
            .effective_radius = 44e-6,
            .contact_modulus = 90e9,
            .work_of_adhesion = 0.3,
            .parameters = typical_parameters(law)};
}

Scale sample_scale(Law law) {
    const ContactPair pair = sample_pair(law);
    return Scale::of(pair, velocity_of_adhesion(law, pair));
}

/// The power of the adhesion number at length 1 that is the length at which it is 1; 0 for a law without.
double power_of_length(Law law) {
    return law.visit<double>([&]<template <class> class L>() {
        const ContactPair pair = sample_pair(law);
        const double at_one = L<double>::adhesion_number(pair, 1.0);
        return at_one > 0.0 ? 1.0 / std::log2(L<double>::adhesion_number(pair, 0.5) / at_one) : 0.0;
    });
}

}  // namespace

template class PieceTree<CriticalPiece, 64, 5, 16>;

CriticalTable& CriticalTable::of(Law law, Detachment detachment, DampingLaw damping_law) {
    return table_of<CriticalTable>(std::tuple(law.index(), detachment, damping_law), law, detachment,
                                   damping_law);
}

CriticalTable::CriticalTable(Law law, Detachment detachment, DampingLaw damping_law)
    : law_(law.index()),
      detachment_(detachment),
      damping_law_(damping_law),
      length_power_(power_of_length(law)) {
    double lower = lowest;
    for (CriticalPiece& octave : roots_) {
        octave.span({1.5 * lower}, 0.5 * lower);
        lower *= 2.0;
    }
}

PieceState CriticalTable::judge(const CriticalPiece& piece, int /*depth*/,
                                CriticalPolynomial& content) const {
    static const Eigen::MatrixXd to_chebyshev = ChebyshevAxis{-1.0, 1.0, degree}.analysis();
    static const Eigen::MatrixXd to_powers = chebyshev_by_powers(CriticalPolynomial::terms);
    const ChebyshevAxis axis{piece.lower(0), piece.upper(0), degree};
    const Law law = Law::at(law_);
    const Scale scale = sample_scale(law);
    const double unit = scale.energy();
    Eigen::VectorXd values(degree + 1);
    for (int i = 0; i <= degree; ++i) {
        const double beta = axis.node(i);
        const Damping damping{damping_law_, scale.damping_coefficient(damping_law_, beta)};
        const CriticalVelocity critical = critical_velocity({law, detachment_, damping, sample_pair(law)});
        // Capture only grows with damping: if v_c is not finite here, it is not at the later nodes either.
        if (!critical.value) return i == 0 ? PieceState::captured : PieceState::unknown;
        values[i] = std::log(critical.dissipated / unit / beta);
        content.detachment_energy = critical.detachment_energy / unit;
    }
    const Eigen::VectorXd spectrum = to_chebyshev * values;
    if (!(spectrum.tail(3).cwiseAbs().maxCoeff() < tolerance)) return PieceState::unknown;
    Eigen::VectorXd::Map(content.coefficients.data(), degree + 1) = to_powers * spectrum;
    return PieceState::tabulated;
}

}  // namespace ashimpact::batch
