// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "solver/surrogate/restitution_map.hpp"

namespace ashimpact {

/// The damping numbers beta(e, x) of a RestitutionMap for one restitution e, as a function of x. Polynomials
/// of ln(x - lowest), or of x where no impact is captured without damping, on pieces of equal width
/// reproduce the map within 1e-13; a look-up takes a tenth of the time. Made from some hundred look-ups in
/// the map, so it pays for thousands of impacts of one restitution.
class RestitutionSection {
  public:
    /// @param restitution 0 < e < 1 [1]
    RestitutionSection(std::shared_ptr<const RestitutionMap> map, double restitution);

    [[nodiscard]] double restitution() const { return restitution_; }
    /// As number_along_x() and number() of the map; outside of the pieces they are those of the map [1].
    [[nodiscard]] NumberAlongX number_along_x(double x) const;
    [[nodiscard]] double number(double x) const;

  private:
    static constexpr int degree = 15;  ///< of a piece
    using Powers = std::array<double, degree + 1>;
    /// A place on a piece.
    struct Place {
        const Powers* powers;
        double t;  ///< -1 ... 1
    };
    /// @return whether the polynomials reproduce the map
    [[nodiscard]] bool divide(int pieces);
    [[nodiscard]] Place place_of(double x) const;  ///< without powers outside of the pieces
    [[nodiscard]] bool has_lowest() const { return std::isfinite(map_->lowest()); }
    [[nodiscard]] double position_of(double x) const {
        return has_lowest() ? std::log(x - map_->lowest()) : x;
    }

    std::shared_ptr<const RestitutionMap> map_;
    double restitution_;
    VelocityRange range_{0.0, 0.0};  ///< of x; empty if the map is used throughout
    double first_ = 0.0;             ///< position_of() its lower end
    double width_ = 1.0;             ///< of a piece, in position
    std::vector<Powers> pieces_{};   ///< coefficients of powers of t
};

}  // namespace ashimpact
