// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/calibration/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/document/values_json.hpp"
#include "pipeline/present/text/result_text.hpp"

namespace ashimpact {

namespace {

/// The observation furthest from what is calibrated, in standard uncertainties.
struct LargestResidual {
    std::string what = "none";  ///< "contact time of 88 um, brach-dunn"
    double in_uncertainties = 0;
};

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

/// A set of free constants and what calibration makes of it.
struct CalibrationHypothesis {
    std::string name;
    std::vector<FreeConstant> free;
    /// Makes the problem that of the hypothesis, where more than the free constants differ.
    std::function<void(CalibrationProblem& problem)> change{};
    std::optional<CalibrationSummary> summary{};
    bool velocities_only = false;  ///< the summary is that of the critical velocities alone
    std::string failure{};         ///< why there is none, or none of all observations
    std::vector<FalseCapture> captures{};
    LargestResidual largest{};

    /// Whether chi^2 lacks the contact times or counts one that the model has not.
    [[nodiscard]] bool lacks_times() const { return velocities_only || !captures.empty(); }
};

/// Takes the contact times as published for another law, whose fits then give their damping.
void set_law_of_times(const Case& data, Law law, CalibrationProblem& problem) {
    for (ContactTimeObservation& time : problem.contact_times) {
        time.law = law;
        time.damping_fit = *data.samples[time.sample].published->damping_fits.find(law);
    }
}

/// Whether a law has a published fit for every contact time, and is not the one they were published for.
bool may_have_times(const Case& data, Law law, const CalibrationProblem& problem) {
    return std::ranges::all_of(problem.contact_times, [&](const ContactTimeObservation& time) {
        const auto& published = data.samples[time.sample].published;
        return time.law != law && published && published->damping_fits.find(law) != nullptr;
    });
}

void set_rigid_wall(CalibrationProblem& problem) {
    for (CalibrationSample& sample : problem.samples)
        sample.contact_modulus = contact_modulus(sample.particle, RigidWall{});
}

/// Hypotheses on how the published numbers were computed, with moduli from XRD and a density for each sample.
std::vector<CalibrationHypothesis> hypotheses_on_method(const Case& data, bool elastic_wall,
                                                        const CalibrationProblem& problem) {
    const std::vector<FreeConstant> free{{CalibrationQuantity::work_of_adhesion, false},
                                         {CalibrationQuantity::density, problem.samples.size() > 1}};
    std::vector<FreeConstant> with_step = free;
    with_step.push_back({CalibrationQuantity::time_step, false});
    std::vector<CalibrationHypothesis> hypotheses{
        {.name = "moduli from XRD, Eq. 31 at a finite step", .free = with_step}};
    for (std::size_t i = 0; i < Law::count() && !problem.contact_times.empty(); ++i)
        if (const Law law = Law::at(i); may_have_times(data, law, problem))
            hypotheses.push_back(
                {.name = fmt::format("moduli from XRD, contact times by {}", law.name()),
                 .free = free,
                 .change = [&data, law](CalibrationProblem& own) { set_law_of_times(data, law, own); }});
    if (elastic_wall)
        hypotheses.push_back(
            {.name = "moduli from XRD, a rigid wall", .free = free, .change = set_rigid_wall});
    return hypotheses;
}

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

LargestResidual largest_residual(const Case& data, const CalibrationProblem& problem,
                                 const CalibrationHypothesis& hypothesis) {
    LargestResidual largest;
    const auto compare = [&](const char* what, const auto& observed,
                             const std::vector<CalibrationResidual>& residuals) {
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            const double size = residuals[i].relative_difference() / residuals[i].relative_uncertainty;
            if (residuals[i].captured_up_to || std::abs(size) <= std::abs(largest.in_uncertainties)) continue;
            largest = {fmt::format("{} of {}, {}", what, data.samples[observed[i].sample].name,
                                   observed[i].law.name()),
                       size};
        }
    };
    compare("v_c", problem.critical_velocities, hypothesis.summary->critical_velocities);
    if (!hypothesis.velocities_only)
        compare("contact time", problem.contact_times, hypothesis.summary->contact_times);
    return largest;
}

std::vector<FalseCapture> false_captures(const Case& data, const CalibrationProblem& problem,
                                         const CalibrationSummary& summary) {
    std::vector<FalseCapture> captures;
    for (std::size_t i = 0; i < summary.contact_times.size(); ++i) {
        const ContactTimeObservation& observed = problem.contact_times[i];
        if (const auto up_to = summary.contact_times[i].captured_up_to)
            captures.push_back({data.samples[observed.sample].name, std::string(observed.law.name()),
                                observed.velocity, *up_to, observed.velocity_uncertainty});
    }
    return captures;
}

/// The hypothesis that AIC prefers, of those that have all contact times, or the end.
auto preferred(const std::vector<CalibrationHypothesis>& hypotheses) {
    auto best = hypotheses.end();
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each)
        if (each->summary && !each->lacks_times() &&
            (best == hypotheses.end() || each->summary->akaike < best->summary->akaike))
            best = each;
    return best;
}

