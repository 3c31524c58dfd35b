// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text.hpp"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "core/json/view.hpp"
#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/text_lines.hpp"
#include "core/text/error.hpp"
#include "core/units/units.hpp"
#include "tests/support/checks.hpp"

namespace ashimpact::test {

namespace {

std::string message(std::string_view text, Dimension dimension) {
    return input_error_of([&] { return parse_quantity(text, dimension); });
}

/// The parts of a text between marks.
std::vector<std::string> parted(const std::string& text, char mark = '|') {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == mark)
            parts.emplace_back();
        else
            parts.back() += letter;
    }
    return parts;
}

using json = nlohmann::ordered_json;

std::string json_message(const char* text, Dimension dimension) {
    return input_error_of([&] { return read_quantity(json::parse(text), dimension); });
}

}  // namespace

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
    CHECK(remedy_for_number_in_quotes("80-100").empty());
    CHECK(word_key("ФАЗА ЁЖ") == "фазаёж");
    CHECK(word_key("ÁREA") == word_key("área"));
    CHECK(word_key("Ø") != word_key("o"));  // a mean is no sample O
    CHECK(word_key("v_ru\u0308ck") == "vrueck");
    CHECK(word_key("Stoßzahl") == word_key("Stosszahl"));
    CHECK(word_key("v_entrée") == word_key("v_entre\u0301e"));
    CHECK(word_key("α-Quartz") == word_key("alpha quartz"));
    CHECK(word_key("SiO₂ (±2σ)", "+") == "sio2+2sigma");
    CHECK(word_key("石英") == "石英");
    CHECK(word_key("wt.%", "%") == "wt%");
}

TEST_CASE("quantities as users write them") {
    struct Written {
        double value;
        Dimension dimension;
        const char* texts;
    };
    for (const Written& written : {
             Written{44e-6, Dimension::length,
                     "44 um|44um| 44 \u00b5m |44 \u03bcm|44\u00a0\u00b5m|44 micron|44 "
                     "micrometer|4.4e-5|+4.4e-5 m"},
             Written{-44e-6, Dimension::length, "\u221244 um"},
             Written{3e-10, Dimension::length, "3 \u00c5"},
             Written{2160, Dimension::density,
                     "2160 kg/m3|2.16 g/cm3|2.16 g/cm^3|2.16 g/cm**3|2160 kg m-3|2160 kg\u00b7m\u207b\u00b3"},
             Written{90e9, Dimension::pressure, "90 GPa|0.09 N/um^2"},
             Written{13000 * 6894.757293168361, Dimension::pressure, "13000 psi"},
             Written{0.3, Dimension::energy_per_area,
                     "0.3 J/m2|300 mJ/m2|300 mJ m-2|300 erg/cm2|0.3 N/m|300 dyn/cm"},
             Written{0.0141, Dimension::damping, "0.0141 kg/s|14.1 g/s|0.0141 N s/m"},
             Written{2, Dimension::velocity, "2 m/s|2 m s-1|7.2 km/h"},
             Written{-2e-3, Dimension::velocity, "-2 mm/s"},
             Written{0.1, Dimension::fraction, "10 %|10%|0.1|0.1 1"},
             Written{294e-9, Dimension::time, "294 ns"},
             Written{0.93e-9, Dimension::mass, "0.93 ug"},
             Written{1.9e-9, Dimension::energy, "1.9 nJ"},
         })
        for (const std::string& text : parted(written.texts)) {
            CAPTURE(text);
            CHECK(relative_difference(parse_quantity(text, written.dimension), written.value) < 1e-14);
        }
}

