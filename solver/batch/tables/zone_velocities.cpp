// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/zone_velocities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/text/error.hpp"
#include "solver/critical_velocity/backward_orbit.hpp"
#include "solver/motion/branches/cohesive_motion.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

/// The critical impacts of a zone. None where the orbit does not converge. An orbit that leaves the range of
/// double precision has escaped.
CriticalImpacts critical_orbit(const CohesiveZone& zone, Detachment detachment, DampingLaw damping_law,
                               double beta) {
    const auto damping = ScaledDamping<Extended>::of(damping_law, {static_cast<Extended>(beta)});
    try {
        CriticalImpacts found =
            critical_impacts(CohesiveMotion(zone, damping, detachment, Precision::standard));
        if (!found.impacts.empty() && !std::isfinite(found.impacts.front().velocity))
            return {.verdict = CaptureVerdict::always_captured};
        return found;
    } catch (const ConvergenceError&) {
        return {};
    }
}

}  // namespace

template class PieceTree<ZoneVelocityPiece, 16, 2, 7>;

ZoneVelocityTable::ZoneVelocityTable(const NumberSpan& span, Detachment detachment, DampingLaw damping_law)
    : span_(span), detachment_(detachment), damping_law_(damping_law) {
    const double half = 0.5 * octaves / static_cast<double>(roots_.size());
    for (std::size_t i = 0; i < roots_.size(); ++i)
        roots_[i].span({lowest + half * static_cast<double>(2 * i + 1)}, half);
    const ChebyshevAxis axis{-within, within, layers - 1};
    for (int k = 0; k < layers; ++k) {
        zones_.emplace_back(span.number_at(axis.node(k)));
        if (!cohesive_refusal(zones_.back(), detachment)) continue;
        zones_.clear();
        return;
    }
}

PieceState ZoneVelocityTable::judge(const ZoneVelocityPiece& piece, int /*depth*/,
                                    ZoneVelocityContent& content) const {
    static const Eigen::MatrixXd by_terms = ChebyshevAxis{-1.0, 1.0, terms - 1}.analysis();
    static const Eigen::MatrixXd by_layers = ChebyshevAxis{-1.0, 1.0, layers - 1}.analysis();
    if (zones_.empty()) return PieceState::undecided;
    const ChebyshevAxis axis{piece.lower(0), piece.upper(0), terms - 1};
    const auto impacts_at = [&](int layer, double x) {
        return critical_orbit(zones_[static_cast<std::size_t>(layer)], detachment_, damping_law_,
                              std::exp2(x));
    };
    // Capture only grows with damping. Orbits escape double precision before they do for certain.
    constexpr double margin = 0.02;
    const auto is_captured = [&](int layer) {
        return impacts_at(layer, piece.lower(0) - margin).verdict == CaptureVerdict::always_captured;
    };
    const auto all_layers = [](const auto& holds) {
        for (int layer = 0; layer < layers; ++layer)
            if (!holds(layer)) return false;
        return true;
    };
    if (is_captured(middle)) return all_layers(is_captured) ? PieceState::captured : PieceState::unknown;
    Eigen::MatrixXd work(terms, layers);
    Eigen::VectorXd energy(layers);
    const auto fill = [&](int layer) {
        for (int i = 0; i < terms; ++i) {
            const CriticalImpacts found = impacts_at(layer, axis.node(i));
            if (found.impacts.empty()) return false;
            work(i, layer) = static_cast<double>(std::log(found.impacts.front().dissipated)) -
                             std::log(2.0) * axis.node(i);
            energy[layer] = static_cast<double>(found.impacts.front().break_energy);
        }
        return true;
    };
    const auto ends_low = [](const auto& last, double allowed) {
        return last.cwiseAbs().maxCoeff() < allowed;
    };
    // One layer shows at a tenth of the cost whether the interval is too long.
    if (!fill(middle) || !ends_low((by_terms * work.col(middle)).tail<2>(), tolerance))
        return PieceState::unknown;
    if (!all_layers([&](int layer) { return layer == middle || fill(layer); })) return PieceState::unknown;
    const Eigen::MatrixXd spectrum = by_terms * work * by_layers.transpose();
    if (!ends_low(spectrum.bottomRows<2>(), tolerance) || !ends_low(spectrum.rightCols<1>(), layer_tolerance))
        return PieceState::unknown;
    content = std::make_unique<ZoneVelocityPolynomials>();
    const Eigen::MatrixXd powers =
        chebyshev_by_powers(terms) * spectrum * chebyshev_by_powers(layers).transpose();
    const Eigen::VectorXd energies = chebyshev_by_powers(layers) * (by_layers * energy);
    for (std::size_t k = 0; k < ZoneVelocityPolynomials::layers; ++k) {
        Eigen::VectorXd::Map(content->log_work[k].data(), terms) = powers.col(static_cast<Eigen::Index>(k));
        content->detachment_energy[k] = energies[static_cast<Eigen::Index>(k)];
    }
    return PieceState::tabulated;
}

ZoneVelocity ZoneVelocityTable::at(double lambda, double beta) {
    const double x = std::max(std::log2(beta), lowest);
    if (!(x < lowest + octaves)) return {PieceState::undecided, 0.0};
    const ZoneVelocityPiece& piece = *find({x}, static_cast<std::size_t>(x - lowest));
    if (piece.state() != PieceState::tabulated) return {piece.state(), 0.0};
    const ZoneVelocityPolynomials& polynomials = *piece.content();
    const double z = span_.z(lambda) / within;
    std::array<double, terms> row = polynomials.log_work.back();
    double energy = polynomials.detachment_energy.back();
    for (std::size_t k = layers - 1; k-- > 0;) {
        for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] * z + polynomials.log_work[k][i];
        energy = energy * z + polynomials.detachment_energy[k];
    }
    const double t = piece.local(0, x);
    double log_work = row.back();
    for (std::size_t i = row.size() - 1; i-- > 0;) log_work = log_work * t + row[i];
    return {PieceState::tabulated, std::sqrt(2.0 * (beta * std::exp(log_work) + std::max(energy, 0.0)))};
}

ZoneVelocities& ZoneVelocities::of(Detachment detachment, DampingLaw damping_law) {
    static std::mutex access;
    static std::map<std::pair<Detachment, DampingLaw>, ZoneVelocities> all;
    const std::scoped_lock lock(access);
    return all.try_emplace({detachment, damping_law}, detachment, damping_law).first->second;
}

ZoneVelocity ZoneVelocities::at(double lambda, double beta) {
    Span& span = spans_[ZoneSpans::index(lambda)];
    std::call_once(span.made, [&] {
        span.table = std::make_unique<ZoneVelocityTable>(ZoneSpans::of(lambda), detachment_, damping_law_);
    });
    return span.table->at(lambda, beta);
}

}  // namespace ashimpact::batch
