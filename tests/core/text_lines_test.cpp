// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/text_lines.hpp"

#include <doctest/doctest.h>

#include "core/text/error.hpp"

using namespace ashimpact;

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
