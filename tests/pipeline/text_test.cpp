// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.hpp"

#include <doctest/doctest.h>

#include "core/quantities/quantity.hpp"
#include "pipeline/app/terminal.hpp"
#include "pipeline/present/text/layout.hpp"
#include "pipeline/present/text/result_text.hpp"

using namespace ashimpact;

TEST_CASE("quantities read in the unit that keeps them short") {
    CHECK(readable(44e-6, "m") == "44 um");
    CHECK(readable(1.48126e11, "Pa") == "148.1 GPa");
    CHECK(readable(9.27726e-10, "kg") == "927.7 ng");
    CHECK(readable(1.93, "m/s") == "1.93 m/s");
    CHECK(readable(0.0126, "m/s") == "0.0126 m/s");
    CHECK(readable(0.00126, "m/s") == "1.26 mm/s");
    CHECK(readable(2.94e-7, "s") == "294 ns");
    CHECK(readable(-7.4e-14, "J") == "-74 fJ");
    CHECK(readable(0.0141, "kg/s") == "0.0141 kg/s");
    CHECK(readable(0, "m") == "0 m");
    CHECK(readable(0.25, "1") == "0.25");
    CHECK(readable({.value = 2e9, .unit = "Pa", .standard_uncertainty = 1e8}) == "2.00 +- 0.10 GPa");
    CHECK(readable({.value = 1.48126e11, .unit = "Pa", .standard_uncertainty = 1.19e10}) == "148 +- 12 GPa");
    CHECK(readable({.value = 1.5, .unit = "m/s", .standard_uncertainty = 4e-15}) == "1.5 m/s");
    CHECK(readable({.value = 0.47, .unit = "1", .standard_uncertainty = 0.02}) == "0.470 +- 0.020");
    CHECK(readable({.value = 2300, .unit = "kg/m3", .standard_uncertainty = 300}) == "2300 +- 300 kg/m3");
}

TEST_CASE(
    "on a terminal the headings of tables are bold, the word warning is yellow, and the rest is as it was") {
    CHECK(with_colors("name\n  -----\n1\n") == "\x1b[1mname\x1b[0m\n  -----\n1\n");
    CHECK(with_colors("name\n--\n1\n") == "name\n--\n1\n");
    CHECK(with_colors("a\nwarning: b\nc") == "a\n\x1b[33mwarning:\x1b[0m b\nc");
    CHECK(with_colors("") == "");
    CHECK(error_in_color("wrong\n") == "\x1b[31mwrong\x1b[0m\n");
}

TEST_CASE("a table keeps its columns whatever the width of its cells") {
    TextTable table({"a", "long heading"});
    table.add({"µm", "1"});
    table.add({"wide cell", "22"});
    CHECK(table.text() ==
          "a          long heading\n"
          "-----------------------\n"
          "µm                    1\n"
          "wide cell            22\n");
}

TEST_CASE("a table wider than the page is shown in parts, each with the names of its rows") {
    TextTable table({"sample", "first column", "second column", "third column"});
    table.add({"fine", "1", "2", "3"});
    const std::string text = table.text(0, 36);
    CHECK(text ==
          "sample  first column  second column\n"
          "-----------------------------------\n"
          "fine               1              2\n"
          "\n"
          "sample  third column\n"
          "--------------------\n"
          "fine               3\n");
}

TEST_CASE("a column without a value is left out") {
    TextTable table({"a", "b", "c"});
    table.add({"1", "-", "2"});
    table.add({"3", "", "4"});
    table.drop_empty_columns();
    CHECK(table.text() == "a  c\n----\n1  2\n3  4\n");
}

TEST_CASE("long lines are broken at blanks, behind their margin; a long word stays whole") {
    CHECK(wrapped("  one two three", 9, 2) == "  one two\n    three");
    CHECK(wrapped("short\nlonger than ten", 10) == "short\nlonger\nthan ten");
    CHECK(wrapped("/a/very/long/path here", 8) == "/a/very/long/path\nhere");
    CHECK(wrapped_command("  run 'a b' -o here", 20) == "  run 'a b' -o here");
    CHECK(wrapped_command("  run 'a b' -o here", 13) == "  run 'a b' \\\n    -o here");
    const std::string folder =
        "/tmp/a folder with a name that is longer than a line of this page is wide, made by CI";
    const std::string printed = wrapped_command(
        "  ashimpact run " + shell_word(folder + "/case.json") + " -o " + shell_word(folder + "/results"),
        80);
    CHECK(printed == "  ashimpact run \\\n    " + shell_word(folder + "/case.json") + " \\\n    -o " +
                         shell_word(folder + "/results"));
    CHECK(wrapped_command("  run 'a b c' -o 'd e'", 12) == "  run \\\n    'a b c' \\\n    -o 'd e'");
    CHECK(cut_to("Hämatit und mehr", 10) == "Hämatit...");
}

