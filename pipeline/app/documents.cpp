// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/embedded.hpp"
#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/sweep/spec/impacts.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/document/run_folder.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/page.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view example = "cases/example/";

std::string schema_of_artifact(const Json& document) {
    const auto names = schema_names();
    if (document.is_object() && document.contains("schema") && document["schema"].is_string())
        for (const std::string& name : names)
            if (document["schema"] == name && name != "case" && name != "published" && name != "literature")
                return name;
    throw InputError("this is not an artifact of ashimpact",
                     "a file of a run's folder, such as comparison.json")
        .at("/schema");
}

/// Whether a member that stands beside a number, or a list of numbers, is what a reader expects of it.
void require_beside_number(const std::string& key, const View& member) {
    if (key == "unit" || key == "origin") {
        if (!member.json().is_string()) member.fail("is " + member.json().dump(), "a string");
    } else if (key == "standard_uncertainty" && !member.json().is_number()) {
        member.fail("is " + member.json().dump(), "a number");
    }
}

/// Refuses a quantity without a readable unit also where the schemas leave open what stands there.
void require_quantities(const View& node) {
    if (node.json().is_array())
        for (const View& element : node.elements()) require_quantities(element);
    if (!node.is_object()) return;
    const bool quantity =
        node.json().contains("unit") && (node.json().contains("value") || node.json().contains("values"));
    for (const auto& [key, member] : node.members()) {
        if (quantity) require_beside_number(key, member);
        require_quantities(member);
    }
}

std::string property_text(const PhaseProperty& property, std::string_view unit) {
    const auto number = [&](double value) {
        return unit == "1" ? readable_number(value) : readable(value, unit);
    };
    std::string text = readable(Quantity{
        .value = property.value, .unit = std::string(unit), .standard_uncertainty = property.uncertainty()});
    if (property.range)
        text += fmt::format(", {} to {}", number(property.range->first), number(property.range->second));
    if (property.assumed) text += ", assumed";
    if (!property.citations.empty()) text += " [" + joined(property.citations) + "]";
    return text;
}

std::string phase_text(const ResolvedPhase& resolved) {
    const Phase& phase = resolved.phase;
    TextList list;
    list.add("phase", phase.name + (phase.amorphous ? " (amorphous)" : ""));
    if (!phase.formula.empty()) list.add("formula", phase.formula);
    list.add("density", property_text(phase.density, "kg/m3"));
    list.add("Young's modulus", property_text(phase.young_modulus, "Pa"));
    if (phase.poisson_ratio) list.add("Poisson's ratio", property_text(*phase.poisson_ratio, "1"));
    std::vector<std::string> names = phase.synonyms;
    names.insert(names.end(), phase.bgmn.begin(), phase.bgmn.end());
    if (!names.empty()) list.add("other names", joined(names));
    std::string text = list.text(0);
    text += uncertainty_legend(text);
    for (const std::string& note : {phase.remark, resolved.note})
        if (!note.empty()) text += note + "\n";
    return text;
}

std::string set_text(const PhaseSet& set) {
    TextTable table({set.name, "formula", "density", "E", "nu"});
    for (const Phase& phase : set.phases)
        table.add({phase.name, phase.formula.empty() ? "-" : phase.formula,
                   readable(phase.density.value, "kg/m3"), readable(phase.young_modulus.value, "Pa"),
                   phase.poisson_ratio ? readable_number(phase.poisson_ratio->value) : "unknown"});
    return table.text();
}

/// Whether an artifact with a hash of its result was edited; older sweeps have none.
bool is_known_edited(const Json& document) {
    return document.at("provenance").contains("result_sha256") && is_edited(document);
}

void run_inspect_command(const CommandOptions& options, std::ostream& out) {
    const std::string& file = options["artifact"];
    const std::string bytes = read_file(file);
    at_place(FileName{file}, [&] {
        const Json document = parse_json(bytes);
        require_schema_version(document, true);
        validate_document(document, schema_of_artifact(document));
        require_quantities(View(document));
        if (is_known_edited(document)) spdlog::warn("warning: {}: {}", file, edited_words);
        out << artifact_text(document, {.all = options.has("--all")},
                             spdlog::should_log(spdlog::level::debug));
    });
}

void run_init_command(const CommandOptions& options, std::ostream& out) {
    const std::string& folder = options["folder"];
    std::vector<FileContent> files;
    for (const std::string_view path : embedded_files(example)) {
        const auto place = std::filesystem::path(folder) / path.substr(example.size());
        if (std::filesystem::exists(place))
            throw InputError("is there already", "a folder without a case").at(FileName{place.string()});
        files.push_back({place, std::string(embedded_file(path).value())});
    }
    write_files(files);
    for (const FileContent& file : files) out << file.path.string() << '\n';
    const auto typed = [&](const char* name) {
        return shell_word((std::filesystem::path(folder) / name).string());
    };
    out << "An example that runs as it is; your own numbers can replace it later:\n  " << program_word()
        << " run " << typed("case.json") << " -o " << typed("results") << '\n';
}

