// SPDX-License-Identifier: GPL-3.0-or-later
// A user's program: what share of particles of a size distribution a wall keeps. Built by CMake and by
// pkg-config.
#include <cmath>
#include <iostream>
#include <vector>

#include <ashimpact/model.hpp>

int main() {
    const ashimpact::Model ash(
        "jkr",
        {{"density", 2160.0}, {"contact_modulus", 60e9}, {"work_of_adhesion", 0.3}, {"damping", 2e-6}});
    std::vector<double> diameter;
    for (int i = 0; i < 100; ++i) diameter.push_back(1e-6 * std::exp(0.046 * i));
    const std::vector<double> velocity(diameter.size(), 0.5);
    const std::vector<double> restitution = ash.restitutions(diameter, velocity);
    const std::vector<double> critical = ash.critical_velocities(diameter);
    int kept = 0;
    for (std::size_t i = 0; i < diameter.size(); ++i) {
        if ((restitution[i] == 0.0) != (velocity[i] < critical[i])) return 1;
        if (restitution[i] == 0.0) ++kept;
    }
    const ashimpact::Impacts all = ash.impacts(
        diameter.size(),
        {ashimpact::column("diameter", diameter), ashimpact::column("velocity", velocity.front())});
    if (!(all.maximum_overlap.front() > 0.0)) return 2;
    try {
        const ashimpact::Model wrong("jrk", {{"contact_modulus", 60e9}});
        return 3;
    } catch (const ashimpact::InputError& error) {
        if (std::string(error.what()).find("jkr") == std::string::npos) return 4;
    }
    std::cout << kept << " of " << diameter.size() << " sizes stay on the wall\n";
    return kept > 0 && kept < 100 ? 0 : 5;
}
