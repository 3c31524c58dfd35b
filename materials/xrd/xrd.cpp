// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/xrd/xrd.hpp"

#include <array>

#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact {

namespace {

struct Reader {
    bool (*recognises)(const TextLines&);
    XrdResult (*read)(const TextLines&);
};

/// Tried in this order: the formats that are recognised most reliably come first.
constexpr std::array readers{
    Reader{xrd::looks_like_json, xrd::read_json},   Reader{xrd::looks_like_bgmn, xrd::read_bgmn},
    Reader{xrd::looks_like_gsas2, xrd::read_gsas2}, Reader{xrd::looks_like_fullprof, xrd::read_fullprof},
    Reader{xrd::looks_like_topas, xrd::read_topas}, Reader{xrd::looks_like_table, xrd::read_table},
};

constexpr TextLimits xrd_limits{.content = "an XRD result", .bytes = longest_xrd_file};

/// Reads a table in a spreadsheet; messages name rows and cells.
XrdResult read_from_workbook(std::string_view bytes, std::string_view sheet) {
    const ChosenSheet chosen(bytes, {.name = std::string(sheet),
                                     .option = "the name of a sheet (--sheet, in a case \"xrd_sheet\")",
                                     .code = xrd_code,
                                     .limits = xrd_limits,
                                     .holds_table = xrd::looks_like_table});
    return chosen.read([&](const TextLines& lines) {
        XrdResult result = xrd::read_table(lines);
        result.warnings.insert(result.warnings.begin(), chosen.findings().begin(), chosen.findings().end());
        for (XrdSample& sample : result.samples) {
            for (Finding& warning : sample.warnings) warning.text = in_rows(warning.text);
            for (PhaseFraction& phase : sample.analysis.phases) phase.place = chosen.place(phase.place);
        }
        return result;
    });
}

XrdResult read(std::string_view text, std::string_view sheet) {
    if (is_workbook(text)) return read_from_workbook(text, sheet);
    if (!sheet.empty())
        throw InputError("a sheet is named, and the file is no spreadsheet", "an .xlsx or .ods");
    const TextLines file(text, xrd_limits);
    for (const Reader& reader : readers) {
        if (!reader.recognises(file)) continue;
        XrdResult result = reader.read(file);
        if (file.was_latin1())
            result.warnings.push_back(
                {xrd_code, Severity::background, "the file is not UTF-8 and was read as Latin-1"});
        return result;
    }
    refuse_line(1, "the format is not known", xrd::known_formats);
}

/// The file's name without folders and ending.
std::string stem(std::string_view name) {
    name.remove_prefix(name.find_last_of("/\\") + 1);
    const auto dot = name.rfind('.');
    return std::string(dot == 0 ? name : name.substr(0, dot));
}

}  // namespace

XrdResult read_xrd(std::string_view text, std::string_view name, std::string_view sheet) {
    return at_place(FileName{std::string(name)}, [&] {
        XrdResult result = read(text, sheet);
        for (XrdSample& sample : result.samples)
            if (sample.name.empty()) sample.name = stem(name);
        return result;
    });
}

}  // namespace ashimpact
