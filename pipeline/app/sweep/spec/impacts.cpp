// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/spec/impacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/regime.hpp"
#include "solver/statistics/design.hpp"

namespace ashimpact {

namespace {

Eigen::Map<const Eigen::ArrayXd> array_of(ImpactColumns::Values values) {
    return {values.data(), std::ssize(values)};
}

/// Impacts of a sweep for the batch solver; the batch refers to @p impacts.
ImpactBatch batch_of(const ImpactModel& model, const ImpactColumns& impacts) {
    std::vector<ParameterColumn> parameters;
    for (const auto& [name, values] : impacts.parameters) parameters.push_back({name, array_of(values)});
    return {model.law,
            model.detachment,
            model.damping_law,
            {array_of(impacts.mass), array_of(impacts.effective_radius), array_of(impacts.contact_modulus),
             array_of(impacts.work_of_adhesion), array_of(impacts.yield_pressure), parameters},
            array_of(impacts.damping),
            array_of(impacts.velocity)};
}

constexpr double none = 0;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A column with so many values.
Eigen::ArrayXd spread(ImpactColumns::Values column, std::size_t count) {
    if (column.size() > 1) return array_of(column);
    return Eigen::ArrayXd::Constant(static_cast<Eigen::Index>(count), column.front());
}

/// Values of a function of two columns.
template <class Function>
Eigen::ArrayXd combined(ImpactColumns::Values a, ImpactColumns::Values b, Function function) {
    const std::size_t count = std::max(a.size(), b.size());
    return spread(a, count).binaryExpr(spread(b, count), function);
}

Impact impact_at(const ImpactModel& model, const ImpactColumns& impacts, std::size_t i) {
    ParameterValues<double> parameters;
    for (const auto& [name, values] : impacts.parameters) parameters.set(name, value_at(values, i));
    return {.law = model.law,
            .detachment = model.detachment,
            .damping = {model.damping_law, value_at(impacts.damping, i)},
            .contact = {.mass = value_at(impacts.mass, i),
                        .effective_radius = value_at(impacts.effective_radius, i),
                        .contact_modulus = value_at(impacts.contact_modulus, i),
                        .work_of_adhesion = value_at(impacts.work_of_adhesion, i),
                        .yield_pressure = value_at(impacts.yield_pressure, i),
                        .parameters = parameters},
            .velocity = value_at(impacts.velocity, i)};
}

/// The command that computes an impact alone.
std::string command_of(const Impact& impact) {
    std::string command = "ashimpact impact --law " + std::string(impact.law.name()) + " --detachment " +
                          std::string(name_of(impact.detachment)) + " --damping-law " +
                          std::string(name_of(impact.damping.law));
    const auto add = [&](const char* option, double value) {
        command += std::string(" --") + option + " " + shortest(value);
    };
    add("mass", impact.contact.mass);
    add("radius", impact.contact.effective_radius);
    add("contact-modulus", impact.contact.contact_modulus);
    if (impact.law.uses_work_of_adhesion()) add("work-of-adhesion", impact.contact.work_of_adhesion);
    if (impact.law.is_plastic()) add("yield-pressure", impact.contact.yield_pressure);
    for (const LawParameter& parameter : impact.law.parameters()) {
        if (!impact.contact.parameters.has(parameter)) continue;
        command += " " + option_of(parameter) + " " + shortest(impact.contact.parameters[parameter]);
    }
    add("damping", impact.damping.coefficient);
    add("velocity", impact.velocity);
    return command;
}

/// Throws for the first impact that is no valid one an error of the variables that make it.
void refuse_first(const ImpactModel& model, const ImpactColumns& impacts) {
    for (std::size_t i = 0; i < impacts.velocity.size(); ++i) {
        try {
            validate(impact_at(model, impacts, i));
        } catch (const InputError& own) {
            throw InputError("at a point of the sweep, " + own.problem(), own.allowed()).at("/variables");
        }
    }
}

using report::CaptureShare;

constexpr std::uint64_t capture_impacts = 8192;
constexpr std::uint64_t most_impacts = 8 * capture_impacts;
constexpr std::size_t slices = 16;
constexpr std::size_t few = 24;  ///< values that are shown one by one

using Values = std::vector<std::vector<double>>;

/// Values of the variables at @p most points of the sweep or fewer: the first ones of a random design, of a
/// grid points that are scattered so that they follow none of its sides.
Values variable_values(const SweepSpec& spec, std::uint64_t most) {
    constexpr double golden = 0.6180339887498949;
    Sampling sampling = spec.sampling;
    const bool is_grid = sampling.method == SamplingMethod::grid;
    if (!is_grid) sampling.points = std::min(sampling.points, most);
    const Design design(distributions_of(spec), sampling);
    const std::uint64_t all = design.points();
    Values values(design.variables(), std::vector<double>(static_cast<std::size_t>(std::min(all, most))));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (all <= most) {
            design.fill(0, i, 0, values[i]);
            continue;
        }
        for (std::size_t n = 0; n < values[i].size(); ++n) {
            const double place = std::fmod(golden * static_cast<double>(n), 1.0) * static_cast<double>(all);
            design.fill(0, i, static_cast<std::uint64_t>(place), {&values[i][n], 1});
        }
    }
    return values;
}

/// 1 for each impact that is captured.
std::vector<double> captured(const ImpactModel& model, const ImpactColumns& impacts) {
    const ImpactBatchResult result =
        solve_impacts(batch_of(model, impacts), {.threads = 0, .turning_point = false});
    std::vector<double> flags(static_cast<std::size_t>(result.restitution.size()));
    for (std::size_t i = 0; i < flags.size(); ++i)
        flags[i] = result.restitution[static_cast<Eigen::Index>(i)] > 0 ? 0 : 1;
    return flags;
}

/// Standard uncertainty of a fraction that was counted.
double uncertainty_of_fraction(double fraction, double count) {
    return std::sqrt(std::max(fraction * (1 - fraction), 0.25 / count) / count);
}

std::vector<CaptureShare> shares_of(const std::vector<double>& variable, const std::vector<double>& flags) {
    std::vector<std::size_t> order(variable.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return variable[a] < variable[b]; });
    const bool listed = std::set<double>(variable.begin(), variable.end()).size() <= few;
    std::vector<CaptureShare> shares;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = std::min(order.size(), (shares.size() + 1) * order.size() / slices);
        if (listed)
            for (end = first + 1; end < order.size() && variable[order[end]] == variable[order[first]];)
                ++end;
        end = std::max(end, first + 1);
        double captures = 0;
        for (std::size_t i = first; i < end; ++i) captures += flags[order[i]];
        const auto count = static_cast<double>(end - first);
        const double fraction = captures / count;
        shares.push_back(
            {variable[order[(first + end) / 2]], fraction, uncertainty_of_fraction(fraction, count)});
        first = end;
    }
    return shares;
}

}  // namespace

