// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/names.hpp"
#include "materials/composition.hpp"
#include "materials/modulus.hpp"
#include "solver/contact/pair.hpp"
#include "solver/inference/extrapolation/damping_curve_fit.hpp"
#include "solver/inference/impacts/measurement.hpp"
#include "solver/statistics/interval.hpp"
#include "solver/statistics/propagation.hpp"
#include "solver/surrogate/contact_model.hpp"

namespace ashimpact {

/// A contact whose properties follow from uncertain inputs.
struct RandomContact {
    std::vector<RandomInput> inputs;
    std::function<ContactPair(std::span<const double> values)> contact;  ///< for values of the inputs. A copy
                                                                         ///< for each thread

    /// The contact at the values of the inputs.
    [[nodiscard]] ContactPair nominal() const;
};

/// Elasticity of a wall, or of a second sphere.
struct RandomWall {
    RandomInput young_modulus;  ///< [Pa]
    RandomInput poisson_ratio;  ///< [1]
};

/// A particle whose modulus follows from its phases and pores.
struct RandomParticle {
    ParticleInputs inputs;
    std::optional<RandomInput> poisson_ratio{};  ///< of the particle; none: mixed from the phases [1]
    std::optional<RandomWall> wall{};            ///< none: rigid
};

/// A second sphere in place of the wall.
struct RandomPartner {
    RandomInput diameter;  ///< [m]
    RandomInput mass;      ///< [kg]; with by_density the density that it follows from [kg/m3]
    bool by_density = false;
};

/// A sphere of one sieve size on a flat wall, or on a second sphere. Exactly one of particle and
/// contact_modulus is given.
struct SphereInContact {
    RandomInput diameter;                          ///< [m]
    std::optional<RandomInput> density{};          ///< none: that of the particle's inputs [kg/m3]
    RandomInput work_of_adhesion;                  ///< of smooth surfaces [J/m2]
    std::optional<RandomInput> roughness{};        ///< rms, see roughness_reduction(); none: smooth [m]
    std::optional<RandomParticle> particle{};      ///< XRD fractions and properties of the phases, or
    std::optional<RandomInput> contact_modulus{};  ///< E* itself [Pa]
    std::optional<RandomPartner> partner{};        ///< none: a flat wall
    double yield_pressure = std::numeric_limits<double>::infinity();  ///< [Pa]
    std::vector<std::pair<LawParameter, RandomInput>> parameters{};   ///< of laws that declare their own [SI]
    ParameterValues<double> other_parameters{};                       ///< that are no inputs [SI]
};

/// The inputs of a sphere in contact: first its diameter, density, w, and what its contact modulus comes
/// from, then its partner's. Draws of a particle's inputs beyond their limits count as the limits.
/// @throws InputError unless exactly one way to a modulus is given, or without a way to a density
[[nodiscard]] RandomContact random_contact(const SphereInContact& sphere);

/// Name of the factor under which the scatter of a fit is ranked.
inline constexpr const char* fit_factor = "damping fit";

/// How the damping changes if the contact differs from its nominal values.
enum class DampingUnderChange {
    /// The measured curve v_r(v_in) is known: the damping is read from it again with the other contact. Its
    /// errors and those of the contact cancel to a large part in v_c.
    reread,
    /// The damping is known by itself, e.g. published: errors do not cancel.
    held,
};

/// v_c with an interval from all uncertainties: the covariance of the fit (with the asymmetry of its
/// interval), size, density, moduli, fractions and w, ranked by their influence.
/// @param contact whose values are those of @p model 's contact
/// @throws InputError if the two contacts differ
[[nodiscard]] Propagation propagate_critical_velocity(const DampingCurveFit& fit, const ContactModel& model,
                                                      const RandomContact& contact,
                                                      DampingUnderChange change = DampingUnderChange::reread,
                                                      const PropagationOptions& options = {});

/// The same from a critical damping that is known by itself, such as one of the paper's Table 3, drawn with
/// the ends of its interval, or log-normal where they are missing; of every law whose contact does not yield,
/// by critical_velocity_of_many().
[[nodiscard]] Propagation propagate_critical_velocity(Law law, Detachment detachment,
                                                      const Interval& critical_damping,
                                                      const RandomContact& contact,
                                                      const PropagationOptions& options = {});

/// The critical velocity from captures and rebounds alone, without any model of the contact.
struct MeasuredCriticalVelocity {
    std::optional<double> value;  ///< > 0; none if only one outcome was seen or they give no threshold [m/s]
    std::optional<double> standard_uncertainty;  ///< [m/s]
    std::optional<double> lower;                 ///< of the 95 % interval; none: not bounded [m/s]
    std::optional<double> upper;                 ///< [m/s]
    std::optional<double> fastest_capture;       ///< [m/s]
    std::optional<double> slowest_rebound;       ///< [m/s]
    std::optional<double>
        width;         ///< standard deviation of the transition: noise, or more where outcomes mix [m/s]
    std::string note;  ///< in words
};

/// Maximum likelihood of P(capture at v) = Phi((v_c - v)/width). The width is the noise of v_in, or more if
/// outcomes mix over a wider range, as when particles differ. The interval is that of the profile likelihood,
/// with the width that is likeliest at each v_c. Without known noise and without mixing it is the gap between
/// the fastest capture and the slowest rebound. Outcomes that contradict a threshold (captures faster than
/// rebounds beyond their noise) give no value; the note gives the reason. Where captures may be rebounds too
/// slow to be seen, the interval has no lower end.
///
/// Captures alone bound v_c from below, by the greatest v_in - z u(v_in) of an impact, z the normal quantile
/// of 1 - 0.05/n for n impacts; rebounds alone bound it from above, by the least v_in + z u(v_in). If all
/// particles share one v_c such a bound holds in 95 % of cases or more, whatever velocities were aimed at.
/// @param scale_uncertainty as in EstimateOptions: it widens the interval or moves the bound
/// @throws InputError for a set that is not valid
[[nodiscard]] MeasuredCriticalVelocity measured_critical_velocity(const MeasurementSet& stated,
                                                                  double scale_uncertainty = 0.0);

/// Standard uncertainty of the difference of two estimates from the same impacts, which share most of their
/// errors. If one of them is efficient, the variance of the difference is the difference of the variances
/// (Hausman 1978). As neither quite is, at least a quarter of the larger variance is taken.
[[nodiscard]] double shared_difference(double one, double other);

enum class CriticalVelocityVerdict { agrees, model_too_low, model_too_high, not_comparable };

template <>
struct Names<CriticalVelocityVerdict> {
    static constexpr std::string_view kind = "verdict";
    static constexpr std::array<std::string_view, 4> all{"agrees", "model-too-low", "model-too-high",
                                                         "not-comparable"};
};

/// Whether a modelled v_c agrees with the measured one within their joint 95 % uncertainty. One below a
/// measured v_c whose interval has no lower end is not comparable with it.
struct CriticalVelocityCheck {
    CriticalVelocityVerdict verdict;
    std::optional<double> deviation;  ///< model less measurement, in joint standard uncertainties

    [[nodiscard]] bool contradicts() const {
        return verdict == CriticalVelocityVerdict::model_too_low ||
               verdict == CriticalVelocityVerdict::model_too_high;
    }
};
[[nodiscard]] CriticalVelocityCheck check(const Interval& model, const MeasuredCriticalVelocity& measured,
                                          bool same_impacts = false);

}  // namespace ashimpact
