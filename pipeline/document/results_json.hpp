// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "pipeline/case/case.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/run/results/run.hpp"

/// The results of stages as the "result" of their artifacts, and back. Reading back what was written gives
/// the same numbers, bit for bit.
namespace ashimpact {

/// The JSON of the result of a stage. @param law damping law of the case, which determines the unit of
/// damping coefficients
template <class Result>
[[nodiscard]] Json to_json(const Result& result, DampingLaw law);

/// The inverse. @throws InputError with the JSON pointer for values that no stage can have written
template <class Result>
[[nodiscard]] Result from_json(const View& result, DampingLaw law);

extern template Json to_json(const ModulusResult& result, DampingLaw law);
extern template ModulusResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const ContactResult& result, DampingLaw law);
extern template ContactResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const AnalyticResult& result, DampingLaw law);
extern template AnalyticResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const RestitutionResult& result, DampingLaw law);
extern template RestitutionResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const DampingStageResult& result, DampingLaw law);
extern template DampingStageResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const FitResult& result, DampingLaw law);
extern template FitResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const CriticalVelocityResult& result, DampingLaw law);
extern template CriticalVelocityResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const HistoriesResult& result, DampingLaw law);
extern template HistoriesResult from_json(const View& result, DampingLaw law);
extern template Json to_json(const ComparisonResult& result, DampingLaw law);
extern template ComparisonResult from_json(const View& result, DampingLaw law);

/// Composition and modulus of one sample, with the keys of `ashimpact modulus --json`.
[[nodiscard]] Json modulus_json(const SampleModulus& sample);

/// A critical velocity with the keys of `ashimpact critical-velocity --json`, but for the law.
[[nodiscard]] Json critical_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law);

/// Tabor parameter, yield velocities, beta and sizes that show whether a law applies, with its warnings.
[[nodiscard]] Json regime_json(const Regime& regime);

/// The critical velocity that outcomes show, or that was reported.
[[nodiscard]] Json measured_velocity_json(const MeasuredCriticalVelocity& measured);

/// Verdict on a modelled v_c, null deviation where there is nothing to measure it in.
[[nodiscard]] Json check_json(const CriticalVelocityCheck& check);

/// The impacts of a series as columns: the rebounds within reach with number (from 1 on), velocity,
/// restitution, greatest_restitution, damping, its uncertainty where known, and contact_time; captures under
/// captured_at with the least damping that captures; the rest under unreachable.
[[nodiscard]] Json inversion_json(const DampingSeries& series, DampingLaw law);

/// The parts of eta(v_in) between their boundary velocities, numbers of the outliers, and why there are none.
[[nodiscard]] Json parts_json(const DampingSeries& series);

/// Where restitution rises with velocity: up to a velocity, beyond which it falls or the data end.
[[nodiscard]] Json rising_branch_json(double upper, bool falls_beyond);

/// A fit of eta(e_n) to impacts: coefficients in ascending powers with covariance, critical damping and
/// critical velocity (for the contact as given) with 95 % intervals, goodness, and for every rebound its
/// residual, its leverage and what leaving it out changes. Impacts are numbered from 1 on.
[[nodiscard]] Json damping_fit_json(const DampingCurveFit& fit);

/// What the impacts support: critical damping and velocity with their intervals, and what they rest on.
[[nodiscard]] Json damping_estimate_json(const DampingEstimate& estimate);

/// Which damping law explains the impacts, as in comparison.json.
[[nodiscard]] Json dampings_json(const DampingComparison& comparison);

/// The ledger of an impact's energy.
[[nodiscard]] Json energy_json(const EnergyLedger& energy);

/// The paper's extrapolation and the estimate compared.
[[nodiscard]] Json comparison_json(const FitComparison& comparison);

/// The result of a stage of a run. @param file of its artifact
[[nodiscard]] Json result_json(const Run& run, std::string_view file);

/// The options of a case that a stage works with, defaults included. @param file of its artifact
[[nodiscard]] Json options_json(const Case& data, std::string_view file);

/// Sets the result and the record of one stage from its artifact. The case has to be read first: the samples
/// of a result become those of the case, in its order.
/// @throws InputError naming the file, for values that no stage can have written and for missing samples
void read_artifact(const Artifacts& artifacts, std::string_view file, Run& run);

/// The run of the artifacts that are there.
[[nodiscard]] Run read_run(const Artifacts& artifacts);

/// The case, complete, as a case document: reading it back gives the same case.
[[nodiscard]] Json case_json(const Case& data);

/// a, b and c of a published fit.
[[nodiscard]] Json quadratic_json(const DampingPolynomial& fit);

/// Impacts in the columns of a case, velocity and rebound_velocity.
[[nodiscard]] Json measurement_columns(const MeasurementSet& set);

}  // namespace ashimpact
