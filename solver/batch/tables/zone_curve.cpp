// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/batch/tables/zone_curve.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "solver/contact/cohesive_zone.hpp"
#include "solver/contact/mechanics.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/registry.hpp"
#include "solver/numeric/chebyshev.hpp"

namespace ashimpact::batch {

namespace {

constexpr double greatest_position = 64.0;  ///< u that the pieces reach
constexpr double piece_ratio = 2.0;         ///< of the ends of a piece
const double next_piece = std::exp2(0.25);  ///< of the beginnings of two pieces
constexpr double first_part = 0.33;  ///< of sqrt(c) where the surfaces part, up to which a piece begins at 0
constexpr int bands_per_octave = 4;
constexpr int terms = ZoneBand::terms;
constexpr int order_count = ZoneBand::orders;
constexpr double pi = std::numbers::pi;

double gap_fold_of(double lambda) {
    return 8.0 * lambda / (3.0 * pi);
}
/// c where contact and gap branch meet, as CohesiveZone has it.
double join_radius_of(double lambda) {
    const double p = lambda * pi / 4.0;
    const double q = 4.0 / 3.0 * lambda * lambda * (pi / 2.0 - 1.0);
    return 2.0 / (q + std::sqrt(q * q + 4.0 * p));
}
double gap_potential(double lambda, double c) {
    return lambda * c * c * c * (4.0 * lambda / 9.0 - pi / 8.0 * c);
}
double gap_overlap(double lambda, double c) {
    return 0.5 * c * c - gap_fold_of(lambda) * c - 2.0 / (pi * lambda);
}
/// Transition parameter from which on the gap's fold, times a factor, is in touch.
double parameter_where(double factor) {
    const auto excess = [=](double x) { return factor * gap_fold_of(0.1 + x) - join_radius_of(0.1 + x); };
    return 0.1 + sign_change<double>(excess, 10.0);
}
/// From these on first touch and pull-off are in touch.
double least_touching() {
    static const double found = parameter_where(2.0);
    return found;
}
double least_folded() {
    static const double found = parameter_where(1.0);
    return found;
}

/// Turns values at Chebyshev nodes, a column each, into coefficients of powers.
const Eigen::MatrixXd& by_powers(int nodes) {
    static const Eigen::MatrixXd of_terms =
        chebyshev_by_powers(terms) * ChebyshevAxis{-1.0, 1.0, terms - 1}.analysis();
    static const Eigen::MatrixXd of_orders =
        chebyshev_by_powers(order_count) * ChebyshevAxis{-1.0, 1.0, order_count - 1}.analysis();
    return nodes == terms ? of_terms : of_orders;
}

double shape_at(DampingLaw law, double u) {
    return RegisteredDampings::visit<double>(law, [&]<class Damping>() {
        return Damping::shapes(u, StaticForces<double>{power<6>(u), 0.0})[0];
    });
}

double at(const Eigen::VectorXd& powers, double t) {
    double sum = 0.0;
    for (Eigen::Index k = powers.size(); k-- > 0;) sum = sum * t + powers[k];
    return sum;
}

/// The functions of one piece, a column each.
using Columns = Eigen::Matrix<double, terms, ZoneBand::functions>;

/// An integral of slope times shape over a piece, by powers of t.
Eigen::VectorXd impulse_of(const Eigen::VectorXd& slope_powers, const ZoneBand::Piece& piece,
                           DampingLaw law) {
    constexpr int fine = 32;
    static const Eigen::MatrixXd analysis = ChebyshevAxis{-1.0, 1.0, fine - 1}.analysis();
    const ChebyshevAxis axis{-1.0, 1.0, fine - 1};
    const double half = 0.5 * (piece.upper - piece.lower);
    Eigen::VectorXd values(fine);
    for (int i = 0; i < fine; ++i) {
        const double t = axis.node(i);
        values[i] = at(slope_powers, t) * shape_at(law, piece.lower + half * (1.0 + t)) * half;
    }
    const Eigen::VectorXd c = analysis * values;
    Eigen::VectorXd integral = Eigen::VectorXd::Zero(terms);
    for (int k = 1; k < terms; ++k) integral[k] = ((k == 1 ? 2.0 : 1.0) * c[k - 1] - c[k + 1]) / (2.0 * k);
    return chebyshev_by_powers(terms) * integral;
}

/// All but the impulse.
Columns functions_of(const CohesiveZone& zone, const ZoneBand::Piece& piece) {
    const ChebyshevAxis axis{piece.lower, piece.upper, terms - 1};
    Columns values = Columns::Zero();
    for (int i = 0; i < terms; ++i) {
        const auto u = static_cast<Extended>(axis.node(i));
        const CohesiveState state = zone.at_contact_radius(u * u);
        const CohesiveZone::Slopes slopes = zone.slopes(state);
        values(i, ZoneBand::slope) =
            static_cast<double>(2 * u * slopes.overlap * state.cosine / slopes.radius);
        values(i, ZoneBand::force) = static_cast<double>(zone.force(state));
        values(i, ZoneBand::potential) = static_cast<double>(zone.potential(state));
        values(i, ZoneBand::overlap) = static_cast<double>(zone.overlap(state));
    }
    return by_powers(terms) * values;
}

double band_of(double lambda) {
    return std::floor(std::log2(lambda) * bands_per_octave);
}

}  // namespace

NumberSpan ZoneSpans::of(double lambda) {
    constexpr double rooted_up_to = 1.4;
    double lower = std::exp2(band_of(lambda) / bands_per_octave);
    double upper = lower * std::exp2(1.0 / bands_per_octave);
    for (const double border : {least_touching(), least_folded()}) {
        if (lambda < border) upper = std::min(upper, border);
        if (lambda >= border) lower = std::max(lower, border);
    }
    if (lower >= least_touching() && lower < rooted_up_to) return {lower, upper, least_touching()};
    return {lower, upper};
}

std::size_t ZoneSpans::index(double lambda) {
    static const double first = band_of(least_transition);
    return static_cast<std::size_t>(band_of(lambda) - first) + (lambda >= least_touching() ? 1U : 0U) +
           (lambda >= least_folded() ? 1U : 0U);
}

ZoneBand::ZoneBand(double lower, double upper)
    : middle_(0.5 * (lower + upper)), stretch_(2.0 / (upper - lower)) {
    const bool touching = lower >= least_touching();
    if (touching) {
        const double first = std::sqrt(lower - least_touching());
        const double last = std::sqrt(upper - least_touching());
        root_middle_ = 0.5 * (first + last);
        root_stretch_ = 2.0 / (last - first);
    }
    const double join = first_part * std::sqrt(join_radius_of(middle_));
    const auto fold = static_cast<double>(std::sqrt(CohesiveZone(lower).pull_off().contact_radius()));
    double begin = std::fmax(join, 0.9 * fold);
    for (bool from_zero = begin == join; begin < greatest_position; begin *= next_piece) {
        pieces_.push_back({.lower = from_zero ? 0.0 : begin, .upper = piece_ratio * begin, .by_order = {}});
        from_zero = false;
    }
    const ChebyshevAxis axis{lower, upper, order_count - 1};
    Eigen::MatrixXd nodes(order_count, static_cast<Eigen::Index>(pieces_.size() * padded));
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(order_count, numbers);
    nodes.setZero();
    for (int j = 0; j < order_count; ++j) {
        const CohesiveZone zone(axis.node(j));
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const Columns columns = functions_of(zone, pieces_[k]);
            for (const Function function : {slope, force, impulse, potential, overlap})
                for (std::size_t i = 0; i < terms; ++i)
                    nodes(j, static_cast<Eigen::Index>(k * padded + index(function, i))) =
                        columns(static_cast<Eigen::Index>(i), function);
        }
        const auto radius = [&](Number number, const CohesiveState& state) {
            values(j, number) = static_cast<double>(state.contact_radius());
        };
        const auto energy = [&](Number number, const CohesiveState& state) {
            values(j, number) = static_cast<double>(zone.potential(state));
        };
        const auto way = [&](Number number, const CohesiveState& state) {
            values(j, number) = static_cast<double>(zone.overlap(state));
        };
        const CohesiveState rest = zone.equilibrium();
        radius(rest_radius, rest);
        way(rest_overlap, rest);
        energy(rest_potential, rest);
        const CohesiveZone::Slopes slopes = zone.slopes(rest);
        const Extended by_u = 2 * std::sqrt(rest.contact_radius()) * rest.cosine / slopes.radius;
        values(j, rest_slope) = static_cast<double>(slopes.overlap * by_u);
        values(j, rest_force_slope) = static_cast<double>(slopes.force * by_u);
        radius(zero_radius, zone.at_overlap(0));
        energy(zero_potential, zone.at_overlap(0));
        radius(fold_radius, zone.pull_off());
        way(fold_overlap, zone.pull_off());
        energy(fold_potential, zone.pull_off());
        radius(tension_radius, zone.greatest_tension());
        way(tension_overlap, zone.greatest_tension());
        energy(tension_potential, zone.greatest_tension());
        if (!touching) continue;
        const double root = root_middle_ + ChebyshevAxis{-1.0, 1.0, order_count - 1}.node(j) / root_stretch_;
        const CohesiveZone other(least_touching() + root * root);
        values(j, touch_radius) = static_cast<double>(other.touch().contact_radius());
        values(j, touch_potential) = static_cast<double>(other.potential(other.touch()));
    }
    nodes = by_powers(order_count) * nodes;
    values = by_powers(order_count) * values;
    for (int j = 0; j < order_count; ++j) {
        for (std::size_t k = 0; k < pieces_.size(); ++k)
            for (std::size_t i = 0; i < padded; ++i)
                pieces_[k].by_order[static_cast<std::size_t>(j)][i] =
                    nodes(j, static_cast<Eigen::Index>(k * padded + i));
        for (std::size_t n = 0; n < numbers; ++n)
            numbers_[static_cast<std::size_t>(j)][n] = values(j, static_cast<Eigen::Index>(n));
    }
}