TEST_CASE("a capture stands beside no rebound, however many there are of each") {
    const Json result = parse_json(R"({"velocity": {"values": [2, 3], "unit": "m/s"},
        "captured_at": {"values": [1, 1.5], "unit": "m/s"}})");
    const std::string text = result_text(result);
    CHECK_MESSAGE(text.find("velocity [m/s]\n") != std::string::npos, text);
    CHECK_MESSAGE(text.find("captured_at [m/s]\n") != std::string::npos, text);
}

TEST_CASE("entries of one kind stand side by side; what is shortened is said, and whole with all") {
    std::string values = "0";
    for (int i = 1; i < 40; ++i) values += "," + std::to_string(i);
    const Json result = parse_json(R"({"dmt": {"v_c": {"value": 1, "unit": "m/s"}, "verdict": "finite"},
        "jkr": {"v_c": {"value": 2, "unit": "m/s"}, "verdict": "finite"},
        "curve": {"t": {"values": [)" +
                                   values + R"(], "unit": "s"}}})");
    const std::string text = result_text(result);
    CHECK_MESSAGE(text.find("v_c [m/s]       1       2") != std::string::npos, text);
    CHECK_MESSAGE(text.find("every 4 of 40 rows; --all shows them") != std::string::npos, text);
    const std::string whole = result_text(result, {.all = true});
    CHECK(whole.find("every") == std::string::npos);
    CHECK_MESSAGE(whole.find("  40     39\n") != std::string::npos, whole);
}

TEST_CASE("a histogram is shown as bars") {
    const Json result = parse_json(R"({"h": {"zeros": 7, "edges": {"values": [0, 1, 2, 3], "unit": "m/s"},
        "counts": [1, 4, 2]}})");
    const std::string text = result_text(result, {.width = 60});
    CHECK_MESSAGE(text.find("####") != std::string::npos, text);
    CHECK_MESSAGE(text.find("zero: 7") != std::string::npos, text);
    CHECK(text.find("edges") == std::string::npos);
}

TEST_CASE("remarks that differ in sample, law and numbers alone are one line") {
    const auto note = [](const char* sample, std::optional<Law> law, Severity severity, const char* text) {
        return Note{.code = "outliers",
                    .severity = severity,
                    .stage = "fit",
                    .sample = sample,
                    .law = law,
                    .text = text};
    };
    const std::vector<Remark> remarks{
        {"5-damping.json", note("fine", Law::of<Dmt>(), Severity::remark, "1 outliers of 20 impacts")},
        {"5-damping.json", note("coarse", Law::of<Jkr>(), Severity::remark, "3 outliers of 9 impacts")},
        {"6-fit.json",
         note("fine", {}, Severity::doubt, "v_c over that of the other: 1.21; they disagree: why")},
        {"6-fit.json",
         note("", {}, Severity::background, "Tabor parameter 2 is between both: neither holds")}};
    const auto lines = remark_lines(remarks, 2);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].text == "2 x 5-damping.json (all samples; dmt, jkr), the first: 1 outliers of 20 impacts");
    CHECK(lines[1].text == "1 x 6-fit.json (fine): v_c over that of the other: 1.21");
    CHECK(lines[2].text == "1 x 6-fit.json: Tabor parameter 2 is between both");
    CHECK(lines[0].decides);
    CHECK_FALSE(lines[2].decides);  // the summary says why which law is taken
}

