// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

namespace ashimpact {

/// Particles of neighbouring sizes.
struct SizeClass {
    double from = 0, to = 0;  ///< diameters [m]
    double share = 0;         ///< of the mass [1]

    /// Representative diameter, the geometric mean of the bounds [m].
    [[nodiscard]] double diameter() const { return std::sqrt(from * to); }
};

/// Mass of particles by size.
class ParticleSizes {
  public:
    /// All of one diameter [m].
    [[nodiscard]] static ParticleSizes one(double diameter);
    /// 1 - exp(-(d/scale)^exponent) of the mass is finer than d; 63.2 % is finer than the scale [m].
    [[nodiscard]] static ParticleSizes rosin_rammler(double scale, double exponent);
    /// Half of the mass is finer than the median [m].
    [[nodiscard]] static ParticleSizes log_normal(double median, double geometric_standard_deviation);
    /// The shares that are finer than each diameter, from 0 to 1; between them linear in ln d.
    /// @pre diameters rise, shares rise from 0 to 1
    [[nodiscard]] static ParticleSizes tabulated(std::vector<double> diameters, std::vector<double> finer);

    /// Share of the mass that is finer than a diameter [1].
    [[nodiscard]] double finer_than(double diameter) const { return finer_(diameter); }
    /// Classes that hold all mass: one of all that is finer than @p finest [m], the others of equal ratio. Of
    /// a distribution without ends 0.1 % of the mass is finer than the first class begins and 0.01 % coarser
    /// than the last one ends; they belong to these.
    /// @param parts of each class, of equal ratio
    [[nodiscard]] std::vector<SizeClass> classes(int count, double finest = 0, int parts = 1) const;

  private:
    std::function<double(double)> finer_{};
    double from_ = 0, to_ = 0;  ///< [m]
};

/// The median by mass of log-normal particles whose median by number is known (Hatch & Choate 1929).
[[nodiscard]] inline double mass_median(double number_median, double geometric_standard_deviation) {
    const double width = std::log(geometric_standard_deviation);
    return number_median * std::exp(3 * width * width);
}

}  // namespace ashimpact
