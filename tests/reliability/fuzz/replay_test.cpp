// SPDX-License-Identifier: GPL-3.0-or-later
// The corpora of the fuzz targets, each file as it is and changed at random: bytes flipped, cut out, doubled,
// and numbers and words of other files put in. Needs no clang.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <doctest/doctest.h>

#include "tests/reliability/fuzz/targets.hpp"
#include "tests/support/random.hpp"

using namespace ashimpact::test;

namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> corpus_of(const std::string& target) {
    const auto folder = std::filesystem::path(ASHIMPACT_FUZZ_CORPUS) / target;
    std::vector<std::filesystem::path> paths;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> files;
    files.reserve(paths.size());
    for (const auto& path : paths) files.push_back(bytes_of(path));
    return files;
}

/// Pieces that break what they are put into.
constexpr const char* pieces[] = {"1e999", "-1",   "nan",     "1e-320", "0",    "null",       "\"\"", "[",
                                  "{",     "}",    "\xff",    "\n",     "\t",   ",",          ";",    "\"//",
                                  "é",     "µm",   "1,5",     "..",     "e_n",  "v_in [m/s]", "%",    "2e5",
                                  "±",     "\r\n", "\\u0000", "true",   "[[]]", "100.01",     "Inf"};

std::string changed(std::string bytes, const std::vector<std::string>& corpus, Random& random) {
    const std::size_t changes = 1 + random.below(6);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
        const std::size_t at = random.below(bytes.size());
        const std::size_t length = 1 + random.below(std::min<std::size_t>(40, bytes.size() - at));
        switch (random.below(6)) {
            case 0:
                bytes[at] = static_cast<char>(random.below(256));
                break;
            case 1:
                bytes.erase(at, length);
                break;
            case 2:
                bytes.insert(at, bytes.substr(at, length));
                break;
            case 3:
                bytes.insert(at, pieces[random.below(std::size(pieces))]);
                break;
            case 4:
                bytes.replace(at, length, pieces[random.below(std::size(pieces))]);
                break;
            default: {
                const std::string& other = corpus[random.below(corpus.size())];
                if (!other.empty()) bytes.insert(at, other.substr(random.below(other.size()), length));
            }
        }
    }
    return bytes;
}

}  // namespace

TEST_CASE("every target takes its corpus, and refuses or takes what is made of it") {
    Random random(11);
    const bool whole = std::getenv("ASHIMPACT_WHOLE") != nullptr;
    for (const auto& entry : fuzz_targets()) {
        const std::string& name = entry.first;
        const FuzzTarget& target = entry.second;
        CAPTURE(name);
        const auto corpus = corpus_of(name);
        REQUIRE_MESSAGE(!corpus.empty(), "no corpus for " << name);
        int fed = 0;
        const int rounds = repetitions(whole ? 20'000 : 200);
        for (const std::string& file : corpus) {
            CHECK_NOTHROW(feed(target, file));
            for (int round = 0; round < rounds; round += static_cast<int>(corpus.size())) {
                const std::string bytes = changed(file, corpus, random);
                try {
                    feed(target, bytes);
                } catch (const std::exception& error) {
                    FAIL_CHECK(name << ": " << error.what() << "\n" << bytes);
                }
                ++fed;
            }
        }
        MESSAGE(name << ": " << fed << " inputs");
    }
}
