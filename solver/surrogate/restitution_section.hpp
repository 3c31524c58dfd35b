// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "solver/surrogate/restitution_map.hpp"

namespace ashimpact {

/// The damping numbers beta(e, x) of a RestitutionMap for one restitution e, as a function of x. Within a
/// range polynomials on pieces of equal width reproduce the map within 1e-13; a look-up takes a tenth of the
/// time. Made from some dozens of look-ups in the map, so it pays for hundreds of impacts of one restitution.
class RestitutionSection {
  public:
    /// @param restitution 0 < e < 1 [1] @param range of x; where no impact has the restitution it is cut off;
    /// empty: look-ups are those of the map
    RestitutionSection(std::shared_ptr<const RestitutionMap> map, double restitution, VelocityRange range);

    [[nodiscard]] double restitution() const { return restitution_; }
    /// As number_along_x() and number() of the map; outside of the range they are those of the map [1].
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
    [[nodiscard]] Place place_of(double x) const;  ///< without powers outside of the range

    std::shared_ptr<const RestitutionMap> map_;
    double restitution_;
    VelocityRange range_;           ///< of x
    double width_ = 1.0;            ///< of a piece
    std::vector<Powers> pieces_{};  ///< coefficients of powers of t
};

}  // namespace ashimpact
