// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/law_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/contact/registry.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/regime.hpp"
#include "solver/motion/scale.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

/// The table of a combination, one for the process, made from @p arguments when it is first needed.
/// Thread-safe. Each thread remembers its last one, so that threads that solve single problems need no lock.
template <class Table, class Key, class... Arguments>
Table& table_of(const Key& key, const Arguments&... arguments) {
    static std::mutex access;
    static std::map<Key, Table> tables;
    thread_local std::pair<Key, Table*> last{key, nullptr};
    if (last.second != nullptr && last.first == key) return *last.second;
    const std::scoped_lock lock(access);
    last = {key, &tables.try_emplace(key, arguments...).first->second};
    return *last.second;
}

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

/// The power of the adhesion number at length 1 that is the length at which it is 1; 0 for a law without.
double power_of_length(Law law) {
    return law.visit<double>([&]<template <class> class L>() {
        const ContactPair pair = sample_pair(law);
        const double at_one = L<double>::adhesion_number(pair, 1.0);
        return at_one > 0.0 ? 1.0 / std::log2(L<double>::adhesion_number(pair, 0.5) / at_one) : 0.0;
    });
}

constexpr double square_tolerance = 2e-13;  ///< of e^2, in its last coefficients
constexpr double time_tolerance = 1e-12;    ///< of the contact time, relative

/// Adhesion or damping number at a coordinate x or y of the table; infinite at 1.
double number_at(double place) {
    return place / (1.0 - place);
}

/// Impacts given by their numbers, with their results, scaled.
struct NumberedImpacts {
    std::vector<double> adhesion{};
    std::vector<double> damping{};
    std::vector<LaneEnd> end{};
    std::vector<double> speed{};
    std::vector<double> time{};

    void add(double x, double y) {
        adhesion.push_back(number_at(x));
        damping.push_back(number_at(y));
    }
    void solve(NumberKernel kernel, Detachment detachment, DampingLaw damping_law) {
        const std::size_t count = adhesion.size();
        end.resize(count);
        speed.resize(count);
        time.resize(count);
        kernel({.damping_law = damping_law,
                .detachment = detachment,
                .count = count,
                .adhesion = adhesion.data(),
                .damping = damping.data(),
                .curve = nullptr,
                .end = end.data(),
                .speed = speed.data(),
                .time = time.data()});
    }
};

/// Transforms along one coordinate of a piece, from values at Chebyshev nodes to coefficients of powers.
template <int terms>
struct Coordinate {
    using Matrix = Eigen::Matrix<double, terms, terms>;

    Matrix chebyshev =
        ChebyshevAxis{-1.0, 1.0, terms - 1}.analysis();  ///< coefficients of values at the nodes
    Matrix powers = chebyshev_by_powers(terms);

    [[nodiscard]] static const Coordinate& the() {
        static const Coordinate only;
        return only;
    }
};

constexpr int rows = SquarePolynomial::rows;
constexpr int columns = SquarePolynomial::columns;
constexpr int low_rows = SquarePolynomial::low_rows;
constexpr int low_columns = SquarePolynomial::low_columns;
using Values = Eigen::Matrix<double, rows, columns>;

/// Error of a sum in single precision, over the sum of the magnitudes of its terms: half of it comes from
/// rounding its coefficients, half from its last operations.
constexpr double single_precision = std::numeric_limits<float>::epsilon();

/// Sorts coefficients of powers into double and single precision.
/// @return whether the latter represents its part within @p allowed
bool store(const Values& powers, double allowed, SquarePolynomial& out) {
    Eigen::Matrix<double, low_rows, columns> high;
    high.leftCols<low_columns>() = powers.bottomLeftCorner<low_rows, low_columns>();
    high.rightCols<low_columns>() = powers.topRightCorner<low_rows, low_columns>();
    if (!(high.cwiseAbs().sum() * single_precision < allowed)) return false;
    Eigen::Map<Eigen::Matrix<float, low_rows, columns, Eigen::RowMajor>>(out.high.data()) =
        high.cast<float>();
    Eigen::Map<Eigen::Matrix<double, low_rows, low_columns, Eigen::RowMajor>>(out.low.data()) =
        powers.topLeftCorner<low_rows, low_columns>();
    return true;
}

