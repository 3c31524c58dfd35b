// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/batch/critical_table.hpp"

#include <cmath>
#include <memory>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/registry.hpp"
#include "solver/motion/scale.hpp"
#include "solver/motion/velocity_scales.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

constexpr int degree = CriticalPiece::terms - 1;
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

CriticalTable& CriticalTable::of(Law law, Detachment detachment, DampingLaw damping_law) {
    constexpr std::size_t combinations =
        Law::count() * all_values<Detachment>.size() * all_values<DampingLaw>.size();
    static const auto tables = [] {
        auto all = std::make_unique<std::array<CriticalTable, combinations>>();
        std::size_t place = 0;
        for (std::size_t index = 0; index < Law::count(); ++index) {
            for (const Detachment end : all_values<Detachment>) {
                for (const DampingLaw damping : all_values<DampingLaw>) {
                    CriticalTable& table = (*all)[place++];
                    table.law_ = Law::at(index);
                    table.detachment_ = end;
                    table.damping_law_ = damping;
                    table.length_power_ = power_of_length(table.law_);
                }
            }
        }
        return all;
    }();
    const auto end = static_cast<std::size_t>(detachment);
    return (*tables)[(law.index() * all_values<Detachment>.size() + end) * all_values<DampingLaw>.size() +
                     static_cast<std::size_t>(damping_law)];
}

CriticalTable::CriticalTable() {
    for (std::size_t octave = 0; octave < octaves; ++octave) {
        const double lower = std::ldexp(lowest, static_cast<int>(octave));
        pieces_[octave].place(lower, 2.0 * lower);
    }
}

CriticalPiece& CriticalTable::entered(double beta, std::uint64_t place) {
    CriticalPiece* piece = &pieces_[place >> index_depth];
    for (int depth = 0; depth < index_depth; ++depth) {
        if (piece->state() == State::unknown) compute(*piece, depth);
        if (piece->state() != State::halved) break;
        piece = &piece->half(beta);
    }
    index_[place].store(piece, std::memory_order_release);
    return *piece;
}

void CriticalTable::compute(CriticalPiece& piece, int depth) const {
    piece.settle([&] {
        const State state = judged(piece);
        if (state != State::unknown) return state;
        if (depth == most_depth) return State::undecided;
        piece.halve();
        return State::halved;
    });
}

CriticalVelocity CriticalTable::solved(double beta) const {
    const double coefficient = sample_scale(law_).damping_coefficient(damping_law_, beta);
    return critical_velocity({law_, detachment_, {damping_law_, coefficient}, sample_pair(law_)});
}

CriticalTable::State CriticalTable::judged(CriticalPiece& piece) const {
    static const Eigen::MatrixXd to_chebyshev = ChebyshevAxis{-1.0, 1.0, degree}.analysis();
    static const Eigen::MatrixXd to_powers = chebyshev_by_powers(CriticalPiece::terms);
    const ChebyshevAxis axis{piece.lower(), piece.upper(), degree};
    const double unit = sample_scale(law_).energy();
    Eigen::VectorXd values(degree + 1);
    double detachment_energy = 0.0;
    for (int i = 0; i <= degree; ++i) {
        const double beta = axis.node(i);
        const CriticalVelocity critical = solved(beta);
        // Capture only grows with damping: if v_c is not finite here, it is not at the later nodes either.
        if (!critical.value) return i == 0 ? State::always_captured : State::unknown;
        values[i] = std::log(critical.dissipated / unit / beta);
        detachment_energy = critical.detachment_energy / unit;
    }
    const Eigen::VectorXd spectrum = to_chebyshev * values;
    if (!(spectrum.tail(3).cwiseAbs().maxCoeff() < tolerance)) return State::unknown;
    CriticalPiece::Coefficients polynomial;
    Eigen::VectorXd::Map(polynomial.data(), degree + 1) = to_powers * spectrum;
    piece.set(polynomial, detachment_energy);
    return State::finite;
}

}  // namespace ashimpact::batch
