// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <minizip/zip.h>
#include <unistd.h>

#include "core/quantities/quantity.hpp"
#include "core/tables/number_marks.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "materials/xrd/table_layout.hpp"
#include "materials/xrd/xrd.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

using Parts = std::vector<std::pair<std::string, std::string>>;

/// A zip archive of these parts, packed by minizip.
std::string archive_of(const Parts& parts) {
    std::string path = (std::filesystem::temp_directory_path() / "ashimpact-workbook-XXXXXX").string();
    const int file = mkstemp(path.data());
    REQUIRE(file >= 0);
    close(file);
    const zipFile zip = zipOpen(path.c_str(), APPEND_STATUS_CREATE);
    REQUIRE(zip != nullptr);
    for (const auto& [name, content] : parts) {
        REQUIRE(zipOpenNewFileInZip(zip, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                    9) == ZIP_OK);
        REQUIRE(zipWriteInFileInZip(zip, content.data(), static_cast<unsigned>(content.size())) == ZIP_OK);
        REQUIRE(zipCloseFileInZip(zip) == ZIP_OK);
    }
    REQUIRE(zipClose(zip, nullptr) == ZIP_OK);
    std::string bytes = file_text(path);
    std::remove(path.c_str());
    return bytes;
}

const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";

/// An .xlsx with one sheet of these rows, and what else is given.
std::string xlsx(const std::string& rows, const std::string& styles = "", const std::string& strings = "",
                 const std::string& comments = "", const std::string& drawing = "",
                 const std::string& sheet = "S") {
    Parts parts{{"_rels/.rels", "<Relationships><Relationship Id='r' Type='" + office +
                                    "officeDocument' Target='xl/workbook.xml'/></Relationships>"},
                {"xl/workbook.xml", "<workbook xmlns:r='x'><sheets><sheet name='" + sheet +
                                        "' sheetId='1' r:id='a'/></sheets></workbook>"},
                {"xl/_rels/workbook.xml.rels",
                 "<Relationships><Relationship Id='a' Type='" + office +
                     "worksheet' Target='worksheets/s.xml'/>" + "<Relationship Id='b' Type='" + office +
                     "styles' Target='/xl/styles.xml'/>" + "<Relationship Id='c' Type='" + office +
                     "sharedStrings' Target='../xl/strings.xml'/></Relationships>"},
                {"xl/worksheets/s.xml", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"}};
    if (!styles.empty()) parts.emplace_back("xl/styles.xml", styles);
    if (!strings.empty()) parts.emplace_back("xl/strings.xml", strings);
    parts.emplace_back("xl/worksheets/_rels/s.xml.rels",
                       "<Relationships><Relationship Id='n' Type='" + office +
                           "comments' Target='../comments1.xml'/><Relationship Id='d' Type='" + office +
                           "drawing' Target='../drawing1.xml'/></Relationships>");
    if (!comments.empty())
        parts.emplace_back("xl/comments1.xml",
                           "<comments><commentList>" + comments + "</commentList></comments>");
    if (!drawing.empty()) parts.emplace_back("xl/drawing1.xml", drawing);
    return archive_of(parts);
}

/// An .ods with one sheet of these rows, its styles, and the styles that have a name for the user.
std::string ods(const std::string& rows, const std::string& styles = "", const std::string& common = "") {
    return archive_of(
        {{"styles.xml", "<office:document-styles xmlns:office='o'><office:styles>" + common +
                            "</office:styles></office:document-styles>"},
         {"content.xml",
          "<office:document-content xmlns:office='o' xmlns:table='t' xmlns:text='p'>"
          "<office:automatic-styles>" +
              styles +
              "</office:automatic-styles><office:body><office:spreadsheet><table:table table:name='S'>" +
              rows +
              "</table:table></office:spreadsheet></office:body>"
              "</office:document-content>"}});
}

std::string text_of(const std::string& bytes) {
    const auto sheets = read_workbook(bytes);
    REQUIRE(sheets.size() == 1);
    return sheets[0].as_text();
}

std::string inline_row(const std::vector<std::string>& cells) {
    std::string row = "<row>";
    for (const std::string& cell : cells) row += "<c t='inlineStr'><is><t>" + cell + "</t></is></c>";
    return row + "</row>";
}

std::string data(const std::string& name) {
    return file_text(ASHIMPACT_TEST_DATA "/workbooks/" + name);
}

}  // namespace

TEST_CASE("every list of columns and rows of XRD tables has a meaning") {
    const WordLists columns("XRD columns");
    for (const auto& [word, list] : columns.words()) {
        CAPTURE(list);
        CHECK(named<xrd::Role>(list) != xrd::Role::other);
    }
    const WordLists rows("XRD rows");
    for (const auto& [word, list] : rows.words()) {
        CAPTURE(list);
        CHECK(named<xrd::RowMeaning>(list) != xrd::RowMeaning::phase);
    }
    CHECK_THROWS_AS(WordLists("no such group"), std::exception);
}

TEST_CASE("uncertainties in headings that contain the name of another column") {
    for (const auto& [heading, factor] : {std::pair{"FA1 SD", 1.0},
                                          std::pair{"FA1_err", 1.0},
                                          std::pair{"FA1 std. error", 1.0},
                                          std::pair{"FA1 unc.", 1.0},
                                          std::pair{"\u00b1 FA1", 1.0},
                                          std::pair{"u(FA1)", 1.0},
                                          std::pair{"error of FA1 [wt%]", 1.0},
                                          std::pair{"FA1 2s", 2.0},
                                          std::pair{"FA1 2 esd", 2.0},
                                          std::pair{"FA1 2 Stabw.", 2.0},
                                          std::pair{"2s(FA1)", 2.0},
                                          std::pair{"fa1 3 errors [%]", 3.0},
                                          std::pair{"FA1 2\u00d7u", 2.0},
                                          std::pair{"FA1 (k=2)", 2.0},
                                          std::pair{"Fehler FA1 2s", 2.0},
                                          std::pair{"error FA1, 2s", 2.0},
                                          std::pair{"err FA1 3s", 3.0},
                                          std::pair{"SD of FA1", 1.0},
                                          std::pair{"FA1 SD (n=3)", 1.0},
                                          std::pair{"FA1 % error", 1.0}}) {
        const std::string text = heading;
        CAPTURE(text);
        const auto beside = uncertainty_beside(text, "FA1");
        REQUIRE(beside);
        CHECK(beside->problem.empty());
        const StatedCoverage coverage = read_coverage(beside->text);
        CHECK(coverage.factor == factor);
        CHECK(coverage.problem.empty());
    }
    for (const char* heading : {"FA1 U", "FA1 95 % CI"}) {
        CAPTURE(heading);
        const auto beside = uncertainty_beside(heading, "FA1");
        REQUIRE(beside);
        CHECK_FALSE(read_coverage(beside->text).problem.empty());
    }
    for (const char* heading :
         {"FA1 SE", "FA1 s", "FA1 RSD", "FA1 CI95", "FA1 MU", "FA1 rel. error %", "s(FA1)", "FA1 Toleranz",
          "error FA1 95", "FA1 double SD", "FA1 error (double SD)", "FA1 doppelte Stabw.", "2-fold SD FA1",
          "FA1 max. error", "FA1 maximaler Fehler", "FA1 error percent", "FA1 fractional error"}) {
        CAPTURE(heading);
        const auto beside = uncertainty_beside(heading, "FA1");
        REQUIRE(beside);
        CHECK(contains(beside->problem, "names no standard uncertainty"));
    }
    for (const char* heading :
         {"FA1", "FA10 SD", "FA1 wet", "FA1 [wt%]", "FA1 2", "FA1 total", "SD", "FA2 SD"}) {
        CAPTURE(heading);
        CHECK_FALSE(uncertainty_beside(heading, "FA1"));
    }
    CHECK_FALSE(uncertainty_beside("FA1 SD", ""));
}

TEST_CASE("a word behind plus and minus that names no standard uncertainty is a problem") {
    for (const char* heading :
         {"v_in \u00b1 CI [m/s]", "v_in +/- U", "wt% \u00b1 tolerance", "v_r \u00b1 max. error",
          "v_in \u00b1 IQR (m/s)", "Wt% \u00b1 Fehlergrenze"}) {
        CAPTURE(heading);
        CHECK(contains(read_coverage(heading).problem, "names no standard uncertainty"));
    }
    for (const char* heading :
         {"v_in \u00b1 u [m/s]", "v_in \u00b1 SD", "wt% \u00b1 esd", "\u00b1 FA1", "FA1 \u00b1 wt%",
          "v_in \u00b1 [m/s]", "v_in \u00b1 0.05", "v_in \u00b1 m/s"}) {
        CAPTURE(heading);
        CHECK(read_coverage(heading).problem.empty());
    }
}

TEST_CASE("headings are found however umlauts and accents are spelled") {
    for (const char* heading : {"Échantillon", "echantillon", "e\u0301chantillon", "ÉCHANTILLON"})
        CHECK(xrd::read_heading(heading).role == xrd::Role::sample);
    for (const char* heading : {"Incertitude élargie", "incertitude elargie", "±", "+/-", "σ", "±σ", "s.u."})
        CHECK(is_uncertainty_word(heading));
    CHECK_FALSE(is_uncertainty_word("quartz"));
    CHECK(xrd::read_heading("%").role == xrd::Role::weight);
    CHECK(xrd::read_heading("+").role == xrd::Role::uncertainty);
    CHECK(xrd::read_heading("Dichte").role == xrd::Role::density);
    CHECK(xrd::read_heading("Density (g/cm³)").unit == "g/cm³");
    for (const char* label : {"Σ", "Gesamt", "合计", "Итого", "Toplam [%]"})
        CHECK(xrd::meaning_of_row(label) == xrd::RowMeaning::total);
    for (const char* heading :
         {"% error", "%err", "err%", "error %", "Fehler in %", "± %", "Percent error", "pct error"})
        CHECK(xrd::read_heading(heading).unit == "%");
    CHECK(read_coverage("FA1 % error").rest == "FA1 error [%]");
    CHECK(read_coverage("95 % error").factor == doctest::Approx(1.96).epsilon(1e-3));
    CHECK(xrd::meaning_of_row("Total crystalline [%]") == xrd::RowMeaning::crystalline_total);
    CHECK(xrd::meaning_of_row("sigma") == xrd::RowMeaning::phase);
    for (const char* cell : {"N.D.", "n. n.", "unter NWG", "Spuren (<1)", "< 0.5", "not detected"})
        CHECK(says_no_number(cell));
    CHECK_FALSE(says_no_number("tr (0.5)"));
    CHECK_FALSE(says_no_number("1"));
}

TEST_CASE("labels of rows that sum up others, and of samples that look like them") {
    for (const char* label :
         {"Mittel", "Schnitt", "n=3", "n = 12", "SD (n=3)", "RSD %", "x\u0304", "Mean \u00b1 SD",
          "Mittel 1-5", "\u00d8 1-5", "Promedio", "\u5408\u8ba1", "mean of 10", "Std. dev. (n = 4)",
          "\u5e73\u5747\u503c", "Max", "gem.", "\u03a3/4", "Sum / n"}) {
        CAPTURE(label);
        CHECK(is_summary(label));
    }
    for (const char* label :
         {"S (dry)", "S 1", "N3", "Meaney Power", "Mean Creek", "FA1 (n=3)", "Totalite", "SD/4", "M"}) {
        CAPTURE(label);
        CHECK_FALSE(is_summary(label));
    }
}

TEST_CASE("phases are named without their marks") {
    const auto is = [](const char* text, const char* name, xrd::PhaseMark mark) {
        CAPTURE(text);
        const xrd::MarkedPhase read = xrd::read_phase_name(text);
        CHECK(read.name == name);
        CHECK(read.mark == mark);
    };
    using xrd::PhaseMark;
    is("Corundum (internal standard)", "Corundum", PhaseMark::standard);
    is("Corundum (spike, 15 %)", "Corundum", PhaseMark::standard);
    is("corundum (spike)", "corundum", PhaseMark::standard);
    is("Corundum, int. std.", "Corundum", PhaseMark::standard);
    is("Corundum (ISTD)", "Corundum", PhaseMark::standard);
    is("Quartz\u00b9", "Quartz", PhaseMark::none);
    is("Corundum [IS]", "Corundum", PhaseMark::standard);
    is("Interner Standard (Korund)", "Korund", PhaseMark::standard);
    is("Spike: corundum", "corundum", PhaseMark::standard);
    is("Anhydrite (not detected)", "Anhydrite", PhaseMark::not_detected);
    is("Lime, n.d.", "Lime", PhaseMark::not_detected);
    is("Kalk (Spuren)", "Kalk", PhaseMark::traces);
    is("Mullite (3:2)", "Mullite (3:2)", PhaseMark::none);
    is("Quartz, syn", "Quartz, syn", PhaseMark::none);
    is("Standard", "Standard", PhaseMark::none);
    is("SiO2 (tridymite)", "SiO2 (tridymite)", PhaseMark::none);
}

TEST_CASE("spreadsheets of three programs hold the same ash") {
    const XrdResult text = read_xrd(
        "Phase;Anteil [Gew.-%];Fehler\nQuarz;10,5;0,4\nMullit;21,3;0,6\nKalk;2,2;0,3\n"
        "Röntgenamorph;66;1\n",
        "ash.csv");
    for (const char* name : {"openpyxl.xlsx", "shared-strings.xlsx", "opendocument.ods"}) {
        CAPTURE(name);
        const XrdResult result = read_xrd(data(name), name);
        REQUIRE(result.samples.size() == 1);
        const auto& phases = result.samples[0].analysis.phases;
        REQUIRE(phases.size() == text.samples[0].analysis.phases.size());
        for (std::size_t i = 0; i < phases.size(); ++i) {
            const PhaseFraction& expected = text.samples[0].analysis.phases[i];
            CHECK(phases[i].fraction == doctest::Approx(expected.fraction).epsilon(1e-12));
            CHECK(phases[i].standard_uncertainty.value() ==
                  doctest::Approx(expected.standard_uncertainty.value()).epsilon(1e-12));
            CHECK(shipped_catalogue().resolve(phases[i].name).phase.name ==
                  shipped_catalogue().resolve(expected.name).phase.name);
        }
    }
    const auto warnings = read_xrd(data("openpyxl.xlsx"), "a.xlsx").warnings;
    CHECK(contains(warnings.front().text, "the sheet \"Phasen\" is read, not \"Notizen\""));
}

TEST_CASE("cells of .xlsx hold what the spreadsheet shows") {
    const std::string styles =
        "<styleSheet><numFmts><numFmt numFmtId='164' formatCode='dd\\.mm\\.yyyy'/>"
        "<numFmt numFmtId='165' formatCode='0.0%'/>"
        "<numFmt numFmtId='166' formatCode='[Red]0.00\" days\"'/>"
        "<numFmt numFmtId='167' formatCode='[&lt;0.1]\"&lt;\"0.0;0.0\\ \\g/\"kg\"'/>"
        "<numFmt numFmtId='168' formatCode='#,##0.00_);(#,##0.00);\"n.d.\"'/>"
        "<numFmt numFmtId='169' formatCode='#,##0.00,\" m/s\"'/>"
        "<numFmt numFmtId='170' formatCode='\"-\"0.0'/><numFmt numFmtId='171' formatCode='(0.0)'/>"
        "<numFmt numFmtId='172' formatCode='0\" 10^-1\"'/><numFmt numFmtId='173' formatCode=';;;'/>"
        "<numFmt numFmtId='174' formatCode='0.0\"*\"'/></numFmts>"
        "<fonts><font/><font><strike/></font></fonts><cellXfs><xf/>"
        "<xf numFmtId='164'/><xf numFmtId='165'/><xf numFmtId='166'/><xf numFmtId='14'/><xf fontId='1'/>"
        "<xf numFmtId='167'/><xf numFmtId='168'/><xf numFmtId='169'/>"
        "<xf numFmtId='170'/><xf numFmtId='171'/><xf numFmtId='172'/><xf numFmtId='173'/>"
        "<xf numFmtId='174'/></cellXfs></styleSheet>";
    const std::string strings =
        "<sst><si><t>plain</t></si><si><r><t>ri</t></r><r><t>ch</t></r>"
        "<rPh><t>phonetic</t></rPh></si></sst>";
    const auto cell = [&](const std::string& xml) {
        std::string text = text_of(xlsx("<row r='1'>" + xml + "</row>", styles, strings));
        REQUIRE(text.ends_with('\n'));
        text.pop_back();
        return text;
    };
    CHECK(cell("<c r='A1'><v>0.40000000000000002</v></c>") == "0.4");
    CHECK(cell("<c r='A1'><v>1e-09</v></c>") == "1e-09");
    CHECK(cell("<c r='A1'><v>1.234</v></c>") == "1.2340");  // a number, whatever the marks of texts
    CHECK(cell("<c r='A1'><v>0.123</v></c>") == "0.123");
    CHECK(cell("<c r='A1' s='2'><v>0.21299999999999999</v></c>") == "21.3 %");
    CHECK(cell("<c r='A1' s='1'><v>46082</v></c>") == "2026-03-01 (a date)");
    CHECK(cell("<c r='A1' s='4'><v>1</v></c>") == "1899-12-31 (a date)");
    CHECK(cell("<c r='A1' s='3'><v>12.5</v></c>") == "12.5 days");
    CHECK(cell("<c r='A1' s='6'><v>0.05</v></c>") == "<0.05");
    CHECK(cell("<c r='A1' s='6'><v>3.5</v></c>") == "3.5 g/kg");
    CHECK(cell("<c r='A1' s='7'><v>1234.5</v></c>") == "1234.5");
    CHECK(cell("<c r='A1' s='7'><v>-2.5</v></c>") == "-2.5");
    CHECK(cell("<c r='A1' s='7'><v>0</v></c>") == "n.d.");
    CHECK(cell("<c r='A1' s='8'><v>1250</v></c>") == "1250 (shown as 1.25 by its number format)");
    CHECK(cell("<c r='A1' s='9'><v>5</v></c>") == "-5");  // what a reader sees
    CHECK(cell("<c r='A1' s='10'><v>5</v></c>") == "(5");
    CHECK(cell("<c r='A1' s='11'><v>5</v></c>") == "5 10^-1");
    CHECK(cell("<c r='A1' s='12'><v>5</v></c>") == "5 (hidden by its number format)");
    CHECK(cell("<c r='A1' s='13'><v>5</v></c>") == "5 *");
    for (const auto& [code, shown] : {std::pair{"0%%", "123 (in a number format that may change it)"},
                                      {"0\\.0", "123 (in a number format that may change it)"},
                                      {"0\".\"00", "123 (in a number format that may change it)"},
                                      {"00-00", "123 (in a number format that may change it)"},
                                      {"0:00", "123 (in a number format that may change it)"},
                                      {"0.0 x", "123 (in a number format that may change it)"},
                                      {"[Unknown]0", "123 (in a number format that may change it)"},
                                      {"0.0\"(4)\"", "123 (in a number format that may change it)"},
                                      {"[$-407]#\\ ##0.00", "123"},
                                      {"[Blue]#,##0.0_);[Red](#,##0.0)", "123"},
                                      {"0.00E+00", "123"},
                                      {"# ?/?", "123"},
                                      {"#'##0.0", "123"},
                                      {"GENERAL", "123"},
                                      {"[DBNum1][$-804]General", "123"}}) {
        CAPTURE(code);
        const std::string own = "<styleSheet><numFmts><numFmt numFmtId='164' formatCode='" +
                                std::string(code) +
                                "'/></numFmts><cellXfs><xf numFmtId='164'/></cellXfs>"
                                "</styleSheet>";
        std::string quoted = own;
        for (auto at = quoted.find("#'##"); at != std::string::npos; at = quoted.find("#'##"))
            quoted.replace(at + 1, 1, "&apos;");
        CHECK(text_of(xlsx("<row><c><v>123</v></c></row>", quoted)) == std::string(shown) + "\n");
    }
    for (const auto& [id, shown] : {std::pair{"2", "123"},
                                    {"49", "123"},
                                    {"67", "123 (in a number format that may change it)"},
                                    {"171", "123 (in a number format that may change it)"}})
        CHECK(text_of(xlsx("<row><c><v>123</v></c></row>",
                           "<styleSheet><cellXfs><xf numFmtId='" + std::string(id) +
                               "'/></cellXfs></styleSheet>")) == std::string(shown) + "\n");
    CHECK(cell("<c r='A1' t='str'><f>B1*2</f></c>") == "=B1*2 (a formula, saved without its result)");
    CHECK(cell("<c r='A1' t='s'><v>0</v></c>") == "plain");
    CHECK(cell("<c r='A1' t='s'><v>1</v></c>") == "rich");
    CHECK(contains(input_error_of([&] { static_cast<void>(cell("<c r='A1' t='s'><v>7</v></c>")); }),
                   "the text of a cell is not in the file"));
    CHECK(contains(
        input_error_of([&] { static_cast<void>(cell("<c r='A1'><v>1</v></c><c r='A1'><v>2</v></c>")); }),
        "A1: the cell is in the file twice"));
    const auto runs = [&](const std::string& properties, const std::string& run) {
        return cell("<c t='inlineStr'><is><r><t>753</t></r><r><rPr>" + properties + "</rPr><t>" + run +
                    "</t></r></is></c>");
    };
    CHECK(runs("<vertAlign val='superscript'/>", "1") == "753\u00b9");
    CHECK(runs("<vertAlign val='superscript'/>", "a") == "753^a");
    CHECK(runs("<vertAlign val='subscript'/>", "a") == "753a");
    CHECK(runs("<vertAlign val='subscript'/>", "1") == "753\u2081");
    CHECK(runs("<vertAlign val='baseline'/>", "1") == "7531");
    CHECK(runs("<strike/>", "9") == "7539 (struck out)");
    CHECK(runs("<strike val='0'/>", "9") == "7539");
    CHECK(cell("<c r='A1' s='5'><v>12.5</v></c>") == "12.5 (struck out)");
    CHECK(cell("<c r='A1' t='b'><v>1</v></c>") == "TRUE");
    CHECK(cell("<c r='A1' t='e'><v>#DIV/0!</v></c>") == "#DIV/0!");
    CHECK(cell("<c r='A1' t='str'><f>A2</f><v>haftet</v></c>") == "haftet");
    CHECK(cell("<c r='A1'><f>1+2</f><v>3</v></c>") == "3");
    CHECK(cell("<c r='A1'><f>1+2</f></c>") == "=1+2 (a formula, saved without its result)");
    CHECK(cell("<c t='inlineStr'><is><t>say \"yes\"</t></is></c><c><v>1</v></c>") ==
          "\"say \"\"yes\"\"\"\t1");
    CHECK(cell("<c r='AB1'><v>5</v></c>") == std::string(27, '\t') + "5");
    CHECK(cell("<x:c xmlns:x='y' r='B1'><x:v>5</x:v></x:c>") == "\t5");
    CHECK(text_of(xlsx("<row r='3'><c><v>1</v></c></row>")) == "\n\n1\n");
    for (const auto& [formula, sums] : {std::pair{"SUM(B1:B3)", true},
                                        {"ROUND(AVERAGE(B$1:B$3),2)", true},
                                        {"_xlfn.STDEV.S(B1:B3)", true},
                                        {"STABW.N($B1:$B3)", true},
                                        {"MAX(B2:B3)", true},
                                        {"AGGREGATE(1,6,B1:B3)", true},
                                        {"TRIMMEAN(B1:B3,0.2)", true},
                                        {"-INTERCEPT(C1:C3,D1:D3)/SLOPE(C1:C3,D1:D3)", true},
                                        {"FORECAST(0,C1:C3,D1:D3)", true},
                                        {"AVERAGE(B5:B9)", true},
                                        {"SLOPE(C4:C9,D4:D9)", false},
                                        {"AVERAGE(C4:E4)", false},
                                        {"SUM(C1:C3)", false},
                                        {"MAX(B4:B9)", false},
                                        {"B1+B2", false}}) {
        CAPTURE(formula);
        const std::string cell_of = "<c r='B4'><f>" + std::string(formula) + "</f><v>3</v></c>";
        const auto sheet = read_workbook(xlsx("<row r='4'>" + cell_of + "</row>")).front();
        CHECK(sheet.summaries().contains(4) == sums);
    }
    CHECK(read_workbook(ods("<table:table-row/><table:table-row/><table:table-row><table:table-cell "
                            "table:formula='of:=SUM([.A1:.A2])' office:value-type='float' office:value='3'/>"
                            "</table:table-row>"))
              .front()
              .summaries()
              .contains(3));
    CHECK(cell_name(6, 1) == "B7");
    CHECK(cell_name(0, 26) == "AA1");
    CHECK(cell_name(0, 701) == "ZZ1");
    CHECK(cell_name(0, 702) == "AAA1");
}

TEST_CASE("cells of .ods hold what the spreadsheet shows") {
    const auto row = [](const std::string& cells) {
        return text_of(ods("<table:table-row>" + cells + "</table:table-row>"));
    };
    CHECK(row("<table:table-cell office:value-type='float' "
              "office:value='0.1'><text:p>0,10</text:p></table:table-cell>") == "0.1\n");
    CHECK(row("<table:table-cell office:value-type='percentage' office:value='0.213'/>") == "21.3 %\n");
    for (const auto& [shown, text] : {std::pair{"3,20 g/kg", "3.2 g/kg"},
                                      {"&lt;3,2", "<3.2"},
                                      {"n.d.", "n.d."},
                                      {"###", "3.2"},
                                      {"", "3.2 (hidden by its number format)"},
                                      {"3,2*", "3.2 *"},
                                      {"3,2 \u00b1 0,4", "3,2 \u00b1 0,4"},
                                      {"(3,2)", "(3.2"},  // no number: a negative one in accounts
                                      {"3,2E+00", "3.2"}})
        CHECK(row(std::string("<table:table-cell office:value-type='float' office:value='3.2'><text:p>") +
                  shown + "</text:p></table:table-cell>") == std::string(text) + "\n");
    for (const auto& [value, shown, text] : {std::tuple{"123", "12.3", "123 (shown as 12.3)"},
                                             {"1234.46", "1.234,5", "1234.46"},
                                             {"1234.46", "1 234.5", "1234.46"},
                                             {"1234567", "12,34,567", "1234567"},
                                             {"1234", "1,234", "1234"},
                                             {"1234", "1,23", "1234 (shown as 1,23)"}})
        CHECK(row(std::string("<table:table-cell office:value-type='float' office:value='") + value +
                  "'><text:p>" + shown + "</text:p></table:table-cell>") == std::string(text) + "\n");
    CHECK(row("<table:table-cell office:value-type='percentage' office:value='0.213'><text:p>21,3 %</text:p>"
              "</table:table-cell>") == "21.3 %\n");
    CHECK(row("<table:table-cell office:value-type='date' office:date-value='2026-03-01T00:00:00'/>") ==
          "2026-03-01 (a date)\n");
    CHECK(row("<table:table-cell table:formula='of:=[.A1]'/>") ==
          "=[.A1] (a formula, saved without its result)\n");
    CHECK(row("<table:table-cell "
              "office:value-type='string'><office:annotation><text:p>note</text:p></office:annotation>"
              "<text:p>v<text:span>_in</text:span><text:s/>[m/s]</text:p></table:table-cell>") ==
          "v_in [m/s]\n# comment on A1: note\n");
    for (const auto& [position, text] : {std::pair{"super 58%", "753\u00b9"},
                                         {"33% 58%", "753\u00b9"},
                                         {"sub 58%", "753\u2081"},
                                         {"-33% 58%", "753\u2081"},
                                         {"0% 100%", "7531"}})
        CHECK(text_of(ods("<table:table-row><table:table-cell><text:p>753<text:span text:style-name='T'>1"
                          "</text:span></text:p></table:table-cell></table:table-row>",
                          "<style:style style:name='T' style:family='text'><style:text-properties "
                          "style:text-position='" +
                              std::string(position) + "'/></style:style>")) == std::string(text) + "\n");
    const auto named = [](const std::string& name, const std::string& rest) {
        return "<style:style style:family='table-cell' style:name='" + name + "'" + rest + "</style:style>";
    };
    const std::string line = "><style:text-properties style:text-line-through-style='solid'/>";
    const std::string common =
        named("Heir", " style:parent-style-name='Out'>") + named("Out", line) +
        named("Back",
              " style:parent-style-name='Out'><style:text-properties "
              "style:text-line-through-style='none'/>") +
        named("Ring", " style:parent-style-name='Ring'>") + named("Default", ">") +
        named("Kilo", " style:data-style-name='N'>") +
        "<number:number-style style:name='N'><number:number number:display-factor='1000'/>"
        "</number:number-style>"
        "<style:style style:family='graphic' style:name='Default'" +
        line + "</style:style>";
    const std::string automatic = named("ce1", " style:parent-style-name='Heir'>") + named("ce2", line);
    const std::string out = "5 (struck out)";
    for (const auto& [columns, of_row, of_cell, text] :
         {std::tuple<std::string, std::string, std::string, std::string>{"", "", "Out", out},
          {"", "", "Heir", out},
          {"", "", "ce1", out},
          {"", "", "ce2", out},
          {"", "", "Back", "5"},
          {"", "", "Ring", "5"},
          {"", "", "Default", "5"},
          {"", "", "Kilo", "5 (shown as 0.005 by its number format)"},
          {"", "Out", "", out},
          {"", "Out", "Default", "5"},
          {"Out", "", "", out},
          {"Out", "Default", "", "5"},
          {"Out", "", "Default", "5"},
          {"Default", "", "", "5"}}) {
        const std::string stated = "column " + columns + ", row " + of_row + ", cell " + of_cell;
        CAPTURE(stated);
        const auto stating = [](const std::string& attribute, const std::string& style) {
            return style.empty() ? "" : " table:" + attribute + "='" + style + "'";
        };
        CHECK(text_of(ods("<table:table-column" + stating("default-cell-style-name", columns) +
                              "/><table:table-row" + stating("default-cell-style-name", of_row) +
                              "><table:table-cell" + stating("style-name", of_cell) +
                              " office:value-type='float' office:value='5'/></table:table-row>",
                          automatic, common)) == text + "\n");
    }
    // A repeated cell may cover columns whose styles differ.
    CHECK(text_of(ods("<table:table-column table:number-columns-repeated='2'/><table:table-column "
                      "table:default-cell-style-name='Out'/><table:table-column/><table:table-row>"
                      "<table:table-cell table:number-columns-repeated='4' office:value-type='float' "
                      "office:value='5'/></table:table-row>",
                      automatic, common)) == "5\t5\t" + out + "\t5\n");
    CHECK(row("<table:table-cell table:number-columns-repeated='2'/><table:table-cell "
              "office:value-type='float' "
              "office:value='1' table:number-columns-repeated='2'/>") == "\t\t1\t1\n");
    CHECK(
        text_of(ods(
            "<table:table-header-rows><table:table-row><table:table-cell><text:p>a</text:p></"
            "table:table-cell>"
            "</table:table-row></table:table-header-rows><table:table-row table:number-rows-repeated='3'>"
            "<table:table-cell><text:p>b</text:p></table:table-cell></table:table-row>"
            "<table:table-row table:number-rows-repeated='1048570'><table:table-cell/></table:table-row>")) ==
        "a\nb\nb\nb\n");
}

TEST_CASE("rows of .ods count however deep they are grouped, and times are no numbers") {
    const auto row = [](const std::string& cell) {
        return "<table:table-row>" + cell + "</table:table-row>";
    };
    const std::string one = row("<table:table-cell office:value-type='time' office:time-value='PT1H30M'/>");
    CHECK(text_of(ods(one)) == "PT1H30M (a time)\n");
    const auto grouped = [&](std::size_t depth) {
        std::string rows = one;
        for (std::size_t i = 0; i < depth; ++i)
            rows = "<table:table-row-group>" + rows + "</table:table-row-group>";
        return ods(rows);
    };
    CHECK(text_of(grouped(7)) == "PT1H30M (a time)\n");
    CHECK(contains(input_error_of([&] { text_of(grouped(100)); }), "rows are grouped too deeply"));
}

TEST_CASE("a value under a merged cell is refused, as no spreadsheet shows it") {
    const std::string table =
        inline_row({"Phase", "wt%"}) + inline_row({"Quartz", "40"}) + inline_row({"Mullite", "60"});
    const auto merged = [&](const std::string& range) {
        return xlsx(table + "</sheetData><mergeCells><mergeCell ref='" + range +
                    "'/></mergeCells><sheetData>");
    };
    CHECK(contains(input_error_of([&] { static_cast<void>(read_xrd(merged("B2:B3"), "a.xlsx")); }),
                   "sheet \"S\", cell B3: the cell has a value that a merged cell hides"));
    CHECK(read_xrd(merged("B3:C9"), "a.xlsx").samples.front().analysis.phases.size() == 2);
    const auto cell = [](const std::string& name, const std::string& text) {
        return "<table:" + name + "><text:p>" + text + "</text:p></table:" + name + ">";
    };
    const auto rows = [&](const std::string& hidden) {
        return ods("<table:table-row>" + cell("table-cell", "Phase") + cell("table-cell", "wt%") +
                   "</table:table-row><table:table-row>" + cell("table-cell", "Quartz") +
                   cell("table-cell", "100") + cell("covered-table-cell", hidden) + "</table:table-row>");
    };
    CHECK(contains(input_error_of([&] { static_cast<void>(read_xrd(rows("5"), "a.ods")); }),
                   "sheet \"S\", cell C2: the cell has a value that a merged cell hides"));
    CHECK(read_xrd(rows(""), "a.ods").samples.size() == 1);
}

TEST_CASE("a comment on a cell is said, and what it states counts as of a text beside the table") {
    const std::string table =
        inline_row({"Phase", "wt%"}) + inline_row({"Quartz", "40"}) + inline_row({"Mullite", "60"});
    const auto with = [&](const std::string& text) {
        return xlsx(table, "", "",
                    "<comment ref='B2'><text><r><t>NN:\n</t></r><r><t>" + text + "</t></r></text></comment>");
    };
    const XrdResult read = read_xrd(with("seen &quot;twice&quot;"), "a.xlsx");
    CHECK(read.samples.front().analysis.phases.size() == 2);
    CHECK(std::ranges::any_of(read.warnings, [](const Finding& each) {
        return each.text == "the comment on B2, \"NN: seen  twice\", is no part of the table";
    }));
    CHECK(contains(input_error_of([&] { static_cast<void>(read_xrd(with("by volume"), "a.xlsx")); }),
                   "sheet \"S\", comments: \"comment on B2: NN: by volume\" states fractions by volume"));
    const auto cell = [](const std::string& text, const std::string& comment = "") {
        return "<table:table-cell><office:annotation><text:p>" + comment +
               "</text:p></office:annotation>"
               "<text:p>" +
               text + "</text:p></table:table-cell>";
    };
    const std::string annotated =
        ods("<table:table-row>" + cell("Phase") + cell("%", "by volume") +
            "</table:table-row><table:table-row>" + cell("Quartz") + cell("100") + "</table:table-row>");
    CHECK(contains(input_error_of([&] { static_cast<void>(read_xrd(annotated, "a.ods")); }),
                   "\"comment on B1: by volume\" states fractions by volume"));
}

TEST_CASE("text boxes, and headers and footers of pages, count as comments") {
    const std::string table = inline_row({"Phase", "%"}) + inline_row({"Quartz", "100"});
    const auto boxed = [&](const std::string& text) {
        return xlsx(table, "", "", "",
                    "<xdr:wsDr><xdr:sp><xdr:txBody><a:p><a:r><a:t>All</a:t></a:r></a:p><a:p><a:r><a:t>" +
                        text + "</a:t></a:r></a:p></xdr:txBody></xdr:sp></xdr:wsDr>");
    };
    const auto paged = [&](const std::string& text) {
        return xlsx(table + "</sheetData><headerFooter><oddHeader>" + text +
                    "</oddHeader></headerFooter><sheetData>");
    };
    const std::string cells =
        "<table:table-row><table:table-cell><text:p>Phase</text:p></table:table-cell><table:table-cell>"
        "<text:p>%</text:p></table:table-cell></table:table-row><table:table-row><table:table-cell>"
        "<text:p>Quartz</text:p></table:table-cell><table:table-cell><text:p>100</text:p>"
        "</table:table-cell></table:table-row>";
    const auto in_ods = [&](const std::string& shapes, const std::string& page) {
        return ods(cells + "<table:shapes>" + shapes + "</table:shapes>", "",
                   "</office:styles><office:master-styles><style:master-page><style:header>" + page +
                       "</style:header></style:master-page></office:master-styles><office:styles>");
    };
    const std::string box =
        "<draw:frame><draw:text-box><text:p>by volume</text:p></draw:text-box></draw:frame>";
    const std::string drawn = "<draw:custom-shape><text:p>by volume</text:p></draw:custom-shape>";
    for (const auto& [bytes, place] :
         {std::pair{boxed("by volume"), "a text box: All by volume"},
          {paged("&amp;C&amp;&quot;Arial,Bold&quot;&amp;12by volume"), "the page: by volume"},
          {in_ods(box, ""), "a text box: by volume"},
          {in_ods(drawn, ""), "a text box: by volume"},
          {in_ods("", "<text:p>by volume</text:p>"), "the page: by volume"}})
        CHECK(contains(input_error_of([&, &file = bytes] { static_cast<void>(read_xrd(file, "a")); }),
                       "\"comment on " + std::string(place) + "\" states fractions by volume"));
    const auto said = [](const std::string& bytes) {
        return joined(texts_of(read_xrd(bytes, "a").warnings));
    };
    CHECK(contains(said(boxed("of June")), "the comment on a text box, \"All of June\", is no part"));
    for (const std::string& bytes :
         {paged("&amp;CPage &amp;P of &amp;N"), paged("&amp;L&amp;A"),
          in_ods("", "<text:p>Page <text:page-number>1</text:page-number></text:p>"),
          in_ods("", "<text:p><text:sheet-name>S</text:sheet-name> ()</text:p>")})
        CHECK_FALSE(contains(said(bytes), "comment"));
}

TEST_CASE("what the name of a sheet states counts: a basis, a standard") {
    const std::string table =
        inline_row({"Phase", "%"}) + inline_row({"Quartz", "90"}) + inline_row({"Corundum", "10"});
    const auto named = [&](const std::string& sheet) {
        return read_xrd(xlsx(table, "", "", "", "", sheet), "a.xlsx").samples.front().analysis.phases;
    };
    for (const char* sheet : {"Volume", "Volumen", "Vol.-%"})
        CHECK(contains(input_error_of([&] { return named(sheet).size(); }), "states fractions by volume"));
    for (const char* sheet : {"mit Korund", "with 10% corundum", "internal standard", "spiked"})
        CHECK_MESSAGE(named(sheet).back().is_standard, sheet);
    for (const char* sheet : {"S", "Number 5", "Corundum", "Mass"})
        CHECK_MESSAGE(!named(sheet).back().is_standard, sheet);
}

TEST_CASE("comments of a table are said, unless they are its heading") {
    const auto told = [](const std::string& text) {
        return joined(texts_of(read_xrd(text, "a.csv").warnings));
    };
    CHECK(contains(told("# unit: see below\nphase,wt%\nQuartz,60\n#\n# line 3 is new\nGlass,40\n"),
                   "line 1, a comment, is no part of the table: \"unit: see below\", \"line 3 is new\""));
    CHECK_FALSE(contains(told("# phase,wt%\nQuartz,60\nGlass,40\n"), "comment"));
    CHECK_FALSE(contains(told("# without amorphous\nphase,wt%\nQuartz,60\nMullite,40\n"), "a comment,"));
}

TEST_CASE("a fraction stays below a thousand, so that its comma has one reading") {
    const auto first = [](const std::string& text) {
        return read_xrd(text, "a.csv").samples.front().analysis.phases.front().fraction;
    };
    CHECK(first("phase;wt%\nQuartz;12,500\nGlass;87,500\n") == doctest::Approx(0.125));
    CHECK(first("phase,wt%\nQuartz,\"12,500\"\nGlass,\"87,500\"\n") == doctest::Approx(0.125));
    CHECK(contains(input_error_of([&] { return first("phase;ppm\nQuartz;12,500\nGlass;987,500\n"); }),
                   "is 12.500 or 12500"));
}

TEST_CASE("a coverage beside the table, not in its headings, is refused") {
    const auto xrd = [](const std::string& before, const std::string& after) {
        return input_error_of(
            [&] { return read_xrd(before + "phase,wt%,esd\nQuartz,60,2\nGlass,40,1\n" + after, "a.csv"); });
    };
    CHECK(contains(xrd("# errors are 2 sigma\n", ""),
                   "line 1: \"errors are 2 sigma\" states \"2 sigma\", and the column \"esd\" does not; "
                   "allowed: the coverage in the heading, \"esd (2 sigma)\""));
    CHECK(contains(xrd("Fly ash, errors k=2\n", ""), "line 1: \"Fly ash, errors k=2\" states \"k=2\""));
    CHECK(contains(xrd("", "\nall errors: 2 sigma\n"), "line 5: \"all errors: 2 sigma\" states"));
    for (const char* text : {"# 3 esd\n", "# uncertainty = 3 esd\n", "errors are 3 e.s.d.\n"})
        CHECK(contains(xrd(text, ""), "states \"3 e"));
    for (const char* text :
         {"# Fehler: 2-fache Standardabweichung\n", "uncertainty = 2 \u00d7 SD\n",
          "error bars: two standard deviations\n", "esd x 3 (B\u00e9rar)\n", "Vertrauensbereich 95 %\n",
          "rel. Fehler in %\n", "coverage factor 2\n", "\u00b1 = 2 s\n", "esds multiplied by 2.5\n",
          "erreurs relatives\n", "relative standard deviations in %\n"})
        CHECK(contains(xrd(text, ""), "and the column \"esd\" does not"));
    CHECK(xrd("# Fly ash 2, sieved 2 s, 95 % below 45 um\n", "").empty());
    CHECK(xrd("# errors are 1 sigma\n", "").empty());
    CHECK(contains(xrd("# volume based composition\n", ""), "states fractions by volume"));
    CHECK(xrd("# relative humidity 45 %, standard procedure, coverage of the beam 2 mm\n", "").empty());
    const auto error = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_xrd(text, "a.csv")); });
    };
    for (const char* corner : {"Phase (2\u03c3)", "Phase (\u00b1 2\u03c3)", "# k=2\nPhase", "2 sigma\nPhase"})
        for (const char* cells :
             {";FA1;FA2\nQuartz;60 \u00b1 2;1\nGlass;40;99\n", ";wt%\nQuartz;60(2)\nGlass;40(1)\n"}) {
            CAPTURE(corner);
            CHECK(contains(error(std::string(corner) + cells),
                           "does not; allowed: the coverage in the heading"));
        }
    const auto told = [](const std::string& text) {
        return joined(texts_of(read_xrd(text, "a.csv").warnings));
    };
    CHECK_FALSE(contains(told("Phase;Density (k=2) [g/cm3];wt%\nQuartz;2.65;60\nGlass;2.5;40\n"), "divided"));
    CHECK(contains(told("Phase;FA1 [wt%] (k=2)\nQuartz;60\nGlass;40\n"), "holds no uncertainties"));
    for (const char* heading : {"Gew.-% \u00b1 3 esd", "FA1 (wt%, k=3)", "FA1 [wt% \u00b1 3\u03c3]"})
        CHECK(contains(told("Phase;" + std::string(heading) + "\nQuartz;60 \u00b1 2\nGlass;40 \u00b1 1\n"),
                       "divided by 3"));
    const XrdResult below =
        read_xrd("Phase;FA1;;FA2;\n;wt%;2\u03c3;wt%;2\u03c3\nQuartz;60;2;20;2\nGlass;40;1;80;1\n", "a.csv");
    REQUIRE(below.samples.size() == 2);
    CHECK(*below.samples[1].analysis.phases[0].standard_uncertainty == doctest::Approx(0.01));
}

