#include "pipeline/commands/calibration_hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "materials/error.hpp"
#include "pipeline/json/statistics_json.hpp"
#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

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
        greatest = std::max(greatest, std::abs(residual.relative_difference()));
    return greatest;
}

/// The hypothesis that AIC prefers, or the end.
auto preferred(const std::vector<CalibrationHypothesis>& hypotheses) {
    auto best = hypotheses.end();
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each)
        if (each->summary && (best == hypotheses.end() || each->summary->akaike < best->summary->akaike))
            best = each;
    return best;
}

}  // namespace

std::vector<CalibrationHypothesis> compare_hypotheses(const CalibrationProblem& problem, bool elastic_wall) {
    std::vector<CalibrationHypothesis> hypotheses = hypotheses_of(elastic_wall, problem.samples.size());
    for (CalibrationHypothesis& hypothesis : hypotheses) {
        CalibrationProblem own = problem;
        own.free = hypothesis.free;
        try {
            hypothesis.summary = calibrate(own);
        } catch (const InputError& error) {
            hypothesis.failure = error.what();
        } catch (const ConvergenceError& error) {
            hypothesis.failure = error.what();
        }
    }
    return hypotheses;
}

std::string hypotheses_text(const std::vector<CalibrationHypothesis>& hypotheses) {
    TextTable table({"hypothesis", "constants", "chi^2", "degrees of freedom", "probability", "AIC",
                     "worst v_c", "worst contact time"});
    const auto percent = [](double share) { return fmt::format("{:.2f} %", 100 * share); };
    const auto best = preferred(hypotheses);
    std::string failures;
    for (const CalibrationHypothesis& hypothesis : hypotheses) {
        if (!hypothesis.summary) {
            failures += fmt::format("{}: {}\n", hypothesis.name, hypothesis.failure);
            continue;
        }
        const CalibrationSummary& summary = *hypothesis.summary;
        table.add({hypothesis.name, std::to_string(summary.constants.size()),
                   readable_number(summary.chi_squared), std::to_string(summary.degrees_of_freedom),
                   readable_number(summary.probability, 2), readable_number(summary.akaike),
                   percent(greatest_difference(summary.critical_velocities)),
                   percent(greatest_difference(summary.contact_times))});
    }
    const std::string verdict =
        best == hypotheses.end()
            ? "No hypothesis could be calibrated.\n"
            : fmt::format("Least AIC: {}. A difference below about 2 decides nothing.\n", best->name);
    return table.text() + failures + verdict;
}

Json hypotheses_json(const std::vector<CalibrationHypothesis>& hypotheses) {
    Json list = Json::array();
    const auto best = preferred(hypotheses);
    for (auto each = hypotheses.begin(); each != hypotheses.end(); ++each) {
        Json json{{"hypothesis", each->name}, {"preferred", each == best}};
        if (each->summary) {
            const CalibrationSummary& summary = *each->summary;
            json.update({{"constants", summary.constants.size()},
                         {"chi_squared", summary.chi_squared},
                         {"degrees_of_freedom", summary.degrees_of_freedom},
                         {"probability", summary.probability},
                         {"akaike", finite_json(summary.akaike)},
                         {"worst_critical_velocity", greatest_difference(summary.critical_velocities)},
                         {"worst_contact_time", greatest_difference(summary.contact_times)}});
        } else {
            json["failure"] = each->failure;
        }
        list.push_back(std::move(json));
    }
    return {{"hypotheses", list}};
}

}  // namespace ashimpact
