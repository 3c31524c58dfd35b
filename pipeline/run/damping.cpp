// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/damping/damping.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/run/dampings.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/damping_inversion.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// One impact by solving, for damping laws and contacts that have no map.
/// @param near the answer of the batch solver, NaN where it has none
InvertedImpact solved(const Measurement& point, std::size_t index, const DampingProblem& problem,
                      double near) {
    InvertedImpact inverted{.index = index, .velocity = point.velocity, .restitution = problem.restitution};
    try {
        const DampingInversion inversion =
            damping_from_restitution(problem, std::isnan(near) ? std::nullopt : std::optional(near));
        inverted.greatest_restitution = inversion.greatest_restitution;
        inverted.damping = inversion.damping.coefficient;
        inverted.contact_time = inversion.impact.contact_time;
    } catch (const InputError&) {  // no damping gives this restitution: listed with the greatest possible one
        inverted.greatest_restitution = restitution_of(
            {problem.law, problem.detachment, {problem.damping_law, 0}, problem.contact, problem.velocity});
    }
    return inverted;
}

std::vector<InvertedImpact> solved_all(const MeasurementSet& set, const LawChoice& choice,
                                       DampingLaw damping_law, const ContactPair& contact) {
    std::vector<DampingProblem> problems;
    for (const Measurement& point : set.points)
        problems.push_back({.law = choice.law,
                            .detachment = choice.detachment,
                            .damping_law = damping_law,
                            .contact = contact,
                            .velocity = point.velocity,
                            .restitution = point.restitution()});
    const Eigen::ArrayXd near = near_dampings(problems);
    std::vector<InvertedImpact> impacts;
    for (std::size_t i = 0; i < problems.size(); ++i)
        impacts.push_back(solved(set.points[i], i, problems[i], near[static_cast<Eigen::Index>(i)]));
    return impacts;
}

/// The points up to the greatest restitution.
std::optional<RisingRange> branch_to_greatest(const MeasurementSet& set) {
    const auto& points = set.points;
    if (points.empty()) return std::nullopt;
    const auto top = std::ranges::max_element(
        points, {}, [](const Measurement& point) { return std::pair(point.restitution(), -point.velocity); });
    const bool beyond = std::any_of(points.begin(), points.end(),
                                    [&](const auto& point) { return point.velocity > top->velocity; });
    return RisingRange{top->velocity, beyond};
}

DampingSeries read_by_solving(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                              const ContactPair& contact) {
    const auto impacts = solved_all(series.impacts, choice, data.damping_law, contact);
    DampingSeries damping = inverted_series(impacts);
    damping.rising = branch_to_greatest(series.impacts);
    const auto smoothing = DampingSmoothing::of(impacts);
    set_parts(find_parts(smoothing, data.fit.parts), impacts, damping);
    damping.angles = compare_angles(series.impacts, impacts, smoothing);
    return damping;
}

DampingSeries read_through_model(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                                 const ContactPair& contact, ContactModels& models) {
    const ContactModel model = models.model_for(choice, contact, series.impacts);
    const auto impacts = invert(model, series.impacts);
    DampingSeries damping = inverted_series(impacts);
    damping.map_accuracy = model.map().accuracy();
    const auto smoothing = DampingSmoothing::of(impacts);
    set_parts(find_parts(smoothing, data.fit.parts), impacts, damping);
    damping.angles = compare_angles(series.impacts, impacts, smoothing);
    try {
        const RisingBranch branch = rising_branch(model, series.impacts, smoothing);
        damping.rising = RisingRange{branch.upper, branch.falls_beyond};
    } catch (const InputError& error) {
        damping.rising_note = error.problem();
    }
    return damping;
}

DampingSeries damping_of(const RestitutionSeries& series, const LawChoice& choice, const Case& data,
                         const ContactPair& contact, ContactModels& models) {
    const bool measured = series.origin == Origin::measured;
    DampingSeries damping = measured && has_contact_model(choice, data.damping_law, contact)
                                ? read_through_model(series, choice, data, contact, models)
                                : read_by_solving(series, choice, data, contact);
    damping.origin = series.origin;
    return damping;
}

