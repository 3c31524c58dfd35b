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
#include "solver/numeric/number.hpp"

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
constexpr double tolerance = 1e-12;  ///< of the logarithms, in their last coefficients

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

/// Of e^2 in its last coefficients, and relative of the contact time.
struct Tolerances {
    double square = 2e-13;
    double time = 1e-12;
};
constexpr Tolerances of_zones{.square = 2e-10, .time = 1e-9};        ///< impacts are integrated to that
constexpr Tolerances of_approaches{.square = 2e-13, .time = 2e-12};  ///< of u at the turn

/// Adhesion or damping number at a coordinate of the table; infinite at 1.
double number_at(double place) {
    return place / (1.0 - place);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// Values of one layer after another at the nodes of a square.
using Layers = std::vector<Values>;

/// Turns values at the nodes of layers into coefficients: of Chebyshev polynomials, or of powers.
Layers across(const Eigen::MatrixXd& transform, const Layers& values) {
    Layers sums(values.size(), Values::Zero());
    for (std::size_t k = 0; k < values.size(); ++k)
        for (std::size_t l = 0; l < values.size(); ++l)
            sums[k] += transform(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) * values[l];
    return sums;
}

/// Fits values at the nodes. @return whether what the polynomial leaves out is below @p allowed
bool fit(const Layers& values, double allowed, SquarePolynomial RestitutionPolynomials::*which,
         RestitutionContent& out) {
    static const Eigen::MatrixXd analysis = ChebyshevAxis{-1.0, 1.0, RestitutionTable::layers - 1}.analysis();
    static const Eigen::MatrixXd layer_powers = chebyshev_by_powers(RestitutionTable::layers);
    const auto& t = Coordinate<rows>::the();
    const auto& u = Coordinate<columns>::the();
    const bool layered = values.size() > 1;
    Layers spectra = layered ? across(analysis, values) : values;
    for (Values& spectrum : spectra) {
        spectrum = (t.chebyshev * spectrum * u.chebyshev.transpose()).eval();
        const double last = std::max(spectrum.bottomRows(2).cwiseAbs().maxCoeff(),
                                     spectrum.rightCols(2).cwiseAbs().maxCoeff());
        auto high_in_both = spectrum.bottomRightCorner<rows - low_rows, columns - low_columns>();
        if (!(last < allowed && high_in_both.cwiseAbs().maxCoeff() < allowed)) return false;
        high_in_both.setZero();
    }
    if (layered && !(spectra.back().cwiseAbs().maxCoeff() < allowed)) return false;
    if (layered) spectra = across(layer_powers, spectra);
    for (std::size_t k = 0; k < spectra.size(); ++k)
        if (!store(t.powers * spectra[k] * u.powers.transpose(), allowed, out[k].*which)) return false;
    return true;
}

}  // namespace

/// Impacts given by their numbers, with their results, scaled.
struct NumberedImpacts {
    std::vector<double> adhesion{};
    std::vector<double> damping{};
    std::vector<double> yield_number{};  ///< of approaches that yield
    std::vector<LaneEnd> end{};
    std::vector<double> result{};
    std::vector<double> time{};
};

template class PieceTree<CriticalPiece, 64, 5, 16>;

CriticalTable& CriticalTable::of(Law law, Detachment detachment, DampingLaw damping_law,
                                 CriticalQuantity quantity) {
    return table_of<CriticalTable>(std::tuple(law.index(), detachment, damping_law, quantity), law,
                                   detachment, damping_law, quantity);
}

