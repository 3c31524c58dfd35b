// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/inference/measured_damping.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scaled_impact.hpp"

namespace ashimpact {

namespace {

void note_impacts(MeasuredDamping& result, const MeasurementSet& set) {
    const auto beyond = std::ranges::count_if(
        result.impacts, [](const InvertedImpact& i) { return i.restitution > 0.0 && !i.damping; });
    if (beyond > 0)
        result.findings.push_back({"faster-than-undamped", Severity::doubt,
                                   std::to_string(beyond) + " of " + counted(set.rebounds(), "rebound") +
                                       (beyond == 1 ? " is" : " are") +
                                       " faster than without any damping: no damping gives " +
                                       (beyond == 1 ? "it" : "them")});
    if (!result.parts.outliers.empty()) {
        std::vector<std::size_t> lines;
        for (const std::size_t index : result.parts.outliers)
            lines.push_back(set.points[index].line > 0 ? set.points[index].line : index + 1);
        const bool in_file = set.points[result.parts.outliers.front()].line > 0;
        result.findings.push_back({"outliers", Severity::remark,
                                   counted(lines.size(), "outlier") + " flagged and left in, law " +
                                       std::string(result.law.name()) + ": " +
                                       numbered(in_file ? "line" : "impact", lines)});
    }
    if (set.rebounds() == 0)
        result.findings.push_back(
            {"no-rebounds", Severity::doubt, "every impact was captured: there is nothing to fit"});
}

/// The paper's extrapolation from the rising branch.
DampingCurveFit extrapolate(MeasuredDamping& result, const ContactModel& model,
                            const MeasuredDampingOptions& options) {
    DampingCurveFit fit = fit_damping_curve(model, result.rising->set, options.extrapolated);
    require_rebounds_above(fit, result.rising->set);
    if (options.estimate.scale_uncertainty > 0)
        add_common_error(fit, model, result.rising->set, options.estimate.scale_uncertainty);
    if (options.estimate.size_scatter)
        result.findings.push_back({"extrapolation-sizes", Severity::background,
                                   "extrapolated fit: the scatter of sizes counts only as far as the "
                                   "rebounds scatter"});
    if (const auto note = enlargement_note(fit))
        result.findings.push_back(
            {"extrapolation-scatter", Severity::background, "extrapolated fit: " + *note});
    return fit;
}

/// The analysis before any step of it: the contact, and the measured critical velocity.
MeasuredDamping begun(Law law, Detachment detachment, const ContactPair& pair, const MeasurementSet& set,
                      const EstimateOptions& options) {
    validate(set);
    MeasuredDamping result{.law = law, .detachment = detachment, .contact = pair};
    result.measured =
        attempt("measured v_c", "no-measured-critical-velocity", Severity::doubt, result.findings, [&] {
            return measured_critical_velocity(set, options.scale_uncertainty);
        }).value_or(MeasuredCriticalVelocity{});
    return result;
}

void note_parts(MeasuredDamping& result, const MeasurementSet& set, const PartOptions& options) {
    result.smoothing = DampingSmoothing::of(result.impacts);
    result.parts = find_parts(result.smoothing, options);
    note_impacts(result, set);
}

/// The rising branch. A robust fit takes every impact where outliers leave too few of them a branch.
RisingBranch branch_for(MeasuredDamping& result, const ContactModel& model, const MeasurementSet& set,
                        const DampingCurveOptions& options) {
    const auto every = [&] {
        result.findings.push_back(
            {"rising-branch-hidden", Severity::background,
             "extrapolated fit: outliers hide the rising branch, every rebound is used"});
        return impacts_up_to(set, std::numeric_limits<double>::infinity());
    };
    try {
        RisingBranch branch = rising_branch(model, set, result.smoothing);
        const auto needed = static_cast<std::size_t>(options.order) + 2;
        return options.robust && branch.set.rebounds() < needed && set.rebounds() >= needed ? every()
                                                                                            : branch;
    } catch (const InputError&) {
        if (!options.robust) throw;
        return every();
    }
}

/// An extrapolated v_c must not lie above half of the rebounds, however uncertain it is; above none of them
/// if nothing else supports it.
void require_below_rebounds(MeasuredDamping& result, const MeasurementSet& set) {
    std::vector<double> rebounds;
    for (const Measurement& point : set.sorted())
        if (!point.captured()) rebounds.push_back(point.velocity);
    const bool alone = !result.estimate && !result.measured.fastest_capture;
    const double bound = rebounds[alone ? 0 : rebounds.size() / 2];
    const double value = result.extrapolated->critical_velocity.value;
    if (value <= bound) return;
    result.findings.push_back({"no-extrapolation", Severity::doubt,
                               "no extrapolated fit: its v_c of " + shortest(std::round(1e4 * value) / 1e4) +
                                   " m/s lies above rebounds, such as one at " + shortest(bound) + " m/s"});
    result.extrapolated.reset();
}

/// Doubt where the estimate lies outside of what captures and rebounds alone allow: it takes some of them for
/// outliers.
void note_outcomes(MeasuredDamping& result) {
    const double value = result.estimate->curve.critical_velocity.value;
    const MeasuredCriticalVelocity& measured = result.measured;
    const bool above = measured.upper && value > *measured.upper;
    if (!above && !(measured.lower && value < *measured.lower)) return;
    const double bound = above ? *measured.upper : *measured.lower;
    result.findings.push_back({"outcomes-disagree", Severity::doubt,
                               std::string("captures and rebounds alone place v_c ") +
                                   (above ? "below " : "above ") + shortest(std::round(1e4 * bound) / 1e4) +
                                   " m/s: the estimate takes some of them for outliers"});
}

FitComparison compare(const DampingCurveFit& extrapolated, const Interval& critical_velocity,
                      const Interval& critical_damping) {
    // In logarithms, in which both are closer to normal; 3.5 leaves room for tails that are not.
    constexpr double limit = 3.5;
    const Interval& other = extrapolated.critical_velocity;
    FitComparison result{};
    result.critical_damping_ratio = critical_damping.value / extrapolated.critical_damping.value;
    result.critical_velocity_ratio = critical_velocity.value / other.value;
    const double allowed =
        limit * shared_difference(critical_velocity.standard_uncertainty / critical_velocity.value,
                                  other.standard_uncertainty / other.value);
    result.consistent = std::abs(std::log(result.critical_velocity_ratio)) <= allowed ||
                        critical_velocity.contains(other.value);
    result.statement = "critical velocity of the estimate over that of the extrapolation: " +
                       shortest(std::round(1e4 * result.critical_velocity_ratio) / 1e4);
    if (!result.consistent)
        result.statement += "; they disagree: a damping of order " +
                            std::to_string(extrapolated.options.order) +
                            " in the restitution does not describe these impacts down to capture";
    return result;
}

}  // namespace

VelocityRange velocities_for_fits(Law law, Detachment detachment, const ContactPair& contact,
                                  const MeasurementSet& set) {
    constexpr double below = 0.02;
    constexpr double above = 10.0;
    const auto [slowest, fastest] = std::ranges::minmax_element(set.points, {}, &Measurement::velocity);
    const CriticalVelocity undamped =
        critical_velocity({law, detachment, {DampingLaw::constant, 0.0}, contact});
    return {below * slowest->velocity, above * std::max(fastest->velocity, undamped.value.value_or(0.0))};
}

MeasuredDamping analyse_impacts(Law law, Detachment detachment, const ContactPair& contact,
                                const MeasurementSet& set, const MeasuredDampingOptions& options) {
    if (can_yield(law, contact)) {
        MeasuredDamping result = begun(law, detachment, contact, set, options.estimate);
        result.impacts = invert_by_solving(law, detachment, contact, set);
        note_parts(result, set, options.parts);
        result.findings.push_back(
            {"no-fit-yielding", Severity::doubt, "no fit: a contact that yields has a history"});
        return result;
    }
    validate(set);
    MeasuredDamping result = analyse_impacts(
        make_contact_model(law, detachment, contact, velocities_for_fits(law, detachment, contact, set)), set,
        options);
    result.law = law;  // without adhesion the model's is Hertz
    result.detachment = detachment;
    return result;
}

MeasuredDamping analyse_impacts(const ContactModel& model, const MeasurementSet& set,
                                const MeasuredDampingOptions& options) {
    MeasuredDamping result =
        begun(model.map().law(), model.map().detachment(), model.contact(), set, options.estimate);
    result.accuracy = model.map().accuracy();
    if (!options.rising_to) {
        result.impacts = invert(model, set);
        note_parts(result, set, options.parts);
    }
    if (set.rebounds() == 0) return result;
    result.estimate = attempt("estimate of v_c", "no-estimate", Severity::doubt, result.findings, [&] {
        return estimate_critical_velocity(model, set, options.estimate, options.velocity);
    });
    if (result.estimate) {
        std::ranges::copy(result.estimate->findings, std::back_inserter(result.findings));
        note_outcomes(result);
    }
    // Without a branch there is nothing to extrapolate, as the inversion has reported.
    if (options.rising_to && !(*options.rising_to > 0.0)) return result;
    result.extrapolated =
        attempt("extrapolated fit", "no-extrapolation", Severity::background, result.findings, [&] {
            result.rising = options.rising_to ? impacts_up_to(set, *options.rising_to)
                                              : branch_for(result, model, set, options.extrapolated);
            return extrapolate(result, model, options);
        });
    if (result.extrapolated) require_below_rebounds(result, set);
    if (result.estimate && result.extrapolated)
        result.comparison = compare(*result.extrapolated, result.estimate->curve.critical_velocity,
                                    result.estimate->curve.critical_damping);
    return result;
}

}  // namespace ashimpact
