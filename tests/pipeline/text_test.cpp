#include <doctest/doctest.h>

#include "materials/base/text.hpp"
#include "pipeline/text/artifact_text.hpp"
#include "pipeline/text/readable.hpp"
#include "pipeline/text/table.hpp"

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
    CHECK(readable({.value = 2e9, .unit = "Pa", .standard_uncertainty = 1e8}) == "2 GPa +- 5 %");
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
    CHECK(without_controls("\xe2\x82\xac \xf0\x9f\x99\x82") == "\xe2\x82\xac \xf0\x9f\x99\x82");
    CHECK(without_controls("\xc2\xb5m, \xc3\xa4sh") == "\xc2\xb5m, \xc3\xa4sh");
}

TEST_CASE("a word of a shell command is quoted where the shell would cut it") {
    CHECK(shell_word("my-case/case.json") == "my-case/case.json");
    CHECK(shell_word("my case") == "'my case'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("") == "''");
}
