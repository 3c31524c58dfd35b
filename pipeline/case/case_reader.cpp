// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/case_reader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/checks.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/case/case_parts.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/maugis_dugdale.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

namespace {

/// Values of the case for samples that do not state their own.
struct Defaults {
    std::optional<View> particle{};
    std::optional<Adhesion> work_of_adhesion{};
    std::optional<PublishedSample> published{};
    std::optional<View> camera{};
    GlassDefaults glass{};
};

std::optional<Stated> read_optional(const std::optional<View>& node, std::string_view name,
                                    Dimension dimension) {
    if (!node) return std::nullopt;
    return read_positive(*node, name, dimension);
}

void add_findings(const std::vector<Finding>& found, const std::string& sample,
                  std::vector<SampleFinding>& findings) {
    for (const Finding& finding : found) findings.push_back({sample, finding});
}

/// Sets what a sample states of its particles, or else "particle" of the case.
void set_particle(const View& own, const std::optional<View>& otherwise, Sample& sample) {
    const auto stated = [&](std::string_view key) {
        const auto node = own.find(key);
        return node || !otherwise ? node : otherwise->find(key);
    };
    if (const auto nu = stated("poisson_ratio")) sample.poisson_ratio = read_poisson_ratio(*nu);
    sample.density = read_optional(stated("density"), "density", Dimension::density);
    sample.contact_modulus = read_optional(stated("contact_modulus"), "contact modulus", Dimension::pressure);
    sample.yield_pressure = read_optional(stated("yield_pressure"), "yield pressure", Dimension::pressure);
    for (const LawParameter& parameter : law_parameters()) {
        const auto node = stated(parameter.name);
        if (!node) continue;
        Stated value = read_stated(*node, parameter.dimension);
        at_place(node->pointer(), [&] { require_allowed(parameter, value.value()); });
        sample.parameters.emplace_back(parameter, std::move(value));
    }
}

Sample read_sample(const View& node, const Defaults& defaults, InputFiles& files,
                   std::vector<SampleFinding>& findings) {
    Sample sample{.name = node.at("name").text(), .diameter = {}};
    std::vector<Finding> notes;
    sample.diameter = read_diameter(node.at("diameter"), notes);
    add_findings(notes, sample.name, findings);
    auto analysis = read_analysis(node.at("composition"), sample.name, files);
    sample.glass = read_glass(node.at("composition"), defaults.glass, sample.name, files, analysis.warnings);
    add_findings(analysis.warnings, sample.name, findings);
    sample.analysis = std::move(analysis.analysis);
    sample.analysis_source = std::move(analysis.source);
    if (const auto porosity = node.find("porosity")) sample.porosity = read_porosity(*porosity);
    set_particle(node, defaults.particle, sample);
    if (const auto porosity = node.find("porosity"); porosity && !porosity->has("value")) {
        if (!sample.density) porosity->fail("the porosity has no value", "value, or density of the sample");
        sample.porosity_from_density = true;
    }
    sample.work_of_adhesion = defaults.work_of_adhesion;
    if (const auto w = node.find("work_of_adhesion")) sample.work_of_adhesion = read_adhesion(*w);
    sample.measured_critical_velocity =
        read_optional(node.find("measured_critical_velocity"), "critical velocity", Dimension::velocity);
    sample.published = defaults.published;
    if (const auto published = node.find("published"))
        sample.published = read_published(*published, "the case file", std::nullopt);
    if (const auto data = node.find("restitution"))
        sample.restitution = read_restitution(*data, sample.published, files, defaults.camera);
    if (const auto* measured =
            sample.restitution ? std::get_if<MeasuredRestitution>(&*sample.restitution) : nullptr) {
        add_findings(measured->impacts.warnings, sample.name, findings);
        if (const auto other = other_sample_finding(measured->impacts, sample.name))
            add_findings({*other}, sample.name, findings);
    }
    return sample;
}

/// Adds a finding for each sample whose measured impacts equal those of an earlier sample.
void add_shared_impacts(const std::vector<Sample>& samples, std::vector<SampleFinding>& findings) {
    std::map<std::vector<std::pair<double, double>>, std::string> first;
    for (const Sample& sample : samples) {
        const auto* measured =
            sample.restitution ? std::get_if<MeasuredRestitution>(&*sample.restitution) : nullptr;
        if (measured == nullptr) continue;
        std::vector<std::pair<double, double>> impacts;
        for (const Measurement& point : measured->impacts.sorted())
            impacts.emplace_back(point.velocity, point.rebound);
        const auto [other, is_new] = first.try_emplace(std::move(impacts), sample.name);
        if (!is_new)
            findings.push_back({sample.name,
                                {"shared-impacts", Severity::doubt,
                                 fmt::format("has the same impacts as sample {} ({}): they count as measured "
                                             "of both",
                                             in_quotes(other->second), measured->source)}});
    }
}

/// The published values that a case refers to, by sample.
std::map<std::string, PublishedSample> read_published_set(const View& document, InputFiles& files,
                                                          std::vector<SampleFinding>& findings) {
    std::map<std::string, PublishedSample> samples;
    const auto name = document.find("published");
    if (!name) return samples;
    at_place(name->pointer(), [&] {
        const std::string built_in = "published/" + name->text() + ".json";
        const bool carried = embedded_file(built_in).has_value();
        at_place(FileName{carried ? built_in : files.shown(name->text())}, [&] {
            const Json json = parse_json(carried ? files.read_built_in(built_in) : files.read(name->text()));
            if (!carried) validate_document(json, "published");  // a test makes sure of ours
            const View set(json);
            add_findings(implausible_values(json.at("samples"), "/samples"), {}, findings);
            for (const auto& [sample, values] : set.at("samples").members())
                samples.emplace(sample,
                                read_published(values, set.at("source").text(), set.find("rounding")));
        });
    });
    return samples;
}

/// Adds the usual range of cohesion to a sample that states none, so that maugis-dugdale can be computed.
void assume_cohesion(Sample& sample) {
    const auto is_stated = [&](const LawParameter& parameter) {
        return std::ranges::any_of(sample.parameters,
                                   [&](const auto& given) { return given.first.name == parameter.name; });
    };
    if (is_stated(stated_tabor) || is_stated(cohesive_stress) || is_stated(cohesion_range)) return;
    sample.parameters.emplace_back(
        cohesion_range, Stated{make_quantity(usual_separation, Dimension::length), Origin::assumed,
                               "equilibrium separation of oxide surfaces, of the order of interatomic "
                               "distances"});
    const auto place = [](const auto& given) {  // in the order in which a case is read
        return std::ranges::find(law_parameters(), given.first.name, &LawParameter::name);
    };
    std::ranges::sort(sample.parameters, {}, place);
}

/// The laws of a case; those of one that names none, with what they need.
std::vector<LawChoice> read_case_laws(const View& document, std::vector<Sample>& samples) {
    const auto elastic =
        std::ranges::find_if(samples, [](const Sample& sample) { return !sample.yield_pressure; });
    std::vector<Law> laws;
    if (const auto names = document.find("laws")) {
        for (const View& name : names->elements()) {
            laws.push_back(Law::named(name.text()));
            if (laws.back().is_plastic() && elastic != samples.end())
                name.fail("law " + name.text() + " needs a yield_pressure, which sample " +
                              in_quotes(elastic->name) + " does not state",
                          "a yield_pressure for each sample, or the laws without " + name.text());
        }
    } else {
        laws = default_laws();
        if (elastic == samples.end()) laws.push_back(Law::named("thornton-ning"));
        for (Sample& sample : samples) assume_cohesion(sample);
    }
    std::ranges::sort(laws, {}, &Law::index);  // so that no choice depends on their order
    std::vector<LawChoice> choices;
    choices.reserve(laws.size());
    for (const Law law : laws) choices.push_back({law, law.default_detachment()});
    read_detachments(document.find("detachments"), choices, "a law of the case");
    return choices;
}

PhaseCatalogue catalogue_of(const View& document, const PhaseCatalogue& built_in) {
    PhaseCatalogue catalogue = built_in;
    if (const auto set = document.find("phase_set"))
        catalogue = at_place(set->pointer(), [&] { return catalogue.preferring(set->text()); });
    if (const auto own = document.find("phases")) catalogue = catalogue.overridden_by(read_user_phases(*own));
    return catalogue;
}

/// Lets a phase be found by @p name: the artifact has no other phase sets and no groups, which resolved it.
void add_synonym_if_needed(Phase& phase, const std::string& name) {
    if (phase.name == name) return;
    const PhaseCatalogue alone({PhaseSet{.name = "case", .phases = {phase}}});
    try {
        static_cast<void>(alone.resolve(name));
    } catch (const InputError&) {
        phase.synonyms.push_back(name);
    }
}

constexpr auto how_to_state =
    "\"amorphous\" beside the fractions: \"47 %\" of the whole, \"none\", \"remainder\" (what is missing to "
    "100 %), {\"crystalline_total\": \"53 %\"}; or \"internal_standard\"";

/// Every phase the samples need, once. @throws InputError where a composition is impossible
std::vector<Phase> phases_of(const std::vector<Sample>& samples, const View& document,
                             const PhaseCatalogue& catalogue, std::vector<SampleFinding>& findings) {
    std::vector<Phase> phases;
    std::map<std::string, std::string> notes;  // by the names of components
    const auto nodes = document.at("samples").elements();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const View place = nodes[i].at("composition");
        const Composition composition = at_place(place.pointer(), [&] {
            return compose_with_glass(samples[i].analysis, catalogue, samples[i].glass, how_to_state)
                .composition;
        });
        for (const Component& component : composition.components) {
            const auto [noted, is_new] = notes.try_emplace(component.name);
            const std::optional<ResolvedPhase> resolved =
                is_new ? std::optional(catalogue.resolve(component.name)) : std::nullopt;
            if (resolved) noted->second = resolved->note;
            if (!noted->second.empty())
                findings.push_back({samples[i].name, {"phase", Severity::remark, noted->second}});
            if (!resolved) continue;
            const Phase& phase = resolved->phase;
            auto known = std::find_if(phases.begin(), phases.end(),
                                      [&name = phase.name](const Phase& p) { return p.name == name; });
            if (known == phases.end()) known = phases.insert(phases.end(), phase);
            add_synonym_if_needed(*known, component.name);
        }
    }
    return phases;
}

