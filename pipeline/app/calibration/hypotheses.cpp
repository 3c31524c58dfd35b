// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/calibration/hypotheses.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/json/view.hpp"
#include "core/quantities/readable.hpp"
#include "core/text/error.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/present/text/layout.hpp"

namespace ashimpact {

namespace {

std::vector<CalibrationHypothesis> hypotheses_of(bool elastic_wall, std::size_t samples) {
    struct Modulus {
        const char* name;
        std::optional<CalibrationQuantity> free;
    };
    std::vector<Modulus> moduli{{"moduli from XRD", std::nullopt},
                                {"one contact modulus", CalibrationQuantity::contact_modulus}};
    if (elastic_wall)
        moduli.push_back({"moduli from XRD, wall free", CalibrationQuantity::wall_young_modulus});
    std::vector<CalibrationHypothesis> hypotheses;
    for (const Modulus& modulus : moduli)
        for (const bool each : {false, true}) {
            if (each && samples < 2) continue;
            CalibrationHypothesis hypothesis{
                .name = fmt::format("{}, {}", modulus.name, each ? "a density per size" : "one density"),
                .free = {{CalibrationQuantity::work_of_adhesion, false},
                         {CalibrationQuantity::density, each}}};
            if (modulus.free) hypothesis.free.push_back({*modulus.free, false});
            hypotheses.push_back(std::move(hypothesis));
        }
    return hypotheses;
}

double greatest_difference(const std::vector<CalibrationResidual>& residuals) {
    double greatest = 0;
    for (const CalibrationResidual& residual : residuals)
        if (!residual.captured_up_to) greatest = std::max(greatest, std::abs(residual.relative_difference()));
    return greatest;
}

/// The observation furthest from what is calibrated, in standard uncertainties.
struct LargestResidual {
    std::string what;  ///< "contact time of 88 um, brach-dunn"
    double in_uncertainties;
};

LargestResidual largest_residual(const CalibrationSummary& summary, bool velocities_only,
                                 const ComparedObservations& observations) {
    LargestResidual largest{"none", 0};
    const auto compare = [&](const char* what, const auto& observed,
                             const std::vector<CalibrationResidual>& residuals) {
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            const double size = residuals[i].relative_difference() / residuals[i].relative_uncertainty;
            if (residuals[i].captured_up_to || std::abs(size) <= std::abs(largest.in_uncertainties)) continue;
            largest = {fmt::format("{} of {}, {}", what, observations.samples[observed[i].sample],
                                   observed[i].law.name()),
                       size};
        }
    };
    compare("v_c", observations.problem.critical_velocities, summary.critical_velocities);
    if (!velocities_only) compare("contact time", observations.problem.contact_times, summary.contact_times);
    return largest;
}

/// An impact that rebounded and that a calibrated model captures.
struct FalseCapture {
    std::string sample;
    std::string law;
    double velocity;              ///< at which its contact time was measured [m/s]
    double captured_up_to;        ///< [m/s]
    double velocity_uncertainty;  ///< standard [m/s]

    [[nodiscard]] double in_uncertainties() const {
        return (captured_up_to - velocity) / velocity_uncertainty;
    }
};

std::vector<FalseCapture> false_captures(const CalibrationSummary& summary,
                                         const ComparedObservations& observations) {
    std::vector<FalseCapture> captures;
    for (std::size_t i = 0; i < summary.contact_times.size(); ++i) {
        const ContactTimeObservation& observed = observations.problem.contact_times[i];
        if (const auto up_to = summary.contact_times[i].captured_up_to)
            captures.push_back({observations.samples[observed.sample], std::string(observed.law.name()),
                                observed.velocity, *up_to, observed.velocity_uncertainty});
    }
    return captures;
}

/// Whether chi^2 lacks the contact times or counts one that the model has not.
bool lacks_times(const CalibrationHypothesis& hypothesis, const ComparedObservations& observations) {
    return hypothesis.velocities_only || !false_captures(*hypothesis.summary, observations).empty();
}

/// The hypothesis that AIC prefers, of those that have all contact times, or the end.
auto preferred(const std::vector<CalibrationHypothesis>& hypotheses,
               const ComparedObservations& observations) {
    auto best = hypotheses.end();
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each)
        if (each->summary && !lacks_times(*each, observations) &&
            (best == hypotheses.end() || each->summary->akaike < best->summary->akaike))
            best = each;
    return best;
}

/// What a hypothesis lacks to be compared, and why.
std::string remark_on(const CalibrationHypothesis& hypothesis, const ComparedObservations& observations) {
    if (!hypothesis.summary) return fmt::format("{}: {}\n", hypothesis.name, hypothesis.failure);
    if (!lacks_times(hypothesis, observations)) return {};
    std::string text =
        hypothesis.velocities_only
            ? fmt::format(
                  "{}: chi^2 of the critical velocities alone, a bound from below (with contact times: {})",
                  hypothesis.name, hypothesis.failure)
            : hypothesis.name +
                  ": a captured impact has no contact time, that just above v_c, prolonged, counts";
    for (const FalseCapture& capture : false_captures(*hypothesis.summary, observations)) {
        text += fmt::format("; contact time of {}, {}: captured at {}, up to {}", capture.sample, capture.law,
                            readable(capture.velocity, "m/s"), readable(capture.captured_up_to, "m/s"));
        if (capture.velocity_uncertainty > 0)
            text += fmt::format(", {} standard uncertainties of the velocity above it",
                                readable_number(capture.in_uncertainties(), 2));
    }
    return text + "\n";
}

}  // namespace