/// " at 0.73 m/s": the velocity of an impact by its number, empty if it has no damping.
std::string velocity_of(const DampingSeries& series, std::size_t number) {
    for (std::size_t i = 0; i < series.number.size(); ++i)
        if (series.number[i] == static_cast<double>(number))
            return " at " + readable(series.velocity[i], "m/s");
    return {};
}

/// "at 0 to 20 degrees +3 +- 4 %".
std::string class_words(const AngleClass& each) {
    constexpr double degree = std::numbers::pi / 180;
    return fmt::format("at {:.0f} to {:.0f} degrees {:+.1f} +- {:.1f} %", each.from / degree,
                       each.to / degree, 100 * std::expm1(each.difference), 100 * each.standard_uncertainty);
}

/// Whether the velocity normal to the wall decides, in words.
Finding finding_on(const AngleComparison& angles) {
    std::vector<std::string> classes;
    for (const AngleClass& each : angles.classes) classes.push_back(class_words(each));
    const std::string differences = fmt::format(
        "damping against that of all angles at the same normal velocity: {} (probability of such "
        "differences by chance {:.2g})",
        joined(classes), angles.probability);
    return angles.normal_decides()
               ? Finding{"angles", Severity::remark, "the normal velocity decides: " + differences}
               : Finding{
                     "angles", Severity::doubt,
                     "the normal velocity alone does not decide, impacts at an angle differ: " + differences};
}

/// @param points impacts of the series
std::vector<Finding> findings_on(const DampingSeries& series, std::size_t points) {
    std::vector<Finding> findings;
    if (!series.unreachable.empty())
        findings.push_back({"unreachable", Severity::doubt,
                            fmt::format("{} of {} cannot be reached by any damping",
                                        series.unreachable.size(), counted(points, "restitution"))});
    if (!series.outliers.empty())
        findings.push_back(
            {"outliers", Severity::remark,
             fmt::format("flagged as outliers and left in: {} of {}, first number {}{}",
                         series.outliers.size(), counted(points, "impact"), series.outliers.front(),
                         velocity_of(series, series.outliers.front()))});
    if (!series.rising_note.empty())
        findings.push_back({"no-rising-branch", Severity::doubt, series.rising_note});
    if (series.angles) findings.push_back(finding_on(*series.angles));
    if (series.velocity.empty())
        findings.push_back({"no-rebound", Severity::doubt, "no rebound, so no damping can be read"});
    return findings;
}

/// That the fastest rebound goes beyond the yield pressure, if it does.
std::optional<Finding> finding_on_yield(const DampingSeries& series, const LawChoice& choice,
                                        const Case& data, const ContactPair& contact) {
    if (series.velocity.empty() || !std::isfinite(contact.yield_pressure)) return std::nullopt;
    const auto fastest = std::ranges::max_element(series.velocity) - series.velocity.begin();
    const Impact impact{choice.law,
                        choice.detachment,
                        {data.damping_law, series.damping[fastest]},
                        contact,
                        series.velocity[fastest]};
    return yield_finding(impact, regime_of(impact, solve_impact(impact).maximum_overlap));
}

/// The laws of the case that take their data from the fit of @p law.
std::vector<Law> laws_served(const Case& data, const Reconstruction& plan, Law law) {
    std::vector<Law> laws;
    for (const LawChoice& choice : data.laws) {
        const bool own = plan.damping_fits.find(choice.law) != nullptr;
        if (choice.law == law || (!own && law.name() == plan.reference)) laws.push_back(choice.law);
    }
    return laws;
}

/// Sets the impacts of a series to those that its columns list, so that later stages compute with the numbers
/// that the artifact has.
void list_impacts(const MeasurementSet& impacts, RestitutionSeries& series) {
    series.columns = columns_of(impacts);
    series.impacts = impacts_of(series.columns);
    series.impacts.source = series.source;
}

