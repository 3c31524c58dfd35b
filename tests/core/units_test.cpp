// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/units.hpp"

#include <array>
#include <initializer_list>
#include <string>

#include <doctest/doctest.h>

#include "core/text/error.hpp"
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

TEST_CASE("symbols and names have their values, with every prefix") {
    struct Row {
        std::string_view text;
        std::string_view si;
        double factor;
    };
    for (const auto& [text, si, factor] :
         {Row{"N", "kg m s-2", 1}, Row{"Pa", "kg m-1 s-2", 1}, Row{"J", "kg m2 s-2", 1},
          Row{"W", "kg m2 s-3", 1}, Row{"Hz", "s-1", 1}, Row{"g", "kg", 1e-3}, Row{"bar", "Pa", 1e5},
          Row{"dyn", "N", 1e-5}, Row{"dyne", "N", 1e-5}, Row{"erg", "J", 1e-7}, Row{"P", "Pa s", 0.1},
          Row{"poise", "Pa s", 0.1}, Row{"L", "m3", 1e-3}, Row{"micron", "m", 1e-6},
          Row{"angstrom", "m", 1e-10}, Row{"mil", "m", 2.54e-5}, Row{"meter", "m", 1}, Row{"newton", "N", 1},
          Row{"gram", "kg", 1e-3}}) {
        struct Prefix {
            std::string_view text;
            double factor;
        };
        for (const Prefix& prefix :
             {Prefix{"", 1}, Prefix{"T", 1e12}, Prefix{"G", 1e9}, Prefix{"M", 1e6}, Prefix{"k", 1e3},
              Prefix{"c", 1e-2}, Prefix{"m", 1e-3}, Prefix{"u", 1e-6}, Prefix{"n", 1e-9}, Prefix{"p", 1e-12},
              Prefix{"f", 1e-15}, Prefix{"giga", 1e9}, Prefix{"MEGA", 1e6}, Prefix{"Kilo", 1e3},
              Prefix{"milli", 1e-3}, Prefix{"micro", 1e-6}, Prefix{"nano", 1e-9}}) {
            const std::string whole = std::string(prefix.text) + std::string(text);
            if (whole == "microN") continue;  // the micron, as names go in any case
            CAPTURE(whole);
            const auto unit = read_unit(whole);
            REQUIRE(unit);
            CHECK(unit->powers == read_unit(si)->powers);
            CHECK(relative_difference(unit->factor, prefix.factor * factor) < 1e-14);
        }
    }
}

TEST_CASE("units are read as UDUNITS-2 2.2.28 reads them") {
    struct Row {
        std::string_view text;
        std::string_view si;
        double factor;
    };
    for (const auto& [text, si, factor] : {Row{"kg.m-3", "kg/m3", 1},
                                           Row{"kg*m^-3", "kg/m3", 1},
                                           Row{"kg m^-3", "kg/m3", 1},
                                           Row{"kg/(m.s)", "Pa s", 1},
                                           Row{"kg/m/s2", "Pa", 1},
                                           Row{"N-s", "N s", 1},
                                           Row{"lb/ft3", "kg/m3", 16.018463373960138},
                                           Row{"lb/in3", "kg/m3", 27679.90471020312},
                                           Row{"mm/ms", "m/s", 1},
                                           Row{"J/(m2)", "J/m2", 1},
                                           Row{"(m)(s-1)", "m/s", 1},
                                           Row{"m per s", "m/s", 1},
                                           Row{"m  per  s", "m/s", 1},
                                           Row{"meters/second", "m/s", 1},
                                           Row{"Metres Per Second", "m/s", 1},
                                           Row{"MICROMETERS", "m", 1e-6},
                                           Row{"inches", "m", 0.0254},
                                           Row{"feet", "m", 0.3048},
                                           Row{"dam", "m", 10},
                                           Row{"m^+2", "m2", 1},
                                           Row{"m+2", "m2", 1},
                                           Row{"((m))", "m", 1},
                                           Row{"Mg", "kg", 1000},
                                           Row{"mg", "kg", 1e-6},
                                           Row{"g/cc", "kg/m3", 1000},
                                           Row{"g/L", "kg/m3", 1},
                                           Row{"km h-1", "m/s", 1 / 3.6},
                                           Row{"mi/h", "m/s", 0.44704},
                                           Row{"ft/s", "m/s", 0.3048},
                                           Row{"knot", "m/s", 1852.0 / 3600},
                                           Row{"kgf/cm2", "Pa", 98066.5},
                                           Row{"lbf/in2", "Pa", 6894.757293168361},
                                           Row{"atm", "Pa", 101325},
                                           Row{"torr", "Pa", 133.322387415},
                                           Row{"mmHg", "Pa", 133.322387415},
                                           Row{"cmH2O", "Pa", 98.0665},
                                           Row{"ksi", "Pa", 6894757.293168361},
                                           Row{"dyn/cm", "J/m2", 1e-3},
                                           Row{"erg/cm2", "J/m2", 1e-3},
                                           Row{"eV", "J", 1.60217733e-19},
                                           Row{"cal", "J", 4.1868},
                                           Row{"kWh", "J", 3.6e6},
                                           Row{"cP", "Pa s", 1e-3},
                                           Row{"min", "s", 60},
                                           Row{"h", "s", 3600},
                                           Row{"days", "s", 86400},
                                           Row{"grain", "kg", 6.479891e-5},
                                           Row{"pounds", "kg", 0.45359237},
                                           Row{"ton", "kg", 907.18474},
                                           Row{"tonnes", "kg", 1000},
                                           Row{"ppm", "1", 1e-6},
                                           Row{"percent", "1", 0.01},
                                           Row{"Btu", "J", 1055.05585262}}) {
        CAPTURE(text);
        const auto unit = read_unit(text);
        REQUIRE(unit);
        CHECK(unit->powers == read_unit(si)->powers);
        CHECK(relative_difference(unit->factor, factor) < 1e-14);
    }
    for (const std::string_view text :
         {"",    "m^", "m^ 2", "m..s", "()",  "m/",  "/m",   "perm", "J perm2", "(J)pers",
          "m()", "(m", "m)",   "m)s",  "%m",  "m%",  "%%",   "mmm",  "oven",    "_m",
          "m_",  "da", "pa",   "2 m",  "1 m", "m 2", "m--2", "m-",   "cdd",     "m99999999999"}) {
        CAPTURE(text);
        CHECK_FALSE(read_unit(text));
    }
    CHECK_FALSE(read_unit(std::string(1'000'000, '(')));
    for (const std::string_view text : {"degC", "K", "A", "mol", "cd", "ncd", "J/degC", "lx"}) {
        CAPTURE(text);
        REQUIRE(read_unit(text));
        CHECK(read_unit(text)->powers.back() != 0);
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
