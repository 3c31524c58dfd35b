// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/quantities/quantity.hpp"
#include "core/tables/text_lines.hpp"
#include "core/text/error.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

TEST_CASE("an input error is one line: place, problem, what is allowed") {
    const InputError error("density is -3 kg/m3", "a positive density");
    CHECK(std::string(error.what()) == "density is -3 kg/m3; allowed: a positive density");
    CHECK(std::string(error.at("/samples/0/density").at("case.json").what()) ==
          "case.json: /samples/0/density: density is -3 kg/m3; allowed: a positive density");
}

TEST_CASE("a place that is there already is not said twice, but a key may hold one of its own name") {
    const InputError error("is 0", "> 0");
    CHECK(std::string(error.at("--density").at("--density").what()) == "--density: is 0; allowed: > 0");
    CHECK(std::string(error.at(FileName{"zz"}).at(FileName{"zz"}).what()) == "zz: is 0; allowed: > 0");
    CHECK(std::string(error.at("line 3").at(FileName{"zz"}).at(FileName{"zz"}).what()) ==
          "zz: line 3: is 0; allowed: > 0");
    CHECK(std::string(error.at("/1").at("").at(FileName{"zz"}).what()) == "zz: /1: is 0; allowed: > 0");
    CHECK(std::string(error.at("/a").at("/a").what()) == "/a/a: is 0; allowed: > 0");
}

TEST_CASE("lines of a megabyte are read, wherever they stand; longer ones are refused with their number") {
    const std::string megabyte(std::size_t{1} << 20, 'x');
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const std::string line = megabyte + end;
        std::string text = line;
        text.append(line).append("last");
        const TextLines lines(text, {});
        REQUIRE(lines.lines().size() == 3);
        CHECK(lines.lines()[1].text.size() == megabyte.size());
        CHECK(lines.lines()[2].text == "last");
        text = line;
        text.append("x").append(line);
        std::string message;
        try {
            const TextLines refused(text, {});
        } catch (const InputError& error) {
            message = error.what();
        }
        CHECK(message == "line 2: the line is longer than a megabyte; allowed: a text file with lines");
    }
}

TEST_CASE("an uncertainty in brackets counts in the last place of the number, its exponent included") {
    struct Row {
        const char* text;
        double value;
        double uncertainty;
    };
    for (const Row& row : {Row{"2.54e1(3)", 25.4, 0.3}, Row{"2.54e1(12)", 25.4, 1.2},
                           Row{"25.4E-2(3)", 0.254, 0.003}, Row{"12.3(4)", 12.3, 0.4}, Row{"12(4)", 12, 4},
                           Row{"12.3(0.25)", 12.3, 0.25}, Row{"0.2548+-0.0029", 0.2548, 0.0029},
                           Row{"12.3 \u00b1 0.4", 12.3, 0.4}, Row{"2.54e1 +/- 3e-1", 25.4, 0.3}}) {
        CAPTURE(row.text);
        const auto number = read_number(row.text);
        REQUIRE(number);
        CHECK(relative_difference(number->value, row.value) < 1e-14);
        CHECK(relative_difference(number->standard_uncertainty.value_or(0), row.uncertainty) < 1e-14);
        CHECK_FALSE(number->per_cent);
    }
}

TEST_CASE("numbers without an uncertainty, per cent, decimal commas, and what is no number") {
    CHECK_FALSE(read_number("12.3")->standard_uncertainty);
    CHECK_FALSE(read_number("12.3(0)")->standard_uncertainty);
    CHECK(read_number("12.3(4) %")->per_cent);
    CHECK(read_number("12,3(4)", true)->value == 12.3);
    for (const char* text :
         {"", "quartz", "12.3(", "12.3(x)", "12.3(-4)", "12.3 4", "1e999", "12,3", "0x1F"}) {
        CAPTURE(text);
        CHECK_FALSE(read_number(text));
    }
}

TEST_CASE("UTF-8 is read character by character; bytes that are none stand for themselves") {
    std::vector<char32_t> found;
    for_each_character("aü€😀\xff", [&](const Character& c) { found.push_back(c.code_point); });
    CHECK(found == std::vector<char32_t>{'a', 0xfc, 0x20ac, 0x1f600, 0xfffd});
    CHECK(is_utf8("aü€😀"));
    for (const char* text : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
                             "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xe2\x82", "\xe2\x28\xa1"}) {
        CAPTURE(text);
        CHECK_FALSE(is_utf8(text));
        CHECK_FALSE(first_character(text).valid);
        CHECK(first_character(text).bytes.size() == 1);
    }
    CHECK(from_latin1("R\xfc"
                      "ck") == "Rück");
    CHECK(is_ascii("~"));
    CHECK_FALSE(is_ascii("é"));
    CHECK(without_controls("a\x1b\tb\xc2\x9b\xff") == "a?\tb??");
}

TEST_CASE("texts are measured and cut in whole characters") {
    CHECK(width_of("µm €") == 4);
    CHECK(first_characters("µm €", 2) == "µm");
    CHECK(first_characters("µm", 9) == "µm");
    CHECK(first_characters("µm", 0).empty());
    CHECK(whole_start("a€b", 3) == "a");
    CHECK(whole_start("a€b", 4) == "a€");
    CHECK(whole_end("a€b", 3) == "b");
    CHECK(whole_end("a€b", 4) == "€b");
}

TEST_CASE("words are compared without marks, case, umlauts and accents") {
    CHECK(word_key("v_{rück}") == "vrueck");
    CHECK(word_key("V_RÜCK") == "vrueck");
    CHECK(word_key("v_ru\u0308ck") == "vrueck");
    CHECK(word_key("Stoßzahl") == word_key("Stosszahl"));
    CHECK(word_key("v_entrée") == word_key("v_entre\u0301e"));
    CHECK(word_key("α-Quartz") == word_key("alpha quartz"));
    CHECK(word_key("SiO₂ (±2σ)", "+") == "sio2+2sigma");
    CHECK(word_key("石英") == "石英");
    CHECK(word_key("wt.%", "%") == "wt%");
}

}  // namespace ashimpact::test