std::vector<FreeConstant> read_calibration(const View& document) {
    std::vector<FreeConstant> free;
    const auto calibration = document.find("calibration");
    if (!calibration) return free;
    for (const View& entry : calibration->at("free").elements()) {
        free.push_back({named<CalibrationQuantity>(entry.at("quantity").text()),
                        entry.has("per_sample") && entry.at("per_sample").truth()});
    }
    return free;
}

HistoryOptions read_histories(const View& document) {
    HistoryOptions options;
    const auto node = document.find("histories");
    if (!node) return options;
    if (const auto points = node->find("points")) options.points = points->integer();
    if (const auto excess = node->find("critical_excess"))
        options.critical_excess = excess->number(Dimension::fraction);
    return options;
}

void check_parameters(Law law, DampingLaw damping, const Sample& sample, const View& node) {
    const auto fault = parameter_fault(parameters_of(law, damping), [&](const LawParameter& parameter) {
        return std::any_of(sample.parameters.begin(), sample.parameters.end(),
                           [&](const auto& given) { return given.first.name == parameter.name; });
    });
    if (fault)
        node.fail(fault->problem() + ", here and in \"particle\", for law " + in_quotes(law.name()),
                  fault->allowed());
}

/// Refuses the surface energy of a second sphere beside a wall. @param node the case or a sample
void require_other_body(const Case& data, const View& node) {
    const auto adhesion = node.find("work_of_adhesion");
    if (data.partner || !adhesion || !adhesion->is_object() || !adhesion->has("surface_energies")) return;
    if (const auto stray = adhesion->at("surface_energies").find("partner"))
        stray->fail("the other body is a wall", "\"wall\", or \"partner\" of the case: a second sphere");
}