TEST_CASE("a remark is shortened at its reason, not within a name and not before its question") {
    const auto shown = [](const char* text) {
        return remark_lines({{"1-modulus.json", {.text = text}}}, 0)[0].text;
    };
    CHECK(shown("the phases leave 0.2 % for the amorphous part: are the fractions of the whole sample?") ==
          "1 x 1-modulus.json: the phases leave 0.2 % for the amorphous part: are the fractions of the whole "
          "sample?");
    CHECK(shown("the column \"Fehler: absolut; in %\" is not read (why: see there): it has no numbers") ==
          "1 x 1-modulus.json: the column \"Fehler: absolut; in %\" is not read (why: see there)");
}

TEST_CASE("the summary shows what a verdict compares, and marks a velocity that is only extrapolated") {
    const CriticalVelocityCheck agrees{CriticalVelocityVerdict::agrees, {}};
    const VelocityEstimate extrapolated{
        .value = 0.684, .interval = Bounds{0.6, 0.7}, .method = VelocityMethod::extrapolation};
    const VelocityEstimate estimated{
        .value = 0.7, .interval = Bounds{0.652, 0.725}, .method = VelocityMethod::estimate};
    SampleComparison sample{
        .name = "fine",
        .reported = ReportedVelocity{Law::of<Jkr>(), estimated, estimated.interval, "why"},
        .taken_as_exact = {"diameter"},
        .measured = Stated{.quantity = {.value = 0.832, .unit = "m/s"}, .origin = Origin::measured},
        .measured_interval = Bounds{0.558, 1.1}};
    sample.laws.set(Law::of<Hertz>(), {.verdict = LawVerdict::finite,
                                       .velocity = extrapolated,
                                       .extrapolated = extrapolated,
                                       .check = agrees});
    sample.laws.set(Law::of<Jkr>(), {.verdict = LawVerdict::finite,
                                     .velocity = estimated,
                                     .extrapolated = VelocityEstimate{.value = 0.65},
                                     .check = agrees});
    const std::string text =
        comparison_text(ComparisonResult{.samples = {sample}, .conclusion = "Done."}, 80);
    CHECK_MESSAGE(text.find("0.832 m/s (0.558 to 1.10)") != std::string::npos, text);
    CHECK_MESSAGE(
        text.starts_with("fine: particles stick below 0.700 m/s (0.652 to 0.725), by jkr.\nfine, by jkr: "),
        text);
    CHECK_MESSAGE(text.find("fine, by jkr: why.\n") != std::string::npos, text);
    CHECK_MESSAGE(text.find("Measured, for comparison only: fine 0.832 m/s") != std::string::npos, text);
    CHECK_MESSAGE(text.find("* 0.684") != std::string::npos, text);
    CHECK_MESSAGE(text.find("* 0.700") == std::string::npos, text);
    CHECK_MESSAGE(text.find("*: extrapolated from the rebounds") != std::string::npos, text);

    // Without a measurement of its own, and the same by every law.
    sample.laws = {};
    for (const Law law : {Law::of<Hertz>(), Law::of<Jkr>()})
        sample.laws.set(law, {.velocity = estimated,
                              .extrapolated = VelocityEstimate{.value = law == Law::of<Jkr>() ? 0.65 : 0.4}});
    sample.measured_by_outcomes = true;
    const std::string same =
        comparison_text({.reported = ReportedLaw{Law::of<Jkr>(), "why", {}}, .samples = {sample}}, 120);
    CHECK_MESSAGE(
        same.find("Captures and rebounds alone: fine 0.832 m/s (0.558 to 1.10).") != std::string::npos, same);
    CHECK_MESSAGE(same.find("The impacts give v_c, whatever the contact law. Other sizes by jkr: why.") !=
                      std::string::npos,
                  same);
    CHECK_MESSAGE(
        same.find("fine    all        0.700  0.652 to 0.725  0.400 to 0.650\n") != std::string::npos, same);
    CHECK_MESSAGE(same.find("verdict") == std::string::npos, same);
    CHECK_MESSAGE(same.find("Taken as exact") == std::string::npos, same);
    CHECK_MESSAGE(same.find("v_c of measured impacts needs no property of the particle") != std::string::npos,
                  same);
}

