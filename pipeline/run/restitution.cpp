// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/restitution.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/quantities/readable.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/inference/calibration/reconstruction.hpp"

namespace ashimpact {

namespace {

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
        Detachment detachment = law.default_detachment();
        for (const LawChoice& choice : data.laws)
            if (choice.law == law) detachment = choice.detachment;
        std::vector<Finding> findings;
        all.push_back(reconstruct({law, detachment, contact.pair, fit}, plan, findings));
        all.back().laws = served;
        found.findings.emplace_back(law, std::move(findings));
    }
    return found;
}

}  // namespace

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