TEST_CASE("what fractions are by counts wherever it stands, or the table is refused") {
    const auto error = [](const std::string& text) {
        return input_error_of([&] { static_cast<void>(read_xrd(text, "a.csv")); });
    };
    const std::string rows = "\nQuartz;20;20\nGlass;80;80\n";
    for (const char* group : {"Vol.-%", "Volume fraction", "Volumenanteil [%]"}) {
        CAPTURE(group);
        const XrdResult result = read_xrd("Phase;" + std::string(group) + ";\n;FA1;FA2" + rows, "a.csv");
        REQUIRE(result.samples.size() == 2);
        CHECK(result.samples.front().analysis.basis == FractionBasis::volume);
    }
    CHECK(read_xrd("Phase;Fly ash;\n;FA1;FA2" + rows, "a.csv").samples.front().analysis.basis ==
          FractionBasis::weight);
    for (const char* heading : {"Modal abundance (%)", "modal %", "FA1 pixels %", "Modalbestand"})
        CHECK(contains(error("Phase;" + std::string(heading) + "\nQuartz;20\nGlass;80\n"),
                       "may hold fractions by volume, as modes and areas are, or by weight"));
    CHECK(error("Phase;modal vol%\nQuartz;20\nGlass;80\n").empty());
    CHECK(read_xrd("Phase;content;unit\nQuartz;20;vol%\nGlass;80;vol%\n", "a.csv")
              .samples.front()
              .analysis.basis == FractionBasis::volume);
    for (const char* table :
         {"Phase;wt%;;\nQuartz;20;;amounts are volume %\nGlass;80;;\n",
          "Phase;%;remark\nQuartz;20;vol%\nGlass;80;vol%\n", "Phase;wt%\nQuartz (vol%);20\nGlass;80\n"})
        CHECK(contains(error(table), "line 2: \""));
    for (const char* group : {"mol%", "Molenbruch", "Fl\u00e4chen-%", "intensit\u00e9 [%]"})
        CHECK_FALSE(error("Phase;" + std::string(group) + ";\n;FA1;FA2" + rows).empty());
    for (const char* heading :
         {"Molenbruch [%]", "fraction molaire [%]", "\u6469\u5c14%", "plocha [%]", "molfractie [%]",
          "Volumen FA1 [%]", "objem [%]", "frakcja molowa [%]", "mol oran\u0131 [%]", "conteggi [%]"})
        CHECK(contains(error("Phase;" + std::string(heading) + "\nQuartz;20\nGlass;80\n"),
                       "no weight or volume fractions"));
    for (const char* text : {"Volume fractions in vol%", "Angaben in Vol.-%", "(Werte in Vol.-%)",
                             "Mole fractions", "in mole percent", "Volumenanteile", "amounts by volume",
                             "area %", "v/v", "by vol.", "en volumen", "modal composition"})
        for (const std::string& heading : {std::string("Phase;%"), std::string("Phase;Gew.-%")}) {
            CAPTURE(text);
            const std::string table = heading + "\nQuartz;20\nGlass;80\n";
            for (const std::string& whole :
                 {text + ("\n" + table), "# " + (text + ("\n" + table)), table + "\n" + text + "\n"})
                CHECK(contains(error(whole), " states fractions by "));
        }
    for (const char* text :
         {"Fuel Vol. 45 (2016)", "# 1 mol HCl, Vol. 12 ml", "Sample number 5", "not in vol%",
          "# surface area 2 m2/g", "analysis by atomic absorption", "# weight fractions, from vol%"})
        CHECK_MESSAGE(error(text + std::string("\nPhase;wt%\nQuartz;20\nGlass;80\n")).empty(), text);
    CHECK(read_xrd("Phase;Surface;Core\nQuartz;20;30\nGlass;80;70\n", "a.csv").samples.size() == 2);
    CHECK(read_xrd("Vol.-%\nPhase;Vol.-%\nQuartz;20\nGlass;80\n", "a.csv").samples.size() == 1);
    CHECK(read_xrd("Phase,kg/t\nQuartz,205\nGlass,795\n", "a.csv").samples[0].analysis.phases[0].fraction ==
          doctest::Approx(0.205));
    CHECK(contains(error("Phase,wt%\nQuartz,20\nMullite,80\nAmorphous content,40\n"),
                   "add up to 100 % without \"Amorphous content\", and to 140 % with it"));
}

