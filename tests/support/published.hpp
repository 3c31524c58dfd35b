// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
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
    [[nodiscard]] const PublishedLaw& of(Law law) const {
        for (const PublishedLaw& entry : laws)
            if (entry.law == law) return entry;
        throw std::runtime_error("nothing published for that law");
    }
};

/// A JSON file of tests/data. @throws std::runtime_error where it cannot be read
[[nodiscard]] inline nlohmann::json data_file(const std::string& name) {
    const std::string path = std::string(ASHIMPACT_TEST_DATA "/").append(name);
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return nlohmann::json::parse(file);
}

/// tests/data/published/dong2013.json.
[[nodiscard]] inline std::vector<PublishedSample> published_samples() {
    const nlohmann::json data = data_file("published/dong2013.json");
    std::vector<PublishedSample> samples;
    for (const auto& entry : data.at("samples")) {
        PublishedSample sample{.name = entry.at("name"),
                               .diameter = entry.at("diameter"),
                               .young_modulus = entry.at("young_modulus"),
                               .contact_time = entry.at("contact_time"),
                               .laws = {}};
        for (const auto& [name, law] : entry.at("laws").items()) {
            const std::array<double, 3> fit = law.at("damping_fit");
            sample.laws.push_back({.law = Law::named(name),
                                   .damping_fit = DampingPolynomial::quadratic(fit[0], fit[1], fit[2]),
                                   .critical_damping = law.at("critical_damping"),
                                   .critical_velocity = law.at("critical_velocity")});
        }
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace ashimpact::test
