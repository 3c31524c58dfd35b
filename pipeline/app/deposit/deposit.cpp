// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/deposit/deposit.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/plausibility.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "pipeline/app/contact/damping_choice.hpp"
#include "pipeline/app/deposit/sizes_choice.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/deposition_fields.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/deposition/deposition_page.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/deposition.hpp"
#include "pipeline/run/rebounds.hpp"
#include "pipeline/run/sizes.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/batch/parallel.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/deposition/tube_flow.hpp"
#include "solver/motion/regime.hpp"
#include "solver/surrogate/rebound_table.hpp"

namespace ashimpact {

namespace {

constexpr int most_classes = 80;   ///< of sizes
constexpr int parts_of_class = 9;  ///< what stays may change from all to nothing within a class
constexpr auto deposit_artifact = "deposit.json";
constexpr double normal_temperature = 273.15;  ///< of "Nm3" [K]

/// The load at the temperature of the gas: "10 g/m3", or at 0 C as plants state it, "35 g/Nm3" [kg/m3].
double read_load(const CommandOptions& options, double gas_temperature) {
    CommandOptions typed = options;
    std::string& text = typed.text_of("--ash-load");
    text = ascii_unit(text);
    const auto normal = text.find("Nm3");
    if (normal == std::string::npos) return typed.positive("--ash-load", Dimension::density);
    text.erase(normal, 1);
    return typed.positive("--ash-load", Dimension::density) * normal_temperature / gas_temperature;
}

TubeConditions read_tube(const CommandOptions& options) {
    TubeConditions tube{.diameter = options.positive("--tube-diameter", Dimension::length),
                        .velocity = options.positive("--gas-velocity", Dimension::velocity),
                        .temperature = options.positive("--gas-temperature", Dimension::temperature)};
    const Gas air = air_at(tube.temperature);
    tube.density = air.density;
    tube.viscosity = air.viscosity;
    if (options.has("--gas-viscosity")) {
        tube.viscosity = options.positive("--gas-viscosity", Dimension::viscosity);
        tube.viscosity_given = true;
    }
    if (options.has("--ash-load")) tube.load = read_load(options, tube.temperature);
    return tube;
}

/// The classes of sizes, fine ones that cannot arrive as one. @param density of the particles [kg/m3]
std::vector<SizeClass> classes_on(const TubeConditions& tube, const ParticleSizes& sizes, double density) {
    return sizes.classes(most_classes, crossed_tube(tube).finest_arriving(density), parts_of_class);
}

/// The damping of every size. @throws InputError for a restitution that is reached by another one at each
Damping damping_of_all(const CommandOptions& options, ContactPair contact, double density,
                       const std::vector<SizeClass>& classes) {
    constexpr double same = 1e-9;  // relative
    const auto at = [&](const SizeClass& size) {
        contact.effective_radius = size.diameter() / 2;
        contact.mass = sphere_mass(contact.effective_radius, density);
        return read_damping_choice(options, contact).damping;
    };
    const Damping damping = at(classes.front());
    if (std::abs(at(classes.back()).coefficient - damping.coefficient) > same * damping.coefficient)
        throw InputError("needs another damping at each size, and a tube meets many",
                         "one of --sizes, --damping, or --damping-law tsuji")
            .at("--damping-restitution");
    return damping;
}

/// What a result was computed from.
struct DepositSource {
    DepositingAsh ash{};
    std::vector<InputFile> inputs{};
    std::string run{};  ///< its identity; empty: none
    bool rests_on_edit = false;
    std::vector<Finding> notes{};
};

/// Notes where the law does not hold for the smallest and the largest sphere at the speed of the gas.
void note_regimes(DepositSource& source, const std::function<Impact(double diameter)>& impact_of,
                  double velocity, Severity least) {
    for (const SizeClass* size : {&source.ash.classes.front(), &source.ash.classes.back()}) {
        Impact impact = impact_of(size->diameter());
        impact.velocity = velocity;
        for (const Finding& finding : regime_of(impact, solve_impact(impact).maximum_overlap).warnings)
            if (finding.severity >= least)
                source.notes.push_back(
                    {finding.code, finding.severity, readable(size->diameter(), "m") + ": " + finding.text});
        if (source.ash.classes.size() == 1) break;
    }
}

/// Ash by the options of a contact: one law and its constants for every size.
DepositSource source_of_options(const CommandOptions& options, const TubeConditions& tube,
                                const ParticleSizes& sizes) {
    for (const char* option : {"--diameter", "--radius", "--mass"})
        if (options.has(option)) throw InputError("the sizes are those of --sizes", "--density").at(option);
    for (const char* option :
         {"--partner-radius", "--partner-diameter", "--partner-density", "--partner-mass"})
        if (options.has(option)) throw InputError("the partner is the tube", "no second sphere").at(option);
    refuse_size_dependent(options, "goes with the size, and a tube meets many");
    if (options.has("--assumption"))
        throw InputError("belongs to a run", "--damping-law, the law for every size").at("--assumption");
    CommandOptions typed = options;
    typed.text_of("--diameter") = "10 um";  // any: the constants are the same for every size
    const ContactChoice choice = read_contact(typed);
    const double density = sphere_density(choice.sphere.radius, choice.sphere.mass);
    std::vector<SizeClass> classes = classes_on(tube, sizes, density);
    const Damping damping = damping_of_all(options, choice.contact, density, classes);
    const bool damped = is_damped(damping, choice.contact.parameters);
    ClassVelocities velocities{.basis =
                                   damped ? named<SizeBasis>(name_of(damping.law)) : SizeBasis::adhesion};
    const auto impact_of = [&](double diameter) {
        ContactPair contact = choice.contact;
        contact.effective_radius = diameter / 2;
        contact.mass = sphere_mass(contact.effective_radius, density);
        return Impact{choice.law, choice.detachment, damping, contact, tube.velocity};
    };
    velocities.value = in_parallel(classes, [&](const SizeClass& size) {
        const Impact impact = impact_of(size.diameter());
        const CriticalVelocity critical =
            quick_critical_velocity({impact.law, impact.detachment, impact.damping, impact.contact});
        if (critical.verdict == CaptureVerdict::never_captured) return 0.0;
        return critical.value.value_or(std::numeric_limits<double>::infinity());
    });
    velocities.lower = velocities.upper = velocities.value;
    for (const double value : velocities.value) velocities.outside.push_back(is_outside_model(value));
    ReboundingSizes rebounding{.diameters = {}, .critical = velocities.value, .fastest = tube.velocity};
    for (const SizeClass& size : classes) rebounding.diameters.push_back(size.diameter());
    std::vector<double> densities(classes.size(), density);
    DepositSource source{.ash = {.law = choice.law,
                                 .classes = std::move(classes),
                                 .densities = std::move(densities),
                                 .assumptions = {std::move(velocities)},
                                 .restitutions = restitutions_by_law(rebounding, impact_of)}};
    note_regimes(source, impact_of, tube.velocity, Severity::background);
    return source;
}

/// One constant damping for sizes that differ, without the user stating that each has it.
std::optional<Finding> doubt_of_damping(const CommandOptions& options, const DepositingAsh& ash) {
    constexpr double similar_sizes = 1.1;
    const double least = ash.classes.front().diameter();
    const double greatest = ash.classes.back().diameter();
    if (!options.has("--damping") || options.has("--damping-law") || greatest < similar_sizes * least)
        return std::nullopt;
    return Finding{"damping-over-sizes", Severity::doubt,
                   fmt::format("one coefficient in kg/s for sizes of {} to {}: with it v_c of small spheres "
                               "grows without bound; --damping-law constant states that it is meant",
                               readable(least, "m"), readable(greatest, "m"))};
}

DepositSource source_of_run(const CommandOptions& options, const TubeConditions& tube,
                            const ParticleSizes& sizes) {
    refuse_contact_options(options);
    for (const auto* name : {"--law", "--at"})
        if (options.has(name))
            throw InputError("the run has it", "a run, or the options of an impact").at(name);
    const std::filesystem::path folder(options["run"]);
    const std::vector<std::string_view> files{case_artifact, contact_artifact, restitution_artifact,
                                              comparison_artifact};
    const Artifacts artifacts = load_artifacts(folder, files);
    DepositSource source;
    for (const std::string_view file : files) {
        const Artifact& artifact = artifacts.at(file);
        source.inputs.push_back({artifact.place, sha256(artifact.bytes)});
        const Json& provenance = artifact.document->at("provenance");
        source.rests_on_edit |= artifact.edited || provenance.value("edited", false);
    }
    source.run = run_of(*artifacts.at(comparison_artifact).document);
    std::optional<SizeBasis> basis;
    if (options.has("--assumption")) {
        basis = at_place("--assumption", [&] { return named<SizeBasis>(options["--assumption"]); });
        if (*basis == SizeBasis::measured)
            throw InputError("holds within the measured sizes alone", "what v_c follows from elsewhere")
                .at("--assumption");
    }
    const Run run = read_run(artifacts);
    if (run.data.partner)
        throw InputError("the impacts are those of two spheres, and a tube is a wall", "a run with a wall")
            .at(FileName{artifacts.at(case_artifact).place});
    double densest = 0;
    for (const SampleContact& sample : run.contact.samples)
        densest = std::max(densest, sample.density.value());
    source.ash = at_place(FileName{artifacts.at(comparison_artifact).place}, [&] {
        return ash_of_run(run, classes_on(tube, sizes, densest), basis, tube.velocity);
    });
    if (auto note = temperature_finding(run, source.ash.law, tube.temperature))
        source.notes.push_back(*std::move(note));
    if (auto note = kept_properties_finding(run.contact)) source.notes.push_back(*std::move(note));
    // The run has said which of its laws suits the contacts, not what the speed of this gas does.
    if (const auto impact_of = assumed_impacts(run, source.ash.assumptions.front().basis))
        note_regimes(source, impact_of, tube.velocity, Severity::remark);
    for (std::size_t i = 0; i < run.comparison.samples.size(); ++i) {
        const SampleComparison& sample = run.comparison.samples[i];
        const LawComparison* of = sample.laws.find(source.ash.law);
        if (of == nullptr) continue;
        std::string words;
        if (of->check && of->check->contradicts())
            words = fmt::format("is {} for the one measured there", verdict_words(of->check));
        for (const RestitutionSeries& series : run.restitution.samples.at(i).series)
            if (words.empty() && of->velocity && series.origin == Origin::measured)
                words = contradiction_of(series.impacts, of->velocity->value);
        if (!words.empty())
            source.notes.push_back({"contradicts-outcomes", Severity::doubt,
                                    fmt::format("v_c of {} in the run {}", in_quotes(sample.name), words)});
    }
    for (const std::string& shared : shared_sizes(run.comparison))
        source.notes.push_back({"shared-size", Severity::doubt, shared});
    return source;
}

/// The options that were given, for the provenance.
Json options_json(const CommandOptions& options) {
    Json json = Json::object();
    std::vector<std::string> names{"--tube-diameter",
                                   "--gas-velocity",
                                   "--gas-temperature",
                                   "--gas-viscosity",
                                   "--sizes",
                                   "--sheet",
                                   "--decimal",
                                   "--ash-load",
                                   "--assumption",
                                   "--law",
                                   "--detachment",
                                   "--density",
                                   "--contact-modulus",
                                   "--yield-pressure",
                                   "--work-of-adhesion",
                                   "--damping-law",
                                   "--damping",
                                   "--damping-restitution",
                                   "--at"};
    for (const LawParameter& parameter : law_parameters()) names.push_back(option_of(parameter));
    const bool by_law = !options.has("run");
    for (const std::string& name : names) {
        if (options.has(name))
            json[name.substr(2)] = options[name];
        else if (by_law && name == "--damping-law")
            json[name.substr(2)] = name_of(DampingLaw::constant);
    }
    if (!by_law) json["run"] = options["run"];
    return json;
}
}  // namespace

Deposition write_deposition(const CommandOptions& options, const TableOptions& table) {
    if (!options.has("run") && !options.has("--law"))
        throw InputError("neither a run nor a contact is given",
                         "RUN_DIR; or --law, --density and the other options of an impact")
            .at("deposit");
    TubeConditions tube = read_tube(options);
    std::vector<Finding> doubts = options.doubts();
    if (ascii_unit(options["--ash-load"]).find("Nm3") !=
        std::string::npos)  // a unit that no other quantity has
        if (auto doubt = implausible_at("--ash-load", *plausible_range("ash_load"), {*tube.load})) {
            warn_of({*doubt});
            doubts.push_back(*std::move(doubt));
        }
    const std::filesystem::path folder(options["--output"]);
    require_writable_folder(folder);
    require_replaceable(folder / deposit_artifact, R"({"schema": "deposit"})");
    SizesChoice sizes = read_sizes(options["--sizes"], table);
    warn_of(sizes.notes, sizes.file ? sizes.file->file : "--sizes");
    if (sizes.file) print_reading(sizes.file->file, sizes.reading);
    tube.sizes = sizes.words;
    DepositSource source;
    if (options.has("run"))
        source = source_of_run(options, tube, sizes.sizes);
    else
        source = source_of_options(options, tube, sizes.sizes);
    if (auto doubt = doubt_of_damping(options, source.ash)) {
        warn_of({*doubt}, "--damping");
        doubts.push_back(*std::move(doubt));
    }
    if (sizes.file) source.inputs.push_back(*sizes.file);

    StageRecord record{.stage = "deposition", .file = deposit_artifact};
    record.note(doubts, "");
    record.note(sizes.notes, "");
    const std::size_t printed = record.notes.size();
    record.note(source.notes, "");
    source.ash.parts = source.ash.classes.size() == 1 ? 1 : parts_of_class;
    Deposition deposition{.result = deposition_on(tube, source.ash, record), .files = {}};
    const DepositionResult& result = deposition.result;
    const Artifact artifact = sealed_artifact({.record = record,
                                               .inputs = source.inputs,
                                               .options = options_json(options),
                                               .rests_on_edit = source.rests_on_edit},
                                              to_json(result, DampingLaw::constant), source.run);
    std::vector<FileContent> files{
        {folder / deposit_artifact, artifact.bytes},
        {folder / "deposit.html", report::deposition_page(result, *artifact.document)}};
    for (const report::Figure& figure : report::deposition_figures(result))
        files.push_back({folder / ("deposit-" + figure.id + ".csv"), report::csv_of(figure.numbers)});
    write_files(files);
    for (std::size_t i = printed; i < record.notes.size(); ++i)
        spdlog::warn("warning: {}", record.notes[i].text);
    for (const FileContent& file : files) deposition.files.push_back(file.path);
    return deposition;
}

}  // namespace ashimpact
