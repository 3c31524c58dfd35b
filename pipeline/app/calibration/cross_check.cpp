// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/run_stages.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/layout.hpp"
#include "solver/critical_velocity/critical_velocity.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

/// One point of the reference curve and what the other fits say at its velocity.
struct CurvePoint {
    double velocity;     ///< [m/s]
    double restitution;  ///< of the reference law
    std::vector<double> others;
};

/// A law's published fit beside the one that the reference curve predicts for it.
struct Prediction {
    Law law;
    DampingPolynomial published;
    std::optional<DampingFit> predicted{};
    std::optional<double> velocity{};  ///< v_c at the predicted eta_c [m/s]
    std::optional<double> printed{};   ///< published v_c [m/s]
    double greatest_difference = 0;    ///< of e_n from the reference curve, at one velocity [1]
};

struct SampleCheck {
    std::string name;
    Law reference;
    std::vector<CurvePoint> points{};
    std::vector<Prediction> others{};
};

PublishedDamping curve_of(const Case& data, const ContactPair& contact, Law law,
                          const DampingPolynomial& fit) {
    const auto chosen = std::ranges::find(data.laws, law, &LawChoice::law);
    return {law, chosen != data.laws.end() ? chosen->detachment : law.default_detachment(), contact, fit};
}

std::vector<CurvePoint> reference_points(const PublishedDamping& reference, const Reconstruction& plan) {
    std::vector<CurvePoint> points;
    for (int i = 0; i < plan.points; ++i) {
        const double e = plan.from + (plan.to - plan.from) * i / (plan.points - 1);
        try {
            points.push_back({reconstructed_velocity(reference, e), e, {}});
        } catch (const InputError&) {  // the fit has no impact with this restitution: no point of the curve
            continue;
        }
    }
    return points;
}

/// The fit that a law would have published, had it been given the reference curve.
Prediction prediction_of(const PublishedDamping& law, const std::vector<CurvePoint>& points) {
    Prediction prediction{.law = law.law, .published = law.damping};
    std::vector<DampingPoint> inverted;
    for (const CurvePoint& point : points) {
        try {
            const auto damping = damping_from_restitution({.law = law.law,
                                                           .detachment = law.detachment,
                                                           .damping_law = DampingLaw::constant,
                                                           .contact = law.contact,
                                                           .velocity = point.velocity,
                                                           .restitution = point.restitution});
            inverted.push_back({point.restitution, damping.damping.coefficient, 0});
        } catch (const InputError&) {  // beyond the reach of this law: it has no such impact
            continue;
        }
    }
    if (inverted.size() < 3) return prediction;
    prediction.predicted = fit_damping(inverted);
    const double critical = prediction.predicted->damping.critical_damping();
    if (critical > 0)
        prediction.velocity =
            critical_velocity({law.law, law.detachment, {DampingLaw::constant, critical}, law.contact}).value;
    return prediction;
}

SampleCheck check_sample(const Case& data, const Sample& sample, const Reconstruction& plan,
                         const ContactPair& contact) {
    const Law reference = Law::named(plan.reference);
    SampleCheck check{.name = sample.name, .reference = reference};
    check.points =
        reference_points(curve_of(data, contact, reference, *plan.damping_fits.find(reference)), plan);
    for (const auto& [law, fit] : plan.damping_fits) {
        if (law == reference) continue;
        const PublishedDamping curve = curve_of(data, contact, law, fit);
        Prediction prediction = prediction_of(curve, check.points);
        for (CurvePoint& point : check.points) {
            point.others.push_back(reconstructed_restitution(curve, point.velocity));
            prediction.greatest_difference =
                std::max(prediction.greatest_difference, std::abs(point.others.back() - point.restitution));
        }
        const Quantity* printed = sample.published ? sample.published->critical_velocity.find(law) : nullptr;
        if (printed != nullptr) prediction.printed = printed->value;
        check.others.push_back(prediction);
    }
    return check;
}

