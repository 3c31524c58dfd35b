// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <unistd.h>

#include "core/json/document.hpp"
#include "core/json/view.hpp"
#include "core/text/error.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/run/results/critical_velocity.hpp"
#include "tests/pipeline/sandbox.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;

namespace {

std::string parse_message(const std::string& text) {
    return test::input_error_of([&] { return parse_json(text); });
}

}  // namespace

TEST_CASE("broken JSON is placed by line and column, with the reason") {
    CHECK(parse_message("{\n  \"a\": 1,\n  \"b\" 2\n}")
              .starts_with("line 3, column 7: this is not valid JSON: "));
    CHECK(parse_message("{\"a\": 1").starts_with("line 1, column 8: "));
    CHECK(parse_message("").starts_with("line 1, column 1: "));
    CHECK(parse_message("{\"a\": NaN}").starts_with("line 1, column 7: "));
    CHECK(parse_message("{} x").starts_with("line 1, column 4: "));
    for (const char* text : {"{\n\n", "[1,\n2", "{\"a\"\n:\n}", "\"\n\""})
        CHECK_MESSAGE(parse_message(text).find('\n') == std::string::npos, text);
}

TEST_CASE("a key that is there twice is found at any depth, a comment may repeat") {
    CHECK(parse_message(R"({"a": {"b": 1, "c": 2, "b": 3}})").starts_with("/a/b: this key is there twice"));
    CHECK(parse_message(R"([{"x": 1}, {"x": 1, "x": 2}])").starts_with("/1/x: "));
    CHECK(parse_message(R"({"//": "one", "//": "two"})").empty());
}

TEST_CASE("a NUL is refused where it stands; a message quotes no endless piece and no endless key") {
    CHECK(parse_message(R"({"a": ["b", "c\u0000d"]})") ==
          "/a/1: holds a NUL character; allowed: a text without it");
    CHECK(parse_message(R"({"a\u0000": 1})") == test::containing("holds a NUL character"));
    CHECK(parse_message("{\"a\": \"" + std::string(100'000, 'b') + "\xff\"}").size() < 400);
    CHECK(InputError("unknown key").at("/samples/0/" + std::string(100'000, 'k')).place().size() < 200);
    CHECK(InputError("is wrong").at("/samples/0/" + std::string(50, 'k')).place() ==
          "/samples/0/" + std::string(50, 'k'));
}

TEST_CASE("a number beyond double precision is refused where it stands") {
    CHECK(parse_message(R"({"a": [1, 1e999]})").starts_with("/a/1: "));
}

TEST_CASE("comments go, at any depth, and nothing else does") {
    const Json plain = parse_json(R"({"a": [{"b": null}], "c/d": "//"})");
    CHECK(plain["c/d"] == "//");
    CHECK(parse_json(R"({"//": 1, "a": [{"// note": {"x": [2]}, "b": null}], "c/d": "//"})") == plain);
    CHECK(parse_json("// one\n{\"a\": [ /* two\n */ {\"b\": null}], // {\n\"c/d\": \"//\"} // end") == plain);
    CHECK(parse_message("{\"a\": 1 / 2}").starts_with("line 1, column "));
}

TEST_CASE("the line of a value counts those of comments") {
    const JsonLines lines("// one\n{ /* two\n*/ \"a\": 3 // three\n, \"// b\": 1,\n\"c\": [5/*\n*/, 6]}");
    CHECK(lines.line_of("/a") == 3);
    CHECK(lines.line_of("/c/0") == 5);
    CHECK(lines.line_of("/c/1") == 6);
}

TEST_CASE("what is written reads back as the same document, short things on one line") {
    const Json document = parse_json(
        R"({"name": "é\n\"x\"", "q": {"value": 4.4e-05, "unit": "m"}, "none": null, "yes": true, "n": 9,
            "list": [], "object": {}, "mixed": [1, [2, 3], {"a": "b"}]})");
    CHECK(parse_json(write_json(document)) == document);
    CHECK(write_json(document) == test::containing("\"q\": {\"value\": 4.4e-05, \"unit\": \"m\"}"));

    Json column;
    for (int i = 0; i < 300; ++i) column["values"].push_back(i / 7.0);
    const std::string text = write_json(column);
    CHECK(parse_json(text) == column);
    for (std::size_t start = 0, end = 0; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
        CHECK(end - start <= 112);
}

TEST_CASE("numbers: shortest in files, 17 digits on request, never one that is not finite") {
    CHECK(write_json(Json(0.1)) == "0.1\n");
    CHECK(write_json(Json(0.1), Digits::seventeen) == "0.10000000000000001\n");
    CHECK(write_json(Json(-0.0)) == "0\n");
    CHECK(parse_json(write_json(Json(1.0 / 3.0), Digits::seventeen)).get<double>() == 1.0 / 3.0);
    CHECK_THROWS_AS(write_json(Json(std::numeric_limits<double>::infinity())), std::logic_error);
    CHECK_THROWS_AS(write_json(Json(std::numeric_limits<double>::quiet_NaN())), std::logic_error);
}

TEST_CASE("a view says where it is when it is wrong") {
    const Json document =
        parse_json(R"({"a/b": [{"m": "3 kg"}, {"m": "3 GPa"}, {"m": {"value": 1, "unit": "g",
        "origin": "measured", "source": "a balance"}}], "v": {"values": [1, 2], "unit": "mm/s"}})");
    const View view(document);
    const auto elements = view.at("a/b").elements();
    CHECK(elements[0].at("m").number(Dimension::mass) == 3.0);
    CHECK(elements[2].at("m").number(Dimension::mass) == doctest::Approx(1e-3));
    CHECK(view.at("v").column(Dimension::velocity) == std::vector<double>{1e-3, 2e-3});
    CHECK(test::input_error_of([&] {
              return elements[1].at("m").number(Dimension::mass);
          }).starts_with("/a~1b/1/m: the unit \"GPa\""));
    CHECK(test::input_error_of([&] { return view.at("w"); }).starts_with("\"w\" is missing"));
    CHECK(test::input_error_of([&] { return elements[0].at("n"); }).starts_with("/a~1b/0: \"n\" is missing"));
    CHECK(test::input_error_of([&] { return view.at("v").at("values").text(); }).starts_with("/v/values: "));
}

TEST_CASE("every schema is complete in itself and lists what the program knows") {
    for (const std::string& name : schema_names()) {
        const std::string text = schema_named(name).dump();
        CHECK_MESSAGE(text.find(".json#") == std::string::npos, name);
        CHECK_MESSAGE(text.find("\"@") == std::string::npos, name);
        CHECK_MESSAGE(schema_named(name).contains("$schema"), name);
    }
}

TEST_CASE("a radius in a case and a diameter in a sweep are told by pointer, with the key that is meant") {
    const auto message = [](const std::string& text) {
        return test::input_error_of([&] { validate_document(parse_json(text), "case"); });
    };
    // The size of a sphere: whether its diameter is missing or stands beside it.
    for (const char* sizes : {R"("radius": "44 um")", R"("radius": "44 um", "diameter": "88 um")"})
        CHECK(message(R"({"name": "x", "samples": [{"name": "a", "composition": {}, )" + std::string(sizes) +
                      "}]}")
                  .starts_with("/samples/0/radius: unknown key, the size of a sphere is its diameter here; "
                               "allowed: \"diameter\": \"88 um\" in place of \"radius\": \"44 um\""));
    CHECK(
        test::input_error_of([] {
            validate_document(parse_json(R"({"impact": {"laws": ["dmt"], "diameter": "88 um"}})"), "sweep");
        }).starts_with("/impact/diameter: unknown key, the size of a sphere is its radius here; allowed: "));
    CHECK(message(R"({"name": "x", "samples": [{"name": "a", "diameter": 1, "composition": {}}]})").empty());
}

TEST_CASE("an unknown key of a quantity is refused with the known ones, by an older name too") {
    for (const char* name : {"added_fraction", "weight_fraction"}) {
        const std::string text = R"({"name": "x", "samples": [{"name": "a", "diameter": 1, "composition": {
            "internal_standard": {"phase": "b", ")" +
                                 std::string(name) + R"(": {"valeu": 0.1}}}}]})";
        CHECK(test::input_error_of([&] { validate_document(parse_json(text), "case"); }) ==
              test::containing("/valeu: unknown key, did you mean \"value\"?; allowed: value, unit"));
    }
}

TEST_CASE("an unknown schema is refused with the names there are") {
    CHECK(test::input_error_of([] { return schema_named("cases"); }) ==
          test::containing("allowed: 0-case, "));
}

TEST_CASE(
    "a velocity is compared with a measured one that has an uncertainty, or where nothing was measured") {
    MeasuredCriticalVelocity measured{};
    const auto verdict = [&](double uncertainty) {
        return name_of(
            checked({1.0, uncertainty, 1.0 - 2 * uncertainty, 1.0 + 2 * uncertainty}, measured, false)
                .verdict);
    };
    const auto nothing = verdict(0.0);
    measured.value = 1.05;
    CHECK(verdict(0.0) == name_of(CriticalVelocityVerdict::not_comparable));
    CHECK(verdict(0.1) == name_of(CriticalVelocityVerdict::not_comparable));
    measured.standard_uncertainty = 0.1;
    CHECK(verdict(0.0) == name_of(CriticalVelocityVerdict::agrees));
    CHECK(nothing == name_of(check({1.0, 0.0, 1.0, 1.0}, MeasuredCriticalVelocity{}, false).verdict));
}

using test::Sandbox;

TEST_CASE("SHA-256 agrees with the vectors of FIPS 180-2") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("files are written with their folders and leave nothing else behind") {
    const Sandbox sandbox;
    const std::array files{FileContent{sandbox.folder() / "a/b/one", "1"},
                           FileContent{sandbox.folder() / "a/two", "22"}};
    write_files(files);
    const auto all = sandbox.everything();
    REQUIRE(all.size() == 4);
    CHECK(sandbox.read("a/b/one") == "1");
    CHECK(sandbox.read("a/two") == "22");
    CHECK(read_file(sandbox.path("a/two")) == "22");
}

TEST_CASE("if one file cannot be written, none is touched") {
    const Sandbox sandbox;
    sandbox.write("one", "before");
    sandbox.write("two/inside", "x");
    const auto before = sandbox.everything();
    const std::array files{FileContent{sandbox.folder() / "one", "after"},
                           FileContent{sandbox.folder() / "two", "after"}};
    CHECK_THROWS_AS(write_files(files), InputError);
    CHECK(sandbox.everything() == before);

    const std::array below_a_file{FileContent{sandbox.folder() / "three", "x"},
                                  FileContent{sandbox.folder() / "one/four", "x"}};
    CHECK_THROWS_AS(write_files(below_a_file), InputError);
    CHECK(sandbox.everything() == before);
}

TEST_CASE("a symbolic link stays one, and a device stays a device") {
    const Sandbox sandbox;
    sandbox.write("target", "a line\nbefore");
    std::filesystem::create_symlink("target", sandbox.folder() / "link");
    write_file(sandbox.folder() / "link", "a line\nafter");
    CHECK(std::filesystem::is_symlink(sandbox.folder() / "link"));
    CHECK(sandbox.read("target") == "a line\nafter");

    std::filesystem::create_symlink("/dev/null", sandbox.folder() / "nothing");
    write_file(sandbox.folder() / "nothing", "lost");
    CHECK(std::filesystem::is_symlink(sandbox.folder() / "nothing"));
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a file that cannot be read is named with the reason") {
    const Sandbox sandbox;
    const auto message = [](const std::string& path) {
        return test::input_error_of([&] { return read_file(path); });
    };
    CHECK(message(sandbox.path("none")) ==
          sandbox.path("none") + ": cannot be read: No such file or directory; allowed: a file");
    CHECK(message(sandbox.folder().string()) == test::containing("it is a folder"));
}

TEST_CASE("a file without an end is refused, not read until the memory is full") {
    CHECK_THROWS_WITH_AS(static_cast<void>(read_file("/dev/zero")),
                         "/dev/zero: is longer than 256 MiB; allowed: a file of at most 256 MiB", InputError);
    CHECK(read_start("/dev/zero", 3) == std::string(3, '\0'));
}

TEST_CASE("a folder that cannot be written into is known before there is anything to write") {
    const Sandbox sandbox;
    sandbox.write("file", "x");
    CHECK_NOTHROW(require_writable_folder(sandbox.folder() / "a/b/c"));
    CHECK_FALSE(sandbox.has("a"));
    CHECK_THROWS_AS(require_writable_folder(sandbox.folder() / "file"), InputError);
    CHECK_THROWS_AS(require_writable_folder(sandbox.folder() / "file/below"), InputError);
    CHECK_THROWS_AS(require_writable_folder(sandbox.folder() / std::string(300, 'x')), InputError);
}

TEST_CASE("one file under several names is one file") {
    const Sandbox sandbox;
    sandbox.write("file", "x");
    sandbox.write("other", "x");
    std::filesystem::create_symlink("file", sandbox.folder() / "link");
    CHECK(is_same_file(sandbox.path("file"), sandbox.path("./file")));
    CHECK(is_same_file(sandbox.path("file"), sandbox.path("link")));
    CHECK_FALSE(is_same_file(sandbox.path("file"), sandbox.path("other")));
    CHECK_FALSE(is_same_file(sandbox.path("file"), sandbox.path("none")));
}
