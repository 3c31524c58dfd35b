// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/embedded.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

using ashimpact::embedded_file;
using ashimpact::embedded_files;
using ashimpact::EmbeddedFile;

namespace ashimpact::test_fixtures {
std::span<const EmbeddedFile> embedded_table();  // generated, see cmake/EmbedFiles.cmake
}

namespace {

std::string on_disk(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file.is_open(), path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("an embedded file has the bytes of the file on disk, whatever they are") {
    const std::span<const EmbeddedFile> table = ashimpact::test_fixtures::embedded_table();
    REQUIRE(table.size() == 4);
    for (const EmbeddedFile& file : table) {
        CAPTURE(file.path);
        CHECK((file.content == on_disk(std::filesystem::path(ASHIMPACT_FIXTURES) / file.path)));
    }
    CHECK(embedded_file(table, "empty")->empty());
    CHECK(embedded_file(table, "an odd folder/bytes (all).bin")->size() == 256);
    CHECK(embedded_file(table, "large.json")->size() == 30000 * 33);
}

TEST_CASE("files are found by their whole path and listed by prefix, in order") {
    const std::span<const EmbeddedFile> table = ashimpact::test_fixtures::embedded_table();
    CHECK(embedded_files(table, "") == std::vector<std::string_view>{"an odd folder/bytes (all).bin", "empty",
                                                                     "large.json", "syntax.txt"});
    CHECK(embedded_files(table, "e") == std::vector<std::string_view>{"empty"});
    CHECK(embedded_files(table, "zzz").empty());
    CHECK_FALSE(embedded_file(table, "empt"));
    CHECK_FALSE(embedded_file(table, "emptyy"));
    CHECK_FALSE(embedded_file(table, ""));
    CHECK_FALSE(embedded_file({}, "empty"));
}

TEST_CASE("the embedded files have the bytes of those in data/ and beside their readers") {
    const std::vector<std::string_view> paths = embedded_files("");
    CHECK(std::ranges::is_sorted(paths));
    const std::filesystem::path data(ASHIMPACT_DATA);
    const std::filesystem::path present = data / "../pipeline/present";
    for (const std::string_view path : paths) {
        CAPTURE(path);
        const std::filesystem::path file =
            path.starts_with("export/")   ? present / "export/templates" / path.substr(7)
            : path.starts_with("report/") ? present / "report/page" / path.substr(7)
                                          : data / path;
        CHECK((embedded_file(path) == on_disk(file)));
    }
    CHECK_FALSE(embedded_file("no such file"));
}
