// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "pipeline/app/sweep/spec/impacts.hpp"

namespace ashimpact {

namespace {

using report::CaptureShare;

/// Impacts whose velocities are far below and far above any critical velocity.
SweepSpec slow_and_fast() {
    return read_sweep_spec(R"({
        "impact": {"laws": ["jkr"], "density": "2300 kg/m3", "contact_modulus": "90 GPa",
                   "work_of_adhesion": "0.3 J/m2", "damping": "0.001 kg/s"},
        "variables": {
            "velocity": {"values": ["1 mm/s", "500 m/s"]},
            "radius": {"grid": "linear", "from": "20 um", "to": "60 um", "points": 40}},
        "sampling": {"method": "grid"}})")
        .spec;
}

}  // namespace

TEST_CASE("capture against a variable of few values: all of the slow impacts, none of the fast") {
    const auto variables = capture_fractions(slow_and_fast()).variables;
    REQUIRE(variables.size() == 2);
    const std::vector<CaptureShare>& velocity = variables[0].curves[0].shares;
    REQUIRE(velocity.size() == 2);
    CHECK(velocity[0].value == 1e-3);
    CHECK(velocity[0].fraction == 1.0);
    CHECK(velocity[1].value == 500.0);
    CHECK(velocity[1].fraction == 0.0);
    // Of 40 impacts without an exception: as if half an impact might be one.
    for (const CaptureShare& share : velocity)
        CHECK(share.standard_uncertainty == doctest::Approx(0.5 / 40).epsilon(1e-14));
}

TEST_CASE("capture against a variable of many values, in sixteen parts of equally many impacts") {
    const auto variables = capture_fractions(slow_and_fast()).variables;
    const std::vector<CaptureShare>& radius = variables[1].curves[0].shares;
    REQUIRE(radius.size() == 16);
    for (std::size_t i = 0; i < radius.size(); ++i) {
        CAPTURE(i);
        if (i > 0) CHECK(radius[i].value > radius[i - 1].value);
        // Of five impacts two or three are slow, as their radius is listed twice.
        CHECK(std::abs(radius[i].fraction - 0.5) < 0.11);
        CHECK(radius[i].standard_uncertainty ==
              doctest::Approx(std::sqrt(radius[i].fraction * (1 - radius[i].fraction) / 5)).epsilon(1e-14));
    }
}

}  // namespace ashimpact
