// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/deposition/particle_sizes.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "solver/statistics/distribution.hpp"

namespace ashimpact {

namespace {

constexpr double finest_share = 1e-3;    ///< below the first edge of classes: too fine to reach a tube
constexpr double coarsest_share = 1e-4;  ///< above the last edge

}  // namespace

ParticleSizes ParticleSizes::one(double diameter) {
    ParticleSizes sizes;
    sizes.finer_ = [=](double d) { return d < diameter ? 0.0 : 1.0; };
    sizes.from_ = sizes.to_ = diameter;
    return sizes;
}

ParticleSizes ParticleSizes::rosin_rammler(double scale, double exponent) {
    ParticleSizes sizes;
    sizes.finer_ = [=](double d) { return -std::expm1(-std::pow(d / scale, exponent)); };
    sizes.from_ = scale * std::pow(-std::log1p(-finest_share), 1 / exponent);
    sizes.to_ = scale * std::pow(-std::log(coarsest_share), 1 / exponent);
    return sizes;
}

ParticleSizes ParticleSizes::log_normal(double median, double geometric_standard_deviation) {
    ParticleSizes sizes;
    const double width = std::log(geometric_standard_deviation);
    sizes.finer_ = [=](double d) {
        return 0.5 * std::erfc(-std::log(d / median) / (width * std::numbers::sqrt2));
    };
    std::array ends{finest_share, 1 - coarsest_share};
    to_quantiles(LogNormal{median, geometric_standard_deviation}, ends);
    sizes.from_ = ends[0];
    sizes.to_ = ends[1];
    return sizes;
}

ParticleSizes ParticleSizes::tabulated(std::vector<double> diameters, std::vector<double> finer) {
    ParticleSizes sizes;
    sizes.from_ = diameters.front();
    sizes.to_ = diameters.back();
    sizes.finer_ = [diameters = std::move(diameters), finer = std::move(finer)](double d) {
        if (d <= diameters.front()) return 0.0;
        if (d >= diameters.back()) return 1.0;
        const auto i = static_cast<std::size_t>(std::ranges::upper_bound(diameters, d) - diameters.begin());
        const double part = std::log(d / diameters[i - 1]) / std::log(diameters[i] / diameters[i - 1]);
        return finer[i - 1] + part * (finer[i] - finer[i - 1]);
    };
    return sizes;
}

std::vector<SizeClass> ParticleSizes::classes(int count, double finest, int parts) const {
    if (from_ == to_ || finest >= to_) return {{from_, to_, 1}};
    const bool has_fines = finest > from_;
    std::vector<double> bounds =
        logarithmic_grid(std::max(from_, finest), to_, has_fines ? count : count + 1);
    if (has_fines) bounds.insert(bounds.begin(), from_);
    std::vector<double> edges{bounds.front()};
    for (std::size_t i = 1; i < bounds.size(); ++i) {
        const double ratio = bounds[i] / bounds[i - 1];
        for (int k = 1; k < parts; ++k)
            edges.push_back(bounds[i - 1] * std::pow(ratio, static_cast<double>(k) / parts));
        edges.push_back(bounds[i]);
    }
    std::vector<SizeClass> list;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double below = i == 0 ? 0 : finer_(edges[i]);
        const double above = i + 2 == edges.size() ? 1 : finer_(edges[i + 1]);
        list.push_back({edges[i], edges[i + 1], above - below});
    }
    return list;
}

}  // namespace ashimpact