/// A constant averaged over hypotheses.
struct AveragedConstant {
    CalibrationQuantity quantity;
    std::string sample;  ///< empty: of all samples
    double mean = 0;
    double standard_uncertainty = 0;  ///< within and between hypotheses
};

/// Density of each sample and work of adhesion, averaged over the hypotheses with all contact times, weighted
/// by exp(-AIC/2) (Burnham & Anderson 2002). Hypotheses without a constant of a sample take the shared one.
std::vector<AveragedConstant> averages_of(const Case& data,
                                          const std::vector<CalibrationHypothesis>& hypotheses) {
    const auto best = preferred(hypotheses);
    if (best == hypotheses.end()) return {};
    const auto average = [&](CalibrationQuantity quantity, std::size_t sample, const std::string& name) {
        double weights = 0;
        double first = 0;
        double second = 0;
        for (const CalibrationHypothesis& each : hypotheses) {
            if (!each.summary || each.lacks_times()) continue;
            const double weight = std::exp(0.5 * (best->summary->akaike - each.summary->akaike));
            for (const CalibratedConstant& constant : each.summary->constants) {
                if (constant.quantity != quantity || constant.sample.value_or(sample) != sample) continue;
                weights += weight;
                first += weight * constant.value;
                second += weight * (constant.value * constant.value +
                                    constant.standard_uncertainty * constant.standard_uncertainty);
            }
        }
        const double mean = first / weights;
        return AveragedConstant{quantity, name, mean,
                                std::sqrt(std::max(0.0, second / weights - mean * mean))};
    };
    std::vector<AveragedConstant> averages{average(CalibrationQuantity::work_of_adhesion, 0, "")};
    for (std::size_t i = 0; i < data.samples.size(); ++i)
        averages.push_back(average(CalibrationQuantity::density, i, data.samples[i].name));
    return averages;
}

std::string averages_text(const std::vector<AveragedConstant>& averages) {
    std::string text;
    for (const AveragedConstant& each : averages)
        text += fmt::format(
            "{}{}{} {}", text.empty() ? "" : "; ", name_of(each.quantity),
            each.sample.empty() ? "" : " of " + each.sample,
            readable(make_quantity(each.mean, dimension_of(each.quantity), each.standard_uncertainty)));
    if (text.empty()) return text;
    text.insert(0, "Averaged over the hypotheses with all contact times, weighted by exp(-AIC/2): ");
    return wrapped(text + ".", output_width(), 2) + "\n";
}

/// What a hypothesis lacks to be compared, and why.
std::string remark_on(const CalibrationHypothesis& hypothesis) {
    if (!hypothesis.summary) return fmt::format("{}: {}\n", hypothesis.name, hypothesis.failure);
    if (!hypothesis.lacks_times()) return {};
    std::string text =
        hypothesis.velocities_only
            ? fmt::format(
                  "{}: chi^2 of the critical velocities alone, a bound from below (with contact times: {})",
                  hypothesis.name, hypothesis.failure)
            : hypothesis.name +
                  ": a captured impact has no contact time, that just above v_c, prolonged, counts";
    for (const FalseCapture& capture : hypothesis.captures) {
        text += fmt::format("; contact time of {}, {}: captured at {}, up to {}", capture.sample, capture.law,
                            readable(capture.velocity, "m/s"), readable(capture.captured_up_to, "m/s"));
        if (capture.velocity_uncertainty > 0)
            text += fmt::format(", {} standard uncertainties of the velocity above it",
                                readable_number(capture.in_uncertainties(), 2));
    }
    return text + "\n";
}