ZoneBand::ZoneBand(const ZoneBand& statics, DampingLaw damping_law) : ZoneBand(statics) {
    const ChebyshevAxis axis{-1.0, 1.0, order_count - 1};
    Eigen::MatrixXd nodes(order_count, static_cast<Eigen::Index>(pieces_.size() * terms));
    for (int j = 0; j < order_count; ++j) {
        Eigen::VectorXd before;
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            const Piece& piece = pieces_[k];
            Eigen::VectorXd slopes(terms);
            for (std::size_t i = 0; i < terms; ++i) {
                double sum = 0.0;
                for (std::size_t order = orders; order-- > 0;)
                    sum = sum * axis.node(j) + piece.by_order[order][index(slope, i)];
                slopes[static_cast<Eigen::Index>(i)] = sum;
            }
            Eigen::VectorXd powers = impulse_of(slopes, piece, damping_law);
            // Continues the impulse of the piece before.
            if (k == 0) {
                powers[0] -= at(powers, -1.0);
            } else {
                const Piece& last = pieces_[k - 1];
                const double middle = 0.5 * (piece.lower + piece.upper);
                powers[0] = at(before, (2.0 * middle - last.lower - last.upper) / (last.upper - last.lower));
            }
            nodes.block(j, static_cast<Eigen::Index>(k * terms), 1, terms) = powers.transpose();
            before = std::move(powers);
        }
    }
    nodes = by_powers(order_count) * nodes;
    for (int j = 0; j < order_count; ++j)
        for (std::size_t k = 0; k < pieces_.size(); ++k)
            for (std::size_t i = 0; i < terms; ++i)
                pieces_[k].by_order[static_cast<std::size_t>(j)][index(impulse, i)] =
                    nodes(j, static_cast<Eigen::Index>(k * terms + i));
}

