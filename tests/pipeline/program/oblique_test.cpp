// SPDX-License-Identifier: GPL-3.0-or-later
// Impacts at an angle on the command line.
#include <cmath>
#include <numbers>
#include <string>

#include <doctest/doctest.h>

#include "core/json/document.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

const std::string oblique_ash =
    " --radius '44 um' --density '2300 kg/m3' --contact-modulus '90 GPa' --work-of-adhesion '0.3 J/m2' --law "
    "dmt"
    " --damping '0.005 kg/s'";

Json oblique_answer(const Sandbox& sandbox, const std::string& arguments) {
    return Json::parse(succeeded(sandbox, arguments + oblique_ash + " --json").out);
}

double number_in(const Json& json, const char* key) {
    return json[key]["value"].get<double>();
}

}  // namespace

TEST_CASE("an angle splits the velocity, and a normal impact stays as it was") {
    const Sandbox sandbox;
    const Json normal = oblique_answer(sandbox, "impact --velocity '2 m/s'");
    const Json oblique = oblique_answer(sandbox, "impact --velocity '4 m/s' --angle '60 deg' --friction 0.2");
    const Json split = oblique_answer(
        sandbox, "impact --velocity '2 m/s' --tangential-velocity '3.4641016151377544 m/s' --friction 0.2");
    for (const char* key : {"restitution", "contact_time", "maximum_overlap", "rebound_velocity"})
        CHECK(relative_difference(number_in(oblique, key), number_in(normal, key)) < 1e-12);
    CHECK(relative_difference(number_in(split, "spin"), number_in(oblique, "spin")) < 1e-12);
    for (const char* key : {"tangential_restitution", "spin", "impulse_ratio", "rebound_angle", "friction"})
        CHECK_FALSE(normal.contains(key));
    CHECK(normal["regime"].is_object());
    CHECK(oblique["contact_regime"].is_object());
    CHECK(oblique["regime"] == "sliding");
    CHECK(number_in(oblique, "tangential_restitution") < 1);
    // mu P_r/m, and P_r above the momentum that turns: the attraction is held as well.
    const double e = number_in(oblique, "restitution");
    const double lost = 3.4641016151377544 * (1 - number_in(oblique, "tangential_restitution"));
    CHECK(lost > 0.2 * (1 + e) * 2);
    CHECK(lost < 0.2 * (1 + e) * 2 * 1.05);
    const Json rolling = oblique_answer(sandbox, "impact --velocity '4 m/s' --angle '10 deg' --friction 0.2");
    CHECK(rolling["regime"] == "rolling");
    CHECK(relative_difference(number_in(rolling, "tangential_restitution"), 5.0 / 7.0) < 1e-12);
    const Json captured =
        oblique_answer(sandbox, "impact --velocity '1 m/s' --angle '89 deg' --friction 0.2");
    CHECK(captured["regime"] == "captured");
    CHECK(number_in(captured, "tangential_restitution") == 0);
    CHECK(captured["rebound_angle"].is_null());
    CHECK(captured["spin"].is_null());
    for (const Json& json : {oblique, rolling, captured}) {  // what comes in along the wall is accounted for
        const Json& energy = json["energy"];
        const auto sum = [&](std::initializer_list<const char*> keys) {
            double total = 0;
            for (const char* key : keys) total += number_in(energy, key);
            return total;
        };
        CHECK(relative_difference(sum({"remaining_sliding", "remaining_spin", "friction", "stopped"}),
                                  sum({"incident_sliding", "incident_spin"})) < 1e-9);
    }
    CHECK(number_in(captured["energy"], "stopped") > 0);
    const std::string text =
        succeeded(sandbox, "impact --velocity '4 m/s' --angle '60 deg' --friction 0.2" + oblique_ash).out;
    CHECK(text == containing("mu = 0.2: slides throughout"));
    CHECK(text == containing("degrees from the normal"));
    CHECK(text == containing("velocity, normal          2 m/s"));
}

TEST_CASE("the critical velocity at an angle is that of the sphere") {
    const Sandbox sandbox;
    const Json normal = oblique_answer(sandbox, "critical-velocity");
    const Json oblique = oblique_answer(sandbox, "critical-velocity --angle '60 deg'");
    CHECK(relative_difference(number_in(oblique, "critical_velocity"),
                              2 * number_in(normal, "critical_velocity")) < 1e-12);
    CHECK(number_in(oblique, "normal_critical_velocity") == number_in(normal, "critical_velocity"));
    CHECK(relative_difference(number_in(oblique, "angle"), std::numbers::pi / 3) < 1e-15);
    CHECK(relative_difference(oblique["crossings"]["values"][0].get<double>(),
                              number_in(oblique, "critical_velocity")) < 1e-15);
    CHECK(succeeded(sandbox, "critical-velocity --angle '60 deg'" + oblique_ash).out ==
          containing("critical velocity, normal"));
    const Json scheme = oblique_answer(sandbox, "critical-velocity --angle '60 deg' --method paper-explicit");
    CHECK(relative_difference(number_in(scheme["paper_explicit"], "critical_velocity"),
                              number_in(scheme, "critical_velocity")) < 0.1);
    CHECK(relative_difference(number_in(scheme["paper_explicit"], "normal_critical_velocity"),
                              number_in(scheme, "normal_critical_velocity")) < 0.1);
    // Far along the wall, the sphere is faster than 500 m/s, and its normal velocity is inside the model.
    const auto grazing = succeeded(sandbox, "critical-velocity --angle '89.99 deg'" + oblique_ash);
    CHECK(grazing.err != containing("outside the model"));
    CHECK(grazing.out != containing("outside the model"));
    const Json far = oblique_answer(sandbox, "critical-velocity --angle '89.99 deg'");
    CHECK(number_in(far, "critical_velocity") > 500);
}

TEST_CASE("options of impacts at an angle that miss or contradict one another") {
    const Sandbox sandbox;
    const std::string impact = "impact --velocity '2 m/s'" + oblique_ash;
    check_refused(sandbox, impact + " --angle '30 deg'", "--friction: is missing");
    check_refused(sandbox, impact + " --spin '1000 rad/s'", "--friction: is missing");
    check_refused(sandbox, impact + " --friction 0.2 --angle '30 deg' --tangential-velocity '1 m/s'",
                  "--angle, --tangential-velocity: both are given");
    check_refused(sandbox, impact + " --friction 0.2 --angle 45",
                  "--angle: 45 is 2578.310078 degrees from the normal; allowed: 0 to below 90 degrees");
    check_refused(sandbox, impact + " --friction 0.2 --angle '-5 deg'", "--angle");
    check_refused(sandbox, impact + " --friction -0.2 --angle '5 deg'", "--friction: friction is -0.2");
    check_refused(sandbox, impact + " --friction 0.2 --spin '50 Hz'",
                  "\"Hz\" is not one of angular velocity");
    check_refused(sandbox, impact + " --friction '20 deg' --angle '5 deg'", "--friction");
    CHECK(succeeded(sandbox, impact + " --friction 0.2").err == containing("--friction: "));
    const Json turns =
        Json::parse(succeeded(sandbox, impact + " --friction 0.2 --spin '9549.296585513720 rpm' --json").out);
    CHECK(relative_difference(number_in(turns, "incident_spin"), 1000) < 1e-12);
}
