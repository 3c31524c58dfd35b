// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/materials/modulus.hpp"

#include <ostream>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/commands/materials/modulus_options.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/document/quantity_json.hpp"
#include "pipeline/present/text/readable.hpp"
#include "pipeline/present/text/table.hpp"
#include "pipeline/run/modulus.hpp"

namespace ashimpact {

namespace {

struct SampleEstimate {
    std::string name;
    Composition composition;
    ModulusEstimate estimate;
    std::optional<Porosity> porosity;
    ParticleDensity density;
    std::vector<std::string> warnings;  ///< of the reader, the composition and the estimate
};

std::vector<XrdSample> chosen(const XrdResult& result, const std::string& name) {
    std::vector<XrdSample> samples;
    std::vector<std::string> names;
    for (const XrdSample& sample : result.samples) {
        names.push_back(sample.name);
        if (name.empty() || sample.name == name) samples.push_back(sample);
    }
    if (samples.empty())
        throw InputError("the file has no sample " + in_quotes(name), joined(names)).at("--sample");
    return samples;
}

std::string percent(double fraction) {
    return fmt::format("{:.2f}", 100 * fraction);
}

std::string phases_text(const Composition& composition) {
    TextTable phases({"phase", "weight %", "volume %", "density", "E"});
    for (const Component& c : composition.components)
        phases.add({c.name, percent(c.weight_fraction), percent(c.volume_fraction),
                    readable(c.phase.density.value, "kg/m3"), readable(c.phase.young_modulus.value, "Pa")});
    return phases.text();
}

std::string with_uncertainty(double value, double uncertainty, Dimension dimension) {
    if (uncertainty == 0) return readable(value, si_unit(dimension));
    return readable(make_quantity(value, dimension, uncertainty));
}

/// What a rule is, beside its value.
std::string_view standing_of(MixtureRule rule) {
    switch (rule) {
        case MixtureRule::parallel:
            return "  Eq. 1, no bound";
        case MixtureRule::voigt:
            return "  upper bound";
        case MixtureRule::reuss:
        case MixtureRule::series:
            return "  lower bound";
        case MixtureRule::hashin_shtrikman_lower:
            return "  lower bound, isotropic";
        case MixtureRule::hashin_shtrikman_upper:
            return "  upper bound, isotropic";
        case MixtureRule::hill:
        case MixtureRule::voigt_reuss_hill:
            return "";
    }
    return "";
}

void list_density(const SampleEstimate& sample, const ModulusCommandOptions& options, TextList& list) {
    const ParticleDensity& density = sample.density;
    list.add(
        "density of the phases",
        with_uncertainty(sample.estimate.density, sample.estimate.density_uncertainty, Dimension::density));
    if (density.porosity == 0) return;
    list.add("density of the particle", readable(density.apparent_density, "kg/m3") +
                                            (options.particle_density.empty() ? "" : " (measured)"));
    list.add("porosity", readable_number(density.porosity));
}

std::string estimate_text(const SampleEstimate& sample, const ModulusCommandOptions& options) {
    const ModulusEstimate& estimate = sample.estimate;
    const std::string pores = sample.porosity ? "  pores by " + options.porosity_law : "";
    TextList list;
    list.add(
        fmt::format("Young's modulus ({})", options.rule),
        with_uncertainty(estimate.young_modulus, estimate.standard_uncertainty, Dimension::pressure) + pores);
    for (const RuleResult& rule : estimate.rules)
        list.add("  " + std::string(name_of(rule.rule)) + (sample.porosity ? ", dense" : ""),
                 with_uncertainty(rule.young_modulus, rule.standard_uncertainty, Dimension::pressure) +
                     std::string(standing_of(rule.rule)));
    if (estimate.poisson_ratio)
        list.add("Poisson's ratio", readable_number(*estimate.poisson_ratio) +
                                        (estimate.poisson_ratio_assumed ? " (of some phases assumed)" : ""));
    list_density(sample, options, list);
    const std::string title = sample.name.empty() ? "" : sample.name + "\n";
    const std::string text = list.text(0);
    return title + phases_text(sample.composition) + "\n" + text + uncertainty_legend(text);
}

Json sample_json(const SampleEstimate& sample, MixtureRule rule) {
    Json json{{"name", sample.name}};
    json.update(modulus_json(sample.composition, sample.estimate, rule));
    json["particle_density"] = quantity_json(sample.density.apparent_density, Dimension::density);
    json["porosity"] = sample.density.porosity;
    if (sample.porosity) json["porosity_law"] = name_of(sample.porosity->law);
    json["warnings"] = sample.warnings;
    return json;
}

SampleEstimate estimated(const XrdSample& sample, const PhaseCatalogue& catalogue,
                         const ModulusCommandOptions& options, MixtureRule rule) {
    SampleEstimate result{.name = sample.name,
                          .composition = composed(sample, catalogue),
                          .estimate = {},
                          .porosity = {},
                          .density = {},
                          .warnings = sample.warnings};
    std::string note;
    result.porosity = porosity_of(options, result.composition.density, note);
    result.estimate = estimate_modulus(result.composition, {.rule = rule, .porosity = result.porosity});
    const auto stated =
        options.porosity.empty() ? std::nullopt : std::optional(result.porosity.value().value);
    result.density = at_place("--particle-density", [&] {
        return particle_density(result.composition.density, stated, measured_density(options));
    });
    for (const auto& notes : {result.composition.notes, result.estimate.notes, result.density.notes})
        result.warnings.insert(result.warnings.end(), notes.begin(), notes.end());
    if (!note.empty()) result.warnings.push_back(note);
    return result;
}

}  // namespace

void run_modulus_command(const ModulusCommandOptions& options, std::ostream& out) {
    const MixtureRule rule = at_place("--rule", [&] { return named<MixtureRule>(options.rule); });
    const PhaseCatalogue catalogue = catalogue_of(options);
    const XrdResult result =
        read_xrd(read_start(options.file, longest_xrd_file + 1), options.file, options.sheet);
    for (const std::string& warning : result.warnings) spdlog::warn("warning: {}: {}", options.file, warning);

    std::vector<SampleEstimate> estimates;
    for (const XrdSample& sample : chosen(result, options.sample)) {
        const XrdSample whole = completed(sample, options);
        SampleEstimate estimate =
            at_place(FileName{options.file}, [&] { return estimated(whole, catalogue, options, rule); });
        for (const std::string& warning : estimate.warnings)
            spdlog::warn("warning: {}: {}", options.file, warning);
        estimate.warnings.insert(estimate.warnings.begin(), result.warnings.begin(), result.warnings.end());
        estimates.push_back(std::move(estimate));
    }

    if (!options.json) {
        for (const SampleEstimate& estimate : estimates)
            out << (&estimate == &estimates.front() ? "" : "\n") << estimate_text(estimate, options);
        return;
    }
    Json json = Json::array();
    for (const SampleEstimate& estimate : estimates) json.push_back(sample_json(estimate, rule));
    out << write_json(json.size() == 1 ? json.front() : Json{{"samples", json}}, Digits::seventeen);
}

}  // namespace ashimpact
