// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "materials/contact_properties.hpp"
#include "solver/contact/law.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/surrogate/contact_model.hpp"
#include "tests/oracles/time_domain.hpp"
#include "tests/support/random.hpp"

namespace ashimpact::studies {

/// What the damping of a truth depends on.
enum class TrueDamping { quadratic_in_restitution, power_of_velocity, bump_in_velocity };

/// Restitution against velocity of one particle, made by GSL's integration in time of the law as its paper
/// has it: nothing of the program's own solver or fits is in it.
class TrueCurve {
  public:
    /// @param diameter over that of the 96 um sample of Dong et al. 2013
    TrueCurve(Law law, TrueDamping damping, double diameter = 1.0);

    [[nodiscard]] double critical_velocity() const { return critical_velocity_; }  ///< [m/s]
    /// Restitution at a velocity up to about 10 critical velocities; 0 for a capture.
    [[nodiscard]] double restitution(double velocity) const;

  private:
    void from_restitution(const Impact& impact, const std::vector<double>& abc);
    void from_velocity(const Impact& impact, const std::function<double(double)>& damping, double near);

    double critical_velocity_ = 0.0;
    std::vector<double> velocity_;
    std::vector<double> restitution_;
};

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
    Laboratories(const Row& row, Law law);

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

inline constexpr unsigned long default_seed = 20130829;

/// The laws of the studies.
inline const std::vector<Law>& laws() {
    static const std::vector<Law> all{Law::of<Hertz>(), Law::of<Dmt>(), Law::of<BrachDunn>(), Law::of<Jkr>()};
    return all;
}

/// The contact of the invented laboratories, known as they know it.
inline ContactModel model_of(const Law& law, double critical_velocity) {
    const ContactPair ash{.mass = sphere_mass(48e-6, 2158.5),
                          .effective_radius = 48e-6,
                          .contact_modulus = 90e9,
                          .work_of_adhesion = 0.2959};
    return make_contact_model(law, law.default_detachment(), ash,
                              {0.02 * critical_velocity, 40.0 * critical_velocity});
}

}  // namespace ashimpact::studies