TEST_CASE("marks in numbers have one reading, by the other numbers of the table, or are refused") {
    struct Case {
        std::vector<std::vector<std::string>> rows;
        std::vector<std::vector<double>> values;  ///< not a number: refused
    };
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Case> cases{
        {{{"1.234", "0.912"}, {"2.345", "1.5"}}, {{1.234, 0.912}, {2.345, 1.5}}},
        {{{"1,234", "0,912"}, {"2,345", "7"}}, {{1.234, 0.912}, {2.345, 7}}},
        {{{"1,234", "5"}, {"2,345", "7"}}, {{none, 5}, {none, 7}}},
        {{{"1.234"}, {"2.345"}}, {{1.234}, {2.345}}},
        {{{"1.234", "5,5"}, {"2.345", "7,25"}}, {{1234, 5.5}, {2345, 7.25}}},
        {{{"1.234", "5,5"}, {"12,5", "7,25"}}, {{none, 5.5}, {12.5, 7.25}}},
        {{{"1,234", "5.5"}, {"12.5", "7.25"}}, {{none, 5.5}, {12.5, 7.25}}},
        {{{"1.234.567", "1,234"}}, {{1234567, 1.234}}},
        {{{"1.234,5"},
          {"1'234,5"},
          {"1\u2019234,5"},
          {"1 234,5"},
          {"1\u00a0234,5"},
          {"12\u202f345\u202f678"},
          {"12,34,567.8"}},
         {{1234.5}, {1234.5}, {1234.5}, {1234.5}, {1234.5}, {12345678}, {1234567.8}}},
        {{{"0.123"}, {"-0.123"}, {"1.2345"}, {"1.234e3"}}, {{0.123}, {-0.123}, {1.2345}, {1234}}},
    };
    for (const Case& c : cases) {
        NumberMarks marks;
        for (const auto& row : c.rows)
            for (std::size_t k = 0; k < row.size(); ++k) marks.see(row[k], k);
        for (std::size_t i = 0; i < c.rows.size(); ++i)
            for (std::size_t k = 0; k < c.rows[i].size(); ++k) {
                CAPTURE(c.rows[i][k]);
                if (std::isnan(c.values[i][k])) {
                    CHECK_THROWS_AS(static_cast<void>(marks.read(c.rows[i][k], k)), InputError);
                } else {
                    const auto number = marks.read(c.rows[i][k], k);
                    REQUIRE(number);
                    CHECK(number->value == c.values[i][k]);
                }
            }
    }
    // Where thousands are possible, "1.753" alone, or beside whole numbers, has two readings.
    const auto of_counts = [](const std::vector<std::string>& column, const std::string& other) {
        NumberMarks counts;
        counts.may_hold_thousands(0);
        for (const std::string& cell : column) counts.see(cell, 0);
        counts.see(other, 1);
        return input_error_of([&] { static_cast<void>(counts.read(column.front(), 0)); });
    };
    CHECK(contains(of_counts({"1.753", "540", "45"}, "7"), "\"1.753\" is 1.753 or 1753"));
    CHECK(contains(of_counts({"1.753", "540", "45"}, "3.4"), "\"1.753\" is 1.753 or 1753"));
    CHECK(contains(of_counts({"1.753", "2.540"}, "7"), "\"1.753\" is 1.753 or 1753"));
    CHECK(of_counts({"1.753", "0.540"}, "7").empty());
    CHECK(of_counts({"1.753", "0"}, "3.4").empty());
    CHECK(of_counts({"1.753", "540", "45.5"}, "7").empty());
    // A remark names the first number whose reading follows from other columns.
    NumberMarks beside_decimals;
    for (const char* cell : {"1,050", "1,110"}) beside_decimals.see(cell, 0);
    beside_decimals.see("0.05", 1);
    CHECK(beside_decimals.read("0.05", 1)->value == 0.05);
    CHECK(beside_decimals.findings("x").empty());
    CHECK(beside_decimals.read("1,050", 0)->value == 1050);
    REQUIRE(beside_decimals.findings("x").size() == 1);
    CHECK(contains(beside_decimals.findings("x").front().text, "\"1,050\" is read as 1050"));
    CHECK(NumberMarks().read("12.3 (\u00b10.4)", 0)->standard_uncertainty == 0.4);
    CHECK(NumberMarks().read("12.3 (\u00b1 0.4)", 0)->value == 12.3);
    CHECK_FALSE(NumberMarks().read("12.3 (\u00b1)", 0));
    for (const char* text : {"12.3 (\u00b1 3 %)", "12.3 (\u00b13%)", "12.3 % (\u00b1 3 %)"})
        CHECK_THROWS_AS((void)NumberMarks().read(text, 0), InputError);
    NumberMarks of_sheet({}, true);
    of_sheet.may_hold_thousands(0);
    for (const char* stored : {"1.25", "1530.7", "1.253"}) of_sheet.see(stored, 0);
    CHECK(of_sheet.read("1.253", 0)->value == 1.253);
    CHECK_THROWS_AS(static_cast<void>(of_sheet.read("1.050", 0)), InputError);  // a text
    const NumberMarks by_comma(DecimalMark::comma);                             // as --decimal states
    CHECK(by_comma.read("1,234", 0)->value == 1.234);
    CHECK(by_comma.read("1.234", 0)->value == 1234);
    CHECK(by_comma.read("1.234,5", 0)->value == 1234.5);
    CHECK(contains(input_error_of([&] { static_cast<void>(by_comma.read("12.5", 0)); }),
                   "\"12.5\" has no decimal comma, which is stated for the table"));
    CHECK_THROWS_AS(static_cast<void>(NumberMarks(DecimalMark::point).read("12,5", 0)), InputError);
    CHECK(NumberMarks(DecimalMark::comma, true).read("12.5", 0)->value == 12.5);  // a cell of a spreadsheet
    const NumberMarks marks;
    CHECK(marks.read("12,3 \u00b1 0,4", 0)->standard_uncertainty == 0.4);
    CHECK(marks.read("(12.3 \u00b1 0.4) %", 0)->standard_uncertainty == 0.4);
    CHECK(marks.read("0 % \u00b1 0.4 %", 0)->standard_uncertainty == 0.4);
    CHECK(contains(input_error_of([&] { static_cast<void>(marks.read("20 % \u00b1 5 %", 0)); }),
                   "the uncertainty is 5 % of the whole, or of the value, 1 % of the whole; allowed: \"(20 "
                   "\u00b1 5) %\" or \"(20 \u00b1 1) %\""));
    CHECK(contains(input_error_of([&] { static_cast<void>(marks.read("12.3 \u00b1 3%", 0)); }),
                   "the uncertainty is 3 % of 12.3, or 3 in the unit of the value"));
    for (const char* junk : {"1.2.3", "1,2,3.4", "12.3 456", "2024 123", "1,23,4.5"}) {
        CAPTURE(junk);
        CHECK_FALSE(marks.read(junk, 0));
    }
    CHECK(contains(input_error_of([&] { static_cast<void>(marks.read("1,234", 0)); }),
                   "\"1,234\" is 1.234 or 1234"));
    NumberMarks brackets;
    CHECK(brackets.read("12.3 (1)", 0)->standard_uncertainty == 0.1);
    brackets.see("30.1 (1.2)", 1);
    CHECK(brackets.read("30.1 (1.2)", 1)->standard_uncertainty == 1.2);
    CHECK(brackets.read("12 (1)", 1)->standard_uncertainty == 1);
    CHECK(contains(input_error_of([&] { static_cast<void>(brackets.read("12.3 (1)", 0)); }),
                   "\"12.3 (1)\" has an uncertainty of 1 last places, or of 1 as other brackets"));
}

