// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/sweep/spec/spec.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/files/schema.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/damping/damping.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact {

namespace {

constexpr std::array default_quantiles{0.05, 0.25, 0.5, 0.75, 0.95};
constexpr double default_restitution_resolution = 0.001;
constexpr double default_relative_resolution = 0.01;
constexpr double most_samples = 1e15;  // a double counts them exactly

std::vector<LawChoice> read_laws(const View& impact) {
    std::vector<LawChoice> laws;
    for (const View& name : impact.at("laws").elements()) {
        const Law law = Law::named(name.text());
        laws.push_back({law, law.default_detachment()});
    }
    read_detachments(impact.find("detachments"), laws, "a law of the sweep");
    return laws;
}

template <class Predicate>
bool any_law(const SweepSpec& spec, const Predicate& predicate) {
    return std::ranges::any_of(spec.laws, predicate, &LawChoice::law);
}

void read_fixed(const View& impact, SweepSpec& spec) {
    for (const auto& [key, node] : impact.members()) {
        if (key == "laws" || key == "detachments" || key == "damping_law" || key == "damping_over_sizes")
            continue;
        const ImpactInput input = impact_input_named(key);
        const Dimension dimension = dimension_of(input, spec.damping_law);
        const double value = node.certain_number(dimension, varies_instead);
        at_place(node.pointer(), [&] { require_allowed(input, value, dimension); });
        spec.fixed[static_cast<std::size_t>(input)] = value;
    }
}

void require_input(const View& document, const SweepSpec& spec, ImpactInput input,
                   const std::string& why = {}) {
    if (is_given(spec, input)) return;
    document.at("impact").fail(
        in_quotes(name_of(input)) + " is missing" + why,
        with_article(dimension_name(dimension_of(input, spec.damping_law))) + " here or in /variables");
}

/// Warns of the inputs that no law of the sweep uses.
void warn_idle(SweepSpec& spec) {
    std::vector<Law> laws;
    for (const LawChoice& choice : spec.laws) laws.push_back(choice.law);
    for (std::size_t i = 0; i < impact_input_count(); ++i) {
        const auto input = static_cast<ImpactInput>(i);
        const auto reason =
            is_given(spec, input) ? idle_reason(laws, spec.damping_law, name_of(input)) : std::nullopt;
        if (reason) spec.warnings.push_back(std::string(name_of(input)) + ": " + idle_words(*reason));
    }
    const bool coefficient = is_given(spec, ImpactInput::damping) &&
                             spec.fixed[static_cast<std::size_t>(ImpactInput::damping)] != 0.0;
    if (coefficient || std::ranges::any_of(parameters_of(spec.damping_law), [&](const LawParameter& own) {
            return is_given(spec, input_of(own));
        }))
        return;
    const std::string idle = ": " + idle_words("there is no damping");
    if (spec.damping_law != DampingLaw::constant) spec.warnings.push_back("damping_law" + idle);
    if (spec.damping_over_sizes) spec.warnings.push_back("damping_over_sizes" + idle);
}

/// The mass of a sphere stands in the sweep as such, or as its density.
void require_one_mass(const View& document, const SweepSpec& spec, ImpactInput density, ImpactInput mass) {
    const auto both = [&](const char* between) {
        return in_quotes(name_of(density)) + between + in_quotes(name_of(mass));
    };
    if (is_given(spec, density) && is_given(spec, mass))
        document.at("impact").fail("both " + both(" and ") + " are given, here or in /variables",
                                   "one of the two");
    if (!is_given(spec, mass))
        require_input(document, spec, density, ", and so is " + in_quotes(name_of(mass)));
}

/// Warns if a radius with a mass makes a sphere of an implausible density.
void warn_of_mass(SweepSpec& spec, ImpactInput radius_input, ImpactInput mass_input) {
    if (!is_given(spec, radius_input) || !is_given(spec, mass_input)) return;
    const Support radius = bulk_of(spec, radius_input);
    const Support mass = bulk_of(spec, mass_input);
    for (const auto& [r, m] :
         {std::pair(radius.lowest, mass.highest), std::pair(radius.highest, mass.lowest)})
        if (const auto doubt = implausible_mass(r, m)) {
            spec.warnings.push_back(std::string(name_of(mass_input)) + ": " + doubt->text);
            return;
        }
}

/// Warns of distributions without ends of which a hundredth is implausible.
void warn_of_tails(SweepSpec& spec) {
    for (const SweepVariable& variable : spec.variables) {
        const PlausibleRange* range = plausible_range(name_of(variable.input));
        const bool has_tails = std::holds_alternative<Normal>(variable.distribution) ||
                               std::holds_alternative<LogNormal>(variable.distribution);
        if (range == nullptr || !has_tails) continue;
        const Support bulk = bulk_of(spec, variable.input);
        for (const double end : {bulk.lowest, bulk.highest})
            if (const auto doubt = implausible(*range, {end}))
                spec.warnings.push_back(std::string(name_of(variable.input)) +
                                        ": one draw in 200 is beyond " + doubt->text);
    }
}

DampingOverSizes read_damping_over_sizes(const View& node) {
    if (node.is_string()) return {.power = 0, .radius = 1};
    const View radius = node.at("at_radius");
    const double value = radius.certain_number(Dimension::length, varies_instead);
    at_place(radius.pointer(), [&] { require_allowed(ImpactInput::radius, value, Dimension::length); });
    return {.power = node.at("power").number(Dimension::fraction), .radius = value};
}

void check_inputs(const View& document, SweepSpec& spec) {
    for (const SweepVariable& variable : spec.variables)
        if (spec.fixed[static_cast<std::size_t>(variable.input)])
            document.at("impact")
                .at(name_of(variable.input))
                .fail("varies too, in /variables", "one of the two");
    require_one_mass(document, spec, ImpactInput::density, ImpactInput::mass);
    if (is_given(spec, ImpactInput::partner_radius))
        require_one_mass(document, spec, ImpactInput::partner_density, ImpactInput::partner_mass);
    else if (is_given(spec, ImpactInput::partner_density) || is_given(spec, ImpactInput::partner_mass))
        require_input(document, spec, ImpactInput::partner_radius);
    for (const ImpactInput input : {ImpactInput::radius, ImpactInput::contact_modulus, ImpactInput::velocity})
        require_input(document, spec, input);
    const bool adhesive = any_law(spec, [](Law law) { return law.uses_work_of_adhesion(); });
    const bool yielding = any_law(spec, [](Law law) { return law.is_plastic(); });
    if (adhesive) require_input(document, spec, ImpactInput::work_of_adhesion);
    if (yielding) require_input(document, spec, ImpactInput::yield_pressure);
    warn_idle(spec);
    warn_of_tails(spec);
    warn_of_mass(spec, ImpactInput::radius, ImpactInput::mass);
    warn_of_mass(spec, ImpactInput::partner_radius, ImpactInput::partner_mass);
    for (const LawChoice& choice : spec.laws) {
        const auto fault = parameter_fault(
            parameters_of(choice.law, spec.damping_law),
            [&](const LawParameter& parameter) { return is_given(spec, input_of(parameter)); });
        if (fault)
            document.at("impact").fail(
                fault->problem() + ", here or in /variables, for law " + in_quotes(choice.law.name()),
                fault->allowed());
    }
}

std::uint64_t read_count(const View& node, double most) {
    const double value = node.number(Dimension::fraction);
    if (!(value >= 0 && value <= most && value == std::floor(value)))
        node.fail("is " + shortest(value), "a whole number up to " + shortest(most));
    return static_cast<std::uint64_t>(value);
}

Sampling read_sampling(const View& node) {
    const std::string method = node.at("method").text();
    const auto refuse = [&](const char* key, const std::string& why) {
        if (const auto given = node.find(key)) given->fail("means nothing for " + in_quotes(method), why);
    };
    Sampling sampling{.method = SamplingMethod::grid};
    if (method != "quasi-random")
        for (const char* key : {"sequence", "shifts"}) refuse(key, "quasi-random sampling");
    if (method == "grid") {
        for (const char* key : {"samples", "seed"}) refuse(key, "random or quasi-random sampling");
        return sampling;
    }
    sampling.method = method == "random" ? SamplingMethod::random : SamplingMethod::quasi_random;
    if (!node.has("samples")) node.fail("\"samples\" is missing", "how many points to draw");
    sampling.points = read_count(node.at("samples"), most_samples);
    if (const auto seed = node.find("seed")) sampling.seed = read_count(*seed, 0x1p53);
    if (const auto shifts = node.find("shifts"))
        sampling.shifts = static_cast<std::uint32_t>(read_count(*shifts, 64));
    if (node.has("sequence") && node.at("sequence").text() == "niederreiter")
        sampling.sequence = QuasiRandomSequence::niederreiter;
    return sampling;
}

Bins bins_of(Observable observable, double resolution) {
    if (observable == Observable::restitution)
        return Bins::absolute(static_cast<std::uint32_t>(std::ceil(1 / resolution - 1e-6)));
    return Bins::relative(static_cast<unsigned>(std::ceil(-std::log2(resolution))));
}

/// Bins and quantiles of an observable; default ones where @p node does not state them.
ObservableStatistics statistics_of(Observable observable, const View& node) {
    double resolution =
        observable == Observable::restitution ? default_restitution_resolution : default_relative_resolution;
    if (const auto given = node.find("resolution")) {
        resolution = given->number(Dimension::fraction);
        if (!(resolution >= 1e-5 && resolution <= 0.5))
            given->fail("is " + shortest(resolution), "1e-5 to 0.5");
    }
    const auto quantiles = node.find("quantiles");
    return {observable, bins_of(observable, resolution),
            quantiles ? quantiles->column(Dimension::fraction)
                      : std::vector<double>(default_quantiles.begin(), default_quantiles.end())};
}

void read_statistics(const View& document, SweepSpec& spec) {
    static const Json none = Json::object();
    spec.statistics.push_back({Observable::captured, Bins::absolute(1), {}});
    if (const auto statistics = document.find("statistics"))
        for (const auto& [key, node] : statistics->members())
            spec.statistics.push_back(statistics_of(named<Observable>(key), node));
    else
        spec.statistics.push_back(statistics_of(Observable::restitution, View(none)));
}

std::vector<Observable> read_observables(const View& document, const char* key) {
    std::vector<Observable> observables;
    if (const auto list = document.find(key))
        for (const View& name : list->elements()) observables.push_back(named<Observable>(name.text()));
    return observables;
}

void check_sensitivity(const View& document, const SweepSpec& spec) {
    if (spec.sensitivity.empty()) return;
    if (spec.sampling.method == SamplingMethod::grid)
        document.at("sensitivity").fail("needs points drawn at random", "random or quasi-random sampling");
    for (const View& name : document.at("sensitivity").elements())
        if (!captures_count(named<Observable>(name.text())))
            name.fail("a captured particle has none, so its variance has no parts",
                      "captured, restitution, ...");
}

void check_sampling(const View& document, const SweepSpec& spec) {
    for (const SweepVariable& variable : spec.variables)
        if (spec.sampling.method == SamplingMethod::grid &&
            !std::holds_alternative<Choice>(variable.distribution))
            document.at("variables")
                .at(name_of(variable.input))
                .fail("a grid takes no distribution", "values or a grid, or another sampling method");
    at_place(document.at("sampling").pointer(), [&] {
        const Design design(distributions_of(spec), spec.sampling, spec.sensitivity.empty() ? 1 : 2);
        if (static_cast<double>(design.points()) > most_samples)
            throw InputError("too many points", "1e15 at most");
        if (design.points() < design.groups())
            throw InputError(
                "\"samples\" is " + std::to_string(design.points()),
                spec.sampling.method == SamplingMethod::random
                    ? "16 or more: errors are estimated by leaving out a sixteenth at a time"
                    : std::to_string(design.groups()) + " or more, a sample for each of the \"shifts\"");
    });
}

}  // namespace

