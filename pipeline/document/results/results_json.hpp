// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json/view.hpp"
#include "pipeline/run/results/analytic.hpp"
#include "pipeline/run/results/comparison.hpp"
#include "pipeline/run/results/contact.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "pipeline/run/results/damping.hpp"
#include "pipeline/run/results/fit.hpp"
#include "pipeline/run/results/histories.hpp"
#include "pipeline/run/results/modulus.hpp"
#include "pipeline/run/results/restitution.hpp"

/// The results of stages as the "result" of their artifacts, and back. Reading back what was written gives
/// the same numbers, bit for bit.
namespace ashimpact {

/// @param law damping law of the case, which determines the unit of damping coefficients
[[nodiscard]] Json to_json(const ModulusResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const ContactResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const AnalyticResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const RestitutionResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const DampingStageResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const FitResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const CriticalVelocityResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const HistoriesResult& result, DampingLaw law);
[[nodiscard]] Json to_json(const ComparisonResult& result, DampingLaw law);

/// @throws InputError with the JSON pointer for values that no stage can have written
template <class Result>
[[nodiscard]] Result from_json(const View& result, DampingLaw law);
template <>
ModulusResult from_json<ModulusResult>(const View& result, DampingLaw law);
template <>
ContactResult from_json<ContactResult>(const View& result, DampingLaw law);
template <>
AnalyticResult from_json<AnalyticResult>(const View& result, DampingLaw law);
template <>
RestitutionResult from_json<RestitutionResult>(const View& result, DampingLaw law);
template <>
DampingStageResult from_json<DampingStageResult>(const View& result, DampingLaw law);
template <>
FitResult from_json<FitResult>(const View& result, DampingLaw law);
template <>
CriticalVelocityResult from_json<CriticalVelocityResult>(const View& result, DampingLaw law);
template <>
HistoriesResult from_json<HistoriesResult>(const View& result, DampingLaw law);
template <>
ComparisonResult from_json<ComparisonResult>(const View& result, DampingLaw law);

/// Composition and modulus of one sample, with the keys of `ashimpact modulus --json`.
[[nodiscard]] Json modulus_json(const SampleModulus& sample);

/// A critical velocity with the keys of `ashimpact critical-velocity --json`, but for the law.
[[nodiscard]] Json critical_velocity_json(const LawCriticalVelocity& velocity, DampingLaw law);

}  // namespace ashimpact
