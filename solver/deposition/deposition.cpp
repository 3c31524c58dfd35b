// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/deposition/deposition.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/batch/parallel.hpp"
#include "solver/numeric/gsl/interpolation.hpp"

namespace ashimpact {

namespace {

constexpr int points_of_means = 16;  ///< between the ends of a range of offsets

/// The part of an interval of offsets within another.
double overlap_of(const OffsetRange& range, double from, double to) {
    return std::max(0.0, std::min(range.to, to) - std::max(range.from, from));
}

std::vector<OffsetRange> staying(const TubeImpaction& impaction, double critical, double gas_velocity) {
    return impaction.any() ? impaction.slower_than(critical / gas_velocity) : std::vector<OffsetRange>{};
}

/// Calls @p add(offset, weight) at some offsets, whose weights sum up to 1. At both ends e and the velocity
/// change with the root of the distance: smooth in this angle.
template <class Add>
void for_means(double from, double to, const Add& add) {
    static const auto angles = gsl::gauss_legendre(points_of_means, 0, std::numbers::pi);
    for (const gsl::QuadratureNode& angle : angles)
        add(from + (to - from) * (0.5 - 0.5 * std::cos(angle.position)),
            0.5 * std::sin(angle.position) * angle.weight);
}

/// What rebounds within a part of the offsets: what lies between those that stay.
Rebounds rebounds_within(const TubeImpaction& impaction, const std::vector<OffsetRange>& stays,
                         const OffsetRange& part, double gas_velocity,
                         const RestitutionOfVelocity& restitution) {
    Rebounds sum;
    const auto add = [&](double from, double to) {
        if (!(to > from)) return;
        for_means(from, to, [&](double offset, double weight) {
            const double velocity = gas_velocity * impaction.at_offset(offset).normal;
            const double ratio = restitution(velocity);
            sum.add({(to - from) * weight, ratio, ratio * velocity}, 1);
        });
    };
    double from = part.from;
    for (const OffsetRange& range : stays) {
        add(from, std::min(range.from, part.to));
        from = std::max(from, range.to);
    }
    add(from, part.to);
    return sum;
}

}  // namespace

void Rebounds::add(const Rebounds& other, double weight) {
    const double more = weight * other.share;
    if (!(more > 0)) return;
    share += more;
    restitution += (other.restitution - restitution) * more / share;
    velocity += (other.velocity - velocity) * more / share;
}

double ClassImpaction::stick_fraction(double critical, double gas_velocity) const {
    double sum = 0;
    for (const OffsetRange& range : staying(impaction, critical, gas_velocity)) sum += range.to - range.from;
    return impaction.any() ? sum / impaction.efficiency() : 0;
}

double ClassImpaction::mean_normal() const {
    if (!impaction.any()) return 0;
    double sum = 0;
    for_means(0, impaction.efficiency(),
              [&](double offset, double weight) { sum += weight * impaction.at_offset(offset).normal; });
    return sum;
}

Rebounds ClassImpaction::rebounds(double critical, double gas_velocity,
                                  const RestitutionOfVelocity& restitution) const {
    if (!impaction.any()) return {};
    return rebounds_within(impaction, staying(impaction, critical, gas_velocity), {0, impaction.efficiency()},
                           gas_velocity, restitution);
}

std::vector<ClassImpaction> impactions_on(const CrossedTube& tube, const std::vector<SizeClass>& classes,
                                          const std::vector<double>& densities) {
    std::vector<std::pair<SizeClass, double>> items;
    for (std::size_t i = 0; i < classes.size(); ++i) items.emplace_back(classes[i], densities[i]);
    return in_parallel(items, [&](const std::pair<SizeClass, double>& item) {
        const TubeParticle particle = tube.particle(item.first.diameter(), item.second);
        return ClassImpaction{item.first, item.second, particle, TubeImpaction(particle)};
    });
}

std::vector<ArcImpaction> arcs_of(const std::vector<ClassImpaction>& classes,
                                  const std::vector<double>& critical,
                                  const std::vector<RestitutionOfVelocity>& restitution, double gas_velocity,
                                  int count) {
    std::vector<ArcImpaction> arcs(static_cast<std::size_t>(count));
    const double width = std::numbers::pi / 2 / count;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        arcs[k].from = static_cast<double>(k) * width;
        arcs[k].to = static_cast<double>(k + 1) * width;
    }
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const TubeImpaction& impaction = classes[i].impaction;
        if (!impaction.any()) continue;
        const auto stays = staying(impaction, critical[i], gas_velocity);
        double from = 0;
        for (std::size_t k = 0; k < arcs.size(); ++k) {
            const double to =
                k + 1 == arcs.size() ? impaction.efficiency() : impaction.offset_of_angle(arcs[k].to);
            if (!(to > from)) continue;
            const double share = classes[i].size.share;
            arcs[k].arrives += share * (to - from);
            for (const OffsetRange& range : stays) arcs[k].stays += share * overlap_of(range, from, to);
            arcs[k].rebounds.add(rebounds_within(impaction, stays, {from, to}, gas_velocity, restitution[i]),
                                 share);
            for_means(from, to, [&](double offset, double weight) {
                const TubePassage passage = impaction.at_offset(offset);
                const double arriving = share * (to - from) * weight;
                arcs[k].normal += arriving * passage.normal;
                arcs[k].incidence += arriving * std::atan2(passage.tangent, passage.normal);
            });
            from = to;
        }
    }
    for (ArcImpaction& arc : arcs) {
        if (!(arc.arrives > 0)) continue;
        arc.normal /= arc.arrives;
        arc.incidence /= arc.arrives;
    }
    return arcs;
}

}  // namespace ashimpact
