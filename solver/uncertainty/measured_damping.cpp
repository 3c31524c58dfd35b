#include "solver/uncertainty/measured_damping.hpp"

#include "materials/base/error.hpp"
#include "materials/base/text.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/motion/scaled_impact.hpp"
#include "solver/uncertainty/outcomes/rebound_check.hpp"

#include <algorithm>
#include <cmath>

namespace ashimpact {

namespace {

/// Calls @p step; input that does not allow it becomes a note.
template <class Step>
void attempt(std::vector<std::string>& notes, const std::string& what, Step&& step) {
    try {
        step();
    } catch (const InputError& error) {
        notes.push_back("no " + what + ": " + error.problem());
    } catch (const ConvergenceError& error) {
        notes.push_back("no " + what + ": " + error.what());
    }
}

void note_impacts(MeasuredDamping& result, const MeasurementSet& set) {
    const auto beyond = static_cast<std::size_t>(
        std::count_if(result.impacts.begin(), result.impacts.end(),
                      [](const InvertedImpact& i) { return i.restitution > 0.0 && !i.damping; }));
    if (beyond > 0)
        result.notes.push_back(std::to_string(beyond) + " of " + std::to_string(set.rebounds()) +
                               " rebounds are faster than without any damping: no damping gives them");
    if (!result.parts.outliers.empty())
        result.notes.push_back(std::to_string(result.parts.outliers.size()) +
                               " outliers are flagged and left in");
    if (set.rebounds() == 0) result.notes.push_back("every impact was captured: there is nothing to fit");
}

/// The fit of that order among those compared, or a new one.
DampingCurveFit fit_or_reuse(const OrderComparison& orders, const ContactModel& model,
                             const MeasurementSet& set, const DampingCurveOptions& options) {
    for (const DampingCurveFit& fit : orders.fits)
        if (fit.options.order == options.order) return fit;
    return fit_damping_curve(model, set, options);
}

class RisingBranchFits {
  public:
    RisingBranchFits(const ContactModel& model, const RandomContact& contact,
                     const MeasuredDampingOptions& options, MeasuredDamping& result)
        : model_(model), contact_(contact), options_(options), result_(result) {}

    void fit() {
        const MeasurementSet& rising = result_.rising->set;
        result_.orders = compare_orders(model_, rising, options_.orders, options_.extrapolated);
        attempt(result_.notes, "extrapolated fit", [&] {
            result_.extrapolated = completed(
                fit_or_reuse(result_.orders, model_, rising, options_.extrapolated), "extrapolated");
        });
        attempt(result_.notes, "direct fit", [&] {
            result_.direct = completed(fit_damping_curve(model_, rising, options_.direct), "direct");
        });
        const auto spacing = spacing_note(rising);
        if (result_.direct && spacing) result_.notes.push_back(*spacing);
        if (result_.extrapolated && result_.direct)
            result_.comparison = compare(result_.extrapolated->fit, result_.direct->fit);
    }

  private:
    DampingResult completed(DampingCurveFit fit, const std::string& name) {
        require_rebounds_above(fit, result_.rising->set);
        DampingResult result{std::move(fit), {}, {}};
        if (const auto note = enlargement_note(result.fit)) result_.notes.push_back(name + " fit: " + *note);
        if (options_.propagate) {
            attempt(result_.notes, "propagation of the " + name + " fit", [&] {
                result.propagation = propagate_critical_velocity(result.fit, model_, contact_,
                                                                 options_.change, options_.propagation);
            });
        }
        result.check = check(result.propagation ? result.propagation->interval : result.fit.critical_velocity,
                             result_.measured);
        return result;
    }

    const ContactModel& model_;
    const RandomContact& contact_;
    const MeasuredDampingOptions& options_;
    MeasuredDamping& result_;
};

}  // namespace

VelocityRange velocities_for_fits(Law law, Detachment detachment, const ContactPair& contact,
                                  const MeasurementSet& set) {
    constexpr double below = 0.02;
    constexpr double above = 10.0;
    const auto slower = [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; };
    const auto [slowest, fastest] = std::minmax_element(set.points.begin(), set.points.end(), slower);
    const CriticalVelocity undamped =
        critical_velocity({law, detachment, {DampingLaw::constant, 0.0}, contact});
    return {below * slowest->velocity, above * std::max(fastest->velocity, undamped.value.value_or(0.0))};
}

MeasuredDamping analyse_impacts(Law law, Detachment detachment, const RandomContact& contact,
                                const MeasurementSet& set, const MeasuredDampingOptions& options) {
    validate(set);
    const ContactPair pair = contact.nominal();
    MeasuredDamping result{.law = law,
                           .detachment = detachment,
                           .contact = pair,
                           .impacts = {},
                           .smoothing = {},
                           .parts = {},
                           .rising = {},
                           .extrapolated = {},
                           .direct = {},
                           .comparison = {},
                           .orders = {},
                           .measured = options.reported.value_or(MeasuredCriticalVelocity{}),
                           .accuracy = 0.0,
                           .notes = {}};
    if (!options.reported)
        attempt(result.notes, "measured v_c", [&] { result.measured = measured_critical_velocity(set); });
    if (can_yield(law, pair)) {
        result.impacts = invert_by_solving(law, detachment, pair, set);
        result.smoothing = DampingSmoothing::of(result.impacts);
        result.parts = find_parts(result.smoothing, options.parts);
        note_impacts(result, set);
        result.notes.push_back("no fit: a contact that yields has a history");
        return result;
    }
    const ContactModel model =
        make_contact_model(law, detachment, pair, velocities_for_fits(law, detachment, pair, set));
    result.accuracy = model.map().accuracy();
    result.impacts = invert(model, set);
    result.smoothing = DampingSmoothing::of(result.impacts);
    result.parts = find_parts(result.smoothing, options.parts);
    note_impacts(result, set);
    if (set.rebounds() == 0) return result;
    attempt(result.notes, "fit", [&] { result.rising = rising_branch(model, set, result.smoothing); });
    if (result.rising) RisingBranchFits(model, contact, options, result).fit();
    return result;
}

}  // namespace ashimpact
