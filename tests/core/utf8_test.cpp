// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "core/text/text.hpp"

namespace ashimpact::test {

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
