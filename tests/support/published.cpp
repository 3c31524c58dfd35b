// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/published.hpp"

#include <array>
#include <stdexcept>

namespace ashimpact::test {

const PublishedLaw& PublishedSample::of(Law law) const {
    for (const PublishedLaw& entry : laws) {
        if (entry.law == law) return entry;
    }
    throw std::runtime_error("nothing published for that law");
}

std::vector<PublishedSample> published_samples() {
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
