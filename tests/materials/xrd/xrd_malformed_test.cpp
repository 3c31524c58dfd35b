// SPDX-License-Identifier: GPL-3.0-or-later
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "materials/xrd/xrd.hpp"
#include "tests/materials/catalogue.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

const std::vector<std::string> good_files{
    "fa07-corundum.lst", "fa12-crlf-undef.lst", "fa07-gsas2.lst", "long-percent.csv", "semicolon-comma.csv",
    "wide-phases.tsv",   "wide-samples.csv",    "volumes.csv",    "peaks.csv",        "peaks-standard.csv",
    "bom-crlf.csv",      "latin1.csv",          "samples.json"};

std::string good(const std::string& file) {
    return file_text(ASHIMPACT_TEST_DATA "/xrd/" + file);
}

std::string refused(const std::string& text) {
    return input_error_of([&] { return read_xrd(text, "ash.lst"); });
}

/// One line, with the file and a line number.
bool well_formed(const std::string& message) {
    constexpr std::string_view file = "ash.lst: ";
    if (!message.starts_with(file) || message.find('\n') != std::string::npos || message.size() > 600)
        return false;
    std::string_view rest = std::string_view(message).substr(file.size());
    if (!rest.starts_with("line ")) return false;
    rest.remove_prefix(5);
    return rest.front() >= '1' && rest.front() <= '9' && rest.find(": ") != std::string_view::npos;
}

/// The text with the first occurrence of `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto found = text.find(from);
    REQUIRE(found != std::string::npos);
    return text.replace(found, from.size(), to);
}

std::string block(const std::string& phase, const std::string& weight) {
    return "Local parameters and GOALs for phase " + phase + "\n*****\nXrayDensity=2.65\n" + weight + "\n\n";
}

void refuses(const std::string& text, const std::string& says) {
    CAPTURE(text);
    CHECK(contains(refused(text), says));
}

}  // namespace

TEST_CASE("empty, blank, binary and unknown files") {
    CHECK(refused("") == "ash.lst: line 1: the file is empty; allowed: an XRD result");
    CHECK(refused("  \r\n\t\n") == "ash.lst: line 1: the file is empty; allowed: an XRD result");
    CHECK(refused("\xef\xbb\xbf") == "ash.lst: line 1: the file is empty; allowed: an XRD result");
    CHECK(refused("\x1a") == "ash.lst: line 1: the file is empty; allowed: an XRD result");
    CHECK(refused("\n\x1a") == "ash.lst: line 1: the file is empty; allowed: an XRD result");
    refuses(std::string("phase,weight\nQuartz,") + '\0', "line 2: this is a binary file");
    refuses(
        "\x7f"
        "ELF\x02\x01",
        "line 1: this is a binary file");
    refuses("\xff\xfep", "line 1: this begins as UTF-16 and is damaged");
    refuses("Dear colleague,\nthe ash holds much glass.\n", "line 1: the format is not known");
    refuses("10.00 512\n10.02 498\n10.04 530\n", "allowed: a BGMN/Profex .lst, a GSAS-II .lst");
}

TEST_CASE("100 MB of one line is refused, wherever it stands") {
    std::string text = "phase,weight\n";
    text.resize(100'000'000, 'x');
    const std::string too_long =
        "ash.lst: line 2: the line is longer than a megabyte; allowed: a text file with lines";
    CHECK(refused(text) == too_long);
    CHECK(refused("{" + text) == too_long);
}