void run_schema_command(const CommandOptions& options, std::ostream& out) {
    const std::string& name = options["name"];
    if (!name.empty()) {
        out << write_json(name == "case" ? schema_with_comments(name) : schema_named(name));
        return;
    }
    for (const std::string& each : schema_names()) out << each << '\n';
}

void run_phases_command(const CommandOptions& options, std::ostream& out) {
    const std::string& name = options["name"];
    const PhaseCatalogue catalogue = built_in_phases();
    if (!name.empty()) {
        out << phase_text(catalogue.resolve_all({PlacedName{.name = name}}).front());
        return;
    }
    for (const PhaseSet& set : catalogue.sets()) out << set_text(set) << '\n';
    out << "One of them with its sources and other names, such as\n  " << program_word()
        << " phases mullite\n"
        << "Phases of your own: `modulus --phases FILE`, or \"phases\" in a case.\n";
}

void run_laws_command(const CommandOptions& options, std::ostream& out) {
    TextList contacts;
    TextList dampings;
    Json json{{"laws", Json::array()}, {"damping_laws", Json::array()}};
    for (std::size_t i = 0; i < Law::count(); ++i) {
        const Law law = Law::at(i);
        contacts.add(std::string(law.name()), std::string(law.summary()));
        Json parameters = Json::array();
        for (const LawParameter& parameter : law.parameters()) parameters.push_back(parameter.name);
        json["laws"].push_back({{"name", law.name()},
                                {"summary", law.summary()},
                                {"uses_work_of_adhesion", law.uses_work_of_adhesion()},
                                {"parameters", parameters},
                                {"default_detachment", name_of(law.default_detachment())},
                                {"page", law.page()}});
    }
    for (const DampingLaw law : all_values<DampingLaw>) {
        dampings.add(std::string(name_of(law)), std::string(summary_of(law)));
        json["damping_laws"].push_back(
            {{"name", name_of(law)}, {"summary", summary_of(law)}, {"unit", unit_of(law)}});
    }
    if (options.has("--json"))
        out << write_json(json);
    else
        out << "Contact laws (--law):\n"
            << contacts.text() << "\nDamping laws (--damping-law):\n"
            << dampings.text() << "\nEach contact law has a page, such as " << Law::at(0).page()
            << "; their options: " << program_word() << " help impact\n";
}

/// A run from its folder.
report::RunData loaded(const std::filesystem::path& folder, const std::string& label) {
    if (!std::filesystem::is_directory(folder))
        throw InputError("is no folder", "the folder of a run, or one result of a sweep")
            .at(FileName{folder.string()});
    return {read_run(load_artifacts(folder, report::report_artifacts())), label};
}

/// Where the artifacts of a figure are: in the folder of a run, single ones elsewhere.
struct FigureFiles {
    std::filesystem::path folder;
    std::map<std::string, std::filesystem::path, std::less<>> single;  ///< folder by file
};

/// Sorts the arguments. @throws InputError for what is neither the folder of a run nor an artifact of one
/// that the figure shows, and for what would count for nothing beside another argument
FigureFiles files_of(const std::vector<std::string>& given, const report::FigureMaker& figure) {
    FigureFiles files;
    const std::vector<std::string_view>& all = report::report_artifacts();
    std::string folder;
    for (const std::string& name : given) {
        const std::filesystem::path path(name);
        const std::string file = path.filename().string();
        std::error_code ignored;
        if (std::filesystem::is_directory(path, ignored)) {
            if (!folder.empty())
                throw InputError("is given beside the folder " + folder, "one run; report shows several")
                    .at(FileName{name});
            folder = name;
            continue;
        }
        if (std::ranges::find(all, file) == all.end())
            throw InputError(
                "is no artifact of a run",
                "the folder of a run, or " + joined(std::vector<std::string>(all.begin(), all.end())))
                .at(FileName{name});
        std::vector<std::string> shown{std::string(case_artifact)};
        shown.insert(shown.end(), figure.shows.begin(), figure.shows.end());
        if (std::ranges::find(shown, file) == shown.end())
            throw InputError("figure " + std::string(figure.id) + " shows nothing of it",
                             joined(shown) + ", or the folder of a run")
                .at(FileName{name});
        if (!files.single.try_emplace(file, path.parent_path()).second)
            throw InputError("another " + file + " is given too", "one of the two").at(FileName{name});
    }
    files.folder =
        folder.empty() ? std::filesystem::path(given.front()).parent_path() : std::filesystem::path(folder);
    return files;
}

/// The artifacts of one run for a figure: those that are given, completed from the folder.
Artifacts gathered(const std::vector<std::string>& given, const report::FigureMaker& figure) {
    const FigureFiles files = files_of(given, figure);
    complete_interrupted(files.folder);
    Artifacts artifacts;
    for (const std::string_view file : report::report_artifacts()) {
        const auto single = files.single.find(file);
        artifacts.add(loaded_artifact(single == files.single.end() ? files.folder : single->second, file));
        warn_of(artifacts.at(file).doubts, artifacts.at(file).place);
    }
    require_one_state(artifacts, figure.shows);
    return artifacts;
}

