// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/report.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "pipeline/app/sweep/spec/capture_fraction.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/document/run_identity.hpp"
#include "pipeline/document/schema.hpp"
#include "pipeline/present/report/figure_file.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/present/report/report.hpp"
#include "pipeline/present/report/sweep/sweep_page.hpp"
#include "pipeline/run/run.hpp"

namespace ashimpact {

namespace {

/// A run from its folder.
report::RunData loaded(const std::filesystem::path& folder, const std::string& label) {
    if (!std::filesystem::is_directory(folder))
        throw InputError("is no folder", "the folder of a run, or one result of a sweep")
            .at(FileName{folder.string()});
    return {load_artifacts(folder, report::report_artifacts()), label};
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

}  // namespace

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
    const report::RunData run(gathered(options.artifacts), "");
    const report::Figure figure = report::figure_named(options.name, run);
    if (figure.panels.empty())
        throw InputError("has nothing to show in this run: " + figure.caption, "another figure")
            .at(options.name);
    const report::Width width = options.width == "single" ? report::Width::narrow : report::Width::wide;
    write_file(options.output, report::figure_bytes(figure, width, format));
    out << options.output << '\n';
}

}  // namespace ashimpact
