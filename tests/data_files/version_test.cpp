#include "data/version.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <string_view>

TEST_CASE("the program, as people will cite it, has the version of CITATION.cff") {
    std::ifstream citation(ASHIMPACT_CITATION);
    std::string cited;
    for (std::string line; cited.empty() && std::getline(citation, line);) {
        if (line.starts_with("version: ")) cited = line.substr(std::string_view("version: ").size());
    }
    CHECK(ashimpact::program_version() == cited);
}

TEST_CASE("the revision is a commit, or says that it is unknown") {
    std::string_view revision = ashimpact::program_revision();
    CAPTURE(revision);
    if (revision == "unknown") return;
    if (revision.ends_with("-dirty")) revision.remove_suffix(std::string_view("-dirty").size());
    CHECK(revision.size() >= 7);
    CHECK(revision.find_first_not_of("0123456789abcdef") == std::string_view::npos);
}