ImpactColumns::ImpactColumns(const SweepSpec& spec, const std::vector<std::vector<double>>& variables,
                             std::size_t count) {
    const auto column = [&](ImpactInput input, const double& otherwise = none) -> Values {
        for (std::size_t i = 0; i < spec.variables.size(); ++i)
            if (spec.variables[i].input == input) return variables[i];
        const auto& fixed = spec.fixed[static_cast<std::size_t>(input)];
        return {fixed ? &*fixed : &otherwise, 1};
    };
    const auto masses = [&](ImpactInput given, ImpactInput density, Values radius) {
        if (!is_given(spec, density)) return column(given);
        Eigen::ArrayXd unit = array_of(column(density));  // to be masses of spheres of radius 1 m
        for (double& value : unit) value = sphere_mass(1.0, value);
        return keep(combined({unit.data(), static_cast<std::size_t>(unit.size())}, radius,
                             [](double m, double r) { return m * r * r * r; }));
    };
    effective_radius = column(ImpactInput::radius);
    contact_modulus = column(ImpactInput::contact_modulus);
    work_of_adhesion = column(ImpactInput::work_of_adhesion);
    yield_pressure = column(ImpactInput::yield_pressure, infinite);
    damping = column(ImpactInput::damping);
    if (spec.damping_over_sizes && spec.damping_over_sizes->power != 0)
        damping = keep(combined(damping, effective_radius, [&](double coefficient, double radius) {
            return coefficient *
                   std::pow(radius / spec.damping_over_sizes->radius, spec.damping_over_sizes->power);
        }));
    velocity = column(ImpactInput::velocity);
    if (is_given(spec, ImpactInput::angle))
        velocity = keep(combined(velocity, column(ImpactInput::angle),
                                 [](double total, double angle) { return total * std::cos(angle); }));
    if (velocity.size() != count) velocity = keep(spread(velocity, count));
    mass = masses(ImpactInput::mass, ImpactInput::density, effective_radius);
    if (is_given(spec, ImpactInput::partner_radius)) {
        const Values radius = column(ImpactInput::partner_radius);
        const Values partner = masses(ImpactInput::partner_mass, ImpactInput::partner_density, radius);
        effective_radius = keep(combined(effective_radius, radius, ashimpact::effective_radius));
        mass = keep(combined(mass, partner, effective_mass));
    }
    for (const LawParameter& parameter : law_parameters())
        if (is_given(spec, input_of(parameter)))
            parameters.emplace_back(parameter.name, column(input_of(parameter)));
}

