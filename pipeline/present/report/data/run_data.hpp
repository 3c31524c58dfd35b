// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/run/results/run.hpp"

namespace ashimpact::report {

/// What a run found out about one law and one sample; null where there is no such result.
struct LawData {
    LawChoice choice;
    std::string name;  ///< for readers, "Brach-Dunn"
    const RestitutionSeries* measured = nullptr;
    const DampingSeries* damping = nullptr;
    const LawFit* fit = nullptr;
    const LawCriticalVelocity* velocity = nullptr;
    const LawComparison* compared = nullptr;
    const std::vector<History>* histories = nullptr;
    const LawCurve* drawn = nullptr;

    /// Whether the impacts of this law were reconstructed.
    [[nodiscard]] bool is_reconstructed() const {
        return measured != nullptr && measured->origin != Origin::measured;
    }
    /// The critical velocity of this law with its interval.
    [[nodiscard]] std::optional<VelocityEstimate> headline() const {
        return velocity != nullptr ? velocity->velocity : std::nullopt;
    }
    /// The critical velocity at which the fit to measured rebounds meets e = 0 [m/s].
    [[nodiscard]] std::optional<double> extrapolated() const;
    /// The model's curve e(v_in); empty if there is none.
    [[nodiscard]] const ModelCurve& curve() const;
};

/// The results of one sample.
struct SampleData {
    const Sample* sample;
    const SampleModulus* modulus;
    const SampleContact* contact;
    const SampleAnalytic* analytic;
    const SampleCriticalVelocity* velocity;
    const SampleComparison* comparison;
    std::vector<LawData> laws{};

    [[nodiscard]] const std::string& name() const { return sample->name; }
};

/// A run by samples and laws, for figures and pages.
class RunData {
  public:
    /// @param label distinguishes this run from others: its folder; may be empty
    RunData(Run run, std::string label);

    [[nodiscard]] const std::string& label() const { return label_; }
    [[nodiscard]] const Run& run() const { return run_; }
    [[nodiscard]] const Case& data() const { return run_.data; }
    [[nodiscard]] const std::vector<SampleData>& samples() const { return samples_; }
    [[nodiscard]] std::string damping_unit() const;

  private:
    std::string label_;
    Run run_;  // samples_ refer to its vectors, which a move of it leaves in place
    std::vector<SampleData> samples_;
};

/// A law's name for readers: "brach-dunn" as "Brach-Dunn", "jkr" as "JKR".
[[nodiscard]] std::string display_name(std::string_view law);

}  // namespace ashimpact::report
