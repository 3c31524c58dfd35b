#include "materials/base/quantity.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "materials/base/error.hpp"
#include "tests/relative_difference.hpp"

using nlohmann::json;

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
    for (const auto& [text, dimension, value, uncertainty] :
         {Row{R"("60 +- 3 um")", Dimension::length, 60e-6, 3e-6},
          Row{R"("60 um +- 3 um")", Dimension::length, 60e-6, 3e-6},
          Row{R"("60 um +/- 5 %")", Dimension::length, 60e-6, 3e-6},
          Row{"\"2.6 \u00b1 0.1 g/cm3\"", Dimension::density, 2600, 100},
          Row{R"("0.42 +- 0.02")", Dimension::fraction, 0.42, 0.02},
          Row{R"("42 +- 2 %")", Dimension::fraction, 0.42, 0.02}}) {
        CAPTURE(text);
        const Quantity quantity = read_quantity(json::parse(text), dimension);
        CHECK(relative_difference(quantity.value, value) < 1e-14);
        CHECK(relative_difference(quantity.standard_uncertainty.value(), uncertainty) < 1e-14);
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
