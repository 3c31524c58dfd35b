#include "materials/error.hpp"

#include <doctest/doctest.h>

#include <string>

using ashimpact::InputError;

TEST_CASE("an input error is one line: place, problem, what is allowed") {
    const InputError error("density is -3 kg/m3", "a positive density");
    CHECK(std::string(error.what()) == "density is -3 kg/m3; allowed: a positive density");
    CHECK(std::string(error.at("/samples/0/density").at("case.json").what()) ==
          "case.json: /samples/0/density: density is -3 kg/m3; allowed: a positive density");
}