CriticalTable::CriticalTable(Law law, Detachment detachment, DampingLaw damping_law,
                             CriticalQuantity quantity)
    : law_(law.index()),
      detachment_(detachment),
      damping_law_(damping_law),
      quantity_(quantity),
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
        const CriticalVelocity critical =
            critical_velocity({law, detachment_, damping, pair}, Precision::standard);
        // Capture only grows with damping: if v_c is not finite here, it is not at the later nodes either.
        if (!critical.value) return i == 0 ? PieceState::captured : PieceState::unknown;
        values[i] = std::log(quantity_ == CriticalQuantity::work ? critical.dissipated / unit / beta
                                                                 : *critical.maximum_overlap / scale.length);
        content.detachment_energy = critical.detachment_energy / unit;
    }
    const Eigen::VectorXd spectrum = to_chebyshev * values;
    if (!(spectrum.tail(3).cwiseAbs().maxCoeff() < tolerance)) return PieceState::unknown;
    Eigen::VectorXd::Map(content.coefficients.data(), degree + 1) = to_powers * spectrum;
    return PieceState::tabulated;
}

template class PieceTree<RestitutionPiece, 1, 6, 9>;

RestitutionTable& RestitutionTable::of(NumberKernel kernel, Detachment detachment, DampingLaw damping_law) {
    return table_of<RestitutionTable>(std::tuple(kernel, detachment, damping_law, ImpactPart::whole), kernel,
                                      detachment, damping_law);
}

RestitutionTable::RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law,
                                   ImpactPart part)
    : kernel_(kernel), detachment_(detachment), damping_law_(damping_law), part_(part) {
    roots_[0].span({0.5, 0.5}, 0.5);
}

RestitutionTable::RestitutionTable(NumberKernel kernel, Detachment detachment, DampingLaw damping_law,
                                   ImpactPart part, const NumberSpan& span)
    : RestitutionTable(kernel, detachment, damping_law, part) {
    span_ = span;
    const ChebyshevAxis axis{-1.0, 1.0, static_cast<int>(layers) - 1};
    for (std::size_t k = 0; k < layers; ++k)
        numbers_.push_back(span.number_at(axis.node(static_cast<int>(k))));
    if (part == ImpactPart::approach) {
        onset_ = YieldOnset(kernel, damping_law, span);
        return;
    }
    for (const double lambda : numbers_) curves_.emplace_back(lambda, damping_law, detachment);
    for (const double end : {-1.0, 1.0}) curves_.emplace_back(span.number_at(end), damping_law, detachment);
}

RestitutionTable& RestitutionTable::of_release() const {
    return table_of<RestitutionTable>(std::tuple(kernel_, detachment_, damping_law_, ImpactPart::release),
                                      kernel_, detachment_, damping_law_, ImpactPart::release);
}

double RestitutionTable::adhesion_at(double x) const {
    if (part_ == ImpactPart::release) return power<3>(release_root * x);
    return curves_.empty() ? number_at(x) : std::exp2(zone_powers * x + zone_least_power);
}

void RestitutionTable::add(double x, double y, std::size_t layer, NumberedImpacts& impacts) const {
    if (part_ != ImpactPart::approach) {
        impacts.adhesion.push_back(adhesion_at(x));
        impacts.damping.push_back(number_at(y));
        return;
    }
    const double square = onset_.velocity_squared_at(x, y, span_.z(numbers_[layer]));
    const auto [adhesion, damping, yield_number] =
        impact_numbers({square, number_at(y), numbers_[layer]}, damping_law_);
    impacts.adhesion.push_back(adhesion);
    impacts.damping.push_back(damping);
    impacts.yield_number.push_back(yield_number);
}

void RestitutionTable::solve(std::size_t layer, NumberedImpacts& impacts) const {
    const std::size_t count = impacts.adhesion.size();
    impacts.end.resize(count);
    impacts.result.resize(count);
    impacts.time.resize(count);
    kernel_({.damping_law = damping_law_,
             .detachment = detachment_,
             .part = part_,
             .count = count,
             .adhesion = impacts.adhesion.data(),
             .damping = impacts.damping.data(),
             .yield_number = impacts.yield_number.empty() ? nullptr : impacts.yield_number.data(),
             .curve = curves_.empty() ? nullptr : &curves_[layer],
             .end = impacts.end.data(),
             .speed = impacts.result.data(),
             .time = impacts.time.data()});
    for (std::size_t i = 0; i < count; ++i) {
        if (part_ != ImpactPart::approach) {
            impacts.result[i] *= impacts.result[i];
            continue;
        }
        const double root = std::sqrt(impacts.yield_number[i]);  // into units of yield
        impacts.result[i] /= root;
        impacts.time[i] *= root;
    }
}

