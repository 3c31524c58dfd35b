// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/size_of_work.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/machine.hpp"

namespace ashimpact::bench {

namespace {

const std::filesystem::path scratch = ASHIMPACT_BENCH_WORK "/sizes";

std::string written(const std::string& name, const std::string& text) {
    std::ofstream(scratch / name) << text;
    return (scratch / name).string();
}

/// Impacts of a sharp threshold at 1 m/s with some scatter, 3 % of them captured.
std::string impacts(int count) {
    std::string rows = "v_in [m/s],e\n";
    for (int i = 0; i < count; ++i) {
        const double velocity = 0.85 + 5.0 * (i + 0.5) / count;
        const double scatter = 0.02 * std::sin(12.9898 * i);
        const double ratio = 1 / velocity;
        const double e = ratio < 1 ? 0.5 * std::sqrt(1 - ratio * ratio) + scatter : 0;
        rows += fmt::format("{:.4f},{:.4f}\n", velocity, std::max(e, 0.0));
    }
    return written("impacts.csv", rows);
}

/// A case of that many samples, alike but for their names, with that many impacts each.
std::string case_of(int samples, int count) {
    impacts(count);
    std::string text =
        R"({"name": "sizes", "wall": {"young_modulus": "193 GPa", "poisson_ratio": 0.29}, "work_of_adhesion": "0.3 J/m2",
        "laws": ["jkr"], "samples": [)";
    for (int i = 0; i < samples; ++i)
        text += fmt::format(
            R"({}{{"name": "s{}", "diameter": "90 um", "density": "2300 kg/m3",
            "composition": {{"weight_fractions": {{"quartz": 1}}, "amorphous": "none"}}, "restitution": {{"file": "impacts.csv"}}}})",
            i == 0 ? "" : ",", i);
    return written("case.json", text + "]}");
}

std::string spec_of(int samples) {
    return written("spec.json", fmt::format(R"({{"impact": {{"laws": ["jkr"], "density": "2600 kg/m3",
        "contact_modulus": "90 GPa", "work_of_adhesion": "0.3 J/m2", "damping": "0.0141 kg/s", "radius": "44 um"}},
        "variables": {{"velocity": {{"distribution": "uniform", "from": "0.5 m/s", "to": "5 m/s"}}}},
        "sampling": {{"method": "quasi-random", "samples": {}, "seed": 1}}}})",
                                            samples));
}

/// A command whose work has a size.
struct Work {
    std::string name;
    std::vector<int> sizes;
    std::function<std::vector<std::string>(int)> command;
};

double seconds_of(const Work& work, int size) {
    std::vector<std::string> command = work.command(size);
    command.insert(command.begin(), ASHIMPACT_PROGRAM);
    const double before = children_seconds();
    (void)start_up_seconds(command, 1);
    return children_seconds() - before;
}

}  // namespace

void print_sizes_of_work() {
    std::filesystem::create_directories(scratch);
    const std::string results = (scratch / "results").string();
    const std::vector<std::string> contact{"--diameter",        "90 um",  "--density",          "2300 kg/m3",
                                           "--contact-modulus", "80 GPa", "--work-of-adhesion", "0.3 J/m2"};
    const auto run_of = [&](int samples, int count) {
        return std::vector<std::string>{"run", case_of(samples, count), "-o", results, "--no-report"};
    };
    const Work works[]{
        {"run, samples of 20 impacts", {1, 2, 4, 8, 16}, [&](int size) { return run_of(size, 20); }},
        {"run, impacts of a sample", {20, 80, 320, 1280}, [&](int size) { return run_of(1, size); }},
        {"damping, impacts",
         {20, 80, 320, 1280},
         [&](int size) {
             std::vector<std::string> command{"damping", "--law", "jkr", "--impacts", impacts(size)};
             command.insert(command.end(), contact.begin(), contact.end());
             return command;
         }},
        {"sweep, samples",
         {1 << 14, 1 << 17, 1 << 20},
         [&](int size) {
             return std::vector<std::string>{"sweep", spec_of(size), "-o", results + ".json"};
         }},
    };
    fmt::print("\nprocessor time by size of the work\n");
    for (const Work& work : works) {
        std::string line = fmt::format("{:<28}", work.name);
        double last = 0;
        double exponent = 0;
        for (std::size_t i = 0; i < work.sizes.size(); ++i) {
            const double seconds = seconds_of(work, work.sizes[i]);
            if (i > 0)
                exponent = std::log(seconds / last) / std::log(1.0 * work.sizes[i] / work.sizes[i - 1]);
            last = seconds;
            line += fmt::format("  {}: {:.2f} s", work.sizes[i], seconds);
        }
        fmt::print("{}; exponent at the end {:.2f}\n", line, exponent);
    }
}

}  // namespace ashimpact::bench
