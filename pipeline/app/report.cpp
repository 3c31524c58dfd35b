// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/report.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/command.hpp"
#include "pipeline/app/sweep/spec/capture_fraction.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/document/run_json.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"

namespace ashimpact {

namespace {

struct ReportOptions {
    std::vector<std::string> runs;  ///< folders of artifacts
    std::string output;             ///< HTML file; empty: report.html in the one folder
};

struct FigureOptions {
    std::string name;                    ///< id of the figure
    std::vector<std::string> artifacts;  ///< files of one run, or its folder
    std::string output;                  ///< .svg, .pdf or .png
    std::string width = "double";        ///< column: "double" or "single"
};

/// A run from its folder.
report::RunData loaded(const std::filesystem::path& folder, const std::string& label) {
    if (!std::filesystem::is_directory(folder))
        throw InputError("is no folder", "the folder of a run, or one result of a sweep")
            .at(FileName{folder.string()});
    return {read_run(load_artifacts(folder, report::report_artifacts())), label};
}

/// Refuses what is neither the folder of a run nor one of its artifacts.
void require_known(const std::vector<std::string>& given) {
    const auto& files = report::report_artifacts();
    for (const std::string& name : given) {
        std::error_code ignored;
        if (std::filesystem::is_directory(name, ignored)) continue;
        if (std::find(files.begin(), files.end(), std::filesystem::path(name).filename().string()) !=
            files.end())
            continue;
        const std::vector<std::string> allowed(files.begin(), files.end());
        throw InputError("is no artifact of a run", "the folder of a run, or " + joined(allowed))
            .at(FileName{name});
    }
}

/// The artifacts of one run from files of it, completed from the folder of the first; a folder stands for its
/// files.
Artifacts gathered(const std::vector<std::string>& given) {
    require_known(given);
    const std::filesystem::path first(given.front());
    const auto folder = std::filesystem::is_directory(first) ? first : first.parent_path();
    Artifacts artifacts;
    for (const std::string_view file : report::report_artifacts()) {
        auto from = folder;
        for (const std::string& name : given)
            if (std::filesystem::path(name).filename() == file)
                from = std::filesystem::path(name).parent_path();
        artifacts.add(load_artifacts(from, {file}).at(file));
    }
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
        return document;
    });
}

void report_sweep(const Json& result, const ReportOptions& options, std::ostream& out) {
    const std::filesystem::path file(options.runs.front());
    const std::filesystem::path output = options.output.empty()
                                             ? std::filesystem::path(file).replace_extension(".html")
                                             : std::filesystem::path(options.output);
    write_file(output, at_place(FileName{file.string()}, [&] {
                   return report::sweep_page(result, capture_fractions(result), file.filename().string());
               }));
    out << output.string() << '\n';
}

void run_report_command(const ReportOptions& options, std::ostream& out) {
    if (options.runs.size() == 1)
        if (const auto sweep = sweep_result(options.runs.front())) {
            report_sweep(*sweep, options, out);
            return;
        }
    std::filesystem::path output = options.output;
    if (output.empty() && options.runs.size() > 1)
        throw InputError("is missing; several runs have no folder in common for their report", "-o FILE.html")
            .at("-o");
    if (output.empty()) output = std::filesystem::path(options.runs.front()) / report::report_file;
    std::vector<report::RunData> runs;
    for (const std::string& folder : options.runs)
        runs.push_back(loaded(folder, options.runs.size() > 1 ? folder : ""));
    write_file(output, report::run_page(runs));
    out << output.string() << '\n';
}

void run_figure_command(const FigureOptions& options, std::ostream& out) {
    const report::FigureFormat format = report::format_of(options.output);
    const report::RunData run(read_run(gathered(options.artifacts)), "");
    const report::Figure figure = report::figure_named(options.name, run);
    if (figure.panels.empty())
        throw InputError("has nothing to show in this run: " + figure.caption, "another figure")
            .at(options.name);
    const report::Width width = options.width == "single" ? report::Width::narrow : report::Width::wide;
    write_file(options.output, report::figure_bytes(figure, width, format));
    out << options.output << '\n';
}

}  // namespace

void add_report(const CommandLine& line) {
    auto [command, options] =
        line.add<ReportOptions>("report", "The report of a run as one HTML file, or of several side by side",
                                "ashimpact report results\n"
                                "  ashimpact report sweep.json\n"
                                "  ashimpact report before after -o comparison.html",
                                run_report_command);
    command->add_option("runs", options->runs, "folders of finished runs, or the result of one sweep")
        ->required()
        ->type_name("DIR");
    add_text(*command, "-o,--output", options->output, "FILE.html",
             "HTML file; default: report.html in the one folder, or the name of the result with .html");
}

void add_figure(const CommandLine& line) {
    auto [command, options] = line.add<FigureOptions>(
        "figure", "One figure of a run for a paper: SVG, PDF or PNG",
        "ashimpact figure restitution results -o restitution.pdf\n"
        "Figures: composition, static-force, regime-map, restitution, damping, damping-fit, "
        "contact-time, sizes, histories,\n"
        "energy, critical-velocity, sensitivity.",
        run_figure_command);
    command->add_option("name", options->name, "of the figure")->required()->type_name("NAME");
    command
        ->add_option("artifacts", options->artifacts,
                     "folder of a run, or artifacts of it; those not named are read beside the first")
        ->required()
        ->type_name("ARTIFACT");
    command
        ->add_option("-o,--output", options->output, "file; its ending says the format: .svg, .pdf or .png")
        ->required()
        ->type_name("FILE");
    command->add_option("--width", options->width, "column of a journal: single (85 mm), double (170 mm)")
        ->capture_default_str()
        ->check(CLI::IsMember({"single", "double"}))
        ->type_name("WIDTH");
}

}  // namespace ashimpact
