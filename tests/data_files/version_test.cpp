// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/version.hpp"

#include <fstream>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

namespace {

/// The text between two marks in the first line of a source file that begins with the first mark; empty if
/// there is none.
std::string first_between(const std::string& file, std::string_view before, std::string_view after) {
    std::ifstream stream(std::string(ASHIMPACT_SOURCES "/") + file);
    REQUIRE(stream);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with(before)) return line.substr(before.size(), line.find(after) - before.size());
    }
    return {};
}

}  // namespace

TEST_CASE("every file that states the version states that of the program") {
    const std::string_view version = ashimpact::program_version();
    CHECK(first_between("CITATION.cff", "version: ", "\n") == version);
    CHECK(first_between("debian/changelog", "ashimpact (", ")") == version);
    const std::string newest = first_between("CHANGELOG.md", "## [", "]");
    CAPTURE(newest);
    CHECK((newest == "Unreleased" || newest == version));
}

TEST_CASE("the revision is a commit, or says that it is unknown") {
    std::string_view revision = ashimpact::program_revision();
    CAPTURE(revision);
    if (revision == "unknown") return;
    if (revision.ends_with("-dirty")) revision.remove_suffix(std::string_view("-dirty").size());
    CHECK(revision.size() >= 7);
    CHECK(revision.find_first_not_of("0123456789abcdef") == std::string_view::npos);
}
