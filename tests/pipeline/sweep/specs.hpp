// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/json/document.hpp"

namespace ashimpact::test {

/// How many samples the program itself is given where there should be many: a sanitized one takes a hundred
/// times as long.
#ifdef __SANITIZE_ADDRESS__
inline constexpr double many_samples = 6'000;
#else
inline constexpr double many_samples = 200'000;
#endif

/// A sweep at fly-ash scale with everything a sweep can be asked for.
[[nodiscard]] inline Json full_spec(double samples) {
    return Json::parse(R"({
        "impact": {"laws": ["dmt", "jkr"], "density": "2600 kg/m3", "contact_modulus": "90 GPa",
                   "work_of_adhesion": "0.3 J/m2", "damping": "0.0141 kg/s"},
        "variables": {
            "velocity": {"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"},
            "radius": {"distribution": "log-normal", "median": "44 um", "geometric_standard_deviation": 1.5}},
        "sampling": {"method": "quasi-random", "samples": )" +
                       std::to_string(static_cast<long long>(samples)) + R"(, "seed": 3},
        "statistics": {"restitution": {}, "contact_time": {"resolution": "1 %"}},
        "sensitivity": ["restitution", "captured"],
        "table": ["restitution", "contact_time", "captured"]})");
}

/// The least a spec can hold.
[[nodiscard]] inline Json least_spec() {
    return Json::parse(R"({
        "impact": {"laws": ["hertz"], "density": 2600, "contact_modulus": 90e9, "radius": 44e-6},
        "variables": {"velocity": {"values": [1, 2]}},
        "sampling": {"method": "grid"}})");
}

}  // namespace ashimpact::test