/// The result of a sweep, or none if the file is something else.
std::optional<Json> sweep_result(const std::string& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
    return at_place(FileName{file}, [&]() -> std::optional<Json> {
        Json document = parse_json(read_file(file));
        if (!document.is_object() || document.value("schema", Json()) != "sweep-result") return std::nullopt;
        validate_document(document, "sweep-result");
        if (is_known_edited(document)) {
            const std::string text = fmt::format("{}; its values count", edited_words);
            spdlog::warn("warning: {}: {}", file, text);
            document["warnings"].push_back("the result " + text);
        }
        return document;
    });
}

void run_report_command(const CommandOptions& options, std::ostream& out) {
    const std::vector<std::string>& folders = options.list("runs");
    const std::filesystem::path first(folders.front());
    std::filesystem::path output = options["--output"];
    if (const std::string ending = lower_case(output.extension().string());
        !std::filesystem::exists(output) && !ending.empty() && ending != ".html" && ending != ".htm")
        throw InputError("a report is an HTML file, not " + in_quotes(ending), "a name that ends in .html")
            .at("-o");
    const auto finish = [&](const std::filesystem::path& standard, const std::string& page) {
        if (output.empty()) output = standard;
        write_file(output, page);
        out << output.string() << '\n';
    };
    if (folders.size() == 1)
        if (const auto sweep = sweep_result(folders.front()))
            return finish(std::filesystem::path(first).replace_extension(".html"),
                          at_place(FileName{first.string()}, [&] {
                              return report::sweep_page(*sweep, capture_fractions(*sweep),
                                                        first.filename().string());
                          }));
    if (output.empty() && folders.size() > 1)
        throw InputError("is missing; several runs have no folder in common for their report", "-o FILE.html")
            .at("-o");
    std::vector<report::RunData> runs;
    for (const std::string& folder : folders)
        runs.push_back(loaded(folder, folders.size() > 1 ? folder : ""));
    finish(first / report::report_file, report::run_page(runs));
}

void run_figure_command(const CommandOptions& options, std::ostream& out) {
    const report::FigureFormat format = report::format_of(options["--output"]);
    const report::FigureMaker& maker = report::figure_maker_named(options["name"]);
    const report::RunData run(read_run(gathered(options.list("artifacts"), maker)), "");
    const report::Figure figure = maker.make(run);
    if (figure.panels.empty())
        throw InputError("has nothing to show in this run: " + figure.caption, "another figure")
            .at(options["name"]);
    const report::Width width = options["--width"] == "single" ? report::Width::narrow : report::Width::wide;
    write_file(options["--output"], report::figure_bytes(figure, width, format));
    out << options["--output"] << '\n';
}

}  // namespace

void add_report_commands(const CommandLine& line) {
    Command report = line.add("report", "The report of a run as one HTML file, or of several side by side",
                              "ashimpact report results\n"
                              "  ashimpact report sweep.json\n"
                              "  ashimpact report before after -o comparison.html",
                              run_report_command);
    report.add_list("runs", "DIR", "folders of finished runs, or the result of one sweep")->required();
    report.add("-o,--output", "FILE.html",
               "HTML file; default: report.html in the one folder, or the name of the result with .html");

    Command figure =
        line.add("figure", "One figure of a run for a paper: SVG, PDF or PNG",
                 "ashimpact figure restitution results -o restitution.pdf\n"
                 "Figures: composition, static-force, regime-map, restitution, damping, damping-fit, "
                 "contact-time, sizes, histories,\n"
                 "energy, critical-velocity, critical-velocity-by-size, sensitivity, oblique, temperature.",
                 run_figure_command);
    figure.add("name", "NAME", "of the figure")->required();
    figure
        .add_list("artifacts", "ARTIFACT",
                  "folder of a run, or artifacts of it; those not named are read beside the first")
        ->required();
    figure.add("-o,--output", "FILE", "file; its ending says the format: .svg, .pdf or .png")->required();
    figure.add("--width", "WIDTH", "column of a journal: single (85 mm), double (170 mm)", "double")
        ->check(CLI::IsMember({"single", "double"}));
}

void add_document_commands(const CommandLine& line) {
    Command inspect = line.add("inspect", "An artifact as tables; -v: inputs and options too",
                               "ashimpact inspect results/comparison.json", run_inspect_command);
    inspect.add("artifact", "ARTIFACT.json", "file of a run's folder")->required();
    inspect.add_flag("--all", "every row and every part, nothing shortened");

    Command init =
        line.add("init", "Write a commented case to start from", "ashimpact init my-case", run_init_command);
    init.add("folder", "DIR", "where to write it")->required();

    Command phases = line.add("phases", "The phase catalogue, or one phase with its sources",
                              "ashimpact phases mullite", run_phases_command);
    phases.add("name", "NAME", "of a phase, under any of its names; without it, all phases");

    line.add("laws", "The contact and damping laws, one line each", "ashimpact laws", run_laws_command)
        .add_json_flag();

    Command schema = line.add("schema", "The JSON Schema of a case or an artifact", "ashimpact schema case",
                              run_schema_command);
    schema.add("name", "NAME", "of the schema; without it, the names");
}

}  // namespace ashimpact
