// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>
#include <hdf5.h>

#include "materials/contact_properties.hpp"
#include "solver/motion/impact.hpp"
#include "tests/pipeline/sweep/process.hpp"
#include "tests/pipeline/sweep/specs.hpp"
#include "tests/relative_difference.hpp"

using namespace ashimpact;
using test::relative_difference;
using test::Sandbox;

namespace {

/// A column of a table with its unit.
struct Dataset {
    std::vector<double> values;
    std::string unit;
};

std::string text_attribute(hid_t object, const char* name) {
    const hid_t attribute = H5Aopen(object, name, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    std::string text(H5Tget_size(type), '\0');
    CHECK(H5Aread(attribute, type, text.data()) >= 0);
    H5Tclose(type);
    H5Aclose(attribute);
    text.resize(text.find('\0'));
    return text;
}

Dataset read_dataset(const std::string& file, const std::string& path) {
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    REQUIRE(opened >= 0);
    const hid_t dataset = H5Dopen2(opened, path.c_str(), H5P_DEFAULT);
    REQUIRE(dataset >= 0);
    const hid_t space = H5Dget_space(dataset);
    Dataset column;
    column.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    CHECK(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, column.values.data()) >= 0);
    column.unit = text_attribute(dataset, "unit");
    H5Sclose(space);
    H5Dclose(dataset);
    H5Fclose(opened);
    return column;
}

}  // namespace

TEST_CASE("a grid through the program is what the scalar solver says, impact by impact") {
    const Sandbox sandbox;
    const Json spec = Json::parse(R"({
        "impact": {"laws": ["hertz", "dmt", "brach-dunn", "jkr", "thornton-ning"], "detachments": {"jkr": "zero-overlap"},
                   "density": "2600 kg/m3", "contact_modulus": "90 GPa", "work_of_adhesion": "0.3 J/m2",
                   "yield_pressure": "1 GPa"},
        "variables": {
            "velocity": {"grid": "logarithmic", "from": "0.1 m/s", "to": "10 m/s", "points": 5},
            "radius": {"values": [22, 44], "unit": "um"},
            "damping": {"values": ["0 kg/s", "0.01 kg/s"]}},
        "sampling": {"method": "grid"},
        "table": ["captured", "restitution", "rebound_velocity", "contact_time", "maximum_overlap"]})");
    sandbox.write("spec.json", spec.dump());
    const test::Ended ended = test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json"});
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    const std::string file = sandbox.path("out.h5");
    const Dataset velocity = read_dataset(file, "variables/velocity");
    const Dataset radius = read_dataset(file, "variables/radius");
    const Dataset damping = read_dataset(file, "variables/damping");
    CHECK(velocity.unit == "m/s");
    CHECK(damping.unit == "kg/s");
    REQUIRE(velocity.values.size() == 20);
    for (const char* name : {"hertz", "dmt", "brach-dunn", "jkr", "thornton-ning"}) {
        CAPTURE(name);
        const auto column = [&](const char* observable) {
            return read_dataset(file, std::string(name) + "/" + observable).values;
        };
        const auto captured = column("captured");
        const auto restitution = column("restitution");
        const auto rebound_velocity = column("rebound_velocity");
        const auto contact_time = column("contact_time");
        const auto maximum_overlap = column("maximum_overlap");
        CHECK(read_dataset(file, std::string(name) + "/contact_time").unit == "s");
        const Law law = Law::named(name);
        for (std::size_t i = 0; i < velocity.values.size(); ++i) {
            CAPTURE(i);
            const bool jkr = std::string(name) == "jkr";
            const Impact impact{.law = law,
                                .detachment = jkr ? Detachment::zero_overlap : law.default_detachment(),
                                .damping = {DampingLaw::constant, damping.values[i]},
                                .contact = {.mass = sphere_mass(radius.values[i], 2600),
                                            .effective_radius = radius.values[i],
                                            .contact_modulus = 90e9,
                                            .work_of_adhesion = 0.3,
                                            .yield_pressure = 1e9},
                                .velocity = velocity.values[i]};
            const ImpactResult known = solve_impact(impact);
            CHECK((captured[i] == 1) == (known.outcome == Outcome::capture));
            CHECK(relative_difference(restitution[i], known.restitution) < 1e-9);
            CHECK(relative_difference(rebound_velocity[i], known.rebound_velocity) < 1e-9);
            CHECK(relative_difference(maximum_overlap[i], known.maximum_overlap) < 1e-9);
            if (known.contact_time)
                CHECK(relative_difference(contact_time[i], *known.contact_time) < 1e-9);
            else
                CHECK(std::isnan(contact_time[i]));
        }
    }
}

TEST_CASE("rows of a sensitivity study are what the file says they are") {
    const Sandbox sandbox;
    sandbox.write("spec.json", test::full_spec(5'000).dump());
    REQUIRE(test::run(sandbox, {ASHIMPACT_STAND_IN, "sweep", "spec.json", "-o", "out.json"}).status == 0);
    const std::string file = sandbox.path("out.h5");
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    CHECK(text_attribute(opened, "rows") ==
          "row 4 n + k is point n: k = 0 at a, 1 at b, 2 + i at a with variable i from b");
    H5Fclose(opened);
    const auto velocity = read_dataset(file, "variables/velocity").values;
    const auto radius = read_dataset(file, "variables/radius").values;
    const auto restitution = read_dataset(file, "dmt/restitution").values;
    REQUIRE(velocity.size() == 20'000);
    for (std::size_t row = 0; row < velocity.size(); row += 4) {
        CHECK(velocity[row + 2] == velocity[row + 1]);
        CHECK(radius[row + 2] == radius[row]);
        CHECK(velocity[row + 3] == velocity[row]);
        CHECK(radius[row + 3] == radius[row + 1]);
        CHECK(relative_difference(restitution[row],
                                  std::max(0.0, 0.9 * (velocity[row] - 1) / velocity[row])) < 1e-15);
    }
}
