// Law maugis-dugdale, a second sphere and rough surfaces, as typed.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "pipeline/json/document.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// What a command prints with --json.
Json printed(const Sandbox& sandbox, const std::string& arguments) {
    const auto result = ashimpact_program(sandbox, arguments + " --json");
    CAPTURE(arguments);
    CAPTURE(result.err);
    REQUIRE(result.status == 0);
    return Json::parse(result.out);
}

double number(const Json& quantity) {
    return quantity["value"].get<double>();
}

const std::string rest = " --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2' --damping '0.001 kg/s'";

}  // namespace

TEST_CASE("maugis-dugdale takes exactly one of Tabor parameter, cohesive stress and range") {
    const Sandbox sandbox;
    const std::string impact =
        "impact --law maugis-dugdale --radius '44 um' --density 2600 --velocity 2" + rest;
    const Json json = printed(sandbox, impact + " --tabor 2");
    CHECK(json["detachment"] == "pull-off");
    CHECK(json["outcome"] == "rebound");
    CHECK(number(json["energy"]["jumps"]) > 0.0);
    CHECK(number(json["regime"]["greatest_pressure"]) > 1e8);
    CHECK(std::abs(json["regime"]["transition_parameter"].get<double>() - 2.3140) < 1e-4);
    for (const std::string given : {" --cohesive-stress '770 MPa'", " --cohesion-range '0.4 nm'"})
        CHECK(printed(sandbox, impact + given)["outcome"] == "rebound");
    for (const std::string given : {"", " --tabor 2 --cohesion-range '0.4 nm'"}) {
        const auto refused = ashimpact_program(sandbox, impact + given);
        CHECK(refused.status == 2);
        CHECK(refused.err.find("--tabor") != std::string::npos);
        CHECK(refused.err.find("--cohesion-range") != std::string::npos);
    }
    const auto gains = ashimpact_program(sandbox, impact + " --tabor 0.5 --detachment load-controlled");
    CHECK(gains.status == 2);
    CHECK(gains.err.find("would gain energy") != std::string::npos);
    CHECK(ashimpact_program(sandbox, impact + " --tabor 1e9").status == 2);
}

TEST_CASE("two spheres: m* and R* of both, the wall as the limit of a large partner") {
    const Sandbox sandbox;
    for (const std::string law : {"dmt", "jkr"}) {
        const std::string command = "critical-velocity --law " + law + rest;
        const auto velocity = [&](const std::string& bodies) {
            return number(printed(sandbox, command + bodies)["critical_velocity"]);
        };
        // Two equal spheres are one of half the mass and half the radius on a wall.
        const double pair =
            velocity(" --radius '40 um' --mass '2e-10 kg' --partner-radius '40 um' --partner-mass 2e-10");
        const double halved = velocity(" --radius '20 um' --mass '1e-10 kg'");
        CHECK(relative_difference(pair, halved) < 1e-12);
        const double wall = velocity(" --radius '40 um' --density 2600");
        double before = 1.0;
        for (const std::string radius : {"4 mm", "40 mm", "400 mm"}) {
            const double near = velocity(
                " --radius '40 um' --density 2600 --partner-density 2600 --partner-radius '" + radius + "'");
            const double distance = relative_difference(near, wall);
            CHECK(distance < 0.2 * before);
            before = distance;
        }
    }
    const auto lonely = ashimpact_program(
        sandbox, "critical-velocity --law dmt --radius '40 um' --density 2600 --partner-density 2600" + rest);
    CHECK(lonely.status == 2);
    CHECK(lonely.err.find("--partner-radius") != std::string::npos);
}

TEST_CASE("rough surfaces: less adhesion, never by default") {
    const Sandbox sandbox;
    const std::string command = "critical-velocity --law jkr --radius '44 um' --density 2600" + rest;
    const double smooth = number(printed(sandbox, command)["critical_velocity"]);
    CHECK(number(printed(sandbox, command + " --roughness 0")["critical_velocity"]) == smooth);
    CHECK(number(printed(sandbox, command + " --roughness '1 nm'")["critical_velocity"]) < smooth);
    CHECK(ashimpact_program(sandbox, command + " --roughness '-1 nm'").status == 2);
}