RestitutionSeries reconstruct(const PublishedDamping& published, const Reconstruction& plan,
                              std::vector<Finding>& findings) {
    RestitutionSeries series{.origin = Origin::reconstructed};
    series.source = fmt::format("damping fit of {} in {}", published.law.name(), plan.source);
    series.coefficient_uncertainty = plan.coefficient_uncertainty;
    MeasurementSet impacts{.source = {}, .points = {}};
    for (int i = 0; i < plan.points; ++i) {
        const double e = plan.from + (plan.to - plan.from) * i / (plan.points - 1);
        try {
            const double velocity = reconstructed_velocity(published, e);
            impacts.points.push_back({.velocity = velocity, .rebound = e * velocity});
        } catch (const InputError& error) {
            findings.push_back(
                {"no-point", Severity::doubt,
                 fmt::format("no point at restitution {}: {}", readable_number(e), error.problem())});
        }
    }
    if (!std::is_sorted(impacts.points.begin(), impacts.points.end(),
                        [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; }))
        findings.push_back({"velocity-not-rising", Severity::doubt,
                            "the velocity does not rise with restitution over the whole range, so this fit "
                            "is not one of a rising branch there"});
    list_impacts(impacts, series);
    return series;
}

/// The series of a sample, and findings on them.
struct FoundSeries {
    SampleRestitution restitution;
    std::vector<std::pair<Law, std::vector<Finding>>> findings{};
};

FoundSeries series_of(const Case& data, const Sample& sample, const SampleContact& contact) {
    FoundSeries found{{sample.name, {}}};
    if (!sample.restitution) return found;
    std::vector<RestitutionSeries>& all = found.restitution.series;
    if (const auto* measured = std::get_if<MeasuredRestitution>(&*sample.restitution)) {
        RestitutionSeries series{.origin = Origin::measured, .source = measured->source};
        for (const LawChoice& choice : data.laws) series.laws.push_back(choice.law);
        list_impacts(measured->impacts, series);
        all.push_back(std::move(series));
        return found;
    }
    const auto& plan = std::get<Reconstruction>(*sample.restitution);
    for (const auto& [law, fit] : plan.damping_fits) {
        const auto served = laws_served(data, plan, law);
        if (served.empty()) continue;
        std::vector<Finding> findings;
        all.push_back(reconstruct({law, data.detachment_of(law), contact.pair, fit}, plan, findings));
        all.back().laws = served;
        found.findings.emplace_back(law, std::move(findings));
    }
    return found;
}

}  // namespace

DampingStageResult damping_stage(const Case& data, const ContactResult& contacts,
                                 const RestitutionResult& restitutions, ContactModels& models,
                                 StageRecord& record) {
    record.citations = {"dong2013, section 4.2"};
    DampingStageResult result;
    for (std::size_t i = 0; i < restitutions.samples.size(); ++i) {
        const SampleRestitution& sample = restitutions.samples[i];
        const auto read = [&](const LawChoice& choice) -> ResultOfLaw<DampingSeries> {
            const RestitutionSeries* series = sample.of(choice.law);
            if (series == nullptr) return {};
            const DampingSeries damping = damping_of(*series, choice, data, contacts.samples[i].pair, models);
            ResultOfLaw<DampingSeries> found{damping, findings_on(damping, series->impacts.points.size())};
            if (const auto yields = finding_on_yield(damping, choice, data, contacts.samples[i].pair))
                found.findings.push_back(*yields);
            return found;
        };
        result.samples.push_back(
            {sample.name, results_by_law<DampingSeries>(data, sample.name, record, read)});
    }
    return result;
}

RestitutionResult restitution_stage(const Case& data, const ContactResult& contacts, StageRecord& record) {
    record.citations = {"dong2013, Eqs. 2 and 31, Table 2"};
    std::vector<std::size_t> positions(data.samples.size());
    std::iota(positions.begin(), positions.end(), 0);
    auto all = in_parallel(
        positions, [&](std::size_t i) { return series_of(data, data.samples[i], contacts.samples[i]); });
    RestitutionResult result;
    for (FoundSeries& found : all) {
        const std::string& name = found.restitution.name;
        if (!data.samples[result.samples.size()].restitution)
            record.note({"no-restitution", Severity::doubt,
                         "no restitution data, so no damping and no dynamic velocity"},
                        name);
        for (const auto& [law, findings] : found.findings) record.note(findings, name, law);
        result.samples.push_back(std::move(found.restitution));
    }
    return result;
}

}  // namespace ashimpact
