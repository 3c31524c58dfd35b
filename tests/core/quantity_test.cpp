// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quantities/quantity.hpp"

#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "core/json/view.hpp"
#include "core/text/error.hpp"
#include "tests/relative_difference.hpp"

using json = nlohmann::ordered_json;

namespace ashimpact::test {

namespace {

std::string json_message(const char* text, Dimension dimension) {
    try {
        static_cast<void>(read_quantity(json::parse(text), dimension));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

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
    CHECK(json_message(R"("60 +- -3 um")", Dimension::length).find("is below zero") != std::string::npos);
    CHECK_FALSE(json_message(R"("60 um +- 3 kg")", Dimension::length).empty());
    CHECK_FALSE(json_message(R"("+- 3 um")", Dimension::length).empty());
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
    CHECK(json_message(R"("60 um +- 3")", Dimension::length).find("has no unit") != std::string::npos);
    CHECK(json_message(R"("60 um +- 1e300 m")", Dimension::length).find("a standard uncertainty of") !=
          std::string::npos);
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
    CHECK(json_message("true", Dimension::length).find("allowed: a number in m") != std::string::npos);
    CHECK(json_message("[1]", Dimension::length).find("not a quantity") != std::string::npos);
    CHECK(json_message(R"({"value": 1})", Dimension::length).find("\"unit\" is missing") !=
          std::string::npos);
    CHECK(json_message(R"({"unit": "m"})", Dimension::length).find("\"value\" is missing") !=
          std::string::npos);
    CHECK(json_message(R"({"value": "1", "unit": "m"})", Dimension::length)
              .starts_with("/value: not a number"));
    CHECK(json_message(R"({"value": 1, "unit": 3})", Dimension::length).starts_with("/unit: not a string"));
    CHECK(json_message(R"({"value": 1, "unit": "kg"})", Dimension::length).find("not one of length") !=
          std::string::npos);
    CHECK(json_message(R"({"value": 1, "unit": "m", "unc": 3})", Dimension::length)
              .starts_with("/unc: unknown key"));
    CHECK(json_message(R"({"value": 1, "unit": "m", "standard_uncertainty": -3})", Dimension::length)
              .starts_with("/standard_uncertainty: "));
}

}  // namespace ashimpact::test
