// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/dem_rates.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include "bench/machine.hpp"
#include "solver/motion/scale.hpp"
#include "tests/oracles/dem/program.hpp"

namespace ashimpact::bench {

namespace {

constexpr int particles = 10000;
constexpr double lowest_velocity = 1.0;
constexpr double steps_a_contact = 200.0;          // of a Hertz contact at the highest velocity
constexpr double hertz_contact_time = 3.21806546;  // undamped, in time scales

struct Code {
    std::string name;
    std::string program;
    std::string deck;
};

Impact impact(int particle) {
    const double radius = 10e-6;
    ContactPair pair{.mass = 2300.0 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius,
                     .effective_radius = radius,
                     .contact_modulus = 90e9,
                     .work_of_adhesion = 0.1};
    const double velocity = lowest_velocity * (1.0 + particle / (particles - 1.0));
    const double damping = Scale::of(pair, lowest_velocity).damping_coefficient(DampingLaw::constant, 0.3);
    return {Law::of<Dmt>(), Detachment::zero_overlap, {DampingLaw::constant, damping}, pair, velocity};
}

double contact_time(const Impact& one) {
    return hertz_contact_time * Scale::of(one.contact, one.velocity).time();
}

oracles::DeckValues values(int steps) {
    using oracles::exact;
    const Impact one = impact(0);
    const ContactPair& pair = one.contact;
    const double fraction = one.damping.coefficient / (2.0 * std::sqrt(pair.mass * hertz_stiffness(pair)));
    const double sphere = 4.0 / 3.0 * std::numbers::pi * std::pow(pair.effective_radius, 3.0);
    return {
        {"spacing", exact(4.0 * pair.effective_radius)},
        {"box", exact(10.0)},
        {"touching", exact(0.1)},
        {"diameter", exact(2.0 * pair.effective_radius)},
        {"radius", exact(pair.effective_radius)},
        {"mass", exact(pair.mass)},
        {"density", exact(pair.mass / sphere)},
        {"velocity", exact(one.velocity)},
        {"skin", exact(0.1 * pair.effective_radius)},
        {"young_modulus", exact(2.0 * pair.contact_modulus)},
        {"damping", exact(one.damping.coefficient)},
        {"surface_energy", exact(pair.work_of_adhesion / 2.0)},
        {"damping_restitution",
         exact(std::exp(-std::numbers::pi * fraction / std::sqrt(1.0 - fraction * fraction)))},
        {"pull_off_force", exact(-2.0 * std::numbers::pi * pair.work_of_adhesion * pair.effective_radius)},
        {"time_step", exact(contact_time(impact(particles - 1)) / steps_a_contact)},
        {"steps", std::to_string(steps)}};
}

/// CPU seconds of one run.
double seconds_of(const Code& code, const std::filesystem::path& place, int steps) {
    std::ofstream(place / "deck.in") << oracles::fill(oracles::deck_template(code.deck), values(steps));
    const double before = children_seconds();
    const int status = oracles::run_program(
        oracles::find_program(code.program, code.program == "lmp" ? "lammps" : code.program),
        {"-in", "deck.in", "-log", "log", "-screen", "none", "-nocite"}, place);
    if (status != 0) throw std::runtime_error(code.name + " ended with status " + std::to_string(status));
    return children_seconds() - before;
}

/// Velocities at the end, in order of particles.
std::vector<double> read_velocities(const std::filesystem::path& file) {
    std::ifstream text(file);
    std::vector<double> velocities;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("ITEM: ATOMS")) break;
    }
    int id = 0;
    for (double velocity = 0.0; text >> id >> velocity;) velocities.push_back(velocity);
    if (std::ssize(velocities) != particles) throw std::runtime_error(file.string() + " is not complete");
    return velocities;
}

DemRate measured(const Code& code, int repetitions) {
    const std::filesystem::path place = std::filesystem::path(ASHIMPACT_BENCH_WORK) / code.program;
    std::filesystem::create_directories(place);
    const double longest = solve_impact(impact(0)).contact_time.value();
    const int steps = static_cast<int>(longest / contact_time(impact(particles - 1)) * steps_a_contact) + 3;
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i) {
        const double idle = seconds_of(code, place, 0);
        seconds.push_back(seconds_of(code, place, steps) - idle);
    }
    std::ranges::sort(seconds);
    std::vector<double> found = read_velocities(place / "velocities.txt");
    std::vector<double> reference;
    for (int i = 0; i < particles; ++i) {
        const Impact one = impact(i);
        found[static_cast<std::size_t>(i)] /= one.velocity;
        reference.push_back(solve_impact(one).restitution);
    }
    return {code.name, particles / seconds[seconds.size() / 2], errors_of(found, reference)};
}

}  // namespace

std::vector<DemRate> dem_rates(int repetitions) {
    return {measured({"LAMMPS, 200 steps a contact", "lmp", "lammps.in"}, repetitions),
            measured({"LIGGGHTS, 200 steps a contact", "liggghts", "liggghts.in"}, repetitions)};
}

}  // namespace ashimpact::bench
