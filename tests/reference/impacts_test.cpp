// SPDX-License-Identifier: GPL-3.0-or-later
// Every impact of data/reference/impacts.json: an independent time-domain integration (DOP853, rtol 1e-12).
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
#include "solver/motion/impact.hpp"
#include "tests/relative_difference.hpp"
#include "tests/support/data_file.hpp"
#include "tests/support/worst.hpp"

using namespace ashimpact;
using namespace ashimpact::test;

namespace {

/// Parameters of the law's own, by name; none where the row has none.
ParameterValues<double> parameters_of(const nlohmann::json& row) {
    ParameterValues<double> values;
    for (const LawParameter& parameter : law_parameters())
        if (row.contains("parameters") && row.at("parameters").contains(parameter.name))
            values.set(parameter.name, row.at("parameters").at(parameter.name).get<double>());
    return values;
}

Impact impact_from(const nlohmann::json& sphere, const nlohmann::json& row) {
    return {.law = Law::named(row.at("law").get<std::string>()),
            .detachment = named<Detachment>(row.at("detachment").get<std::string>()),
            .damping = {DampingLaw::constant, row.at("damping")},
            .contact = {.mass = sphere.at("mass"),
                        .effective_radius = sphere.at("radius"),
                        .contact_modulus = sphere.at("contact_modulus"),
                        .work_of_adhesion = row.at("work_of_adhesion"),
                        .parameters = parameters_of(row)},
            .velocity = row.at("velocity")};
}

struct Deviations {
    Worst restitution;
    Worst contact_time;
    Worst maximum_overlap;

    void see(const nlohmann::json& row, const ImpactResult& result) {
        const std::string where = row.dump();
        restitution.see(relative_difference(result.restitution, row.at("restitution")), where);
        if (!row.at("contact_time").is_null()) {
            contact_time.see(relative_difference(result.contact_time.value(), row.at("contact_time")), where);
        }
        if (!row.at("maximum_overlap").is_null()) {
            maximum_overlap.see(relative_difference(result.maximum_overlap, row.at("maximum_overlap")),
                                where);
        }
    }
};

}  // namespace

TEST_CASE("every reference impact: outcome, restitution, contact time and overlap") {
    const nlohmann::json data = data_file("reference/impacts.json");
    Deviations by_place;
    Deviations by_force;
    std::set<std::string> laws;
    int captures = 0;
    for (const auto& row : data.at("cases")) {
        CAPTURE(row.dump());
        const ImpactResult result = solve_impact(impact_from(data.at("sphere"), row));
        REQUIRE(std::string(name_of(result.outcome)) == row.at("outcome").get<std::string>());
        CHECK(result.contact_time.has_value() == !row.at("contact_time").is_null());
        captures += result.outcome == Outcome::capture ? 1 : 0;
        const auto detachment = row.at("detachment").get<std::string>();
        laws.insert(row.at("law").get<std::string>());
        (detachment == "zero-force" ? by_force : by_place).see(row, result);
    }
    CHECK(by_force.restitution.count() > 0);
    CHECK(by_place.restitution.count() + by_force.restitution.count() ==
          static_cast<int>(data.at("cases").size()));
    CHECK(captures > 0);
    for (std::size_t i = 0; i < Law::count(); ++i) {
        if (Law::at(i) == Law::of<ThorntonNing>()) continue;   // elastic, it is jkr; see its own tests
        if (Law::at(i) == Law::of<MaugisDugdale>()) continue;  // tests/oracles integrates it in time
        CAPTURE(Law::at(i).name());
        CHECK(laws.contains(std::string(Law::at(i).name())));
    }
    CHECK_MESSAGE(by_place.restitution.deviation() < 1e-9, by_place.restitution.where());
    CHECK_MESSAGE(by_place.contact_time.deviation() < 1e-9, by_place.contact_time.where());
    CHECK_MESSAGE(by_place.maximum_overlap.deviation() < 1e-9, by_place.maximum_overlap.where());
    CHECK_MESSAGE(by_force.restitution.deviation() < 1e-7, by_force.restitution.where());
    CHECK_MESSAGE(by_force.contact_time.deviation() < 1e-7, by_force.contact_time.where());
}
