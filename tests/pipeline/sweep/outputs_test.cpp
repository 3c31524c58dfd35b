// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <doctest/doctest.h>

#include "tests/pipeline/sweep/process.hpp"

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
        CHECK(ended.err.find(says) != std::string::npos);
        CHECK(sandbox.everything() == before);
    }
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
