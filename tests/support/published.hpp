// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "solver/contact/law.hpp"
#include "solver/damping/damping_polynomial.hpp"

namespace ashimpact::test {

/// What Dong et al. 2013 print for one law and sieve size.
struct PublishedLaw {
    Law law;
    DampingPolynomial damping_fit;  ///< Table 2 [kg/s]
    double critical_damping;        ///< Table 3 [kg/s]
    double critical_velocity;       ///< Table 4 [m/s]
};

/// What they print for one sieve size.
struct PublishedSample {
    std::string name;
    double diameter;       ///< [m]
    double young_modulus;  ///< [Pa]
    double contact_time;   ///< Brach-Dunn, near 2 m/s [s]
    std::vector<PublishedLaw> laws;

    /// The entry of that law.
    [[nodiscard]] const PublishedLaw& of(Law law) const;
};

/// tests/data/published/dong2013.json.
[[nodiscard]] std::vector<PublishedSample> published_samples();

/// A JSON file of tests/data. @throws std::runtime_error where it cannot be read
[[nodiscard]] inline nlohmann::json data_file(const std::string& name) {
    const std::string path = std::string(ASHIMPACT_TEST_DATA "/").append(name);
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return nlohmann::json::parse(file);
}

}  // namespace ashimpact::test
