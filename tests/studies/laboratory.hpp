// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/curve/headline.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/surrogate/contact_model.hpp"
#include "tests/studies/truth.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::studies {

/// How a laboratory errs, and what its file says of it.
enum class Flaw {
    none,
    proportional,
    camera,
    nothing_told,
    scatter_of_size,
    scatter_of_adhesion,   ///< of 20 %, not stated
    scatter_of_threshold,  ///< all velocities of a particle's curve scatter by 10 %, not stated
    outliers,
    few,             ///< 8 impacts
    very_few,        ///< 5 impacts
    many,            ///< 20,000 impacts
    slow_lost,       ///< rebounds slower than 0.1 m/s are not in the file
    slow_captured,   ///< rebounds slower than 0.1 m/s are recorded as captures
    no_captures,     ///< captures are not in the file
    scale,           ///< both velocities read with a common factor, 1 within the stated 3 %
    wrong_adhesion,  ///< w of the contact is twice the true one, within its stated 50 %
    oblique,         ///< up to 20 degrees, speeds taken for normal velocities
};

struct Row {
    std::string name;
    Truth truth;
    Flaw flaw;
    bool hertz = true;  ///< whether a contact without adhesion has such a truth
};

/// The rows of the study.
[[nodiscard]] const std::vector<Row>& rows();

/// Laboratories of one row and law: 15 to 60 impacts, or as many as the row says, between 0.3 and 8 v_c,
/// evenly over the velocity in every other laboratory, evenly over its logarithm in the rest.
class Laboratories {
  public:
    Laboratories(const Row& row, Law law);

    [[nodiscard]] double critical_velocity() const { return curves_[nominal_].critical_velocity(); }
    [[nodiscard]] MeasurementSet measure(test::Random& random) const;

  private:
    [[nodiscard]] bool scatters() const;
    [[nodiscard]] const TrueCurve& particle(test::Random& random) const;
    [[nodiscard]] std::size_t impacts(test::Random& random) const;
    [[nodiscard]] bool is_lost(const Measurement& point) const;
    [[nodiscard]] Measurement seen(test::Random& random, double velocity, double rebound) const;

    Row row_;
    std::vector<TrueCurve> curves_;  ///< by size; one where all are alike
    std::size_t nominal_ = 0;
    double noise_ = 0.0;  ///< standard uncertainty of both velocities [m/s]
    Camera camera_{.frame_rate = 80e3, .pixel_size = 8e-6, .frames = 5};
};

inline constexpr unsigned long default_seed = 20130829;

/// The laws of the studies.
inline const std::vector<Law>& laws() {
    static const std::vector<Law> all{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()};
    return all;
}

/// The contact of the invented laboratories, as they know it.
[[nodiscard]] ContactModel model_of(const Row& row, const Law& law, double critical_velocity);
/// What they state beside their impacts.
[[nodiscard]] EstimateOptions options_of(const Row& row);

}  // namespace ashimpact::studies