/// Checks that concern the case as a whole. @throws InputError
void check_whole(const Case& data, const View& document) {
    std::set<std::string> names;
    const auto nodes = document.at("samples").elements();
    for (std::size_t i = 0; i < data.samples.size(); ++i) {
        const Sample& sample = data.samples[i];
        if (!names.insert(sample.name).second)
            nodes[i].at("name").fail("two samples have this name", "another name");
        if (!data.wall && !sample.contact_modulus)
            nodes[i].fail(data.partner ? "neither the partner's elasticity nor a contact modulus is given"
                                       : "neither a wall nor a contact modulus is given",
                          data.partner
                              ? "young_modulus and poisson_ratio of \"partner\", or contact_modulus here"
                              : "\"wall\" or \"partner\" of the case, or contact_modulus here");
        const bool adhesive = std::any_of(data.laws.begin(), data.laws.end(), [](const LawChoice& choice) {
            return choice.law.uses_work_of_adhesion();
        });
        if (adhesive && !sample.work_of_adhesion)
            nodes[i].fail("\"work_of_adhesion\" is missing, here and in the case",
                          "an energy per area, such as \"0.3 J/m2\"");
        for (const LawChoice& choice : data.laws)
            check_parameters(choice.law, data.damping_law, sample, nodes[i]);
        require_other_body(data, nodes[i]);
    }
    require_other_body(data, document);
}