TEST_CASE("a second heading line holds units, and lines of one text behind a blank one are notes") {
    TableRow heading{.line = 1, .cells = {"Nr.", "v_in", "v_r"}};
    const auto unit = [](std::string_view text) { return text == "m/s" || text == "1"; };
    for (const auto& cells : std::vector<std::vector<std::string>>{{"1", "m/s", "m/s"},
                                                                   {"", "", "-"},
                                                                   {"", "m/s", "kg"},
                                                                   {"", "1", "m/s"},
                                                                   {"", "m/s", "m/s", "m/s"}})
        CHECK_FALSE(take_units(heading, {.line = 2, .cells = cells}, unit));
    CHECK(take_units(heading, {.line = 2, .cells = {"-", "(m/s)", "m/s"}}, unit));
    CHECK(heading.cells == std::vector<std::string>{"Nr.", "v_in [m/s]", "v_r [m/s]"});
    CHECK_FALSE(take_units(heading, {.line = 3, .cells = {"", "m/s"}}, unit));
    const TextLines file("a;b\n1;\nx;\n\n* lost;\n\nQuelle: NN\n", {});
    auto lines = lines_with_content(file);
    const auto notes = take_notes(lines, 1, ';', "code");
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].text == "line 5 below the table is not read: \"* lost;\"");
    CHECK(lines.size() == 3);
}

