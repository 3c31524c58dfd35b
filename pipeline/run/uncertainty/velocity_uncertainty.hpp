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
    const std::optional<MeasuredCriticalVelocity>& measured;
    bool measured_is_reported;  ///< by the case, and not read from the same impacts
    ContactModels& models;

    [[nodiscard]] bool from_impacts() const { return fit.estimate || fit.extrapolated; }
    /// eta_c that v_c follows from: what the impacts support, or else that of the polynomial [SI].
    [[nodiscard]] double critical_damping() const {
        return fit.estimate ? fit.estimate->critical_damping.value : fit.critical_damping;
    }
    [[nodiscard]] double critical_damping_uncertainty() const {
        return fit.estimate ? fit.estimate->critical_damping.standard_uncertainty
                            : fit.critical_damping_uncertainty.value_or(0);
    }
};

/// Sets the interval of v_c by propagation of everything that is uncertain, with the ranking of what
/// dominates, the check against the measured one, and the same of the paper's extrapolation. Results that
/// cannot be had become findings.
/// @param velocity by exact solution, with v_c at the critical damping
void set_uncertainty(const VelocityTask& task, LawCriticalVelocity& velocity, std::vector<Finding>& findings);

/// The contact of a sample as random quantities. Size, density and w have the uncertainties of
/// 2-contact.json. The contact modulus is propagated from the XRD fractions, phase moduli and wall of the
/// case if one of them is uncertain and together they give that modulus; otherwise it is that of
/// 2-contact.json. Parameters are those of @p law.
/// @param response of the density and w to the contact modulus, for constants that were calibrated at it
[[nodiscard]] RandomContact uncertain_contact(const Case& data, const Sample& sample,
                                              const SampleContact& contact, Law law,
                                              const CalibrationResponse& response);

}  // namespace ashimpact