/// The wall, or the second sphere in its place.
void read_other_body(const View& document, Case& data) {
    const auto wall = document.find("wall");
    const auto partner = document.find("partner");
    if (wall && partner) partner->fail("a wall and a second sphere are both given", "one of the two");
    if (wall) data.wall = read_wall(*wall);
    if (!partner) return;
    data.partner = read_partner(*partner);
    const auto elasticity = {"young_modulus", "poisson_ratio", "rigid", "contact_modulus"};
    if (std::ranges::any_of(elasticity, [&](const char* key) { return partner->has(key); }))
        data.wall = read_wall(*partner);
}

/// The doubt about the density that follows from the mass of a second sphere.
std::optional<Finding> doubt_about_mass(const std::optional<PartnerSphere>& partner) {
    if (!partner || !partner->mass) return std::nullopt;
    auto doubt = implausible_mass(partner->diameter.value() / 2, partner->mass->value());
    if (doubt) doubt->text.insert(0, "/partner/mass: ");
    return doubt;
}

Case read_case_with(const View& document, const PhaseCatalogue& built_in, InputFiles& files,
                    std::vector<SampleFinding>& findings) {
    Case data{.name = document.at("name").text()};
    const PhaseCatalogue catalogue = catalogue_of(document, built_in);
    const auto published = read_published_set(document, files, findings);
    if (const auto rule = document.find("mixture_rule")) data.mixture_rule = named<MixtureRule>(rule->text());
    read_other_body(document, data);
    if (const auto doubt = doubt_about_mass(data.partner)) findings.push_back({{}, *doubt});
    if (const auto roughness = document.find("roughness")) {
        data.roughness = read_stated(*roughness, Dimension::length);
        at_place(roughness->pointer(),
                 [&] { require_not_negative("rms roughness", data.roughness->value(), Dimension::length); });
    }
    if (const auto friction = document.find("friction")) {
        static_cast<void>(friction->certain_number(Dimension::fraction, "the coefficient alone"));
        data.friction = read_stated(*friction, Dimension::fraction);
        at_place(friction->pointer(),
                 [&] { require_not_negative("friction", data.friction->value(), Dimension::fraction); });
    }
    if (const auto temperature = document.find("temperature"))
        data.temperature = read_temperatures(*temperature);
    Defaults defaults{.particle = document.find("particle"),
                      .camera = document.find("camera"),
                      .glass = {document.find("oxides"), document.find("glass"),
                                document.at("samples").elements().size() > 1}};
    if (defaults.particle) {  // checked even if every sample has values of its own
        Sample unused{.name = {}, .diameter = {}};
        set_particle(*defaults.particle, std::nullopt, unused);
    }
    if (const auto w = document.find("work_of_adhesion")) defaults.work_of_adhesion = read_adhesion(*w);
    if (defaults.camera)
        static_cast<void>(read_camera(*defaults.camera));  // checked even if no sample uses it
    for (const View& node : document.at("samples").elements()) {
        const auto of_sample = published.find(node.at("name").text());
        defaults.published = of_sample == published.end() ? std::nullopt : std::optional(of_sample->second);
        data.samples.push_back(read_sample(node, defaults, files, findings));
    }
    add_shared_impacts(data.samples, findings);
    data.laws = read_case_laws(document, data.samples);
    const bool has_tabor = std::ranges::any_of(data.samples, [](const Sample& sample) {
        return std::ranges::any_of(sample.parameters,
                                   [](const auto& given) { return given.first.name == stated_tabor.name; });
    });
    if (data.roughness && data.roughness->value() > 0 && has_tabor &&
        std::ranges::any_of(data.laws, [](const LawChoice& each) { return each.law.takes(stated_tabor); }))
        document.at("roughness")
            .fail("a sample states its tabor: that of the smooth surfaces or of the rough ones",
                  "cohesion_range or cohesive_stress in place of tabor, or no roughness");
    if (const auto law = document.find("damping_law")) data.damping_law = named<DampingLaw>(law->text());
    if (const auto scheme = document.find("paper_explicit")) {
        const View step = scheme->at("time_step");
        data.paper_time_step = read_positive(step, "time step", Dimension::time).value();
        static_cast<void>(step.certain_number(Dimension::time, "the time step alone"));
    }
    data.histories = read_histories(document);
    data.fit = read_fit_options(document.find("fit"));
    data.uncertainty = read_uncertainty_choices(document.find("uncertainty"));
    data.calibration = read_calibration(document);
    data.phases = phases_of(data.samples, document, catalogue, findings);
    check_whole(data, document);
    return data;
}