std::vector<CalibrationHypothesis> compare_hypotheses(const CalibrationProblem& problem, bool elastic_wall,
                                                      bool shows_progress) {
    std::vector<CalibrationHypothesis> hypotheses = hypotheses_of(elastic_wall, problem.samples.size());
    Progress progress(hypotheses.size(), 0, shows_progress, "hypotheses");
    std::uint64_t begun = 0;
    for (CalibrationHypothesis& hypothesis : hypotheses) {
        progress.update(begun++);
        CalibrationProblem own = problem;
        own.free = hypothesis.free;
        try {
            hypothesis.summary = calibrate_despite_captures(own);
        } catch (const InputError& error) {
            hypothesis.failure = error.what();
        } catch (const ConvergenceError& error) {
            hypothesis.failure = error.what();
        }
        if (hypothesis.summary) continue;
        try {
            hypothesis.summary = calibrate_by_velocities(own);
            hypothesis.velocities_only = true;
        } catch (const InputError&) {  // too few of them: the failure stands
        } catch (const ConvergenceError&) {
        }
    }
    return hypotheses;
}

std::string hypotheses_text(const std::vector<CalibrationHypothesis>& hypotheses,
                            const ComparedObservations& observations) {
    TextTable table({"hypothesis", "constants", "chi^2", "degrees of freedom", "probability", "AIC",
                     "worst v_c", "worst contact time", "largest residual [u]"});
    const auto percent = [](double share) { return fmt::format("{:.2f} %", 100 * share); };
    std::string remarks;
    for (const CalibrationHypothesis& hypothesis : hypotheses) {
        remarks += remark_on(hypothesis, observations);
        if (!hypothesis.summary) continue;
        const CalibrationSummary& summary = *hypothesis.summary;
        const bool captured = !false_captures(summary, observations).empty();
        const char* bound = hypothesis.velocities_only ? "> " : "";
        const LargestResidual largest = largest_residual(summary, hypothesis.velocities_only, observations);
        table.add({hypothesis.name, std::to_string(summary.constants.size()),
                   bound + readable_number(summary.chi_squared), std::to_string(summary.degrees_of_freedom),
                   readable_number(summary.probability, 2), bound + readable_number(summary.akaike),
                   percent(greatest_difference(summary.critical_velocities)),
                   captured                     ? "captured"
                   : hypothesis.velocities_only ? "-"
                                                : percent(greatest_difference(summary.contact_times)),
                   fmt::format("{:+.1f} {}", largest.in_uncertainties, largest.what)});
    }
    const auto best = preferred(hypotheses, observations);
    const std::string verdict =
        best == hypotheses.end()
            ? "No hypothesis could be calibrated.\n"
            : fmt::format("Least AIC: {}. A difference below about 2 decides nothing.\n", best->name);
    return table.text() + remarks + verdict;
}

Json hypotheses_json(const std::vector<CalibrationHypothesis>& hypotheses,
                     const ComparedObservations& observations) {
    Json list = Json::array();
    const auto best = preferred(hypotheses, observations);
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each) {
        Json json{{"hypothesis", each->name}, {"preferred", each == best}};
        if (each->summary) {
            const CalibrationSummary& summary = *each->summary;
            const LargestResidual largest = largest_residual(summary, each->velocities_only, observations);
            json.update({{"constants", summary.constants.size()},
                         {"velocities_only", each->velocities_only},
                         {"chi_squared", summary.chi_squared},
                         {"degrees_of_freedom", summary.degrees_of_freedom},
                         {"probability", summary.probability},
                         {"akaike", finite_json(summary.akaike)},
                         {"worst_critical_velocity", greatest_difference(summary.critical_velocities)},
                         {"worst_contact_time", greatest_difference(summary.contact_times)},
                         {"largest_residual",
                          {{"observation", largest.what}, {"in_uncertainties", largest.in_uncertainties}}}});
            json["captured"] = Json::array();
            for (const FalseCapture& capture : false_captures(summary, observations))
                json["captured"].push_back(
                    {{"sample", capture.sample},
                     {"law", capture.law},
                     {"velocity", quantity_json(capture.velocity, Dimension::velocity)},
                     {"captured_up_to", quantity_json(capture.captured_up_to, Dimension::velocity)},
                     {"in_uncertainties", finite_json(capture.in_uncertainties())}});
        }
        if (!each->failure.empty()) json["failure"] = each->failure;
        list.push_back(std::move(json));
    }
    return {{"hypotheses", list}};
}

}  // namespace ashimpact
