// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/surrogate/batch/restitution_table.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "solver/batch/instruction_set.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

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
    void solve(const Kernels& kernels, Detachment detachment, DampingLaw damping_law) {
        const std::size_t count = adhesion.size();
        end.resize(count);
        speed.resize(count);
        time.resize(count);
        kernels.numbers({.damping_law = damping_law,
                         .detachment = detachment,
                         .count = count,
                         .adhesion = adhesion.data(),
                         .damping = damping.data(),
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

RestitutionTable& RestitutionTable::of(Law law, Detachment detachment, DampingLaw damping_law) {
    // The kernel stands for the law and the instruction set: no two of them share one.
    using Key = std::tuple<NumberKernel, Detachment, DampingLaw>;
    static std::mutex access;
    static std::map<Key, RestitutionTable> tables;
    // Each thread remembers the last table, so that threads that solve single impacts need no lock.
    thread_local Key last{nullptr, detachment, damping_law};
    thread_local RestitutionTable* found = nullptr;
    settle_instruction_set();
    const Kernels kernels = kernels_of(law);
    const Key key{kernels.numbers, detachment, damping_law};
    if (found != nullptr && key == last) return *found;
    const std::scoped_lock lock(access);
    found = &tables.try_emplace(key, kernels, detachment, damping_law).first->second;
    last = key;
    return *found;
}

RestitutionPiece& RestitutionTable::entered(double x, double y, std::size_t place) {
    RestitutionPiece* piece = &root_;
    for (int depth = 0; depth < index_depth; ++depth) {
        if (piece->state() == State::unknown) compute(*piece, depth);
        if (piece->state() != State::quartered) break;
        piece = &piece->quarter(x, y);
    }
    index_[place].store(piece, std::memory_order_release);
    return *piece;
}

void RestitutionTable::compute(RestitutionPiece& piece, int depth) const {
    piece.settle([&] {
        const State state = judged(piece, depth);
        if (state != State::unknown) return state;
        if (depth == most_depth) return State::undecided;
        piece.quarter();
        return State::quartered;
    });
}

RestitutionTable::State RestitutionTable::judged(RestitutionPiece& piece, int depth) const {
    NumberedImpacts corners;
    corners.add(piece.lower_x(), piece.lower_y());
    const bool bounded = piece.upper_x() < 1.0 && piece.upper_y() < 1.0;
    if (bounded) corners.add(piece.upper_x(), piece.upper_y());
    corners.solve(kernels_, detachment_, damping_law_);
    if (corners.end.front() == LaneEnd::capture) return State::capture;
    if (!bounded || corners.end.back() != LaneEnd::rebound || depth < least_depth) return State::unknown;
    return fitted(piece) ? State::rebound : State::unknown;
}

bool RestitutionTable::fitted(RestitutionPiece& piece) const {
    const ChebyshevAxis x{piece.lower_x(), piece.upper_x(), rows - 1};
    const ChebyshevAxis y{piece.lower_y(), piece.upper_y(), columns - 1};
    NumberedImpacts nodes;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) nodes.add(x.node(i), y.node(j));
    }
    nodes.solve(kernels_, detachment_, damping_law_);
    Values squared;
    Values time;
    std::size_t k = 0;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j, ++k) {
            if (nodes.end[k] != LaneEnd::rebound) return false;
            squared(i, j) = nodes.speed[k] * nodes.speed[k];
            time(i, j) = nodes.time[k];
        }
    }
    auto polynomials = std::make_unique<RestitutionPolynomials>();
    if (!fit(squared, square_tolerance, polynomials->restitution_squared) ||
        !fit(time, time_tolerance * time.maxCoeff(), polynomials->contact_time)) {
        return false;
    }
    piece.set(std::move(polynomials));
    return true;
}

}  // namespace ashimpact::batch
