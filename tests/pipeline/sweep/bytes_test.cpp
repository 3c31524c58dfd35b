// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers/bytes.hpp"

#include <doctest/doctest.h>

using namespace ashimpact;

namespace {

struct Pair {
    double number = 0;
    std::vector<std::string> texts;

    template <class Archive>
    void transfer(Archive& archive) {
        archive(number, texts);
    }
};

std::string written(std::vector<Pair> pairs) {
    ByteWriter writer;
    writer(pairs);
    return std::move(writer).take();
}

}  // namespace

TEST_CASE("what is written is read") {
    const std::string bytes = written({{0.1, {"a", ""}}, {-0.0, {}}});
    std::vector<Pair> pairs;
    ByteReader reader(bytes);
    reader(pairs);
    CHECK_NOTHROW(reader.finish());
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0].number == 0.1);
    CHECK(pairs[0].texts == std::vector<std::string>{"a", ""});
    CHECK(std::signbit(pairs[1].number));
}

TEST_CASE("bytes that end too early, too late or claim too much are refused") {
    const std::string bytes = written({{0.1, {"abc"}}});
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        std::vector<Pair> pairs;
        ByteReader reader(std::string_view(bytes).substr(0, length));
        CHECK_THROWS_AS(reader(pairs), BrokenBytes);
    }
    std::vector<Pair> pairs;
    const std::string one_more = bytes + "x";
    ByteReader longer(one_more);
    longer(pairs);
    CHECK_THROWS_AS(longer.finish(), BrokenBytes);
    ByteReader claims(std::string_view("\xff\xff\xff\xff\xff\xff\xff\x7f", 8));
    CHECK_THROWS_AS(claims(pairs), BrokenBytes);
}
