// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/uncertainty/contact_models.hpp"
#include "solver/inference/calibration/calibration.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"

namespace ashimpact {

/// Inputs of the interval of v_c, for one law of one sample.
struct VelocityTask {
    const Case& data;
    const LawChoice& choice;
    const SampleContact& contact;
    const RandomContact& uncertain;
    const CalibrationResponse& response;
    const RestitutionSeries* series;  ///< null: none was given
    const LawFit& fit;
    const std::optional<MeasuredCriticalVelocity>& measured;  ///< reported by the case, or else the outcomes
    const std::optional<MeasuredCriticalVelocity>& outcomes;  ///< what the impacts show by themselves
    bool measured_is_reported;  ///< by the case, and not read from the same impacts
    ContactModels& models;

    [[nodiscard]] bool from_impacts() const { return fit.estimate || fit.extrapolated; }
    /// eta_c that v_c follows from: what the impacts support, or else that of the polynomial [SI].
    [[nodiscard]] Interval critical_damping() const {
        if (fit.estimate) return fit.estimate->critical_damping;
        return {fit.critical_damping, fit.critical_damping_uncertainty.value_or(0)};
    }
};

/// Sets the interval of v_c by propagation of everything that is uncertain, with the ranking of what
/// dominates, the check against the measured one, and the same of the paper's extrapolation. Results that
/// cannot be had become findings.
/// @param velocity by exact solution, with v_c at the critical damping
void set_uncertainty(const VelocityTask& task, LawCriticalVelocity& velocity, std::vector<Finding>& findings);

/// Standard uncertainty of E* from the phases, pores and wall of a sample [Pa], linearly: E and Poisson's
/// ratio follow from the same inputs. None where the case does not describe the contact that way, or where
/// @p modulus is not theirs, as it was edited.
[[nodiscard]] std::optional<double> contact_modulus_uncertainty(const Case& data, const Sample& sample,
                                                                const SampleModulus& modulus);

/// The contact of a sample as random quantities. Size and w have the uncertainties of 2-contact.json. Contact
/// modulus and density are propagated from the phases, pores and wall of the case, each of which is drawn
/// once, if they give the values of 2-contact.json; otherwise they are those of 2-contact.json, independent
/// of each other. A stated density that does not give the porosity is an input of its own. Parameters are
/// those of @p law.
/// @param response of the density and w to the contact modulus, for constants that were calibrated at it
[[nodiscard]] RandomContact uncertain_contact(const Case& data, const Sample& sample,
                                              const SampleContact& contact, Law law,
                                              const CalibrationResponse& response);

}  // namespace ashimpact