const ZoneBand& ZoneBand::of(double lambda, DampingLaw damping_law) {
    static std::mutex access;
    static std::map<double, ZoneBand> statics;  // by the lower end
    static std::map<std::pair<double, DampingLaw>, ZoneBand> bands;
    const NumberSpan span = ZoneSpans::of(lambda);
    const std::scoped_lock lock(access);
    const auto known = bands.find({span.lower(), damping_law});
    if (known != bands.end()) return known->second;
    const auto& of_all_laws = statics.try_emplace(span.lower(), span.lower(), span.upper()).first->second;
    return bands.try_emplace({span.lower(), damping_law}, of_all_laws, damping_law).first->second;
}

double ZoneBand::place(double lambda) const {
    return (lambda - middle_) * stretch_;
}

std::array<double, ZoneBand::numbers> ZoneBand::values(double lambda) const {
    std::array<double, numbers> x;
    x.fill(place(lambda));
    if (root_stretch_ > 0.0)
        x[touch_radius] = x[touch_potential] =
            (std::sqrt(lambda - least_touching()) - root_middle_) * root_stretch_;
    std::array<double, numbers> sums = numbers_.back();
    for (std::size_t j = orders - 1; j-- > 0;)
        for (std::size_t n = 0; n < numbers; ++n) sums[n] = sums[n] * x[n] + numbers_[j][n];
    return sums;
}

ZoneCurve::ZoneCurve(double lambda, DampingLaw damping_law, Detachment detachment)
    : ZoneCurve(lambda, ZoneBand::of(lambda, damping_law), detachment) {}

ZoneCurve::ZoneCurve(double lambda, const ZoneBand& band, Detachment detachment)
    : lambda_(lambda), band_(&band), gap_fold_(gap_fold_of(lambda)), join_radius_(join_radius_of(lambda)) {
    using enum ZoneBand::Number;
    place_ = band_->place(lambda);
    const std::array<double, ZoneBand::numbers> values = band_->values(lambda);
    const auto value = [&](ZoneBand::Number number) { return values[number]; };
    const auto u_at = [&](ZoneBand::Number number) { return std::sqrt(std::fmax(value(number), 0.0)); };
    const double reach = 2.0 / (pi * lambda);
    const Place parting{0.0, gap_overlap(lambda, join_radius_), gap_potential(lambda, join_radius_)};
    const auto in_touch = [](const Place& place) { return Border{place, false, place.potential}; };
    rest_ = {.place = {u_at(rest_radius), value(rest_overlap), value(rest_potential)},
             .slope = value(rest_slope),
             .force_slope = value(rest_force_slope)};
    admissible_ = detachment != Detachment::zero_force;
    begin_ = lambda < least_touching() ? Border{parting, true, gap_potential(lambda, 2.0 * gap_fold_)}
                                       : in_touch({u_at(touch_radius), -reach, value(touch_potential)});
    end_ = lambda < least_folded()
               ? Border{parting, true, gap_potential(lambda, gap_fold_)}
               : in_touch({u_at(fold_radius), value(fold_overlap), value(fold_potential)});
    if (detachment == Detachment::zero_overlap)
        begin_ = end_ = in_touch({u_at(zero_radius), 0.0, value(zero_potential)});
    if (detachment == Detachment::load_controlled) {
        end_ = in_touch({u_at(tension_radius), value(tension_overlap), value(tension_potential)});
        admissible_ = end_.touching.overlap <= -reach;
    }
}

}  // namespace ashimpact::batch
