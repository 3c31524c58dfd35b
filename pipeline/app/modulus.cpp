// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "materials/glass/oxide_table.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/contact/single_contact.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact {

namespace {

/// "0.42", "42 %", "42(2) %" or "42 +- 2 %", as in a case.
Quantity read_fraction(const char* option, const std::string& text) {
    return at_place(option, [&] {
        Quantity fraction = quantity_of_text(text, Dimension::fraction);
        require_fraction("the fraction", fraction.value);
        return fraction;
    });
}

Amorphous read_amorphous(const std::string& text, FractionBasis basis) {
    if (text == "none") return AmorphousNone{};
    if (text == "remainder") return AmorphousRemainder{};
    try {
        constexpr auto option = "--amorphous-fraction";
        const Quantity fraction =
            read_fraction(option, at_place(option, [&] { return xrd::without_basis(text, basis); }));
        if (fraction.value == 0) return AmorphousNone{};
        return AmorphousFraction{fraction.value, fraction.standard_uncertainty, basis};
    } catch (const InputError& error) {
        throw InputError(error.problem(),
                         "a fraction of the whole (0.42, \"42 %\", \"42 +- 2 %\"), none, remainder")
            .at(error.place());
    }
}

void refuse_contradictions(const CommandOptions& options) {
    const int ways = int{options.has("--amorphous-fraction")} + int{options.has("--crystalline-total")} +
                     int{options.has("--internal-standard")};
    if (ways > 1)
        throw InputError("the amorphous part is given in " + std::to_string(ways) + " ways", "one of them")
            .at("--amorphous-fraction, --crystalline-total, --internal-standard");
    if (options.has("--internal-standard") != options.has("--added-fraction"))
        throw InputError("one is given without the other",
                         "the phase of the standard, and its weight over that of the mixture")
            .at("--internal-standard, --added-fraction");
}

PhaseCatalogue catalogue_of(const CommandOptions& options) {
    PhaseCatalogue catalogue = built_in_phases();
    if (options.has("--phase-set"))
        catalogue = at_place("--phase-set", [&] { return catalogue.preferring(options["--phase-set"]); });
    if (!options.has("--phases")) return catalogue;
    return at_place(FileName{options["--phases"]}, [&] {
        const Json document = parse_json(read_file(options["--phases"]));
        const View root(document);
        warn_of(implausible_values(document), options["--phases"]);
        return catalogue.overridden_by(read_user_phases(document.is_array() ? root : root.at("phases")));
    });
}

/// The name that a sample gives the phase of another name: "Korund" for "corundum".
std::string name_in(const XrdSample& sample, const std::string& phase) {
    const PhaseCatalogue catalogue = built_in_phases();
    const auto known = [&](const std::string& name) {
        try {
            return catalogue.resolve(name).phase.name;
        } catch (const InputError&) {
            return name;
        }
    };
    const auto& phases = sample.analysis.phases;
    for (const PhaseFraction& each : phases)
        if (phase_key(each.name) == phase_key(phase)) return phase;
    const auto found = std::ranges::find_if(
        phases, [&](const PhaseFraction& each) { return known(each.name) == known(phase); });
    return found == phases.end() ? phase : found->name;
}

XrdSample completed(const XrdSample& sample, const CommandOptions& options) {
    refuse_contradictions(options);
    XrdSample result = sample;
    Analysis& analysis = result.analysis;
    const auto state = [&](const char* option, Amorphous amorphous) {
        at_place(option, [&] { analysis.state_amorphous(amorphous); });
    };
    if (options.has("--amorphous-fraction"))
        state("--amorphous-fraction", read_amorphous(options["--amorphous-fraction"], analysis.basis));
    if (options.has("--crystalline-total")) {
        constexpr auto option = "--crystalline-total";
        const Quantity total = read_fraction(
            option, at_place(option, [&] { return xrd::without_basis(options[option], analysis.basis); }));
        state("--crystalline-total", CrystallineTotal{total.value, total.standard_uncertainty});
    }
    if (!options.has("--internal-standard")) return result;
    const std::string by_weight = at_place("--added-fraction", [&] {
        return xrd::without_basis(options["--added-fraction"], FractionBasis::weight);
    });
    const Quantity added = read_fraction("--added-fraction", by_weight);
    return at_place("--internal-standard", [&] {
        return with_internal_standard(sample, name_in(sample, options["--internal-standard"]), added.value,
                                      added.standard_uncertainty);
    });
}

std::optional<double> measured_density(const CommandOptions& options) {
    if (!options.has("--particle-density")) return std::nullopt;
    const double density = options.number("--particle-density", Dimension::density);
    at_place("--particle-density", [&] { require_positive("density", density, Dimension::density); });
    return density;
}

std::optional<Porosity> porosity_of(const CommandOptions& options, double true_density,
                                    std::vector<Finding>& findings) {
    if (!options.has("--porosity-law")) {
        if (options.has("--porosity") || options.has("--porosity-coefficient"))
            throw InputError("is missing",
                             "the law by which pores soften: " + joined(names_of<PorosityLaw>()))
                .at("--porosity-law");
        return std::nullopt;
    }
    Porosity porosity{
        .law = at_place("--porosity-law", [&] { return named<PorosityLaw>(options["--porosity-law"]); })};
    if (options.has("--porosity-coefficient"))
        porosity.coefficient = options.number("--porosity-coefficient", Dimension::fraction);
    if (options.has("--porosity")) {
        const Quantity value = read_fraction("--porosity", options["--porosity"]);
        porosity.value = value.value;
        porosity.standard_uncertainty = value.standard_uncertainty;
    } else if (const auto measured = measured_density(options)) {
        const auto found = at_place("--particle-density", [&] {
            return porosity_from_density(porosity, make_quantity(*measured, Dimension::density),
                                         true_density);
        });
        porosity = found.porosity;
        findings.push_back(found.finding);
    } else {
        throw InputError("neither is given", "the porosity, or the density from which it follows")
            .at("--porosity, --particle-density");
    }
    const bool known = options.has("--porosity") && !options.has("--porosity-coefficient");
    at_place(known ? "--porosity" : "--porosity, --porosity-coefficient", [&] { require_valid(porosity); });
    return porosity;
}

struct SampleEstimate {
    std::string name;
    Composition composition{};
    ModulusEstimate estimate{};
    std::optional<SampleGlass> glass{};
    std::optional<Porosity> porosity{};
    ParticleDensity density{};
    std::vector<Finding> warnings;          ///< of the reader, the composition and the estimate
    std::vector<Finding> oxide_warnings{};  ///< of the oxides and the glass by them
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
    for (const Component& c : composition.listed())
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
    using enum MixtureRule;
    if (rule == parallel) return "  Eq. 1, no bound";
    if (rule == voigt) return "  upper bound";
    if (rule == reuss || rule == series) return "  lower bound";
    if (rule == hashin_shtrikman_lower) return "  lower bound, isotropic";
    return rule == hashin_shtrikman_upper ? "  upper bound, isotropic" : "";
}

void list_density(const SampleEstimate& sample, const CommandOptions& options, TextList& list) {
    const ParticleDensity& density = sample.density;
    list.add(
        "density of the phases",
        with_uncertainty(sample.estimate.density, sample.estimate.density_uncertainty, Dimension::density));
    if (density.porosity == 0) return;
    list.add("density of the particle", readable(density.apparent_density, "kg/m3") +
                                            (!options.has("--particle-density") ? "" : " (measured)"));
    list.add("porosity", readable_number(density.porosity));
}

/// The glass by its chemistry, and the modulus of the sample with either.
std::string glass_text(const SampleGlass& glass, const SampleEstimate& sample) {
    std::string oxides;
    for (const auto& [oxide, fraction] : glass.composition)
        oxides += fmt::format("{}{} {:.1f}", oxides.empty() ? "" : ", ", oxide, 100 * fraction.value);
    TextList list;
    list.add("glass by its oxides [wt%]", oxides);
    list.add("  part of the sample", percent(glass.weight_fraction.value) + " % (by XRD " +
                                         percent(glass.amorphous_fraction.value) + " %)");
    list.add("  Young's modulus", readable(glass.young_modulus) + "  Makishima & Mackenzie");
    list.add("  Poisson's ratio", readable_number(glass.poisson_ratio));
    list.add("  density", readable(glass.density) + (glass.density_assumed ? "  assumed" : ""));
    list.add(
        glass.used ? "E with the catalogue's glass" : "E with this glass",
        with_uncertainty(glass.other.young_modulus.value,
                         glass.other.young_modulus.standard_uncertainty.value_or(0), Dimension::pressure) +
            fmt::format("  ({:+.1f} %)",
                        100 * (glass.other.young_modulus.value / sample.estimate.young_modulus - 1)));
    return list.text(0);
}

std::string estimate_text(const SampleEstimate& sample, const CommandOptions& options) {
    const ModulusEstimate& estimate = sample.estimate;
    const std::string pores = sample.porosity ? "  pores by " + options["--porosity-law"] : "";
    TextList list;
    list.add(
        fmt::format("Young's modulus ({})", options["--rule"]),
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
    const std::string text = list.text(0) + (sample.glass ? "\n" + glass_text(*sample.glass, sample) : "");
    return title + phases_text(sample.composition) + "\n" + text + uncertainty_legend(text);
}

Json sample_json(const SampleEstimate& sample, MixtureRule rule) {
    Json json{{"name", sample.name}};
    SampleModulus modulus = sample_modulus(sample.composition, sample.estimate, rule);
    modulus.glass = sample.glass;
    json.update(modulus_json(modulus));
    json["particle_density"] = quantity_json(sample.density.apparent_density, Dimension::density);
    json["porosity"] = sample.density.porosity;
    if (sample.porosity) json["porosity_law"] = name_of(sample.porosity->law);
    json["warnings"] = texts_of(sample.warnings);
    return json;
}

/// Returns what @p compute returns. Its error gets the name of a sample of several, unless it has a place.
template <class Compute>
SampleEstimate naming_sample(const std::string& sample, Compute&& compute) {
    try {
        return compute();
    } catch (const InputError& error) {
        if (sample.empty() || !error.place().empty()) throw;
        throw error.at("sample " + in_quotes(sample));
    }
}

/// The file of --oxides; none if it is not given.
std::optional<OxideResult> read_oxides_of(const CommandOptions& options) {
    if (!options.has("--oxides")) {
        for (const auto* option : {"--oxides-sample", "--oxides-sheet", "--glass", "--glass-density"})
            if (options.has(option))
                throw InputError("belongs to a file of oxides", "--oxides FILE").at(option);
        return std::nullopt;
    }
    const std::string file = options["--oxides"];
    TableOptions table = table_options(options);
    table.sheet = options.has("--oxides-sheet") ? options["--oxides-sheet"] : "";
    OxideResult oxides = read_oxides(read_start(file, longest_xrd_file + 1), file, table);
    warn_of(oxides.warnings, file);
    return oxides;
}

/// Oxides and choice of glass for a sample; with oxides the glass from chemistry counts by default.
GlassInputs glass_inputs(const std::string& sample, const std::optional<OxideResult>& oxides,
                         const CommandOptions& options, std::vector<Finding>& warnings) {
    GlassInputs inputs;
    if (!oxides) return inputs;
    const bool stated = options.has("--oxides-sample");
    const OxideSample& chosen = at_place(FileName{options["--oxides"]}, [&]() -> const OxideSample& {
        return oxide_sample(*oxides, stated ? options["--oxides-sample"] : sample, stated);
    });
    warnings.insert(warnings.end(), chosen.warnings.begin(), chosen.warnings.end());
    if (const auto other = stated ? std::nullopt : other_sample_finding(chosen, sample))
        warnings.push_back(*other);
    inputs.oxides = chosen.analysis;
    inputs.source = !options.has("--glass")
                        ? GlassSource::from_chemistry
                        : at_place("--glass", [&] { return named<GlassSource>(options["--glass"]); });
    if (options.has("--glass-density"))
        inputs.density = at_place("--glass-density", [&] {
            return quantity_of_text(options["--glass-density"], Dimension::density);
        });
    return inputs;
}

SampleEstimate estimated(const XrdSample& sample, const PhaseCatalogue& catalogue,
                         const std::optional<OxideResult>& oxides, const CommandOptions& options,
                         MixtureRule rule) {
    SampleEstimate result{.name = sample.name, .warnings = sample.warnings};
    const GlassInputs inputs = glass_inputs(sample.name, oxides, options, result.oxide_warnings);
    const GlassInSample composed = compose_with_glass(
        sample.analysis, catalogue, inputs,
        "--amorphous-fraction X (of the whole; none; remainder: what is missing to 100 %), "
        "--crystalline-total X, or --internal-standard PHASE with --added-fraction X");
    result.composition = composed.composition;
    std::vector<Finding> inferred;
    result.porosity = porosity_of(options, result.composition.density, inferred);
    ModulusOptions modulus{.rule = rule, .porosity = result.porosity};
    if (result.porosity && !options.has("--porosity"))
        modulus.apparent_density = make_quantity(*measured_density(options), Dimension::density);
    result.estimate = estimate_modulus(result.composition, modulus);
    if (composed.other)
        result.glass = sample_glass(composed, estimate_modulus(*composed.other, modulus), inputs.source);
    const auto stated =
        !options.has("--porosity") ? std::nullopt : std::optional(result.porosity.value().value);
    result.density = at_place("--particle-density", [&] {
        return particle_density(result.composition.density, stated, measured_density(options));
    });
    for (const auto& notes :
         {result.composition.notes, result.estimate.notes, result.density.notes, inferred})
        result.warnings.insert(result.warnings.end(), notes.begin(), notes.end());
    if (composed.glass)
        result.oxide_warnings.insert(result.oxide_warnings.end(), composed.glass->notes.begin(),
                                     composed.glass->notes.end());
    return result;
}

/// Names of the phases of the first set of a catalogue, which are those of the user, that no sample has.
std::vector<std::string> unused_own_phases(const std::vector<SampleEstimate>& samples,
                                           const PhaseCatalogue& catalogue) {
    std::set<std::string> used;
    for (const SampleEstimate& sample : samples)
        for (const Component& component : sample.composition.components) used.insert(component.phase.name);
    std::vector<std::string> names;
    for (const Phase& phase : catalogue.sets().front().phases)
        if (!used.contains(phase.name)) names.push_back(in_quotes(phase.name));
    return names;
}

/// Prints each text once, with the names of the samples that have it if they are not all.
void warn_of_samples(const std::vector<SampleEstimate>& estimates,
                     std::vector<Finding> SampleEstimate::*findings, const std::string& place) {
    std::set<std::string> printed;
    std::vector<Finding> all;
    for (const SampleEstimate& estimate : estimates)
        for (Finding finding : estimate.*findings) {
            if (!printed.insert(finding.text).second) continue;
            std::vector<std::string> names;
            for (const SampleEstimate& other : estimates)
                if (std::ranges::find(other.*findings, finding.text, &Finding::text) !=
                    (other.*findings).end())
                    names.push_back(other.name);
            if (names.size() < estimates.size()) finding.text = joined(names) + ": " + finding.text;
            all.push_back(std::move(finding));
        }
    warn_of(all, place);
}

void run_modulus_command(const CommandOptions& options, std::ostream& out) {
    const MixtureRule rule = at_place("--rule", [&] { return named<MixtureRule>(options["--rule"]); });
    const PhaseCatalogue catalogue = catalogue_of(options);
    const XrdResult result =
        read_xrd(read_start(options["file"], longest_xrd_file + 1), options["file"], table_options(options));
    warn_of(result.warnings, options["file"]);

    const std::optional<OxideResult> oxides = read_oxides_of(options);
    std::vector<SampleEstimate> estimates;
    const std::vector<XrdSample> samples = chosen(result, options["--sample"]);
    if (oxides && (oxides->samples.size() == 1 || options.has("--oxides-sample")) && samples.size() > 1)
        warn_of({{glass_code, Severity::remark,
                  fmt::format("one analysis counts for {} samples", samples.size())}},
                options["--oxides"]);
    for (const XrdSample& sample : samples) {
        const XrdSample whole = completed(sample, options);
        estimates.push_back(at_place(FileName{options["file"]}, [&] {
            return naming_sample(result.samples.size() > 1 ? sample.name : std::string(),
                                 [&] { return estimated(whole, catalogue, oxides, options, rule); });
        }));
    }
    warn_of_samples(estimates, &SampleEstimate::warnings, options["file"]);
    warn_of_samples(estimates, &SampleEstimate::oxide_warnings, options["--oxides"]);
    print_reading(options["file"], result.reading);
    if (oxides) print_reading(options["--oxides"], oxides->reading);
    const auto doubts = options.doubts();
    for (SampleEstimate& estimate : estimates) {
        std::vector<Finding> all = result.warnings;
        for (const auto& each : {doubts, estimate.warnings, estimate.oxide_warnings})
            all.insert(all.end(), each.begin(), each.end());
        estimate.warnings = std::move(all);
    }

    if (options.has("--phases"))
        if (const auto unused = unused_own_phases(estimates, catalogue); !unused.empty())
            warn_idle("--phases", "no sample has " + joined(unused));

    if (!options.has("--json")) {
        for (const SampleEstimate& estimate : estimates)
            out << (&estimate == &estimates.front() ? "" : "\n") << estimate_text(estimate, options);
        return;
    }
    Json json = Json::array();
    for (const SampleEstimate& estimate : estimates) json.push_back(sample_json(estimate, rule));
    out << write_json(json.size() == 1 ? json.front() : Json{{"samples", json}}, Digits::seventeen);
}

}  // namespace

void add_modulus(const CommandLine& line) {
    Command command = line.add("modulus", "XRD result -> phase volumes -> Young's modulus with bounds",
                               "ashimpact modulus my-case/ash.csv --amorphous-fraction '42 +- 2 %'\n"
                               "  (ash.csv is among what `ashimpact init my-case` writes)",
                               run_modulus_command);
    command
        .add("file", "FILE",
             "XRD result: BGMN/Profex or GSAS-II .lst, FullProf .sum, TOPAS .out, CSV, .xlsx, .ods or JSON")
        ->required();
    command.add("--amorphous-fraction", "X",
                "amorphous part of the whole, by weight (by volume where the file is); none; remainder: what "
                "is missing to 100 %");
    command.add("--crystalline-total", "X", "the rest of the whole is amorphous");
    command.add("--internal-standard", "PHASE",
                "standard that was added and refined; the amorphous part follows");
    command.add("--added-fraction", "X", "its weight over that of the mixture");
    command.add("--oxides", "FILE",
                "chemical analysis (XRF) of the sample, as CSV, .xlsx or .ods: the glass from its chemistry");
    command.add("--oxides-sample", "NAME", "of a file of oxides with several; default: the name in FILE");
    command.add("--oxides-sheet", "NAME", "sheet of a spreadsheet with several tables of oxides");
    command.add("--glass", "NAME", "glass that counts: from-chemistry (with --oxides), catalogue");
    command.add("--glass-density", "Q", "density of the glass; default: 2.5 +- 0.1 g/cm3");
    command.add("--sample", "NAME", "of a file with several; default: all");
    command.add_table_options();
    command.add("--phase-set", "NAME", "phase set to look in first: literature, dong2013");
    command.add("--phases", "CASE.json", "case file whose own phases come before all others");
    command.add("--rule", "NAME", "mixture rule of the modulus", "parallel");
    command.add("--porosity-law", "NAME", "law by which pores soften; default: no pores");
    command.add("--porosity", "X", "default: from --particle-density and the phases");
    command.add("--porosity-coefficient", "B", "b of the law spriggs");
    command.add("--particle-density", "RHO", "as measured, pores included");
    command.add_json_flag();
}

}  // namespace ashimpact
