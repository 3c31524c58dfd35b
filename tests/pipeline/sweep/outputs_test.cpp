// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>

#include <doctest/doctest.h>
#include <hdf5.h>

#include "materials/contact_properties.hpp"
#include "pipeline/app/sweep/bytes.hpp"
#include "solver/motion/impact.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::Ended;
using test::Sandbox;

namespace {

/// A grid of two impacts with a table.
Json small_grid() {
    return Json::parse(R"({
        "impact": {"laws": ["hertz"], "radius": "44 um", "density": "2600 kg/m3", "contact_modulus": "90 GPa",
                   "work_of_adhesion": "0.3 J/m2"},
        "variables": {"velocity": {"values": [1, 2], "unit": "m/s"}},
        "sampling": {"method": "grid"},
        "table": ["restitution"]})");
}

Ended sweep(const Sandbox& sandbox, const std::string& spec, const std::string& output,
            const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{ASHIMPACT_PROGRAM, "sweep", spec, "-o", output};
    command.insert(command.end(), more.begin(), more.end());
    return test::run(sandbox, command);
}

/// Exit status 2, one line, every file as it was.
void check_refused(const Sandbox& sandbox, const std::string& spec, const std::string& output,
                   const std::string& says) {
    const auto before = sandbox.everything();
    for (const auto& more : {std::vector<std::string>{}, std::vector<std::string>{"--restart"}}) {
        const Ended ended = sweep(sandbox, spec, output, more);
        CAPTURE(ended.err);
        CHECK(ended.status == 2);
        CHECK(ended.out.empty());
        CHECK(test::lines_of(ended.err).size() == 1);
        CHECK(ended.err == test::containing(says));
        CHECK(sandbox.everything() == before);
    }
}

struct Pair {
    double number = 0;
    std::vector<std::string> texts;

    void transfer(auto& archive) { archive(number, texts); }
};

using Pairs = std::vector<Pair>;

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

TEST_CASE("a sweep does not write over its spec, under whatever name") {
    const Sandbox sandbox;
    for (const char* name : {"self.json", "z.h5", "q.json.rows", "q.json.checkpoint"})
        sandbox.write(name, small_grid().dump());
    std::filesystem::create_symlink("self.json", sandbox.folder() / "link.json");
    const char* says = "is the spec, which would be lost; allowed: another -o";
    check_refused(sandbox, "self.json", "self.json", says);
    check_refused(sandbox, "self.json", "./self.json", says);
    check_refused(sandbox, "self.json", "link.json", says);
    check_refused(sandbox, "link.json", "self.json", says);
    check_refused(sandbox, "z.h5", "z.json", says);
    check_refused(sandbox, "q.json.rows", "q.json", says);
    check_refused(sandbox, "q.json.checkpoint", "q.json", says);
}

TEST_CASE("a sweep does not touch a table, rows or a checkpoint that no sweep wrote") {
    const Sandbox sandbox;
    sandbox.write("spec.json", small_grid().dump());
    sandbox.write("q.h5", "mine");
    sandbox.write("r.json.rows", "mine");
    sandbox.write("c.json.checkpoint", "mine");
    check_refused(sandbox, "spec.json", "q.json", "q.h5: is there already and is no table of a sweep");
    check_refused(sandbox, "spec.json", "r.json", "r.json.rows: is there already and holds no rows");
    check_refused(sandbox, "spec.json", "c.json", "c.json.checkpoint: is there already and is no checkpoint");
    sandbox.write("other.json", small_grid().dump());
    sandbox.write("0-case.json", R"({"schema": "0-case"})");
    for (const std::string file : {"other.json", "0-case.json"})
        check_refused(sandbox, "spec.json", file,
                      file + ": is there already, and is nothing that this command writes");
    check_refused(sandbox, "spec.json", "/dev/null", "is no regular file");
    check_refused(sandbox, "spec.json", std::string(300, 'x'), "File name too long");
}

TEST_CASE("two results do not share a table, but a sweep replaces its own after an edit") {
    const Sandbox sandbox;
    sandbox.write("spec.json", small_grid().dump());
    REQUIRE(sweep(sandbox, "spec.json", "a.json").status == 0);
    const std::string first = sandbox.read("a.h5");
    REQUIRE_FALSE(first.empty());
    CHECK(sweep(sandbox, "spec.json", "a.json").status == 0);
    CHECK(sandbox.read("a.h5") == first);

    Json edited = small_grid();
    edited["variables"]["velocity"]["values"] = {1, 3};
    sandbox.write("spec.json", edited.dump());
    check_refused(sandbox, "spec.json", "a.txt", "a.h5: is there already and is the table of another sweep");
    CHECK(sweep(sandbox, "spec.json", "a.json").status == 0);
    CHECK(sandbox.read("a.h5") != first);
}

TEST_CASE("an input out of range is found at its place, and leaves nothing behind") {
    const Sandbox sandbox;
    Json spec = small_grid();
    spec["impact"]["laws"] = {"brach-dunn"};
    spec["impact"]["work_of_adhesion"] = "1e300 J/m2";
    sandbox.write("spec.json", spec.dump());
    check_refused(sandbox, "spec.json", "wo.json", "spec.json: /impact/work_of_adhesion: ");
}

TEST_CASE("a folder for the result is made as needed") {
    const Sandbox sandbox;
    sandbox.write("spec.json", small_grid().dump());
    const Ended ended = sweep(sandbox, "spec.json", "new/folder/a.json");
    CHECK_MESSAGE(ended.status == 0, ended.err);
    CHECK(sandbox.has("new/folder/a.json"));
    CHECK(sandbox.has("new/folder/a.h5"));
    sandbox.write("file", "x");
    check_refused(sandbox, "spec.json", "file/a.json", "cannot be written: it is no folder");
}

TEST_CASE("what is written is read") {
    const auto pairs = unpacked<Pairs>(packed(Pairs{{0.1, {"a", ""}}, {-0.0, {}}}));
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0].number == 0.1);
    CHECK(pairs[0].texts == std::vector<std::string>{"a", ""});
    CHECK(std::signbit(pairs[1].number));
}

TEST_CASE("bytes that end too early, too late or claim too much are refused") {
    const std::string bytes = packed(Pairs{{0.1, {"abc"}}});
    const auto check_broken = [](std::string_view broken) {
        CHECK_THROWS_AS(static_cast<void>(unpacked<Pairs>(broken)), BrokenBytes);
    };
    for (std::size_t length = 0; length < bytes.size(); ++length) check_broken(bytes.substr(0, length));
    check_broken(bytes + "x");
    check_broken(std::string_view("\xff\xff\xff\xff\xff\xff\xff\x7f", 8));
}

#ifndef __SANITIZE_ADDRESS__  // which keeps what was freed

TEST_CASE("memory does not depend on the number of samples") {
    long fewer = 0;
    for (const double samples : {2e5, 5e6}) {
        const test::Sandbox sandbox;
        Json spec = test::full_spec(samples);
        for (const char* part : {"sensitivity", "table"}) spec.erase(part);
        sandbox.write("spec.json", spec.dump());
        const test::Ended ended =
            test::run(sandbox, {ASHIMPACT_PROGRAM, "sweep", "spec.json", "-o", "out.json", "--threads", "2"});
        CHECK(ended.status == 0);
        CHECK(ended.peak_memory < 100'000);
        if (fewer == 0) fewer = ended.peak_memory;
        CHECK(ended.peak_memory < fewer + 20'000);
    }
}

#endif

using test::relative_difference;

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
