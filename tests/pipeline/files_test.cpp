// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <doctest/doctest.h>
#include <unistd.h>

#include "core/text/error.hpp"
#include "pipeline/files/file.hpp"
#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
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
    sandbox.write("target", "before");
    std::filesystem::create_symlink("target", sandbox.folder() / "link");
    write_file(sandbox.folder() / "link", "after");
    CHECK(std::filesystem::is_symlink(sandbox.folder() / "link"));
    CHECK(sandbox.read("target") == "after");

    std::filesystem::create_symlink("/dev/null", sandbox.folder() / "nothing");
    write_file(sandbox.folder() / "nothing", "lost");
    CHECK(std::filesystem::is_symlink(sandbox.folder() / "nothing"));
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a file that cannot be read is named with the reason") {
    const Sandbox sandbox;
    const auto message = [](const std::string& path) {
        try {
            static_cast<void>(read_file(path));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string{};
    };
    CHECK(message(sandbox.path("none")) ==
          sandbox.path("none") + ": cannot be read: No such file or directory; allowed: a file");
    CHECK(message(sandbox.folder().string()).find("it is a folder") != std::string::npos);
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