TEST_CASE("junk, wrong dimensions and numbers that are none are one-line errors with examples") {
    for (const std::string& text : parted(
             "|  |um|forty um|44 parsnips|44 um um um/|44 5 um|44 m 3|nan|inf um|1e999 m|-inf|0x10 um|4,4 um|"
             "44 um since 1970-01-01|44 lg(re 1 um)|44 um @ 3|44 um\n44 um|--1 m|+-1 m|1e|44 m -3|44 m*3|44 "
             "m2|"
             "44 kg|44 %|44 1/m|44 degC")) {
        CAPTURE(text);
        const std::string line = message(text, Dimension::length);
        CHECK_FALSE(contains(line, "\n"));
        CHECK(contains(line, "allowed: a length [m], e.g. 44 um"));
    }
    CHECK(message("2 kg/m 3", Dimension::density) ==
          "the unit \"kg/m 3\" is not known, did you mean \"kg/m3\"?; allowed: a density [kg/m3], e.g. 2160 "
          "kg/m3, 2.16 g/cm3");
    CHECK(message("3 J", Dimension::energy_per_area) ==
          "the unit \"J\" is not one of energy per area; allowed: an energy per area [J/m2], e.g. 0.3 J/m2, "
          "300 "
          "mJ/m2, 0.3 N/m");
    CHECK(contains(message("5 1/s", Dimension::time), "allowed"));
    CHECK(contains(message("1e308 GPa", Dimension::pressure), "too large"));
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
    // An SI unit, and units that are so many of it.
    for (const std::string& line : parted(
             "kg/m3|kg.m-3 = 1|kg*m^-3 = 1|kg m^-3 = 1|lb/ft3 = 16.018463373960138|"
             "lb/in3 = 27679.90471020312|g/cc = 1000|g/L = 1\n"
             "Pa s|kg/(m.s) = 1|cP = 1e-3\n"
             "Pa|kg/m/s2 = 1|kgf/cm2 = 98066.5|lbf/in2 = 6894.757293168361|atm = 101325|torr = 133.322387415|"
             "mmHg = 133.322387415|cmH2O = 98.0665|ksi = 6894757.293168361\n"
             "N s|N-s = 1\n"
             "m/s|mm/ms = 1|(m)(s-1) = 1|m per s = 1|m  per  s = 1|meters/second = 1|Metres Per Second = 1|"
             "km h-1 = 0.2777777777777778|mi/h = 0.44704|ft/s = 0.3048|knot = 0.5144444444444445\n"
             "J/m2|J/(m2) = 1|dyn/cm = 1e-3|erg/cm2 = 1e-3\n"
             "m|MICROMETERS = 1e-6|inches = 0.0254|feet = 0.3048|dam = 10|((m)) = 1\n"
             "m2|m^+2 = 1|m+2 = 1\n"
             "kg|Mg = 1000|mg = 1e-6|grain = 6.479891e-5|pounds = 0.45359237|ton = 907.18474|tonnes = 1000\n"
             "J|eV = 1.60217733e-19|cal = 4.1868|kWh = 3.6e6|Btu = 1055.05585262\n"
             "s|min = 60|h = 3600|days = 86400\n"
             "1|ppm = 1e-6|percent = 0.01",
             '\n')) {
        const std::vector<std::string> units = parted(line);
        for (std::size_t i = 1; i < units.size(); ++i) {
            CAPTURE(units[i]);
            const std::size_t equals = units[i].find(" = ");
            const auto unit = read_unit(units[i].substr(0, equals));
            REQUIRE(unit);
            CHECK(unit->powers == read_unit(units[0])->powers);
            CHECK(relative_difference(unit->factor, std::stod(units[i].substr(equals + 3))) < 1e-14);
        }
    }
    for (const std::string& text :
         parted("|m^|m^ 2|m..s|()|m/|/m|perm|J perm2|(J)pers|m()|(m|m)|m)s|%m|m%|%%|mmm|oven|_m|m_|da|pa|2 "
                "m|1 m|m 2|m--2|m-|cdd|m99999999999")) {
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

TEST_CASE("per cent is no factor of another unit") {
    for (const char* text :
         {"90 % GPa", "193 +- 5 % GPa", "88 \u00b1 4 % um", "10 % %", "30 % J/m2", "5 percent um"}) {
        CAPTURE(text);
        CHECK(!input_error_of([&] { return parse_quantity(text, Dimension::length); }).empty());
        CHECK(!input_error_of([&] { return parse_quantity(text, Dimension::pressure); }).empty());
        CHECK(!input_error_of([&] { return parse_quantity(text, Dimension::fraction); }).empty());
    }
    CHECK(parse_quantity("5 %", Dimension::fraction) == 0.05);
}

TEST_CASE("a unit of two readings is refused with both") {
    CHECK_THROWS_WITH_AS(static_cast<void>(parse_quantity("2.3 gr/cm3", Dimension::density)),
                         "the unit \"gr/cm3\" has two readings, gram and grain; allowed: \"g\" or \"grain\"",
                         InputError);
    for (const char* text : {"2.3 ton/m3", "2.3 tons/m3", "2.3 Ton/m3", "8 lb/gallon"})
        CHECK_THROWS_AS(static_cast<void>(parse_quantity(text, Dimension::density)), InputError);
    CHECK(parse_quantity("2.3 t/m3", Dimension::density) == 2300);
    CHECK(parse_quantity("1 short_ton", Dimension::mass) == doctest::Approx(907.18474));
    CHECK_THROWS_WITH_AS(static_cast<void>(parse_quantity("30 grad", Dimension::angle)),
                         "the unit \"grad\" has two readings, degree and gradian; allowed: \"deg\"; 100 "
                         "gradians are 90 deg",
                         InputError);
    for (const char* angle : {"500 mrad", "500 milliradians", "0.5 rad"})
        CHECK(parse_quantity(angle, Dimension::angle) == doctest::Approx(0.5));
    CHECK_THROWS_AS(static_cast<void>(parse_quantity("50 %", Dimension::angle)), InputError);
    CHECK(parse_quantity("30 Grad", Dimension::angle) == parse_quantity("30 deg", Dimension::angle));
    CHECK(parse_quantity("900 deg C", Dimension::temperature) == doctest::Approx(1173.15));
    CHECK(parse_quantity("0.005 Ns/m", Dimension::damping) == 0.005);
    CHECK(parse_quantity("0.04 mPas", Dimension::viscosity) ==
          parse_quantity("0.04 mPa s", Dimension::viscosity));
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

TEST_CASE("a quantity is read from a number, a string or an object, and is SI afterwards") {
    const auto from_number = read_quantity(json::parse("4.4e-5"), Dimension::length);
    CHECK(from_number.value == 4.4e-5);
    CHECK(from_number.unit == "m");
    CHECK(!from_number.standard_uncertainty);
    CHECK(relative_difference(read_quantity(json::parse(R"("44 um")"), Dimension::length).value, 4.4e-5) <
          1e-15);
    const auto from_object = read_quantity(
        json::parse(R"({"value": 143.1, "unit": "GPa", "standard_uncertainty": 2.5})"), Dimension::pressure);
    CHECK(relative_difference(from_object.value, 143.1e9) < 1e-15);
    CHECK(from_object.unit == "Pa");
    CHECK(relative_difference(from_object.standard_uncertainty.value(), 2.5e9) < 1e-15);
    const auto other_unit = json::parse(R"({"value": 143.1, "unit": "GPa", "standard_uncertainty": 2.5e9})");
    CHECK(contains(input_error_of([&] { static_cast<void>(read_quantity(other_unit, Dimension::pressure)); }),
                   "1.75e+07 times the value: it may be in another unit"));
    // A velocity may be a difference.
    const auto difference = json::parse(R"({"value": 1e-9, "unit": "m/s", "standard_uncertainty": 0.5})");
    CHECK(read_quantity(difference, Dimension::velocity).standard_uncertainty == 0.5);
}

TEST_CASE("a string may carry its standard uncertainty, with one unit for both, or per cent") {
    struct Row {
        const char* text;
        Dimension dimension;
        double value;
        double uncertainty;
    };
    for (const Row& row : {Row{R"("60 +- 3 um")", Dimension::length, 60e-6, 3e-6},
                           Row{R"("60 um +- 3 um")", Dimension::length, 60e-6, 3e-6},
                           Row{R"("60 um +/- 5 %")", Dimension::length, 60e-6, 3e-6},
                           Row{"\"2.6 \u00b1 0.1 g/cm3\"", Dimension::density, 2600, 100},
                           Row{R"("0.42 +- 0.02")", Dimension::fraction, 0.42, 0.02},
                           Row{R"("42 +- 2 %")", Dimension::fraction, 0.42, 0.02}}) {
        CAPTURE(row.text);
        const Quantity quantity = read_quantity(json::parse(row.text), row.dimension);
        CHECK(relative_difference(quantity.value, row.value) < 1e-14);
        CHECK(relative_difference(quantity.standard_uncertainty.value(), row.uncertainty) < 1e-14);
    }
    CHECK(contains(json_message(R"("60 +- -3 um")", Dimension::length), "is below zero"));
    CHECK_FALSE(json_message(R"("60 um +- 3 kg")", Dimension::length).empty());
    CHECK_FALSE(json_message(R"("+- 3 um")", Dimension::length).empty());
}

TEST_CASE("the shortest text of a number is that number, of powers of two as well") {
    for (int power = -1074; power <= 1023; ++power) {
        const double value = std::ldexp(1.0, power);
        for (const double each : {value, std::nextafter(value, 0.0), std::nextafter(value, 2 * value)})
            CHECK(std::strtod(shortest(each).c_str(), nullptr) == each);
    }
}

TEST_CASE("a raised digit in a number is refused, in a unit it counts") {
    for (const char* text : {"1\u00b710\u00b3 m/s", "10\u00b3 m/s", "1.5\u00b9 m/s", "2\u00d710\u2076 m/s"})
        CHECK_MESSAGE(
            contains(input_error_of([&] { return quantity_of_text(text, Dimension::velocity).value; }),
                     "has a raised digit in its number"),
            text);
    CHECK(quantity_of_text("1e3 kg/m\u00b3", Dimension::density).value == 1000);
    CHECK(quantity_of_text("2.6 g\u00b7cm\u207b\u00b3", Dimension::density).value == doctest::Approx(2600));
}

TEST_CASE("three decimals in a unit that often has thousands are refused") {
    for (const char* text : {"95.600 N/mm2", "206.800 MPa", "193.000 GPa"})
        CHECK_MESSAGE(
            contains(input_error_of([&] { return quantity_of_text(text, Dimension::pressure).value; }),
                     " is " + std::string(text, std::string_view(text).find(' '))),
            text);
    CHECK(contains(input_error_of([&] { return quantity_of_text("15.400 ppm", Dimension::fraction).value; }),
                   "15.400 or 15400"));
    CHECK(contains(input_error_of([&] { return quantity_of_text("1.550 mm/s", Dimension::velocity).value; }),
                   "1.550 or 1550"));
    CHECK(contains(input_error_of([&] { return quantity_of_text("1.200 cm/s", Dimension::velocity).value; }),
                   "1.200 or 1200"));
    CHECK(contains(input_error_of([&] { return quantity_of_text("14.100 mg/s", Dimension::damping).value; }),
                   "14.100 or 14100"));
    CHECK(quantity_of_text("1.550 m/s", Dimension::velocity).value == 1.55);
    CHECK(quantity_of_text("2.648 g/cm3", Dimension::density).value == doctest::Approx(2648));
    CHECK(quantity_of_text("0.950 MPa", Dimension::pressure).value == doctest::Approx(0.95e6));
    CHECK(quantity_of_text("110.25 MPa", Dimension::pressure).value == doctest::Approx(110.25e6));
}

TEST_CASE("a number without a dimension needs no unit; a decimal comma is refused with the remedy") {
    const auto ratio =
        read_quantity(json::parse(R"({"value": 0.29, "standard_uncertainty": 0.01})"), Dimension::fraction);
    CHECK(ratio.value == 0.29);
    CHECK(ratio.standard_uncertainty == 0.01);
    CHECK(json_message(R"("2,6 g/cm3")", Dimension::density)
              .starts_with("\"2,6 g/cm3\" has a decimal comma, write \"2.6 g/cm3\"; allowed: a density"));
}

TEST_CASE("the remedy for commas is a number that means what was meant") {
    const auto remedy = [](const std::string& text, Dimension dimension) {
        const std::string message = json_message(json(text).dump().c_str(), dimension);
        const auto begin = message.find("write ");
        return begin == std::string::npos ? message
                                          : message.substr(begin, message.find("; allowed") - begin);
    };
    CHECK(remedy("2,60 g/cm3", Dimension::density) == "write \"2.60 g/cm3\"");
    CHECK(remedy("0,005 kg/s", Dimension::damping) == "write \"0.005 kg/s\"");
    CHECK(remedy("2,300 kg/m3", Dimension::density) == "write \"2300 kg/m3\" or \"2.300 kg/m3\"");
    CHECK(remedy("2.300,5 kg/m3", Dimension::density) == "write \"2300.5 kg/m3\"");
    CHECK(remedy("2,300.5 kg/m3", Dimension::density) == "write \"2300.5 kg/m3\"");
    CHECK(remedy("1,234,567 Pa", Dimension::pressure) == "write \"1234567 Pa\"");
    CHECK(remedy("2,3 +- 0,1 g/cm3", Dimension::density) == "write \"2.3 +- 0.1 g/cm3\"");
    CHECK(json_message(R"({"value": "2,3", "unit": "g/cm3"})", Dimension::density)
              .starts_with("/value: not a number, write 2.3 without quotes"));
    CHECK(json_message(R"({"value": "much", "unit": "g/cm3"})", Dimension::density)
              .starts_with("/value: not a number; allowed"));
}

TEST_CASE("a value far from what ash has is doubted; where another unit is likely, it must be written") {
    struct Written {
        const char* option;
        const char* text;
        const char* says;  // empty: plausible
        bool refused = false;
    };
    for (const Written& each :
         {Written{"--diameter", "44e-6", ""},
          {"--diameter", "5 mm", ""},
          {"--diameter", "10 nm", ""},
          {"--radius", "3 mm", "--radius: 3 mm is outside of what is plausible, 5 nm to 2.5 mm: is the unit"},
          {"--diameter", "0.9", "0.9 has no unit and is 0.9 m, did you mean 0.9 um?", true},
          {"--diameter", "0.9 m", "--diameter: 900 mm is outside"},
          {"--diameter", "90 m", "--diameter: 90 m is outside of what is plausible, 10 nm to 5 mm"},
          {"--diameter", "90", "--diameter: 90 has no unit and is 90 m, did you mean 90 um?; allowed: 10 nm",
           true},
          {"--partner-diameter", "200 +- 3", "200 has no unit and is 200 m, did you mean 200 um?", true},
          {"--radius", "8000", "did you mean 8000 nm?", true},
          {"--young-modulus", "110", "110 has no unit and is 110 Pa, did you mean 110 GPa?", true},
          {"--wall-young-modulus", "193000 MPa", ""},
          {"--contact-modulus", "5000", "did you mean 5000 MPa?", true},
          {"--roughness", "1", "--roughness: 1 has no unit and is 1 m, did you mean 1 nm?", true},
          {"--density", "2.3", "--density: 2.3 has no unit and is 2.3 kg/m3, did you mean 2.3 g/cm3?", true},
          {"--density", "2.3 kg/m3",
           "--density: 2.3 kg/m3 is outside of what is plausible, 50 to 25,000 kg/m3"},
          {"--density", "30", "--density: 30 kg/m3 is outside"},
          {"--density", "2.3 g/cm3", ""},
          {"--work-of-adhesion", "300", "did you mean 300 mJ/m2?", true},
          {"--work-of-adhesion", "300 J/m2", "--work-of-adhesion: 300 J/m2 is outside"},
          {"--friction", "20", "--friction: 20 is outside of what is plausible, 0.001 to 2"},
          {"--work-of-adhesion", "30000", "did you mean 30000 uJ/m2?", true},
          {"--work-of-adhesion", "0", ""},
          {"--velocity", "3000 m/s",
           "--velocity: 3000 m/s is outside of what is plausible, 1e-6 to 2,000 m/s"},
          {"--to-velocity", "1e30", "1e+30 has no unit and is 1e+30 m/s; allowed: 1e-6 to 2,000 m/s", true},
          {"--mass", "1 kg", "--mass: 1 kg is outside of what is plausible, 1e-23 kg to 2 g"},
          {"--partner-mass", "44", "44 has no unit and is 44 kg, did you mean 44 ug?", true},
          {"--cohesion-energy-density", "100 MJ/m3", ""},
          {"--cohesion-energy-density", "2 J/m3",
           "--cohesion-energy-density: 2 Pa is outside of what is plausible, 100 J/m3 to 100 GJ/m3"},
          {"--cohesion-energy-density", "1e20", "1e+20 has no unit and is 1e+20 Pa; allowed: 100 J/m3", true},
          {"--yield-pressure", "35.3", "did you mean 35.3 MPa?", true},
          {"--cohesive-stress", "1e13 Pa", "--cohesive-stress: 1e+04 GPa is outside"},
          {"--cohesion-range", "0.4", "did you mean 0.4 nm?", true},
          {"--pixel-size", "2", "did you mean 2 um?", true},
          {"--tangential-velocity", "-5000 m/s",
           "--tangential-velocity: -5000 m/s is outside of what is plausible, 1e-6 to 2,000 m/s"},
          {"--tangential-velocity", "-2 m/s", ""},
          {"--spin", "-1e12 rad/s",
           "--spin: -1e+12 rad/s is outside of what is plausible, 0.01 to 1e9 rad/s"},
          {"--spin", "1e20", "--spin: 1e+20 has no unit and is 1e+20 rad/s; allowed: 0.01", true},
          {"--velocity", "junk", ""},  // refused by whoever needs it
          {"--damping", "1e30", ""}}) {
        CAPTURE(each.option);
        CAPTURE(each.text);
        std::string said;
        const std::string refusal = input_error_of([&] {
            const auto doubts = implausible_text(each.option, each.text);
            if (!doubts.empty()) said = doubts.front().text;
            return 0;
        });
        CHECK(refusal.empty() != each.refused);
        const std::string& told = each.refused ? refusal : said;
        CHECK_MESSAGE(told.find(each.says) != std::string::npos, told);
        CHECK((told.empty() == (*each.says == 0)));
    }
}

TEST_CASE("quantities of a document are doubted by their keys, a column once") {
    const json document = json::parse(
        R"({"diameter": "9 m", "phases": [{"density": {"value": 2.65, "unit": "kg/m3", "range": [2, 3]}}],
            "work_of_adhesion": {"surface_energies": {"particle": "400 J/m2", "wall": "0.5 J/m2"}, "rule": "dupre"},
            "radius": {"distribution": "log-normal", "median": "4 cm", "geometric_standard_deviation": 1.5},
            "velocity": {"values": [1, 2500000, 3000000], "unit": "mm/s"}, "density": 2300})");
    const json shares = json::parse(R"({"relative_standard_uncertainties": {"density": 0.002}})");
    CHECK(implausible_values(shares, "", false).empty());  // of an artifact, whose quantities have units
    std::vector<std::string> places;
    for (const Finding& doubt : implausible_values(document)) {
        CHECK(doubt.severity == Severity::doubt);
        places.push_back(doubt.text.substr(0, doubt.text.find(':')));
    }
    CHECK(places == std::vector<std::string>{"/diameter", "/phases/0/density",
                                             "/work_of_adhesion/surface_energies/particle", "/radius/median",
                                             "/velocity/values/1"});  // the first that is outside
    CHECK(input_error_of([&] {
              return implausible_values(json::parse(R"({"radius": [1e-6, "0.1 m", 44]})"));
          }).starts_with("/radius/2: 44 has no unit"));
    CHECK(critical_velocity_text(499, "499 m/s") == "499 m/s");
    CHECK(critical_velocity_text(2.4e16, "") == "above 500 m/s, outside the model");
}

TEST_CASE("an uncertainty in the last digits, and one without a unit") {
    const auto of = [](const char* text, Dimension dimension) {
        return read_quantity(json(text), dimension);
    };
    const Quantity diameter = of("60(3) um", Dimension::length);
    CHECK(relative_difference(diameter.value, 60e-6) < 1e-14);
    CHECK(relative_difference(diameter.standard_uncertainty.value(), 3e-6) < 1e-14);
    const Quantity density = of("2.300(15) g/cm3", Dimension::density);
    CHECK(relative_difference(density.value, 2300) < 1e-14);
    CHECK(relative_difference(density.standard_uncertainty.value(), 15) < 1e-13);
    CHECK(relative_difference(of("42(2) %", Dimension::fraction).standard_uncertainty.value(), 0.02) < 1e-14);
    CHECK(relative_difference(of("0.29(1)", Dimension::fraction).standard_uncertainty.value(), 0.01) < 1e-14);
    CHECK(of("3 kg/(m s)", Dimension::viscosity).value == 3);
    CHECK(contains(json_message(R"("60 um +- 3")", Dimension::length), "has no unit"));
    CHECK(contains(json_message(R"("60 um +- 1e300 m")", Dimension::length), "a standard uncertainty of"));
}

TEST_CASE("what is written is read back to the bit") {
    const Quantity quantity = make_quantity(1.48126e11 / 3, Dimension::pressure, 1.7e9 / 7);
    const json node = quantity;
    CHECK(node.size() == 3);
    const auto back = read_quantity(json::parse(node.dump()), Dimension::pressure);
    CHECK(back.value == quantity.value);
    CHECK(back.standard_uncertainty == quantity.standard_uncertainty);
    const nlohmann::ordered_json ordered = make_quantity(2, Dimension::velocity);
    CHECK(ordered.dump() == R"({"value":2.0,"unit":"m/s"})");
}

TEST_CASE("a wrong quantity is refused with a pointer to the wrong part") {
    CHECK(contains(json_message("true", Dimension::length), "allowed: a number in m"));
    CHECK(contains(json_message("[1]", Dimension::length), "not a quantity"));
    CHECK(contains(json_message(R"({"value": 1})", Dimension::length), "\"unit\" is missing"));
    CHECK(contains(json_message(R"({"unit": "m"})", Dimension::length), "\"value\" is missing"));
    CHECK(json_message(R"({"value": "1", "unit": "m"})", Dimension::length)
              .starts_with("/value: not a number"));
    CHECK(json_message(R"({"value": 1, "unit": 3})", Dimension::length).starts_with("/unit: not a string"));
    CHECK(contains(json_message(R"({"value": 1, "unit": "kg"})", Dimension::length), "not one of length"));
    CHECK(json_message(R"({"value": 1, "unit": "m", "unc": 3})", Dimension::length)
              .starts_with("/unc: unknown key"));
    CHECK(json_message(R"({"value": 1, "unit": "m", "standard_uncertainty": -3})", Dimension::length)
              .starts_with("/standard_uncertainty: "));
}

TEST_CASE("temperatures: kelvin, and units with an offset, whose differences have none") {
    constexpr auto temperature = Dimension::temperature;
    for (const char* text : {"900 C", "900 \u00b0C", "900 degC", "900 celsius", "1652 F", "1652 \u00b0F",
                             "1173.15 K", "1173.15"}) {
        CAPTURE(text);
        CHECK(std::abs(quantity_of_text(text, temperature).value - 1173.15) < 1e-9);
    }
    for (const char* text : {"900 +- 10 C", "900 C +- 10 C", "900(10) C", "900 C +- 10 K", "900 C +- 18 F"}) {
        CAPTURE(text);
        const Quantity quantity = quantity_of_text(text, temperature);
        CHECK(std::abs(quantity.value - 1173.15) < 1e-9);
        CHECK(std::abs(quantity.standard_uncertainty.value() - 10) < 1e-9);
    }
    const Quantity json =
        read_quantity(parse_json(R"({"value": 900, "unit": "C", "standard_uncertainty": 10})"), temperature);
    CHECK(json.unit == "K");
    CHECK(std::abs(json.value - 1173.15) < 1e-9);
    CHECK(std::abs(json.standard_uncertainty.value() - 10) < 1e-9);
    for (const char* text : {"900 m", "900 kK2", "900 coulomb", "hot"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(static_cast<void>(quantity_of_text(text, temperature)), InputError);
    }
}

}  // namespace ashimpact::test
