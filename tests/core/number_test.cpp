// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "core/quantities/quantity.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

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

}  // namespace ashimpact::test