TEST_CASE("the summary begins with what sticks, or with what is known of it") {
    const Bounds bounds{0.5, 0.6};
    const std::pair<ReportedVelocity, const char*> cases[]{
        {{Law::of<Dmt>(), VelocityEstimate{.value = 0.55}, bounds},
         "stick below 0.550 m/s (0.500 to 0.600), by dmt."},
        {{{}, VelocityEstimate{.value = 0.55}, {}}, "stick below 0.550 m/s."},
        {{{}, VelocityEstimate{.value = 7e8}, {}},
         ": the critical velocity is above 500 m/s, outside the model."},
        {{{}, {}, Bounds{0.5, {}}}, "stick below 0.500 m/s at least."},
        {{{}, {}, Bounds{{}, 0.6}}, "rebound above 0.600 m/s at least."},
        {{}, ": no critical velocity."}};
    for (const auto& [reported, end] : cases)
        for (const char* name : {"88 um", "fine"}) {
            const SampleComparison sample{.name = name, .reported = reported, .diameter = 88e-6};
            const std::string text = comparison_text(ComparisonResult{.samples = {sample}}, 120);
            const bool named = std::string(name) == "fine";
            const std::string begin = named ? "fine: particles of 88 um" : "Particles of 88 um";
            CHECK_MESSAGE(text.starts_with(begin + (*end == ':' ? "" : " ") + end + "\n"), text);
        }
}

TEST_CASE("a list that is empty in one entry only is shown as none, whole too") {
    const Json part{{"part", "rising"}, {"from", 1.0}, {"to", 2.0}};
    const Json result{{"hertz", {{"parts", {part, part}}, {"name", "a"}}},
                      {"dmt", {{"parts", Json::array()}, {"name", "a"}}}};
    for (const bool all : {false, true}) {
        const std::string text = result_text(result, {.all = all});
        CHECK_MESSAGE(text.find("none") != std::string::npos, text);
        CHECK_MESSAGE(text.find("rising") != std::string::npos, text);
    }
}

TEST_CASE("an empty text, an empty list and a list of mixed values are shown as they are") {
    const Json result = parse_json(R"({"contact_modulus": "", "options": {"x": "", "none": []},
        "mixed": [1, {"k": "v"}, ""], "matrix": [[1, 2], [{"deep": ""}]]})");
    const std::string text = result_text(result);
    for (const char* piece : {"contact_modulus  \"\"", "x     \"\"", "none  none", "k  v", "1, 2", "deep"})
        CHECK_MESSAGE(text.find(piece) != std::string::npos, piece, "\n", text);
}

TEST_CASE("a result of any shape becomes text with every value in it") {
    const Json result = parse_json(R"({"name": "x", "E": {"value": 9e10, "unit": "Pa"}, "none": null,
        "curve": {"t": {"values": [1, 2], "unit": "s"}, "v": {"values": [3, 4], "unit": "m/s"}},
        "rows": [{"k": "p", "n": 1}, {"k": "q", "n": 2}]})");
    const std::string text = result_text(result);
    for (const char* piece : {"90 GPa", "t [s]", "v [m/s]", "none  -", "p  1", "q  2"})
        CHECK_MESSAGE(text.find(piece) != std::string::npos, piece, "\n", text);
}

TEST_CASE("what a terminal would obey is shown as a question mark") {
    CHECK(without_controls("a\x1b[31mb\x07\r\x7f") == "a?[31mb???");
    CHECK(without_controls("one\ttwo\nthree") == "one\ttwo\nthree");
    CHECK(without_controls("\xc2\x9b\x33m") == "?3m");  // CSI as one character of UTF-8
    CHECK(in_quotes(std::string(59, 'a') + "\xc3\xa9") == '"' + std::string(59, 'a') + "...\"");
    CHECK(without_controls("a\xff\xc3z\xe2\x82") == "a??z??");  // half a character
    CHECK(without_controls("\xed\xa0\x80") == "???");           // half of a surrogate pair
    CHECK(without_controls("\xe2\x82\xac \xf0\x9f\x99\x82") == "\xe2\x82\xac \xf0\x9f\x99\x82");
    CHECK(without_controls("\xc2\xb5m, \xc3\xa4sh") == "\xc2\xb5m, \xc3\xa4sh");
}

TEST_CASE("a word of a shell command is quoted where the shell would cut it") {
    CHECK(shell_word("my-case/case.json") == "my-case/case.json");
    CHECK(shell_word("my case") == "'my case'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("") == "''");
}