Json check_json(const SampleCheck& check) {
    const auto column = [&](Dimension dimension, const auto& value_of) {
        std::vector<double> values;
        for (const CurvePoint& point : check.points) values.push_back(value_of(point));
        return column_json(values, dimension);
    };
    Json json{{"name", check.name},
              {"reference_law", check.reference.name()},
              {"velocity", column(Dimension::velocity, [](const CurvePoint& p) { return p.velocity; })},
              {"restitution",
               {{std::string(check.reference.name()),
                 column(Dimension::fraction, [](const CurvePoint& p) { return p.restitution; })}}},
              {"predictions", Json::object()}};
    for (std::size_t i = 0; i < check.others.size(); ++i) {
        const Prediction& other = check.others[i];
        const std::string name(other.law.name());
        json["restitution"][name] =
            column(Dimension::fraction, [&](const CurvePoint& point) { return point.others[i]; });
        json["predictions"][name] = {
            {"greatest_difference_in_restitution", other.greatest_difference},
            {"published", quadratic_json(other.published)},
            {"predicted", other.predicted ? quadratic_json(other.predicted->damping) : Json(nullptr)},
            {"predicted_critical_velocity", quantity_json(other.velocity, Dimension::velocity)},
            {"published_critical_velocity", quantity_json(other.printed, Dimension::velocity)}};
    }
    return json;
}

std::string check_text(const SampleCheck& check) {
    std::vector<std::string> heading{"v_in [m/s]", std::string(check.reference.name())};
    for (const Prediction& other : check.others) heading.emplace_back(other.law.name());
    TextTable curves(std::move(heading));
    for (const CurvePoint& point : check.points) {
        std::vector<std::string> row{fmt::format("{:.3f}", point.velocity),
                                     fmt::format("{:.3f}", point.restitution)};
        for (const double e : point.others) row.push_back(e > 0 ? fmt::format("{:.3f}", e) : "captured");
        curves.add(std::move(row));
    }
    TextTable fits({"fit of", "", "a [kg/s]", "b [kg/s]", "c [kg/s]", "v_c [m/s]", "e_n apart by"});
    const auto add = [&](std::vector<std::string> row, const DampingPolynomial& fit,
                         const std::optional<double>& critical, std::string apart) {
        for (const double value : fit.coefficients.reverse()) row.push_back(fmt::format("{:.4f}", value));
        row.push_back(critical ? fmt::format("{:#.3g}", *critical) : std::string("-"));
        row.push_back(std::move(apart));
        fits.add(std::move(row));
    };
    for (const Prediction& other : check.others) {
        add({std::string(other.law.name()), "published"}, other.published, other.printed,
            fmt::format("at most {:.3f}", other.greatest_difference));
        if (other.predicted) add({"", "predicted"}, other.predicted->damping, other.velocity, "");
    }
    return fmt::format("{}: restitution that each published fit implies\n{}\n{}", check.name, curves.text(2),
                       fits.text(2));
}

void run_cross_check_command(const CommandOptions& options, std::ostream& out) {
    const Run run = compute_run(options.if_given("case"), "contact", options.has("--allow-outside"));
    print_readings(run.inputs);
    const Case& data = run.data;
    std::vector<SampleCheck> checks;
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const Sample& sample = data.samples[i];
        const auto* plan = sample.restitution ? std::get_if<Reconstruction>(&*sample.restitution) : nullptr;
        if (plan == nullptr) continue;
        checks.push_back(check_sample(data, sample, *plan, run.contact.samples[i].pair));
    }
    if (checks.empty())
        throw InputError("no sample has published fits to be checked against one another",
                         "restitution by \"reconstruct\"")
            .at("/samples")
            .at(FileName{options["case"]});
    if (options.has("--json")) {
        Json json{{"samples", Json::array()}};
        for (const SampleCheck& check : checks) json["samples"].push_back(check_json(check));
        out << write_json(json, Digits::seventeen);
        return;
    }
    for (const SampleCheck& check : checks)
        out << (&check == &checks.front() ? "" : "\n") << check_text(check);
    out << "\nPredicted: the impacts that the reference law's fit implies, inverted by the other law and "
           "fitted.\n";
}

}  // namespace

void add_cross_check(const CommandLine& line) {
    Command command =
        line.add("cross-check", "Whether published damping fits of several laws describe the same impacts",
                 "ashimpact cross-check", run_cross_check_command);
    command.add_case_argument();
    command.add_allow_outside_flag();
    command.add_json_flag();
}

}  // namespace ashimpact