/// Fits values at the nodes. @return whether what the polynomial leaves out is below @p allowed
bool fit(const Values& values, double allowed, SquarePolynomial& out) {
    const auto& t = Coordinate<rows>::the();
    const auto& u = Coordinate<columns>::the();
    Values spectrum = t.chebyshev * values * u.chebyshev.transpose();
    const double last =
        std::max(spectrum.bottomRows(2).cwiseAbs().maxCoeff(), spectrum.rightCols(2).cwiseAbs().maxCoeff());
    auto high_in_both = spectrum.bottomRightCorner<rows - low_rows, columns - low_columns>();
    if (!(last < allowed && high_in_both.cwiseAbs().maxCoeff() < allowed)) return false;
    high_in_both.setZero();
    return store(t.powers * spectrum * u.powers.transpose(), allowed, out);
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
    const ContactPair pair = sample_pair(law);
    const Scale scale = Scale::of(pair, velocity_of_adhesion(law, pair));
    const double unit = scale.energy();
    Eigen::VectorXd values(degree + 1);
    for (int i = 0; i <= degree; ++i) {
        const double beta = axis.node(i);
        const Damping damping{damping_law_, scale.damping_coefficient(damping_law_, beta)};
        const CriticalVelocity critical = critical_velocity({law, detachment_, damping, pair});
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

template class PieceTree<RestitutionPiece, 1, 6, 9>;

RestitutionTable& RestitutionTable::of(NumberKernel kernel, Detachment detachment, DampingLaw damping_law) {
    return table_of<RestitutionTable>(std::tuple(kernel, detachment, damping_law), kernel, detachment,
                                      damping_law);
}

RestitutionTable::RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law)
    : kernel_(kernel), detachment_(detachment), damping_law_(damping_law) {
    roots_[0].span({0.5, 0.5}, 0.5);
}

PieceState RestitutionTable::judge(const RestitutionPiece& piece, int depth,
                                   std::unique_ptr<RestitutionPolynomials>& content) const {
    NumberedImpacts corners;
    corners.add(piece.lower(0), piece.lower(1));
    const bool bounded = piece.upper(0) < 1.0 && piece.upper(1) < 1.0;
    if (bounded) corners.add(piece.upper(0), piece.upper(1));
    corners.solve(kernel_, detachment_, damping_law_);
    if (corners.end.front() == LaneEnd::capture) return PieceState::captured;
    if (!bounded || corners.end.back() != LaneEnd::rebound || depth < least_depth) return PieceState::unknown;
    content = fitted(piece);
    return content ? PieceState::tabulated : PieceState::unknown;
}

std::unique_ptr<RestitutionPolynomials> RestitutionTable::fitted(const RestitutionPiece& piece) const {
    const ChebyshevAxis x{piece.lower(0), piece.upper(0), rows - 1};
    const ChebyshevAxis y{piece.lower(1), piece.upper(1), columns - 1};
    NumberedImpacts nodes;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) nodes.add(x.node(i), y.node(j));
    }
    nodes.solve(kernel_, detachment_, damping_law_);
    Values squared;
    Values time;
    std::size_t k = 0;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j, ++k) {
            if (nodes.end[k] != LaneEnd::rebound) return nullptr;
            squared(i, j) = nodes.speed[k] * nodes.speed[k];
            time(i, j) = nodes.time[k];
        }
    }
    auto polynomials = std::make_unique<RestitutionPolynomials>();
    const bool accurate = fit(squared, square_tolerance, polynomials->restitution_squared) &&
                          fit(time, time_tolerance * time.maxCoeff(), polynomials->contact_time);
    return accurate ? std::move(polynomials) : nullptr;
}

}  // namespace ashimpact::batch
