// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/report.hpp"

#include "pipeline/present/report/drawing/figure.hpp"
#include "pipeline/present/report/figures/figures.hpp"
#include "pipeline/present/report/page/run_page.hpp"
#include "pipeline/run/stage.hpp"

namespace ashimpact::report {

namespace {

std::string file_stem(std::string_view id, Width width) {
    return std::string(id) + (width == Width::narrow ? "-single" : "");
}

/// Each figure for one column and for two, as SVG and as PDF.
void add_figures(const RunData& run, const std::filesystem::path& folder, std::vector<FileContent>& files) {
    for (const FigureMaker& maker : figure_makers()) {
        const Figure figure = maker.make(run);
        if (figure.panels.empty()) continue;
        for (const Width width : {Width::wide, Width::narrow})
            for (const FigureFormat format : {FigureFormat::svg, FigureFormat::pdf}) {
                const std::string name =
                    file_stem(figure.id, width) + (format == FigureFormat::svg ? ".svg" : ".pdf");
                files.push_back({folder / figures_folder / name, figure_bytes(figure, width, format)});
            }
    }
}

}  // namespace

const std::vector<std::string_view>& report_artifacts() {
    static const std::vector<std::string_view> files = [] {
        std::vector<std::string_view> all{case_artifact};
        for (const Stage& stage : stages()) all.push_back(stage.file);
        return all;
    }();
    return files;
}

std::vector<std::filesystem::path> own_figures(const std::filesystem::path& figures) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const FigureMaker& maker : figure_makers())
        for (const Width width : {Width::wide, Width::narrow}) {
            const auto svg = figures / (file_stem(maker.id, width) + ".svg");
            if (!std::filesystem::is_regular_file(svg, ignored) || !is_own_svg(read_file(svg))) continue;
            files.push_back(svg);
            const auto pdf = std::filesystem::path(svg).replace_extension(".pdf");
            if (std::filesystem::is_regular_file(pdf, ignored)) files.push_back(pdf);
        }
    return files;
}

Presentation present(Run run, const PresentationPlan& plan) {
    std::vector<RunData> runs;
    runs.emplace_back(std::move(run), "");
    Presentation made;
    if (plan.page) {
        made.page = plan.folder / report_file;
        made.files.push_back({made.page, run_page(runs)});
    }
    if (plan.figures) add_figures(runs.front(), plan.folder, made.files);
    return made;
}

void require_figure_programs() {
    require_converter(FigureFormat::pdf);
}

}  // namespace ashimpact::report
