// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/run/uncertainty/calibrated_constants.hpp"

#include <algorithm>
#include <variant>

#include "pipeline/run/uncertainty/calibration_problem.hpp"

namespace ashimpact {

namespace {

bool is_inferred(const Stated& stated) {
    return stated.origin == Origin::inferred;
}

bool has_inferred_density(const Sample& sample) {
    return sample.density && is_inferred(*sample.density);
}

bool has_inferred_adhesion(const Sample& sample) {
    const auto* stated = sample.work_of_adhesion ? std::get_if<Stated>(&*sample.work_of_adhesion) : nullptr;
    return stated != nullptr && is_inferred(*stated);
}

}  // namespace

std::vector<CalibrationResponse> calibrated_constants(const Case& data, const ModulusResult& moduli,
                                                      const ContactResult& contacts, StageRecord& record) {
    std::vector<CalibrationResponse> independent(data.samples.size());
    const bool inferred = std::ranges::any_of(data.samples, [](const Sample& sample) {
        return has_inferred_density(sample) || has_inferred_adhesion(sample);
    });
    if (!inferred || data.calibration.empty()) return independent;
    std::vector<Finding> findings;
    auto responses =
        attempt("response of the inferred constants to the contact modulus", "no-calibration-response",
                Severity::doubt, findings,
                [&] { return response_to_contact_modulus(calibration_problem(data, moduli, contacts)); });
    record.note(findings, {});
    if (!responses) return independent;
    for (std::size_t i = 0; i < responses->size(); ++i) {
        if (!has_inferred_density(data.samples[i])) (*responses)[i].density = 0;
        if (!has_inferred_adhesion(data.samples[i])) (*responses)[i].work_of_adhesion = 0;
    }
    return *std::move(responses);
}

}  // namespace ashimpact