TEST_CASE("a long cell of blanks, words or brackets takes no longer than it is") {
    for (const char* part : {" ", "a ", "(", "1 ", "a/"}) {
        std::string cell = "Q";
        while (cell.size() < 200'000) cell += part;
        cell += 'z';
        for (const std::string& text :
             {"phase;wt%\n" + cell + ";20\nglass;80\n", "phase;wt%;" + cell + "\nQuartz;20;1\nglass;80;1\n",
              "phase;wt%\nQuartz;" + cell + "\nglass;80\n", cell + "\nphase;wt%\nQuartz;20\nglass;80\n"}) {
            const std::clock_t start = std::clock();  // processor time, whatever else the machine does
            const std::string message = refused(text);
            CHECK_MESSAGE(std::clock() - start < 5 * CLOCKS_PER_SEC, message.substr(0, 100));
        }
    }
}

TEST_CASE("a file of too many lines, bytes or cells is refused where it becomes too long") {
    const auto repeated = [](const std::string& line, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += line;
        return text;
    };
    const std::string too_long =
        "the file is too long for an XRD result; allowed: 100000 lines and 16 MB or less";
    CHECK(refused("phase,wt%\n" + repeated("Quartz,1\n", 100'000)) == "ash.lst: line 100001: " + too_long);
    CHECK(refused(repeated("x=1\r\n", 100'001)) == "ash.lst: line 100001: " + too_long);
    CHECK(refused(repeated("x=1\r", 100'001)) == "ash.lst: line 100001: " + too_long);
    std::string long_line(900'000, 'x');
    long_line.back() = '\n';
    CHECK(refused(repeated(long_line, 20)) == "ash.lst: line 19: " + too_long);
    const std::string row = repeated(",0", 100'000) + "\n";
    refuses("sample" + repeated(",Quartz", 100'000) + "\n" + repeated("s" + row, 6),
            "line 6: the table is too large for an XRD result; allowed: 500000 cells or fewer");
}

TEST_CASE("a table whose columns beside the first have no heading") {
    refuses(
        "\xef\xbb\xbfPhase;\r\nMullit;62\r\n",
        "line 1: no column beside \"Phase\" has a heading; allowed: \"weight %\" or the name of a sample");
    refuses("sample,,\nash,62,38\n",
            "line 1: no column beside \"sample\" has a heading; allowed: the name of a phase");
    for (const char* heading : {"Sample;Quartz;Glass;esd;esd", "Sample;Quartz;esd;esd;Glass",
                                "Phase;wt%;esd;esd;x", "Phase;wt%;density [g/cm3];esd;x"})
        refuses(heading + std::string("\nA;60;40;1;1\n"), "they may be of it, or of another column");
    refuses("Sample;Quartz modal %\nash;62\n",
            "line 1: no column beside \"Sample\" holds fractions: \"Quartz modal %\"; allowed: the name of a "
            "phase");
}

TEST_CASE("malformed BGMN lists") {
    const std::string list = good("fa07-corundum.lst");
    refuses(with(list, "for phase Mullite", "for phase Quartz"),
            "line 38: the phase \"Quartz\" is there twice, first in line 20");
    refuses(with(list, "GEWICHT=0.5049+-0.0038", "GEWICHT=0.50.49"), "line 50: cannot read \"0.50.49\"");
    refuses(with(list, "GEWICHT=0.5049+-0.0038", "GEWICHT=-0.5049"),
            "line 50: the weight of \"Mullite\" is below zero");
    refuses(with(list, "GEWICHT=0.5049+-0.0038\n", ""), "the block of \"Mullite\" has no GEWICHT");
    refuses(with(list, "GEWICHT=0.5049+-0.0038", "GEWICHT=1\nGEWICHT=1"), "line 51: GEWICHT is there twice");
    refuses(with(list, "QMullite=0.5610", "QMullite=0.56x0"), "line 13: cannot read");
    for (const char* goal : {"QMullite=1e300", "QMullite=-0.5610", "QMullite=56.10"}) {
        CAPTURE(goal);
        refuses(with(list, "QMullite=0.5610", goal), "line 13: ");
        refuses(with(list, "QMullite=0.5610", goal), "allowed: a fraction");
    }
    for (const char* goal : {"amorphous=0.40+-0.01\nEPS2", "Qamorphous=0.40\nEPS2", "Amorph=0.40\nEPS2"})
        refuses(with(list, "EPS2", goal), "line 18: the goal \"");
    refuses(with(list, "EPS2", "amorphous=0.40\nEPS2"),
            "states an amorphous part: the phases may be fractions");
    refuses(with(list, "XrayDensity=2.648", "XrayDensity=heavy"), "line 24: cannot read \"heavy\"");
    refuses("BGMN version 4.2.23, 3001 measured points\nRp=4.71%\n",
            "line 2: there is no block of a phase: the file seems to be cut off");
    refuses(block("Quartz", "GEWICHT=UNDEF"), "no phase has a weight");
    refuses(block("Quartz", "GEWICHT=0"), "no phase has a weight");
    refuses(with(list, "XrayDensity=2.648", "XrayDensity=0"), "line 24: XrayDensity is 0");
    const std::string two = block("Quartz", "GEWICHT=0.6") + block("Mullite", "GEWICHT=0.4015");
    CHECK(refused(two).empty());
    const std::string goals = "Global parameters and GOALs\nQQuartz=0.6+-0.01\nQMullite=0.4+-0.01\n\n" +
                              block("Quartz", "GEWICHT=0.6") + block("Mullite", "GEWICHT=");
    const std::string open_end = goals.substr(0, goals.size() - 2);
    refuses(open_end, "a GEWICHT without an end");
    refuses(open_end + "0.4", "a GEWICHT without an end");
    CHECK(refused(open_end + "0.4+-0.01").empty());
    refuses(two.substr(0, two.size() - 4),
            "line 9: the last line is a GEWICHT without an end: the file seems to be cut off");
    refuses(block("", "GEWICHT=1"), "line 1: the heading has no phase name");
}

TEST_CASE("malformed GSAS-II lists") {
    const std::string list = good("fa07-gsas2.lst");
    refuses(with(list, "Weight fraction  :  0.73021", "Weight fraction  :  0.93021"), "add up to 1.2");
    refuses(with(list, "Weight fraction  :  0.73021", "Weight fraction  :  7.3021"),
            "line 37: the weight fraction is 7.3021");
    refuses(with(list, "Weight fraction  :  0.73021", "Weight fraction  :  -0.7"),
            "line 37: the weight fraction is -0.7");
    refuses(with(list, "sig    0.00402", "sig    0.004O2"), "line 37: cannot read the weight fraction");
    refuses(with(list, "sig    0.00402", "sig   -0.00402"), "line 37: cannot read the weight fraction");
    refuses(with(list, "Phase: Hematite in", "Phase: Quartz in"),
            "line 41: the phase \"Quartz\" is there twice in \"FA-07.xy Bank 1\"");
    refuses(with(list, "Density: 2.6489", "Density: x"), "line 18: cannot read the density \"x\"");
    const XrdResult uncertain = read_xrd(with(list, "Density: 2.6489", "Density: 2.6489(3)"), "ash.lst");
    CHECK(contains(uncertain.samples[0].warnings.at(0).text, "0.0003 g/cm3, is not used"));
    refuses(" GSAS-II Refinement\n wR = 7 %\n", "line 2: there is no refined weight fraction");
    refuses(" Phase fraction  :    1.0, sig 0.0 Weight fraction  :  1.0, sig 0.0\n",
            "line 1: a weight fraction stands before any phase heading");
}

TEST_CASE("malformed tables") {
    refuses("Phase;wt%;esd\nQuartz;20 \u00b1 0.4;1\nMullite;80;2\n",
            "line 2: the cell and a column state an uncertainty of the fraction");
    refuses("Phase;wt% (kristallin);Gew.-% (gesamt)\nQuartz;60;40\nMullite;40;20\namorph;-;40\n",
            "line 1: the columns \"wt% (kristallin)\" and \"Gew.-% (gesamt)\" hold the same quantity");
    refuses("Phase;wt% (crystalline)\nQuartz;40\nMullite;40\n",
            "line 3: the fractions of the crystalline part add up to 80 %: a phase may be missing");
    refuses("phase,weight\n", "line 1: there are no lines below the heading");
    refuses("phase,weight\nQuartz,0.5\nQuartz,0.5\n",
            "line 3: the phase \"Quartz\" is there twice in the sample, first in line 2");
    refuses("phase,wt%\nQuartz,60\nMullite,50\n",
            "line 3: the fractions of the sample add up to 110 % or more");
    refuses("phase,wt%\nQuartz,160\n", "line 2: the amount of \"Quartz\" is 160 %");
    refuses("phase,wt%\nQuartz,-3\n", "line 2: the amount of \"Quartz\" is -3 %");
    for (const char* huge : {"1e300", "1e41"})
        refuses("phase,wt%,esd\nQuartz,60," + std::string(huge) + "\nMullite,40,1\n", "line 2");
    refuses("phase,wt%\nQuartz,much\n", "line 2, cell 2: cannot read \"much\"");
    refuses("phase,wt%\nQuartz,60\nMullite,", "line 3: the last line stops before its amount");
    refuses("sample,phase,wt%\na,Quartz,60\na,Quartz,4\n", "is there twice in the sample \"a\"");
    refuses("phase,wt%\nQuartz,inf\n", "line 2, cell 2: cannot read \"inf\"");
    refuses("phase,wt%\nQuartz\n", "line 2: the line has 1 cell, the heading has 2");
    refuses("phase,wt%\nQuartz,12,5\n", "line 2: the line has 3 cells, the heading has 2");
    refuses("phase,wt%\n\"Quartz,12\n", "line 2: a quote is not closed");
    refuses("phase,wt%\n,12\n", "line 2: the line names no phase");
    refuses("phase,wt%\nQuartz,n.d.\n", "line 2: the sample has no phase with an amount");
    refuses("phase,wt%\nQuartz,60\nGlass,40\nTotal,99\n",
            "line 4: the total of the sample is given as 99 %, the phases above add up to 100 %");
    refuses("sample,phase,wt%\nA,Quartz,60\nA,Glass,40\nB,Quartz,60\nB,Glass,30\nB,Total,100\n",
            "line 6: the total of the sample \"B\" is given as 100 %");
    refuses("phase,wt%,content\nQuartz,60,50\n", "line 1: the columns \"wt%\" and \"content\" hold the same");
    refuses("phase,wt%,esd\nQuartz,60,-1\n", "line 2: the uncertainty is below zero");
    refuses("phase,wt%,density\nQuartz,60,2.65\n",
            "line 2, cell 3: column \"density\": the density has no unit");
    refuses("Phase;wt%;Dichte\nquartz;13,5;2,65\nmullite;86,5;3,16\n",
            "line 2, cell 3: column \"Dichte\": the density has no unit");
    refuses("phase,wt%,density [GPa]\nQuartz,60,2.65\n",
            "line 2, cell 3: column \"density [GPa]\": the unit \"GPa\" is not one of density");
    refuses("phase,wt%,density [g/cm3]\nQuartz,60,-2.65\n", "line 2, cell 3: the density is not positive");
    for (const char* cell : {"2.65 \u00b1 0.05", "2.65(5)", "2.65+-0.05"}) {
        const std::string text(cell);
        const std::string problem =
            "\" states an uncertainty, which nothing here uses; allowed: the density alone, or the phase";
        refuses("phase,wt%,density [g/cm3]\nQuartz,60," + text + "\n", "line 2, cell 3: \"" + text + problem);
        refuses("phase,wt%,density\nQuartz,60," + text + " g/cm3\n",
                "line 2, cell 3: \"" + text + " g/cm3" + problem);
    }
    refuses("phase,intensity\nQuartz,60\n",
            "line 1: there are intensities without reference intensity ratios");
    refuses("phase,intensity,rir\nQuartz,60,\n", "line 2: intensity or rir of \"Quartz\" is missing");
    refuses("phase,intensity,rir\nQuartz,60,0\n", "line 2: intensity or rir of \"Quartz\" is out of range");
    refuses("phase,wt%,standard\nQuartz,60,5\nMullite,40,5\n", "line 3: there are two internal standards");
    refuses("phase,wt%,standard [%]\nQuartz,95,\nCorundum,5,20\n", "line 3: by the internal standard");
    refuses("name,Quartz,Glass\nFA-1,60,40\n", "line 1: \"name\" may be that of a phase or of a sample");
}

TEST_CASE("malformed JSON results") {
    const auto phases = [](const std::string& list) {
        return R"({"samples": [{"name": "a", "phases": [)" + list + "]}]}";
    };
    const std::string quartz = R"({"name": "Quartz", "weight_fraction": 0.6})";
    refuses("{\"samples\": [\n", "line 2");
    refuses(
        "{\n \"samples\": [ {\n \"name\": \"a]\\\"\", \"phases\": [\n\n"
        " {\"name\": \"Quartz\",\n \"weight_fraction\": 60}]}]}",
        "line 6: /samples/0/phases/0/weight_fraction: the fraction is 60");
    refuses(R"({"samples": []})", "/samples: no samples");
    refuses(R"([1, 2])", "line 1: is not an object; allowed: an object with the key samples");
    refuses(R"({"samples": [], "x": 1})", "/x: unknown key");
    refuses(phases(quartz + "," + quartz),
            "line 1: /samples/0/phases/1: the phase \"Quartz\" is there twice");
    refuses(phases(quartz + R"(,{"name": "Mullite", "weight_fraction": 0.7})"),
            "/samples/0/phases: the fractions add up to 130 %");
    refuses(phases(R"({"name": "Quartz", "weight_fraction": 60})"),
            "/samples/0/phases/0/weight_fraction: the fraction is 60");
    refuses(phases(R"({"name": "Quartz"})"), "/samples/0/phases/0: not exactly one fraction");
    refuses(phases(quartz + R"(,{"name": "Glass", "volume_fraction": 0.4})"), "by weight and by volume");
    refuses(phases(R"({"name": "Quartz", "weight_fraction": "0.6 m"})"), "not one of fraction");
    refuses(R"({"samples": [{"name": "a", "phases": [)" + quartz + R"(], "amorphous": "some"}]})",
            "line 1: /samples/0/amorphous: the amorphous part is \"some\"");
    refuses(R"({"samples": [{"name": "a", "phases": [)" + quartz +
                R"(], "amorphous": {"weight_fraction": 0.4, "crystalline_total": 0.6}}]})",
            "/samples/0/amorphous: the amorphous part is stated 2 times");
    refuses(R"({"samples": [{"name": "a", "phases": [)" + quartz +
                R"(], "internal_standard": {"phase": "Corundum", "weight_fraction": 0.1}}]})",
            "/samples/0/internal_standard: the internal standard \"Corundum\" is not among the phases");
    refuses(R"({"samples": [{"name": "a"}]})", "/samples/0: the composition is missing");
    refuses(R"({"samples": [{"name": "a", "peaks": []}]})", "all intensities are zero");
}

TEST_CASE("a list that is cut off after any line is refused, or complete in all that counts") {
    for (const auto* file : {"fa07-corundum.lst", "fa07-gsas2.lst", "samples.json"}) {
        const std::string text = good(file);
        const XrdResult whole = read_xrd(text, file);
        int refusals = 0;
        for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1)) {
            const std::string part = text.substr(0, end);
            const std::string message = refused(part);
            CAPTURE(part.size());
            CAPTURE(file);
            if (!message.empty()) {
                CHECK(well_formed(message));
                ++refusals;
                continue;
            }
            const XrdResult result = read_xrd(part, file);
            REQUIRE(result.samples.size() <= whole.samples.size());
            for (std::size_t i = 0; i < result.samples.size(); ++i) {
                const auto& phases = result.samples[i].analysis.phases;
                REQUIRE(phases.size() == whole.samples[i].analysis.phases.size());
                for (std::size_t k = 0; k < phases.size(); ++k)
                    CHECK(phases[k].fraction == whole.samples[i].analysis.phases[k].fraction);
            }
        }
        CHECK(refusals > 20);
    }
}

TEST_CASE("random damage to good files ends in a result or in one line") {
    std::mt19937_64 generator(42);
    int refusals = 0;
    for (const std::string& file : good_files) {
        const std::string text = good(file);
        CHECK_NOTHROW(static_cast<void>(read_xrd(text, file)));
        for (int i = 0; i < 300; ++i) {
            std::string damaged = text;
            const auto at = [&] { return generator() % damaged.size(); };
            for (int k = 0; k < 3; ++k) {
                switch (generator() % 4) {
                    case 0:
                        damaged[at()] = static_cast<char>(generator() & 0xff);
                        break;
                    case 1:
                        damaged.erase(at(), 1 + generator() % 20);
                        break;
                    case 2:
                        damaged.insert(at(), text.substr(generator() % text.size(), 1 + generator() % 40));
                        break;
                    default:
                        damaged.resize(1 + at());
                        break;
                }
                if (damaged.empty()) damaged = "x";
            }
            const std::string message = refused(damaged);
            if (message.empty()) continue;
            CAPTURE(message);
            CHECK(well_formed(message));
            ++refusals;
        }
    }
    CHECK(refusals > 500);
}

}  // namespace ashimpact::test