TEST_CASE("Unicode text as Excel saves it, and a quoted cell over two lines") {
    for (const bool little : {true, false}) {
        std::string bytes = little ? "\xff\xfe" : "\xfe\xff";
        for (const unsigned unit : {0x70U, 0xd8U, 0x20acU, 0xd83dU, 0xde00U, 0x0aU}) {
            const std::array both{static_cast<char>(unit >> 8U), static_cast<char>(unit & 0xffU)};
            bytes += little ? std::string{both[1], both[0]} : std::string{both[0], both[1]};
        }
        CHECK(TextLines(bytes, {}).text() == "p\u00d8\u20ac\U0001f600\n");
    }
    const TextLines file("a;\"v_in\r\n[m/s]\"\r\n5\" pipe;1\n6\" pipe;2\n", {});
    REQUIRE(file.lines().size() == 3);
    CHECK(cut_row(file.lines()[0], ';').cells.back() == "v_in  [m/s]");
    CHECK(file.lines()[1].number == 3);
    CHECK(file.lines()[2].text == "6\" pipe;2");
}

TEST_CASE("what is wrong in a spreadsheet is said with its sheet and cell") {
    const auto refused = [](const std::string& rows) {
        return input_error_of([&] { return read_xrd(xlsx(rows), "a.xlsx"); });
    };
    const std::string head = inline_row({"phase", "weight [%]"});
    CHECK(contains(refused(head + inline_row({"Quartz", "much"})),
                   "a.xlsx: sheet \"S\", cell B2: cannot read \"much\""));
    CHECK(contains(refused(head + inline_row({"Quartz", "60"}) + "<row/>" + inline_row({"Quartz", "20"})),
                   "sheet \"S\", row 4: the phase \"Quartz\" is there twice in the sample, first in row 2"));
    CHECK(contains(
        refused("<row/>" + head + "<row><c t='inlineStr'><is><t>Quartz</t></is></c><c><f>B1</f></c></row>"),
        "cell B3: cannot read \"=B1 (a formula, saved without its result)\""));
    CHECK(contains(refused(inline_row({"nothing"})), "no sheet holds an XRD result with its headings") ==
          false);
    CHECK(contains(refused(inline_row({"nothing"})), "sheet \"S\", row 1: no heading line was found"));
    CHECK(contains(refused(""), "every sheet is empty"));
}

