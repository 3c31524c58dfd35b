// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/input_files.hpp"

#include <algorithm>

#include "core/embedded.hpp"
#include "core/text/error.hpp"
#include "pipeline/files/file.hpp"

namespace ashimpact {

namespace {

constexpr auto built_in_mark = "builtin:";

}  // namespace

InputFiles::InputFiles(std::string case_name, std::filesystem::path folder, bool is_built_in)
    : case_name_(std::move(case_name)), folder_(std::move(folder)), is_built_in_(is_built_in) {}

InputFiles InputFiles::beside(const std::filesystem::path& case_file) {
    return {case_file.string(), case_file.parent_path(), false};
}

InputFiles InputFiles::built_in(const std::string& case_file) {
    return {case_file, std::filesystem::path(case_file).parent_path(), true};
}

std::string InputFiles::read_case() {
    return is_built_in_ ? read_built_in(case_name_) : record(case_name_, read_file(case_name_));
}

std::string InputFiles::read(const std::string& name) {
    const std::string path = shown(name);
    if (!is_built_in_ && !may_leave_) require_inside(name);
    return is_built_in_ ? read_built_in(path) : record(path, read_file(path));
}

std::string InputFiles::read_built_in(const std::string& path) {
    const auto bytes = embedded_file(path);
    if (!bytes) throw InputError("the program carries no such file").at(FileName{built_in_mark + path});
    return record(built_in_mark + path, std::string(*bytes));
}

const XrdResult& InputFiles::xrd(const std::string& name, const TableOptions& options) {
    const auto [known, is_new] = xrd_.try_emplace({name, options.sheet, options.decimal});
    if (is_new) {
        known->second = read_xrd(read(name), shown(name), options);
        record_reading(name, known->second.reading);
    }
    return known->second;
}

const OxideResult& InputFiles::oxides(const std::string& name, const TableOptions& options) {
    const auto [known, is_new] = oxides_.try_emplace({name, options.sheet, options.decimal});
    if (is_new) {
        known->second = read_oxides(read(name), shown(name), options);
        record_reading(name, known->second.reading);
    }
    return known->second;
}

MeasurementSet InputFiles::impacts(const std::string& name, const TableOptions& options) {
    MeasurementSet set = read_measurements(read(name), shown(name), options);
    record_reading(name, set.reading);
    return set;
}

void InputFiles::record_reading(const std::string& name, const std::string& reading) {
    const auto file = std::ranges::find(used_, shown(name), &InputFile::file);
    if (file == used_.end()) return;  // carried by the program
    if (std::ranges::find(file->readings, reading) == file->readings.end()) file->readings.push_back(reading);
}

std::string InputFiles::shown(const std::string& name) const {
    return (folder_ / name).string();
}

void InputFiles::require_inside(const std::string& name) const {
    std::error_code failure;
    const auto folder = std::filesystem::weakly_canonical(
        std::filesystem::absolute(folder_.empty() ? "." : folder_), failure);
    const auto file = std::filesystem::weakly_canonical(std::filesystem::absolute(folder_ / name), failure);
    const auto way = file.lexically_relative(folder);
    if (!failure && !way.empty() && *way.begin() != "..") return;
    throw InputError("lies outside of the folder of the case", "a file in that folder, or --allow-outside")
        .at(FileName{shown(name)});
}

std::string InputFiles::record(const std::string& name, std::string bytes) {
    const bool known =
        std::any_of(used_.begin(), used_.end(), [&](const auto& entry) { return entry.file == name; });
    if (!known) used_.push_back({name, sha256(bytes)});
    return bytes;
}

}  // namespace ashimpact
