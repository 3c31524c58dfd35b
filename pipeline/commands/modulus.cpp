#include "pipeline/commands/modulus.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <ostream>

#include "materials/text.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/commands/contact_options.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/json/writer.hpp"
#include "pipeline/stages/modulus.hpp"
#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

namespace ashimpact {

namespace {

struct SampleEstimate {
    std::string name;
    Composition composition;
    ModulusEstimate estimate;
};

void state_amorphous_part(Analysis& analysis, const std::string& text) {
    if (text.empty()) return;
    const double fraction = read_option("--amorphous-fraction", text, Dimension::fraction);
    if (fraction == 0)
        analysis.amorphous = AmorphousNone{};
    else
        analysis.amorphous =
            AmorphousFraction{.value = fraction, .standard_uncertainty = {}, .basis = analysis.basis};
}

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

std::string estimate_text(const SampleEstimate& sample, const ModulusCommandOptions& options) {
    TextTable phases({"phase", "weight %", "volume %", "density", "E"});
    for (const Component& c : sample.composition.components)
        phases.add({c.name, percent(c.weight_fraction), percent(c.volume_fraction),
                    readable(c.phase.density.value, "kg/m3"), readable(c.phase.young_modulus.value, "Pa")});
    const ModulusEstimate& estimate = sample.estimate;
    TextList list;
    list.add(
        fmt::format("Young's modulus ({})", options.rule),
        readable(make_quantity(estimate.young_modulus, Dimension::pressure, estimate.standard_uncertainty)));
    for (const RuleResult& rule : estimate.rules)
        list.add("  " + std::string(mixture_rule_name(rule.rule)), readable(rule.young_modulus, "Pa"));
    if (estimate.poisson_ratio)
        list.add("Poisson's ratio", readable_number(*estimate.poisson_ratio) +
                                        (estimate.poisson_ratio_assumed ? " (of some phases assumed)" : ""));
    list.add("density of the phases", readable(estimate.density, "kg/m3"));
    const std::string title = sample.name.empty() ? "" : sample.name + "\n";
    return title + phases.text() + "\n" + list.text(0);
}

Json sample_json(const SampleEstimate& sample, MixtureRule rule) {
    Json json{{"name", sample.name}};
    json.update(modulus_json(sample.composition, sample.estimate, rule));
    Json notes = Json::array();
    for (const auto& source : {sample.composition.notes, sample.estimate.notes})
        for (const std::string& note : source) notes.push_back(note);
    json["warnings"] = notes;
    return json;
}

}  // namespace

void run_modulus_command(const ModulusCommandOptions& options, std::ostream& out) {
    const MixtureRule rule = at_place("--rule", [&] { return mixture_rule(options.rule); });
    PhaseCatalogue catalogue = built_in_phases();
    if (!options.phase_set.empty())
        catalogue = at_place("--phase-set", [&] { return catalogue.preferring(options.phase_set); });
    const XrdResult result = read_xrd(read_file(options.file), options.file);
    for (const std::string& warning : result.warnings) spdlog::warn("warning: {}: {}", options.file, warning);

    std::vector<SampleEstimate> estimates;
    for (XrdSample& sample : chosen(result, options.sample)) {
        state_amorphous_part(sample.analysis, options.amorphous_fraction);
        estimates.push_back(in_file(options.file, [&] {
            Composition composition = compose(sample.analysis, catalogue);
            ModulusEstimate estimate = estimate_modulus(composition, {.rule = rule, .porosity = {}});
            return SampleEstimate{sample.name, std::move(composition), std::move(estimate)};
        }));
        for (const auto& notes :
             {sample.warnings, estimates.back().composition.notes, estimates.back().estimate.notes})
            for (const std::string& note : notes) spdlog::warn("warning: {}: {}", options.file, note);
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