TEST_CASE("of several sheets the one with a table is read, or the one that is named") {
    const std::string two = data("opendocument.ods");
    CHECK(read_xrd(two, "a.ods").samples[0].analysis.phases.size() == 4);
    CHECK(read_xrd(two, "a.ods", {.sheet = "Phasen"}).samples[0].analysis.phases.size() == 4);
    CHECK(contains(input_error_of([&] { return read_xrd(two, "a.ods", {.sheet = "Phase"}); }),
                   "there is no sheet \"Phase\"; allowed: \"Phasen\", \"St\u00f6\u00dfe\""));
    CHECK(contains(
        input_error_of([&] { return read_xrd("phase,weight\nQuartz,1\n", "a.csv", {.sheet = "S"}); }),
        "a sheet is named, and the file is no spreadsheet"));
    const std::string table =
        "<table:table-row><table:table-cell><text:p>phase</text:p></table:table-cell>"
        "<table:table-cell><text:p>weight</text:p></table:table-cell></table:table-row>";
    const std::string quartz = table +
                               "<table:table-row><table:table-cell><text:p>Quartz</text:p></table:table-cell>"
                               "<table:table-cell><text:p>100</text:p></table:table-cell></table:table-row>";
    const std::string other =
        "<table:table-row><table:table-cell><text:p>old</text:p></table:table-cell>"
        "</table:table-row>";
    const XrdResult beside = read_xrd(
        ods(quartz + "</table:table><table:table table:name='T' table:style-name='H'>" + other,
            "<style:style xmlns:style='s' style:name='H' style:family='table'><style:table-properties "
            "table:display='false'/></style:style>"),
        "a.ods");
    CHECK(beside.warnings.front().text == "the sheet \"S\" is read, not \"T\" (hidden)");
    CHECK(beside.warnings.front().severity == Severity::remark);
    CHECK(contains(
        input_error_of([&] {
            return read_xrd(ods(table + "</table:table><table:table table:name='T'>" + table), "a.ods");
        }),
        "2 sheets hold a table; allowed: the name of a sheet (--sheet, in a case \"xrd_sheet\") and one of "
        "\"S\", \"T\""));
}

