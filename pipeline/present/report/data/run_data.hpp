// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/case/case.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/present/report/data/headline.hpp"
#include "pipeline/present/report/data/model_curve.hpp"
#include "pipeline/run/results/run.hpp"
#include "solver/damping/damping_polynomial.hpp"

namespace ashimpact::report {

/// What a run says of one law and one sample; what there is not is null or none.
struct LawData {
    LawChoice choice;
    std::string name;                   ///< for readers, "Brach-Dunn"
    const RestitutionSeries* measured;  ///< the impacts this law was read from
    const DampingSeries* damping;
    const LawFit* fit;
    const LawCriticalVelocity* velocity;
    Json damping_json;   ///< its entry in 5-damping.json, or null
    Json fit_json;       ///< in 6-fit.json
    Json velocity_json;  ///< in 7-critical-velocity.json
    Json histories;      ///< in 8-histories.json
    Headline headline{};
    std::optional<DampingPolynomial> damping_fit{};  ///< eta(e) over the rising branch
    std::optional<double> curve_start{};             ///< v_c of that fit, where the curve begins [m/s]
    ModelCurve curve{};
};

struct SampleData {
    std::string name;
    const Sample* sample;
    const SampleContact* contact;
    const SampleAnalytic* analytic;
    Json modulus;     ///< its entry in 1-modulus.json
    Json comparison;  ///< in comparison.json
    Json measured;    ///< measured critical velocity in 7-critical-velocity.json, or null
    std::vector<LawData> laws{};
};

/// A run as its artifacts have it, with the model's curves, which are computed from them.
class RunData {
  public:
    /// @param label what tells this run from others: its folder, or the name of its case
    /// @throws InputError for artifacts that do not fit together
    RunData(Artifacts artifacts, std::string label);

    [[nodiscard]] const std::string& label() const { return label_; }
    [[nodiscard]] const Case& data() const { return run_.data; }
    [[nodiscard]] const Run& run() const { return run_; }
    [[nodiscard]] const Artifacts& artifacts() const { return artifacts_; }
    [[nodiscard]] const std::vector<SampleData>& samples() const { return samples_; }
    [[nodiscard]] std::string damping_unit() const;
    [[nodiscard]] bool any_reconstructed() const;
    [[nodiscard]] bool any_measured() const;

  private:
    void read_sample(std::size_t index);

    std::string label_;
    Artifacts artifacts_;
    Run run_;
    std::vector<SampleData> samples_;
};

/// A law's name for readers: "brach-dunn" as "Brach-Dunn", "jkr" as "JKR".
[[nodiscard]] std::string display_name(std::string_view law);

}  // namespace ashimpact::report
