// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/case/case.hpp"
#include "pipeline/run/results/contact.hpp"
#include "solver/inference/calibration/calibration.hpp"
#include "solver/inference/critical_velocity_uncertainty.hpp"

namespace ashimpact {

/// The contact of a sample with what is known of its uncertainty: size, density and w as in 2-contact.json;
/// the contact modulus from the XRD fractions, phase moduli and the wall of the case where one of those is
/// uncertain and they give that modulus, else as it stands in 2-contact.json. Of the parameters of contact
/// laws it has those of @p law.
/// @param response of the density and w to the contact modulus, for constants that were calibrated at it
[[nodiscard]] RandomContact uncertain_contact(const Case& data, const Sample& sample,
                                              const SampleContact& contact, Law law,
                                              const CalibrationResponse& response);

}  // namespace ashimpact