TEST_CASE("files that are no spreadsheet, or a damaged or huge one, are refused") {
    const auto refused = [](const std::string& bytes) {
        return input_error_of([&] { return read_xrd(bytes, "a.xlsx"); });
    };
    CHECK(contains(refused("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and so on"),
                   "old Excel file (.xls), or one with a password"));
    CHECK(contains(refused(archive_of({{"letter.txt", "Dear"}})), "a zip archive and no spreadsheet"));
    CHECK(contains(refused("PK\x03\x04 and no more"), "begins as a spreadsheet and is damaged"));
    CHECK(contains(refused(xlsx("<row><c></row>")),
                   "the part xl/worksheets/s.xml of the spreadsheet is damaged"));
    CHECK(contains(refused(xlsx(std::string(20U << 20U, ' '))), "unpacks to more than 8 MB"));
    CHECK(contains(refused(xlsx("<row r='1'><c r='XFD1'><v>1</v></c></row>")),
                   "has a text in row 1, column 16384"));
    // Some kilobytes that unpack to gigabytes: many parts, a long text that is repeated, and one that is
    // nested.
    const std::string eight(8U << 20U, ' ');
    Parts parts{{"_rels/.rels", "<Relationships><Relationship Id='r' Type='" + office +
                                    "officeDocument' Target='w.xml'/></Relationships>"}};
    std::string sheets;
    std::string targets;
    for (const std::string name : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
        sheets += "<sheet name='" + name + "' id='" + name + "'/>";
        targets += "<Relationship Id='" + name + "' Type='" + office + "worksheet' Target='" + name + "'/>";
        parts.emplace_back(name, "<w>" + eight.substr(20) + "</w>");
    }
    parts.emplace_back("w.xml", "<workbook><sheets>" + sheets + "</sheets></workbook>");
    parts.emplace_back("_rels/w.xml.rels", "<Relationships>" + targets + "</Relationships>");
    CHECK(contains(refused(archive_of(parts)), "all parts to more than 64 MB"));
    CHECK(contains(refused(ods("<table:table-row table:number-rows-repeated='900'><table:table-cell "
                               "table:number-columns-repeated='900'><text:p>" +
                               eight.substr(0, 1000) + "x</text:p></table:table-cell></table:table-row>")),
                   "the sheet \"S\" is too large; allowed: 1000000 cells and 128 MB in all"));
    std::string nested = "x";
    for (int i = 0; i < 16; ++i) nested = "<text:span>" + nested + "</text:span>";
    std::string deep(100'000 * 11, ' ');
    for (std::size_t i = 0; i < 100'000; ++i) deep.replace(11 * i, 11, "<text:span>");
    for (int i = 0; i < 100'000; ++i) deep += "</text:span>";
    const auto cell = [](const std::string& text) {
        return ods("<table:table-row><table:table-cell><text:p>" + text +
                   "</text:p></table:table-cell></table:table-row>");
    };
    CHECK(text_of(cell(nested)) == "x\n");
    CHECK(contains(refused(cell(deep)), "nested too deeply"));
    CHECK(contains(refused(ods("<table:table-row table:number-rows-repeated='1048576'><table:table-cell "
                               "table:number-columns-repeated='900'><text:p>x</text:p></table:table-cell>"
                               "</table:table-row>")),
                   "the sheet \"S\" is too large"));
}

TEST_CASE("no byte of a spreadsheet that is changed or missing does worse than an input error") {
    std::mt19937 random(7);
    for (const char* name : {"openpyxl.xlsx", "shared-strings.xlsx", "opendocument.ods"}) {
        const std::string bytes = data(name);
        for (int i = 0; i < 300; ++i) {
            std::string changed = bytes;
            if (i % 3 == 0) {
                changed.resize(random() % bytes.size());
            } else {
                for (int k = 0; k < 1 + i % 4; ++k)
                    changed[random() % changed.size()] = static_cast<char>(random());
            }
            try {
                static_cast<void>(read_xrd(changed, name));
            } catch (const InputError& error) {
                CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
            }
        }
    }
}

}  // namespace ashimpact::test
