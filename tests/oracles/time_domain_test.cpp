// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/time_domain.hpp"

#include <fstream>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "tests/relative_difference.hpp"

namespace ashimpact::oracles {

using test::relative_difference;

namespace {

double or_nothing(const nlohmann::json& value) {
    return value.is_null() ? 0 : value.get<double>();
}

}  // namespace

TEST_CASE("the time-domain oracle agrees with the reference impacts") {
    std::ifstream file(ASHIMPACT_TEST_DATA "/reference/impacts.json");
    REQUIRE(file);
    const auto reference = nlohmann::json::parse(file);
    const auto& sphere = reference["sphere"];
    for (const auto& row : reference["cases"]) {
        if (row["law"] == "sjkr")
            continue;  // no force of this oracle; its rows come from another integration
        const ImpactCase impact{.law = law_from(row["law"]),
                                .detachment = detachment_from(row["detachment"]),
                                .radius = sphere["radius"],
                                .mass = sphere["mass"],
                                .contact_modulus = sphere["contact_modulus"],
                                .work_of_adhesion = row["work_of_adhesion"],
                                .damping = row["damping"],
                                .velocity = row["velocity"]};
        const std::string label = row.dump();
        CAPTURE(label);
        const double tolerance = impact.detachment == Detachment::zero_force ? 1e-7 : 1e-9;
        const auto result = time_domain_impact(impact);
        CHECK(result.rebound == (row["outcome"] == "rebound"));
        CHECK(relative_difference(result.restitution.value, row["restitution"]) <= tolerance);
        CHECK(relative_difference(result.contact_time.value, or_nothing(row["contact_time"])) <= tolerance);
        if (!row["maximum_overlap"].is_null())
            CHECK(relative_difference(result.maximum_overlap.value, row["maximum_overlap"]) <= tolerance);
    }
}

}  // namespace ashimpact::oracles