ImpactColumns::Values ImpactColumns::keep(Eigen::ArrayXd values) {
    const Eigen::ArrayXd& kept = kept_.emplace_back(std::move(values));
    return {kept.data(), static_cast<std::size_t>(kept.size())};
}

Support bulk_of(const SweepSpec& spec, ImpactInput input) {
    if (const auto& fixed = spec.fixed[static_cast<std::size_t>(input)]) return {*fixed, *fixed};
    const Distribution& distribution =
        std::ranges::find(spec.variables, input, &SweepVariable::input)->distribution;
    if (std::holds_alternative<Choice>(distribution)) return support_of(distribution);
    std::vector<double> ends{0.005, 0.995};
    to_quantiles(distribution, ends);
    return {ends[0], ends[1]};
}

namespace {

bool is_varied(const SweepSpec& spec, ImpactInput input) {
    return std::ranges::find(spec.variables, input, &SweepVariable::input) != spec.variables.end();
}

/// What varies of the inputs that the Tabor parameter depends on.
std::optional<std::string> varied_below_tabor(const SweepSpec& spec) {
    for (const ImpactInput input : {ImpactInput::radius, ImpactInput::partner_radius,
                                    ImpactInput::work_of_adhesion, ImpactInput::contact_modulus})
        if (is_varied(spec, input)) return std::string(name_of(input));
    return std::nullopt;
}

}  // namespace

std::vector<std::string> warnings_of_sizes(const SweepSpec& spec) {
    std::vector<std::string> warnings;
    const auto varied = varied_below_tabor(spec);
    for (const LawParameter& parameter : law_parameters())
        if (varied && parameter.name == "tabor" &&
            spec.fixed[static_cast<std::size_t>(input_of(parameter))].has_value())
            warnings.push_back("tabor: stays the same while " + *varied +
                               " varies, so that the range of the attraction goes with it; cohesion_range "
                               "or cohesive_stress is one for all");
    constexpr double similar_sizes = 1.1;  // greatest ratio of radii that one mass or damping may serve
    const auto warn_of_mass = [&](ImpactInput radius, ImpactInput mass) {
        if (!is_given(spec, radius) || !is_given(spec, mass)) return;
        const Support radii = bulk_of(spec, radius);
        const Support masses = bulk_of(spec, mass);
        if (is_varied(spec, mass) || radii.highest <= similar_sizes * radii.lowest) return;
        const auto density = [&](double of_radius) {
            return readable(masses.lowest / sphere_mass(of_radius, 1), "kg/m3");
        };
        warnings.push_back(
            fmt::format("{}: stays the same while {} varies, so that densities go from {} to {}; "
                        "a density is one for all",
                        name_of(mass), name_of(radius), density(radii.highest), density(radii.lowest)));
    };
    warn_of_mass(ImpactInput::radius, ImpactInput::mass);
    warn_of_mass(ImpactInput::partner_radius, ImpactInput::partner_mass);
    if (!is_given(spec, ImpactInput::radius) || !is_given(spec, ImpactInput::damping) ||
        spec.damping_law != DampingLaw::constant || spec.damping_over_sizes)
        return warnings;
    Support radii = bulk_of(spec, ImpactInput::radius);
    if (is_given(spec, ImpactInput::partner_radius)) {
        const Support partners = bulk_of(spec, ImpactInput::partner_radius);
        radii = {effective_radius(radii.lowest, partners.lowest),
                 effective_radius(radii.highest, partners.highest)};
    }
    if (radii.highest > similar_sizes * radii.lowest)
        warnings.push_back("damping: one coefficient for radii of " + readable(radii.lowest, "m") + " to " +
                           readable(radii.highest, "m") +
                           "; with it v_c of small spheres grows without bound. State "
                           "\"damping_over_sizes\": \"same\", or a power of the radius, or choose another "
                           "damping_law");
    return warnings;
}