bool is_given(const SweepSpec& spec, ImpactInput input) {
    return spec.fixed[static_cast<std::size_t>(input)].has_value() ||
           std::ranges::find(spec.variables, input, &SweepVariable::input) != spec.variables.end();
}

std::vector<Distribution> distributions_of(const SweepSpec& spec) {
    std::vector<Distribution> distributions;
    for (const SweepVariable& variable : spec.variables) distributions.push_back(variable.distribution);
    return distributions;
}

LoadedSpec read_sweep_spec(const std::string& text) {
    const Json json = parse_json(text);
    require_schema_version(json, false);
    validate_document(json, "sweep");
    const View document(json);
    SweepSpec spec;
    spec.warnings = texts_of(implausible_values(json));
    const View impact = document.at("impact");
    spec.laws = read_laws(impact);
    if (const auto law = impact.find("damping_law")) spec.damping_law = named<DampingLaw>(law->text());
    read_fixed(impact, spec);
    for (const auto& member : document.at("variables").members()) {
        const ImpactInput input = impact_input_named(member.key);
        spec.variables.push_back({input, read_variable(member.value, input, spec.damping_law)});
    }
    if (const auto sizes = impact.find("damping_over_sizes"))
        spec.damping_over_sizes = read_damping_over_sizes(*sizes);
    check_inputs(document, spec);
    for (const std::string& warning : warnings_of_sizes(spec)) spec.warnings.push_back(warning);
    spec.sampling = read_sampling(document.at("sampling"));
    if (spec.sampling.method != SamplingMethod::grid)  // draws follow the names, not the order of the keys
        std::ranges::sort(spec.variables, std::ranges::greater(),
                          [](const SweepVariable& variable) { return name_of(variable.input); });
    read_statistics(document, spec);
    spec.sensitivity = read_observables(document, "sensitivity");
    check_sensitivity(document, spec);
    spec.table = read_observables(document, "table");
    check_sampling(document, spec);
    return {std::move(spec), write_json(json)};
}

}  // namespace ashimpact