/// Adds the doubts about the quantities that a case states.
void add_implausible(const Json& document, std::vector<SampleFinding>& findings) {
    Json whole = document;
    whole.erase("samples");
    add_findings(implausible_values(whole), {}, findings);
    const Json& samples = document.at("samples");
    for (std::size_t i = 0; i < samples.size(); ++i)
        add_findings(implausible_values(samples[i], child_pointer("/samples", i)), samples[i].at("name"),
                     findings);
}

constexpr std::string_view example_folder = "cases/example/";
constexpr std::string_view first_words = "A case of ashimpact. ";  // of the example's comments

Json example_case() {
    return parse_json(embedded_file(std::string(example_folder) + "case.json").value());
}

bool same_member(const Json& ours, const Json& theirs, const std::string& key) {
    return ours.contains(key) && theirs.contains(key) && ours.at(key) == theirs.at(key);
}

/// Adds what a sample shares with the one of the example in its place, other than names.
void add_sample(const Json& ours, const Json& theirs, const std::string& place,
                std::vector<std::string>& remains) {
    for (const auto& [key, value] : ours.items()) {
        if (key == "name") continue;
        if (key == "composition" && value.is_object()) {
            for (const char* part : {"amorphous", "weight_fractions"})
                if (theirs.contains(key) && same_member(value, theirs.at(key), part))
                    remains.push_back(fmt::format("{}/{}/{}", place, key, part));
        } else if (key == "restitution" && value.is_object() && value.contains("file")) {
            continue;  // the file was replaced, or the whole case is the example
        } else if (same_member(ours, theirs, key)) {
            remains.push_back(fmt::format("{}/{}", place, key));
        }
    }
}

/// The files beside the example's case that a case reads unchanged.
std::vector<std::string> same_files(const std::vector<InputFile>& inputs) {
    std::vector<std::string> names;
    for (const InputFile& input : inputs) {
        const std::string name = std::filesystem::path(input.file).filename().string();
        const auto bytes = embedded_file(std::string(example_folder) + name);
        if (bytes && name != "case.json" && input.sha256 == sha256(*bytes)) names.push_back(name);
    }
    return names;
}

