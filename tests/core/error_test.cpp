// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/error.hpp"

#include <string>

#include <doctest/doctest.h>

using ashimpact::FileName;
using ashimpact::InputError;

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