std::vector<CalibrationHypothesis> compare_hypotheses(const Case& data, const CalibrationProblem& problem) {
    const bool elastic_wall = data.wall && std::holds_alternative<ElasticWall>(*data.wall);
    std::vector<CalibrationHypothesis> hypotheses = hypotheses_of(elastic_wall, problem.samples.size());
    std::ranges::move(hypotheses_on_method(data, elastic_wall, problem), std::back_inserter(hypotheses));
    Progress progress(hypotheses.size(), 0, on_terminal(), "hypotheses");
    std::uint64_t begun = 0;
    for (CalibrationHypothesis& hypothesis : hypotheses) {
        progress.update(begun++);
        CalibrationProblem own = problem;
        own.free = hypothesis.free;
        if (hypothesis.change) hypothesis.change(own);
        const auto calibrated_by = [&](CalibrationSummary (*method)(const CalibrationProblem&)) {
            std::string failure;
            try {
                hypothesis.summary = method(own);
            } catch (const InputError& error) {
                failure = error.what();
            } catch (const ConvergenceError& error) {
                failure = error.what();
            }
            return failure;
        };
        hypothesis.failure = calibrated_by(calibrate_despite_captures);
        if (!hypothesis.summary) {
            calibrated_by(calibrate_by_velocities);  // may lack observations: the first failure stands
            hypothesis.velocities_only = hypothesis.summary.has_value();
        }
        if (!hypothesis.summary) continue;
        hypothesis.captures = false_captures(data, own, *hypothesis.summary);
        hypothesis.largest = largest_residual(data, own, hypothesis);
    }
    return hypotheses;
}

std::string hypotheses_text(const Case& data, const std::vector<CalibrationHypothesis>& hypotheses) {
    TextTable table({"hypothesis", "constants", "chi^2", "degrees of freedom", "probability", "AIC",
                     "worst v_c", "worst contact time", "largest residual [u]"});
    const auto percent = [](double share) { return fmt::format("{:.2f} %", 100 * share); };
    std::string remarks;
    for (const CalibrationHypothesis& hypothesis : hypotheses) {
        remarks += remark_on(hypothesis);
        if (!hypothesis.summary) continue;
        const CalibrationSummary& summary = *hypothesis.summary;
        const char* bound = hypothesis.velocities_only ? "> " : "";
        table.add({hypothesis.name, std::to_string(summary.constants.size()),
                   bound + readable_number(summary.chi_squared), std::to_string(summary.degrees_of_freedom),
                   readable_number(summary.probability, 2), bound + readable_number(summary.akaike),
                   percent(greatest_difference(summary.critical_velocities)),
                   !hypothesis.captures.empty() ? "captured"
                   : hypothesis.velocities_only ? "-"
                                                : percent(greatest_difference(summary.contact_times)),
                   fmt::format("{:+.1f} {}", hypothesis.largest.in_uncertainties, hypothesis.largest.what)});
    }
    const auto best = preferred(hypotheses);
    const std::string verdict =
        best == hypotheses.end()
            ? "No hypothesis could be calibrated.\n"
            : fmt::format("Least AIC: {}. A difference below about 2 decides nothing.\n", best->name);
    return table.text() + remarks + verdict + averages_text(averages_of(data, hypotheses));
}

Json averages_json(const std::vector<AveragedConstant>& averages) {
    Json list = Json::array();
    for (const AveragedConstant& each : averages)
        list.push_back(
            {{"quantity", name_of(each.quantity)},
             {"sample", each.sample.empty() ? Json(nullptr) : Json(each.sample)},
             {"value", make_quantity(each.mean, dimension_of(each.quantity), each.standard_uncertainty)}});
    return list;
}

Json hypotheses_json(const Case& data, const std::vector<CalibrationHypothesis>& hypotheses) {
    Json list = Json::array();
    const auto best = preferred(hypotheses);
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each) {
        Json json{{"hypothesis", each->name}, {"preferred", each == best}};
        if (each->summary) {
            const CalibrationSummary& summary = *each->summary;
            json.update({{"constants", summary.constants.size()},
                         {"velocities_only", each->velocities_only},
                         {"chi_squared", summary.chi_squared},
                         {"degrees_of_freedom", summary.degrees_of_freedom},
                         {"probability", summary.probability},
                         {"akaike", finite_json(summary.akaike)},
                         {"worst_critical_velocity", greatest_difference(summary.critical_velocities)},
                         {"worst_contact_time", greatest_difference(summary.contact_times)},
                         {"largest_residual",
                          {{"observation", each->largest.what},
                           {"in_uncertainties", each->largest.in_uncertainties}}}});
            json["captured"] = Json::array();
            for (const FalseCapture& capture : each->captures)
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
    return {{"hypotheses", list}, {"averages", averages_json(averages_of(data, hypotheses))}};
}

}  // namespace

void print_hypotheses(const Case& data, const CalibrationProblem& problem, bool json, std::ostream& out) {
    const auto hypotheses = compare_hypotheses(data, problem);
    out << (json ? write_json(hypotheses_json(data, hypotheses), Digits::seventeen)
                 : hypotheses_text(data, hypotheses));
}

}  // namespace ashimpact
