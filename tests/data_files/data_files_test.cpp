// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/embedded.hpp"
#include "core/version.hpp"

using ashimpact::embedded_file;
using ashimpact::embedded_files;
using ashimpact::EmbeddedFile;

namespace ashimpact::test_fixtures {
std::span<const EmbeddedFile> embedded_table();  // generated, see cmake/EmbedFiles.cmake
}

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file.is_open(), path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> files_below(const std::string& folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ASHIMPACT_SOURCES) / folder))
        if (extensions.contains(entry.path().extension().string())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// A comment's or a page's lines as one, so that a citation may run over their ends.
std::string on_one_line(const std::string& text) {
    static const std::regex line_end("\n[ \t]*(///?|\\*|%)?[ \t]*");
    return std::regex_replace(text, line_end, " ");
}

std::string lower_case(std::string word) {
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    return word;
}

/// Keys of "Johnson, Kendall & Roberts 1971", "Dong et al. 2013", "Hertz 1882": the first author and the
/// year.
std::set<std::string> cited_in_words(const std::string& text) {
    static const std::regex citation(
        "([A-Z][A-Za-z'-]+)(?:(?:, | & | and )[A-Z][A-Za-z'-]+)*(?: et al\\.)?,? "
        "\\(?((?:18|19|20)[0-9]{2}[a-z]?)\\b");
    std::set<std::string> keys;
    const std::string line = on_one_line(text);
    for (std::sregex_iterator found(line.begin(), line.end(), citation), end; found != end; ++found)
        if ((*found)[1] != "Sep" && (*found)[1] != "YADE")
            keys.insert(lower_case((*found)[1].str()) + (*found)[2].str());
    return keys;
}

/// Keys in the lists of `.citations = {"dong2013, Eq. 1", ...}` and `"citations": ["bass1995", ...]`.
std::set<std::string> cited_by_key(const std::string& text) {
    static const std::regex list("citations(?: = \\{|\": ?\\[)([^}\\]]*)[}\\]]");
    static const std::regex quoted("\"([a-z][a-z0-9-]*)");
    std::set<std::string> keys;
    for (std::sregex_iterator found(text.begin(), text.end(), list), end; found != end; ++found) {
        const std::string inside = (*found)[1].str();
        for (std::sregex_iterator key(inside.begin(), inside.end(), quoted); key != end; ++key)
            keys.insert((*key)[1].str());
    }
    return keys;
}

/// The text between two marks in the first line of a source file that begins with the first mark; empty if
/// there is none.
std::string first_between(const std::string& file, std::string_view before, std::string_view after) {
    std::ifstream stream(std::string(ASHIMPACT_SOURCES "/") + file);
    REQUIRE(stream);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(before)) return line.substr(before.size(), line.find(after) - before.size());
    }
    return {};
}

}  // namespace

TEST_CASE(
    "whatever the sources, the data and the pages cite stands in data/references.bib, and nothing else") {
    std::map<std::string, int> entries;
    static const std::regex entry("\n@[a-z]+\\{([^,]+),");
    const std::string bibliography = text_of(fs::path(ASHIMPACT_DATA) / "references.bib");
    for (std::sregex_iterator found(bibliography.begin(), bibliography.end(), entry), end; found != end;
         ++found)
        ++entries[(*found)[1].str()];
    REQUIRE(entries.size() > 40);
    for (const auto& entry_count : entries)
        CHECK_MESSAGE(entry_count.second == 1, "twice in references.bib: ", entry_count.first);

    std::set<std::string> cited;
    for (const char* folder : {"core", "materials", "solver", "pipeline", "data", "docs", "bench"}) {
        for (const fs::path& path : files_below(folder, {".hpp", ".cpp", ".json", ".md"})) {
            const std::string text = text_of(path);
            std::set<std::string> keys = cited_in_words(text);
            if (path.extension() != ".md") keys.merge(cited_by_key(text));
            for (const std::string& key : keys)
                CHECK_MESSAGE(entries.contains(key), path.string(), " cites ", key,
                              ", which data/references.bib has not");
            cited.merge(keys);
        }
    }
    for (const auto& entry_count : entries)
        CHECK_MESSAGE(cited.contains(entry_count.first), "nothing cites ", entry_count.first,
                      " of data/references.bib");
}

TEST_CASE("an embedded file has the bytes of the file on disk, whatever they are") {
    const std::span<const EmbeddedFile> table = ashimpact::test_fixtures::embedded_table();
    REQUIRE(table.size() == 4);
    for (const EmbeddedFile& file : table) {
        CAPTURE(file.path);
        CHECK((file.content == text_of(std::filesystem::path(ASHIMPACT_FIXTURES) / file.path)));
    }
    CHECK(embedded_file(table, "empty")->empty());
    CHECK(embedded_file(table, "an odd folder/bytes (all).bin")->size() == 256);
    CHECK(embedded_file(table, "large.json")->size() == 30000 * 33);
}

TEST_CASE("files are found by their whole path and listed by prefix, in order") {
    const std::span<const EmbeddedFile> table = ashimpact::test_fixtures::embedded_table();
    CHECK(embedded_files(table, "") == std::vector<std::string_view>{"an odd folder/bytes (all).bin", "empty",
                                                                     "large.json", "syntax.txt"});
    CHECK(embedded_files(table, "e") == std::vector<std::string_view>{"empty"});
    CHECK(embedded_files(table, "zzz").empty());
    CHECK_FALSE(embedded_file(table, "empt"));
    CHECK_FALSE(embedded_file(table, "emptyy"));
    CHECK_FALSE(embedded_file(table, ""));
    CHECK_FALSE(embedded_file({}, "empty"));
}

