// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/bytes.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace ashimpact;

namespace {

struct Pair {
    double number = 0;
    std::vector<std::string> texts;

    void transfer(auto& archive) { archive(number, texts); }
};

using Pairs = std::vector<Pair>;

}  // namespace

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
