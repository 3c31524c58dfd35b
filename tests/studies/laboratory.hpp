// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "solver/inference/impacts/measurement.hpp"
#include "tests/studies/truth.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::studies {

/// How a laboratory errs, and what its file says of it.
enum class Flaw { none, proportional, camera, nothing_told, scatter_of_size, outliers, few };

struct Row {
    std::string name;
    TrueDamping damping;
    Flaw flaw;
};

/// The rows of the study.
[[nodiscard]] const std::vector<Row>& rows();

/// Laboratories of one row and law: 15 to 60 impacts (8 in the row of few) between 0.3 and 8 v_c, evenly over
/// the velocity in every other laboratory, evenly over its logarithm in the rest.
class Laboratories {
  public:
    Laboratories(const Row& row, oracles::Law law);

    [[nodiscard]] double critical_velocity() const { return curves_[nominal_].critical_velocity(); }
    [[nodiscard]] MeasurementSet measure(test::Random& random) const;

  private:
    [[nodiscard]] const TrueCurve& particle(test::Random& random) const;
    [[nodiscard]] Measurement seen(test::Random& random, double velocity, double rebound) const;

    Row row_;
    std::vector<TrueCurve> curves_;  ///< by size; one where all are alike
    std::size_t nominal_ = 0;
    Camera camera_{.frame_rate = 80e3, .pixel_size = 8e-6, .frames = 5};
};

}  // namespace ashimpact::studies