TEST_CASE("the embedded files have the bytes of those in data/ and beside their readers") {
    const std::vector<std::string_view> paths = embedded_files("");
    CHECK(std::ranges::is_sorted(paths));
    const std::filesystem::path data(ASHIMPACT_DATA);
    const std::filesystem::path present = data / "../pipeline/present";
    for (const std::string_view path : paths) {
        CAPTURE(path);
        const std::filesystem::path file =
            path.starts_with("export/")   ? present / "export/templates" / path.substr(7)
            : path.starts_with("report/") ? present / "report/page" / path.substr(7)
                                          : data / path;
        CHECK((embedded_file(path) == text_of(file)));
    }
    CHECK_FALSE(embedded_file("no such file"));
}

TEST_CASE("every file that states the version states that of the program") {
    const std::string_view version = ashimpact::program_version();
    CHECK(first_between("CITATION.cff", "version: ", "\n") == version);
    CHECK(first_between("debian/changelog", "ashimpact (", ")") == version);
    const std::string newest = first_between("CHANGELOG.md", "## [", "]");
    CAPTURE(newest);
    CHECK((newest == "Unreleased" || newest == version));
}

TEST_CASE("the revision is a commit or the word unknown") {
    std::string_view revision = ashimpact::program_revision();
    CAPTURE(revision);
    if (revision == "unknown") return;
    if (revision.ends_with("-dirty")) revision.remove_suffix(std::string_view("-dirty").size());
    CHECK(revision.size() >= 7);
    CHECK(revision.find_first_not_of("0123456789abcdef") == std::string_view::npos);
}

namespace {

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// A column of the table of scatter in docs/validation.md.
struct ScatterColumn {
    std::size_t impacts = 0;
    double median = 0;            ///< of e
    double robust_deviation = 0;  ///< of ln(-ln e), 1.4826 times the median distance from its median
    std::size_t beyond = 0;       ///< three of them
    std::size_t damped = 0;       ///< of these with more damping
    std::size_t far = 0;          ///< e beyond three times 4 % of its median
};

ScatterColumn scatter_of(const std::vector<double>& restitutions) {
    ScatterColumn column{.impacts = restitutions.size(), .median = median_of(restitutions)};
    std::vector<double> dampings, distances;
    for (const double e : restitutions) {
        dampings.push_back(std::log(-std::log(e)));
        if (std::abs(e / column.median - 1) > 0.12) ++column.far;
    }
    const double median = median_of(dampings);
    for (const double each : dampings) distances.push_back(std::abs(each - median));
    column.robust_deviation = 1.4826 * median_of(distances);
    for (const double each : dampings) {
        if (std::abs(each - median) <= 3 * column.robust_deviation) continue;
        ++column.beyond;
        if (each > median) ++column.damped;
    }
    return column;
}

}  // namespace

TEST_CASE("docs/validation.md has the scatter of the measured restitutions") {
    std::ifstream table(fs::path(ASHIMPACT_DATA) / "measured/fullmer2021.csv");
    std::map<std::string, std::vector<double>> pairs;
    for (std::string line; std::getline(table, line);) {
        const auto comma = line.find(',');
        if (line.empty() || line.front() == '#' || line == "pair,e_n") continue;
        pairs[line.substr(0, comma)].push_back(std::stod(line.substr(comma + 1)));
    }
    std::vector<std::string> rows{"| |",
                                  "| impacts |",
                                  "| median of e |",
                                  "| standard deviation of ln(-ln e), by the median |",
                                  "| beyond three of it; normal: 0.3 % |",
                                  "| of them with more damping |",
                                  "| e beyond 12 % of its median |"};
    std::size_t impacts = 0;
    std::size_t far = 0;
    for (const char* pair : {"glass on acrylic", "glass on glass", "glass on HDPE", "HDPE on HDPE"}) {
        const ScatterColumn column = scatter_of(pairs[pair]);
        impacts += column.impacts;
        far += column.far;
        rows[0] += fmt::format(" {} |", pair);
        rows[1] += fmt::format(" {} |", column.impacts);
        rows[2] += fmt::format(" {:.3f} |", column.median);
        rows[3] += fmt::format(" {:.3f} |", column.robust_deviation);
        rows[4] += fmt::format(" {} |", column.beyond);
        rows[5] += fmt::format(" {} |", column.damped);
        rows[6] += fmt::format(" {} |", column.far);
    }
    std::size_t ratios = 0;
    int largest = 0;
    for (const double e : pairs["glass on acrylic"])
        for (int whole = 1; whole <= 300; ++whole) {
            if (std::abs(std::sqrt(std::round(e * e * whole) / whole) - e) > 5e-10) continue;
            ++ratios;
            largest = std::max(largest, whole);
            break;
        }
    rows.push_back(
        fmt::format("each of the {} e is to its nine digits the root of a ratio of whole numbers up to {}",
                    ratios, largest));
    // Beyond three standard deviations, and outliers.
    const double expected = 0.02 + 0.98 * std::erfc(3 / std::sqrt(2));
    rows.push_back(fmt::format("{:.1f} % of the impacts, {:.0f} of these {}; {} are there", 100 * expected,
                               expected * static_cast<double>(impacts), impacts, far));
    std::string page = text_of(fs::path(ASHIMPACT_SOURCES) / "docs/validation.md");
    std::ranges::replace(page, '\n', ' ');
    for (const std::string& row : rows) CHECK_MESSAGE(page.find(row) != std::string::npos, row);
}