bool RestitutionTable::all_end(LaneEnd end, double x, double y, double more) const {
    const auto ends = [&](std::size_t layer, double adhesion) {
        NumberedImpacts corner{.adhesion = {adhesion}, .damping = {number_at(y)}};
        solve(layer, corner);
        return corner.end.front() == end;
    };
    if (curves_.empty()) return ends(0, adhesion_at(x));
    for (std::size_t layer = 0; layer < curves_.size(); ++layer)
        if (!ends(layer, adhesion_at(x) * (1.0 + more))) return false;
    return true;
}

PieceState RestitutionTable::judge(const RestitutionPiece& piece, int depth,
                                   RestitutionContent& content) const {
    constexpr double margin = 1e-3;
    if (part_ == ImpactPart::approach) {
        if (!onset_.known() || depth > most_approach_depth) return PieceState::undecided;
        if (depth < least_approach_depth || piece.upper(1) > YieldOnset::greatest_place)
            return PieceState::unknown;
    } else {
        if (!std::ranges::all_of(curves_, &ZoneCurve::admissible)) return PieceState::undecided;
        if (all_end(LaneEnd::capture, piece.lower(0), piece.lower(1), -margin)) return PieceState::captured;
        const bool bounded = adhesion_at(piece.upper(0)) < infinity && piece.upper(1) < 1.0;
        if (!bounded || depth < least_depth ||
            !all_end(LaneEnd::rebound, piece.upper(0), piece.upper(1), margin))
            return PieceState::unknown;
    }
    content = fitted(piece);
    return content ? PieceState::tabulated : PieceState::unknown;
}

RestitutionContent RestitutionTable::fitted(const RestitutionPiece& piece) const {
    const ChebyshevAxis x{piece.lower(0), piece.upper(0), rows - 1};
    const ChebyshevAxis y{piece.lower(1), piece.upper(1), columns - 1};
    const std::size_t count = std::max<std::size_t>(numbers_.size(), 1);
    Layers result(count);
    Layers time(count);
    for (std::size_t layer = 0; layer < count; ++layer) {
        NumberedImpacts nodes;
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) add(x.node(i), y.node(j), layer, nodes);
        solve(layer, nodes);
        std::size_t k = 0;
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j, ++k) {
                if (nodes.end[k] != LaneEnd::rebound) return nullptr;
                result[layer](i, j) = nodes.result[k];
                time[layer](i, j) = nodes.time[k];
            }
        }
    }
    const Tolerances tolerances = part_ == ImpactPart::approach ? of_approaches
                                  : curves_.empty()             ? Tolerances{}
                                                                : of_zones;
    RestitutionContent polynomials(new RestitutionPolynomials[count]);
    const bool accurate =
        fit(result, tolerances.square, &RestitutionPolynomials::result, polynomials) &&
        fit(time, tolerances.time * time.front().maxCoeff(), &RestitutionPolynomials::time, polynomials);
    return accurate ? std::move(polynomials) : nullptr;
}

RestitutionTable& RestitutionTable::make_span(std::size_t index, const NumberSpan& span, ImpactPart part) {
    RestitutionTable& made = table_of<RestitutionTable>(std::tuple(kernel_, detachment_, damping_law_, index),
                                                        kernel_, detachment_, damping_law_, part, span);
    of_spans_[index].store(&made, std::memory_order_release);
    return made;
}

}  // namespace ashimpact::batch
