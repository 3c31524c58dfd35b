// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/outputs.hpp"

#include <cmath>
#include <variant>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/app/sweep/table/row_log.hpp"
#include "pipeline/app/sweep/table/table_file.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/present/report/page/html.hpp"

namespace ashimpact {

namespace {

constexpr auto another = "another -o";

[[noreturn]] void refuse(const std::filesystem::path& file, const char* problem, const char* allowed) {
    throw InputError(problem, allowed).at(FileName{file.string()});
}

void check_result(const std::filesystem::path& result) {
    if (result.extension() == ".h5")
        refuse(result, "would be the full table", "a JSON file, such as sweep.json; -o");
    if (result.extension() == ".html")
        refuse(result, "would be the report", "a JSON file, such as sweep.json; -o");
    const auto status = std::filesystem::status(result);
    if (std::filesystem::is_directory(status)) refuse(result, "is a folder", "a file; -o");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse(result, "is no regular file, and others are written beside it", "a file; -o");
    const auto folder = result.parent_path();
    require_writable_folder(folder.empty() ? "." : folder);
}

/// The report replaces a page of ours and nothing else.
void check_report(const SweepFiles& files) {
    const auto status = std::filesystem::status(files.report);
    if (std::filesystem::exists(status) && !report::is_own_page(files.report))
        refuse(files.report, "is there already and is no report of ours", "another -o, or --no-report");
}

/// Its own table a sweep may replace, after an edit of its spec too; not that of a sweep whose result stands
/// under another name.
void check_table(const SweepFiles& files, const SweepPlan& plan) {
    if (!std::filesystem::exists(files.table)) return;
    const auto spec = spec_of_table(files.table);
    if (!spec) refuse(files.table, "is there already and is no table of a sweep", another);
    if (*spec != plan.hash() && !std::filesystem::exists(files.result))
        refuse(files.table, "is there already and is the table of another sweep", another);
}

/// Refuses a table that cannot have room, before anything is computed. Digits of numbers drawn at random do
/// not shrink: 6.5 bytes are left of each. Everything else is taken to shrink to a hundredth of its 8 bytes.
/// Until the table is written its rows stand beside it.
void check_room(const SweepFiles& files, const SweepPlan& plan) {
    double random = 0;
    for (const SweepVariable& variable : plan.spec().variables)
        random += std::holds_alternative<Choice>(variable.distribution) ? 0 : 1;
    const auto columns = static_cast<double>(plan.table_columns().size());
    const double row = 6.5 * random + 0.08 * (columns - random);
    const double needed = 2 * row * static_cast<double>(plan.rows());
    std::error_code failure;
    const auto folder = std::filesystem::absolute(files.table, failure).parent_path();
    const auto space = std::filesystem::space(folder, failure);
    if (failure || needed <= static_cast<double>(space.available)) return;
    const auto gigabytes = [](double bytes) { return shortest(std::round(bytes / 1e8) / 10) + " GB"; };
    throw InputError("a table of " + std::to_string(plan.rows()) + " rows takes " + gigabytes(needed) +
                         " or more, and " + gigabytes(static_cast<double>(space.available)) + " are free",
                     "fewer samples, no \"table\", or a larger disk; -o")
        .at(FileName{files.table.string()});
}

/// Whether a file is there and does not begin as a sweep's own do.
bool is_foreign(const std::filesystem::path& file, std::string_view mark) {
    constexpr std::size_t enough = 64;
    if (!std::filesystem::exists(file)) return false;
    const std::string start = read_start(file, enough);
    return start.find(mark) == std::string::npos && !mark.starts_with(start);
}

}  // namespace

void check_outputs(const SweepFiles& files, const std::filesystem::path& spec, const SweepPlan& plan,
                   bool with_report) {
    const bool with_table = !plan.spec().table.empty();
    check_result(files.result);
    for (const auto& file : {files.result, files.checkpoint, files.rows, files.table})
        if ((with_table || file != files.table) && is_same_file(file, spec))
            refuse(file, "is the spec, which would be lost", another);
    if (with_report) check_report(files);
    if (with_table) check_table(files, plan);
    if (with_table) check_room(files, plan);
    if (is_foreign(files.rows, row_log_mark))
        refuse(files.rows, "is there already and holds no rows of a sweep", another);
    if (is_foreign(files.checkpoint, checkpoint_mark))
        refuse(files.checkpoint, "is there already and is no checkpoint", another);
}

}  // namespace ashimpact