/// JSON pointers of what a case that began as the one of `ashimpact init` still has of it: the wall, the
/// camera and the particles of an invented laboratory. Empty for any other case, and for the example itself,
/// whose numbers are all invented. A case began as the example if it has its first comment or its camera.
/// @param text the file of the case, with comments
/// @param inputs the files that the case was read from
std::vector<std::string> example_remains(const Json& ours, std::string_view text,
                                         const std::vector<InputFile>& inputs) {
    const Json theirs = example_case();
    const bool began_as_example =
        text.find(first_words) != std::string_view::npos || same_member(ours, theirs, "camera");
    if (!began_as_example) return {};
    std::vector<std::string> remains = same_files(inputs);
    if (ours == theirs && remains.size() == 2) return {};
    for (const char* key : {"name", "wall", "work_of_adhesion", "camera"})
        if (same_member(ours, theirs, key)) remains.push_back(std::string("/") + key);
    const Json& samples = theirs.at("samples");
    const std::size_t count = std::min(ours.at("samples").size(), samples.size());
    for (std::size_t i = 0; i < count; ++i)
        add_sample(ours.at("samples")[i], samples[i], "/samples/" + std::to_string(i), remains);
    return remains;
}

/// Refuses a table in the place of a case, with what to do with it. @throws InputError
void refuse_table(std::string_view bytes, const std::string& name) {
    const auto is_read = [](auto&& read) {
        try {
            static_cast<void>(read());
            return true;
        } catch (const InputError&) {
            return false;
        }
    };
    const std::string file = std::filesystem::path(name).filename().string();
    const std::string ending = lower_case(std::filesystem::path(file).extension().string());
    if (trimmed(bytes).starts_with('{') || trimmed(bytes).starts_with('/')) return;
    const bool impacts = is_read([&] { return read_measurements(bytes, name); });
    const bool xrd = !impacts && is_read([&] { return read_xrd(bytes, name); });
    if (!impacts && !xrd && !is_workbook(bytes) && ending != ".csv" && ending != ".tsv") return;
    const std::string restitution = "\"restitution\": {\"file\": " + in_quotes(file) + "}";
    const std::string composition = "\"composition\": {\"xrd\": " + in_quotes(file) + "}";
    throw InputError(std::string("this is a table") +
                         (impacts ? " of impacts"
                          : xrd   ? " of XRD results"
                                  : "") +
                         ", not a case",
                     "a case with " +
                         (impacts ? restitution
                          : xrd   ? composition
                                  : composition + " or " + restitution) +
                         " in a sample; `ashimpact init DIR` writes one to start from");
}

}  // namespace

std::vector<Law> default_laws() {
    return {Law::named("hertz"), Law::named("dmt"), Law::named("brach-dunn"), Law::named("jkr"),
            Law::named("maugis-dugdale")};
}

PhaseCatalogue built_in_phases() {
    std::vector<PhaseSet> sets;
    for (const char* name : {"literature", "dong2013"}) {
        const auto text = embedded_file("phases/" + std::string(name) + ".json");
        if (!text) throw std::logic_error("a phase set is missing");
        sets.push_back(read_phase_set(*text));
    }
    return PhaseCatalogue(std::move(sets));
}

Case read_case(const View& document, const PhaseCatalogue& catalogue, InputFiles& files) {
    std::vector<SampleFinding> findings;
    return read_case_with(document, catalogue, files, findings);
}

LoadedCase load_case(const std::optional<std::string>& file, bool allow_outside) {
    InputFiles files = file ? InputFiles::beside(*file) : InputFiles::built_in(built_in_case);
    if (allow_outside) files.allow_outside();
    const std::string text = files.read_case();
    return at_place(FileName{files.case_name()}, [&] {
        refuse_table(text, files.case_name());
        const Json document = parse_json(text);
        require_schema_version(document, false);
        validate_document(document, "case");
        LoadedCase loaded;
        add_implausible(document, loaded.findings);
        loaded.data = read_case_with(View(document), built_in_phases(), files, loaded.findings);
        for (SampleFinding& unused : unused_statements(View(document), loaded.data))
            loaded.findings.push_back(std::move(unused));
        loaded.inputs = files.used();
        if (const auto remains = example_remains(document, text, loaded.inputs); !remains.empty())
            loaded.findings.push_back(
                {{},
                 {"example-remains", Severity::doubt,
                  "still of the example of `ashimpact init`, whose numbers are invented (" + joined(remains) +
                      "), to be replaced or deleted"}});
        return loaded;
    });
}

}  // namespace ashimpact