namespace {

/// Numbers of captured impacts.
struct CaptureCounts {
    double all = 0;
    double outside = 0;  ///< captured at fastest_in_model, too
};
/// Counts the captures among the impacts at @p values.
CaptureCounts count_captures(const SweepSpec& spec, const ImpactModel& model, const Values& values) {
    const std::size_t count = values.front().size();
    const ImpactColumns impacts(spec, values, count);
    ImpactColumns fast(spec, values, count);  // without yielding a slower impact is captured as well
    std::vector<double> velocities(fast.velocity.begin(), fast.velocity.end());
    for (double& velocity : velocities) velocity = std::max(velocity, fastest_in_model);
    fast.velocity = velocities;
    fast.yield_pressure = {&infinite, 1};
    const std::vector<double> captures = captured(model, impacts);
    const double all = std::accumulate(captures.begin(), captures.end(), 0.0);
    if (all == 0) return {};
    const std::vector<double> still = captured(model, fast);
    return {all, std::inner_product(captures.begin(), captures.end(), still.begin(), 0.0)};
}

}  // namespace

std::vector<OutsideShare> captures_outside_model(const SweepSpec& spec) {
    std::vector<OutsideShare> shares(spec.laws.size());
    if (spec.variables.empty()) return shares;
    constexpr std::uint64_t least = capture_impacts / 8;
    constexpr double enough = 1000;  // captures
    for (std::size_t k = 0; k < spec.laws.size(); ++k) {
        const ImpactModel model{spec.laws[k].law, spec.laws[k].detachment, spec.damping_law};
        // Often few of the impacts are captures; those of other laws take long to solve.
        const std::uint64_t most = has_tables(model.law, spec.damping_law) ? most_impacts : least;
        try {
            std::uint64_t drawn = least;
            Values values = variable_values(spec, drawn);
            CaptureCounts counts = count_captures(spec, model, values);
            while (counts.all < enough && drawn < most && values.front().size() == drawn) {
                values = variable_values(spec, drawn *= 4);
                counts = count_captures(spec, model, values);
            }
            if (counts.all == 0) continue;
            shares[k].fraction = counts.outside / counts.all;
            const bool is_whole =
                spec.sampling.method == SamplingMethod::grid && values.front().size() < drawn;
            if (!is_whole) shares[k].uncertainty = uncertainty_of_fraction(shares[k].fraction, counts.all);
        } catch (const InputError&) {  // reported where the impact itself is solved
        } catch (const ConvergenceError&) {
        }
    }
    return shares;
}

