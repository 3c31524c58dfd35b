#include "pipeline/sweep/table/outputs.hpp"

#include "materials/base/error.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/sweep/table/row_log.hpp"
#include "pipeline/sweep/table/table_file.hpp"

namespace ashimpact {

namespace {

constexpr auto another = "another -o";

[[noreturn]] void refuse(const std::filesystem::path& file, const char* problem, const char* allowed) {
    throw InputError(problem, allowed).in_file(file.string());
}

void check_result(const std::filesystem::path& result) {
    if (result.extension() == ".h5")
        refuse(result, "would be the full table", "a JSON file, such as sweep.json; -o");
    const auto status = std::filesystem::status(result);
    if (std::filesystem::is_directory(status)) refuse(result, "is a folder", "a file; -o");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse(result, "is no regular file, and others are written beside it", "a file; -o");
    const auto folder = result.parent_path();
    require_writable_folder(folder.empty() ? "." : folder);
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

/// Whether a file is there and does not begin as a sweep's own do.
bool is_foreign(const std::filesystem::path& file, std::string_view mark) {
    constexpr std::size_t enough = 64;
    if (!std::filesystem::exists(file)) return false;
    const std::string start = read_start(file, enough);
    return start.find(mark) == std::string::npos && !mark.starts_with(start);
}

}  // namespace

void check_outputs(const SweepFiles& files, const std::filesystem::path& spec, const SweepPlan& plan) {
    const bool with_table = !plan.spec().table.empty();
    check_result(files.result);
    for (const auto& file : {files.result, files.checkpoint, files.rows, files.table})
        if ((with_table || file != files.table) && is_same_file(file, spec))
            refuse(file, "is the spec, which would be lost", another);
    if (with_table) check_table(files, plan);
    if (is_foreign(files.rows, row_log_mark))
        refuse(files.rows, "is there already and holds no rows of a sweep", another);
    if (is_foreign(files.checkpoint, checkpoint_mark))
        refuse(files.checkpoint, "is there already and is no checkpoint", another);
}

}  // namespace ashimpact
