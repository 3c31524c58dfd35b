// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/units.hpp"

#include <array>
#include <initializer_list>
#include <string>

#include <doctest/doctest.h>

#include "core/error.hpp"
#include "core/units/unit_system.hpp"
#include "tests/relative_difference.hpp"

namespace ashimpact::test {

namespace {

std::string message(std::string_view text, Dimension dimension) {
    try {
        static_cast<void>(parse_quantity(text, dimension));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("quantities as users write them") {
    struct Row {
        std::string_view text;
        Dimension dimension;
        double value;
    };
    constexpr std::array rows{
        Row{"44 um", Dimension::length, 44e-6},
        Row{"44um", Dimension::length, 44e-6},
        Row{" 44 \u00b5m ", Dimension::length, 44e-6},
        Row{"44 \u03bcm", Dimension::length, 44e-6},
        Row{"44\u00a0\u00b5m", Dimension::length, 44e-6},
        Row{"44 micron", Dimension::length, 44e-6},
        Row{"\u221244 um", Dimension::length, -44e-6},
        Row{"300 dyn/cm", Dimension::energy_per_area, 0.3},
        Row{"44 micrometer", Dimension::length, 44e-6},
        Row{"3 \u00c5", Dimension::length, 3e-10},
        Row{"4.4e-5", Dimension::length, 44e-6},
        Row{"+4.4e-5 m", Dimension::length, 44e-6},
        Row{"2160 kg/m3", Dimension::density, 2160},
        Row{"2.16 g/cm3", Dimension::density, 2160},
        Row{"2.16 g/cm^3", Dimension::density, 2160},
        Row{"2.16 g/cm**3", Dimension::density, 2160},
        Row{"2160 kg m-3", Dimension::density, 2160},
        Row{"2160 kg\u00b7m\u207b\u00b3", Dimension::density, 2160},
        Row{"90 GPa", Dimension::pressure, 90e9},
        Row{"0.09 N/um^2", Dimension::pressure, 90e9},
        Row{"13000 psi", Dimension::pressure, 13000 * 6894.757293168361},
        Row{"0.3 J/m2", Dimension::energy_per_area, 0.3},
        Row{"300 mJ/m2", Dimension::energy_per_area, 0.3},
        Row{"300 mJ m-2", Dimension::energy_per_area, 0.3},
        Row{"300 erg/cm2", Dimension::energy_per_area, 0.3},
        Row{"0.3 N/m", Dimension::energy_per_area, 0.3},
        Row{"0.0141 kg/s", Dimension::damping, 0.0141},
        Row{"14.1 g/s", Dimension::damping, 0.0141},
        Row{"0.0141 N s/m", Dimension::damping, 0.0141},
        Row{"2 m/s", Dimension::velocity, 2},
        Row{"2 m s-1", Dimension::velocity, 2},
        Row{"7.2 km/h", Dimension::velocity, 2},
        Row{"10 %", Dimension::fraction, 0.1},
        Row{"10%", Dimension::fraction, 0.1},
        Row{"0.1", Dimension::fraction, 0.1},
        Row{"0.1 1", Dimension::fraction, 0.1},
        Row{"294 ns", Dimension::time, 294e-9},
        Row{"0.93 ug", Dimension::mass, 0.93e-9},
        Row{"1.9 nJ", Dimension::energy, 1.9e-9},
        Row{"-2 mm/s", Dimension::velocity, -2e-3},
    };
    for (const Row& row : rows) {
        CAPTURE(row.text);
        CHECK(relative_difference(parse_quantity(row.text, row.dimension), row.value) < 1e-14);
    }
}

TEST_CASE("junk, wrong dimensions and numbers that are none are one-line errors with examples") {
    for (const auto text : std::initializer_list<std::string_view>{"",
                                                                   "  ",
                                                                   "um",
                                                                   "forty um",
                                                                   "44 parsnips",
                                                                   "44 um um um/",
                                                                   "44 5 um",
                                                                   "44 m 3",
                                                                   "nan",
                                                                   "inf um",
                                                                   "1e999 m",
                                                                   "-inf",
                                                                   "0x10 um",
                                                                   "4,4 um",
                                                                   "44 um since 1970-01-01",
                                                                   "44 lg(re 1 um)",
                                                                   "44 um @ 3",
                                                                   "44 um\n44 um",
                                                                   "--1 m",
                                                                   "+-1 m",
                                                                   "1e",
                                                                   "44 m -3",
                                                                   "44 m*3",
                                                                   "44 m2",
                                                                   "44 kg",
                                                                   "44 %",
                                                                   "44 1/m",
                                                                   "44 degC"}) {
        CAPTURE(text);
        const std::string line = message(text, Dimension::length);
        CHECK(line.find('\n') == std::string::npos);
        CHECK(line.find("allowed: a length [m], e.g. 44 um") != std::string::npos);
    }
    CHECK(message("2 kg/m 3", Dimension::density) ==
          "the unit \"kg/m 3\" is not known; allowed: a density [kg/m3], e.g. 2160 kg/m3, 2.16 g/cm3");
    CHECK(message("3 J", Dimension::energy_per_area) ==
          "the unit \"J\" is not one of energy per area; allowed: an energy per area [J/m2], e.g. 0.3 J/m2, "
          "300 "
          "mJ/m2, 0.3 N/m");
    CHECK(message("5 1/s", Dimension::time).find("allowed") != std::string::npos);
    CHECK(message("1e308 GPa", Dimension::pressure).find("too large") != std::string::npos);
}

TEST_CASE("a long piece of junk is shown cut") {
    CHECK(message(std::string(100'000, 'x'), Dimension::mass).size() < 200);
}

TEST_CASE("the small unit table agrees with the UDUNITS-2 database, with every prefix") {
    const std::array<std::pair<std::string_view, std::string_view>, 12> units{{{"m", "m"},
                                                                               {"g", "kg"},
                                                                               {"s", "s"},
                                                                               {"N", "kg.m.s-2"},
                                                                               {"Pa", "kg.m-1.s-2"},
                                                                               {"J", "kg.m2.s-2"},
                                                                               {"W", "kg.m2.s-3"},
                                                                               {"bar", "kg.m-1.s-2"},
                                                                               {"dyne", "kg.m.s-2"},
                                                                               {"erg", "kg.m2.s-2"},
                                                                               {"meter", "m"},
                                                                               {"newton", "kg.m.s-2"}}};
    int compared = 0;
    for (const auto& [unit, base] : units) {
        for (const auto* prefix : {"", "T", "G", "M", "k", "c", "m", "u", "n", "p", "f", "giga", "mega",
                                   "kilo", "centi", "milli", "micro", "nano"}) {
            const std::string text = prefix + std::string(unit);
            const auto small = scale_to(text, base);
            const auto large = database_scale_to(text, base);
            CAPTURE(text);
            CHECK(small.problem == large.problem);
            CHECK(relative_difference(small.scale, large.scale) < 1e-14);
            compared += large.problem == UnitProblem::none;
        }
    }
    CHECK(compared > 120);
    for (const auto* text : {"%", "percent", "micron", "angstrom"}) {
        const auto* const base = text[0] == '%' || text[0] == 'p' ? "1" : "m";
        CAPTURE(text);
        CHECK(relative_difference(scale_to(text, base).scale, database_scale_to(text, base).scale) < 1e-14);
    }
}

TEST_CASE("rounding noise of the unit factors does not reach the values") {
    CHECK(parse_quantity("44 um", Dimension::length) == 44e-6);
    CHECK(parse_quantity("2.8 g/cm3", Dimension::density) == 2800);
    CHECK(parse_quantity("143.1 GPa", Dimension::pressure) == 143.1e9);
    CHECK(parse_quantity("294 ns", Dimension::time) == 294e-9);
}

TEST_CASE("every dimension's own unit converts to itself") {
    for (int i = 0; i <= static_cast<int>(Dimension::damping); ++i) {
        const auto dimension = static_cast<Dimension>(i);
        CAPTURE(dimension_name(dimension));
        CHECK(to_si(7.3, si_unit(dimension), dimension) == 7.3);
    }
}

}  // namespace ashimpact::test