namespace {

/// Adds the share of the impacts that a law does not hold for, with one of its findings.
void warn_of_regimes(const SweepSpec& spec, std::vector<std::string>& warnings) {
    /// Impacts of one law with findings of one severity.
    struct Remarked {
        int impacts = 0;
        std::string first;  ///< finding
    };
    constexpr std::uint64_t judged = 100;
    const Values values = variable_values(spec, judged);
    const std::size_t count = values.empty() ? 1 : values.front().size();
    const ImpactColumns impacts(spec, values, count);
    for (const LawChoice& choice : spec.laws) {
        const ImpactModel model{choice.law, choice.detachment, spec.damping_law};
        std::map<Severity, Remarked> remarked;
        for (std::size_t i = 0; i < count; ++i) {
            std::map<Severity, std::string> own;
            try {
                const Impact impact = impact_at(model, impacts, i);
                for (const Finding& finding :
                     regime_of(impact, solve_impact(impact).maximum_overlap).warnings)
                    own.try_emplace(finding.severity, finding.text);
            } catch (const InputError&) {  // reported where the sweep solves the impact
            } catch (const ConvergenceError&) {
            }
            for (const auto& [severity, text] : own)
                if (remarked[severity].impacts++ == 0) remarked[severity].first = text;
        }
        for (const auto& [severity, of] : remarked)
            warnings.push_back(
                fmt::format("{}: {:.3g} % of the impacts are outside of where the law holds; one: {}",
                            choice.law.name(), 100.0 * of.impacts / static_cast<double>(count), of.first));
    }
}

}  // namespace

std::vector<std::string> warnings_of_impacts(const SweepSpec& spec,
                                             const std::vector<OutsideShare>& outside) {
    std::vector<std::string> warnings;
    for (std::size_t k = 0; k < spec.laws.size(); ++k)
        if (outside[k].fraction > 0)
            warnings.push_back(fmt::format(
                "{}: of {:.3g} %{} of the captures v_c is {}; they, and shares that count them, are no "
                "result",
                spec.laws[k].law.name(), 100 * outside[k].fraction,
                outside[k].uncertainty > 0 ? fmt::format(" (± {:#.2g} %)", 100 * outside[k].uncertainty) : "",
                outside_model_text()));
    warn_of_regimes(spec, warnings);
    return warnings;
}

ResultColumns solve_in_batch(const ImpactModel& model, const ImpactColumns& impacts,
                             const WantedResults& wanted) {
    const std::size_t count = impacts.velocity.size();
    ResultColumns results;
    const auto column = [&](std::vector<double>& values, bool is_wanted) -> double* {
        if (!is_wanted) return nullptr;
        values.resize(count);
        return values.data();
    };
    const BatchOutputs outputs{.restitution = column(results.restitution, true),
                               .contact_time = column(results.contact_time, wanted.contact_time),
                               .maximum_overlap = column(results.maximum_overlap, wanted.maximum_overlap)};
    BatchReport report;
    try {
        report = solve_impacts(batch_of(model, impacts), outputs,
                               {.turning_point = wanted.maximum_overlap,
                                .contact_time = wanted.contact_time,
                                .method = wanted.method,
                                .keep_failures = true});
    } catch (const InputError&) {
        refuse_first(model, impacts);
        throw;
    }
    for (const FailedImpact& failed : report.failed) {
        const auto place = static_cast<std::size_t>(failed.place);
        results.failed.push_back({place, failed.reason, command_of(impact_at(model, impacts, place))});
    }
    return results;
}

report::CaptureFractions capture_fractions(const SweepSpec& spec) {
    report::CaptureFractions fractions{.impacts = 1};
    for (const SweepVariable& variable : spec.variables)
        fractions.variables.push_back(
            {.name = std::string(name_of(variable.input)),
             .unit = std::string(si_unit(dimension_of(variable.input, spec.damping_law)))});
    if (spec.variables.empty()) return fractions;
    const bool is_grid = spec.sampling.method == SamplingMethod::grid;
    const Values values = variable_values(spec, is_grid ? most_impacts : capture_impacts);
    fractions.impacts = values.front().size();
    const ImpactColumns impacts(spec, values, fractions.impacts);
    for (const LawChoice& choice : spec.laws) {
        const std::vector<double> flags =
            captured({choice.law, choice.detachment, spec.damping_law}, impacts);
        for (std::size_t i = 0; i < values.size(); ++i)
            fractions.variables[i].curves.push_back({choice.law, shares_of(values[i], flags)});
    }
    return fractions;
}

report::CaptureFractions capture_fractions(const Json& artifact) {
    return capture_fractions(read_sweep_spec(artifact.at("provenance").at("options").dump()).spec);
}

}  // namespace ashimpact
