// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer's entry: ASHIMPACT_FUZZ_TARGET names the target. `./dev fuzz` builds and runs it.
#include <cstdio>
#include <cstdlib>

#include "tests/reliability/fuzz/targets.hpp"

namespace {

const ashimpact::test::FuzzTarget& chosen() {
    const char* name = std::getenv("ASHIMPACT_FUZZ_TARGET");
    const auto& targets = ashimpact::test::fuzz_targets();
    const auto found = targets.find(name != nullptr ? name : "");
    if (found != targets.end()) return found->second;
    std::fputs("ASHIMPACT_FUZZ_TARGET names one of:", stderr);
    for (const auto& [known, _] : targets) std::fprintf(stderr, " %s", known.c_str());
    std::fputs("\n", stderr);
    std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const ashimpact::test::FuzzTarget& target = chosen();
    ashimpact::test::feed(target, {reinterpret_cast<const char*>(data), size});
    return 0;
}
