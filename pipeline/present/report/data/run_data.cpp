// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/data/run_data.hpp"

#include <algorithm>

#include "pipeline/case/laws.hpp"
#include "pipeline/document/results/run_json.hpp"
#include "solver/batch/in_parallel.hpp"

namespace ashimpact::report {

namespace {

/// The entry of a sample in an artifact's result.
const Json& entry_of(const Artifacts& artifacts, std::string_view file, const std::string& name) {
    static const Json none = Json::object();
    const Json& result = artifacts.at(file).document.at("result");
    for (const Json& sample : result.at("samples"))
        if (sample.at("name") == name) return sample;
    return none;
}

Json member(const Json& object, const std::string& key) {
    return object.contains(key) ? object.at(key) : Json(nullptr);
}

/// The fit eta(e) of measured impacts, null for others.
const Json* curve_fit(const LawData& law) {
    if (!law.fit_json.is_object() || !law.fit_json.contains("extrapolated")) return nullptr;
    const Json& fit = law.fit_json.at("extrapolated");
    return fit.is_object() && fit.contains("coefficients") ? &fit : nullptr;
}

std::optional<DampingPolynomial> damping_fit_of(const LawData& law) {
    if (law.fit == nullptr) return std::nullopt;
    return law.fit->extrapolated ? law.fit->extrapolated->damping : law.fit->damping;
}

/// Covariance of the coefficients; of a reconstructed series the rounding of the printed ones.
Eigen::MatrixXd covariance_of(const LawData& law) {
    const Eigen::Index count = law.damping_fit->coefficients.size();
    if (law.measured != nullptr && law.measured->coefficient_uncertainty) {
        const double u = *law.measured->coefficient_uncertainty;
        return u * u * Eigen::MatrixXd::Identity(count, count);
    }
    if (law.fit->extrapolated) return law.fit->extrapolated->covariance;
    return Eigen::MatrixXd::Zero(count, count);
}

/// Curves end at so many times the greatest velocity of the impacts: a fit that needs more for the greatest
/// restitution would take the whole figure.
constexpr double beyond_impacts = 1.25;

/// Impacts near the rising model curve: where it begins, and the points up to the greatest restitution.
std::vector<CurveKnot> knots_of(const LawData& law) {
    std::vector<CurveKnot> knots;
    if (law.curve_start && *law.curve_start > 0) knots.push_back({0, *law.curve_start});
    const std::vector<double>& e = law.damping->restitution;
    const std::vector<double>& v = law.damping->velocity;
    if (e.empty()) return knots;
    const auto greatest = static_cast<std::size_t>(std::max_element(e.begin(), e.end()) - e.begin());
    for (std::size_t i = 0; i < v.size(); ++i)
        if (v[i] <= v[greatest]) knots.push_back({e[i], v[i]});
    return knots;
}

}  // namespace

std::string display_name(std::string_view law) {
    const bool spelled = law.find_first_of("aeiou") == std::string_view::npos;  // an abbreviation
    std::string name;
    bool capital = true;
    for (const char c : law) {
        const bool letter = c >= 'a' && c <= 'z';
        name += letter && (capital || spelled) ? static_cast<char>(c - 'a' + 'A') : c;
        capital = !letter;
    }
    return name;
}

RunData::RunData(Artifacts artifacts, std::string label)
    : label_(std::move(label)), artifacts_(std::move(artifacts)), run_(read_run(artifacts_)) {
    for (std::size_t i = 0; i < run_.data.samples.size(); ++i) read_sample(i);
    std::vector<LawData*> laws;
    std::vector<const SampleData*> owners;
    for (SampleData& sample : samples_)
        for (LawData& law : sample.laws) {
            laws.push_back(&law);
            owners.push_back(&sample);
        }
    std::vector<std::size_t> positions(laws.size());
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = i;
    // The slowest curves first, so that no core waits for one at the end.
    std::stable_partition(positions.begin(), positions.end(), [&](std::size_t i) {
        return is_cohesive(laws[i]->choice.law, owners[i]->contact->pair);
    });
    const auto curves = in_parallel(positions, [&](std::size_t i) -> ModelCurve {
        const LawData& law = *laws[i];
        if (law.damping == nullptr || !law.damping_fit || !law.headline.value) return {};
        const auto greatest = [](const std::vector<double>& values) {
            return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
        };
        return model_curve({.choice = law.choice,
                            .damping_law = run_.data.damping_law,
                            .contact = owners[i]->contact->pair,
                            .damping_fit = *law.damping_fit,
                            .covariance = covariance_of(law),
                            .greatest_restitution = greatest(law.damping->restitution),
                            .greatest_velocity = beyond_impacts * greatest(law.damping->velocity),
                            .knots = knots_of(law)});
    });
    for (std::size_t i = 0; i < laws.size(); ++i) laws[positions[i]]->curve = curves[i];
}

void RunData::read_sample(std::size_t index) {
    const Sample& sample = run_.data.samples[index];
    const Json& dampings = entry_of(artifacts_, "5-damping.json", sample.name);
    const Json& fits = entry_of(artifacts_, "6-fit.json", sample.name);
    const Json& velocities = entry_of(artifacts_, "7-critical-velocity.json", sample.name);
    const Json& histories = entry_of(artifacts_, "8-histories.json", sample.name);
    SampleData entry{.name = sample.name,
                     .sample = &sample,
                     .contact = &run_.contact.samples[index],
                     .analytic = &run_.analytic.samples[index],
                     .modulus = entry_of(artifacts_, "1-modulus.json", sample.name),
                     .comparison = entry_of(artifacts_, "comparison.json", sample.name),
                     .measured = member(velocities, "measured")};
    const SampleRestitution& restitution = run_.restitution.samples[index];
    const SampleDamping& damping = run_.damping.samples[index];
    const SampleFit& fit = run_.fit.samples[index];
    const SampleCriticalVelocity& velocity = run_.critical_velocity.samples[index];
    for (const LawChoice& choice : run_.data.laws) {
        const std::string key(choice.law.name());
        LawData law{.choice = choice,
                    .name = display_name(key),
                    .measured = restitution.of(choice.law),
                    .damping = damping.laws.find(choice.law),
                    .fit = fit.laws.find(choice.law),
                    .velocity = velocity.laws.find(choice.law),
                    .damping_json = member(dampings, key),
                    .fit_json = member(fits, key),
                    .velocity_json = member(velocities, key),
                    .histories = member(histories, key)};
        if (law.velocity_json.is_object()) law.headline = headline_of(law.velocity_json);
        law.damping_fit = damping_fit_of(law);
        const Json* fit_of_curve = curve_fit(law);
        law.curve_start =
            fit_of_curve != nullptr ? number_in(*fit_of_curve, "critical_velocity") : law.headline.value;
        entry.laws.push_back(std::move(law));
    }
    samples_.push_back(std::move(entry));
}

std::string RunData::damping_unit() const {
    return std::string(unit_of(run_.data.damping_law));
}

bool RunData::any_reconstructed() const {
    for (const auto& sample : run_.restitution.samples)
        for (const auto& series : sample.series)
            if (series.origin != Origin::measured) return true;
    return false;
}

bool RunData::any_measured() const {
    for (const auto& sample : run_.restitution.samples)
        for (const auto& series : sample.series)
            if (series.origin == Origin::measured) return true;
    return false;
}

}  // namespace ashimpact::report
