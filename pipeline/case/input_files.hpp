// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "materials/glass/oxide_table.hpp"
#include "materials/xrd/xrd.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact {

/// A file that went into a result.
struct InputFile {
    std::string file;                     ///< as the user named it, or "builtin:" and its path in the program
    std::string sha256;                   ///< of its bytes
    std::vector<std::string> readings{};  ///< how its tables were read, by TableReading
};

/// Reads the files that a case names, relative to it, and records those that were read.
class InputFiles {
  public:
    /// Files beside a case file of the user.
    [[nodiscard]] static InputFiles beside(const std::filesystem::path& case_file);
    /// Files beside a case the program carries, such as "cases/dong2013/case.json".
    [[nodiscard]] static InputFiles built_in(const std::string& case_file);

    /// The bytes of the case file itself. To be called before any other read, so that it comes first in the
    /// record.
    [[nodiscard]] std::string read_case();
    /// Allows the case to name files outside of its folder.
    void allow_outside() { may_leave_ = true; }
    /// The bytes of another file. @throws InputError if it cannot be read, or lies outside of the case's
    /// folder, through links too, where that is not allowed
    [[nodiscard]] std::string read(const std::string& name);
    /// The bytes of a file the program carries.
    [[nodiscard]] std::string read_built_in(const std::string& path);

    /// The XRD result in a file, which is read once, however many samples it holds. @throws InputError
    [[nodiscard]] const XrdResult& xrd(const std::string& name, const TableOptions& options);

    /// The chemical analysis in a file, likewise read once. @throws InputError
    [[nodiscard]] const OxideResult& oxides(const std::string& name, const TableOptions& options);

    /// The measured impacts in a file. @throws InputError
    [[nodiscard]] MeasurementSet impacts(const std::string& name, const TableOptions& options);

    /// What a message calls a file.
    [[nodiscard]] std::string shown(const std::string& name) const;
    [[nodiscard]] const std::string& case_name() const { return case_name_; }
    [[nodiscard]] const std::vector<InputFile>& used() const { return used_; }

  private:
    InputFiles(std::string case_name, std::filesystem::path folder, bool is_built_in);
    std::string record(const std::string& name, std::string bytes);
    void record_reading(const std::string& name, const std::string& reading);
    void require_inside(const std::string& name) const;

    std::string case_name_;
    std::filesystem::path folder_;
    bool is_built_in_;
    bool may_leave_ = false;
    std::vector<InputFile> used_;
    /// Results by file, sheet and decimal mark.
    template <class Result>
    using ByTable = std::map<std::tuple<std::string, std::string, std::optional<DecimalMark>>, Result>;

    ByTable<XrdResult> xrd_;
    ByTable<OxideResult> oxides_;
};

}  // namespace ashimpact
