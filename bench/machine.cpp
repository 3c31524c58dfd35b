// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/machine.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tests/oracles/dem/program.hpp"

namespace ashimpact::bench {

namespace {

cpu_set_t all_cores() {
    static const cpu_set_t all = [] {
        cpu_set_t set;
        CPU_ZERO(&set);
        sched_getaffinity(0, sizeof set, &set);
        return set;
    }();
    return all;
}

void allow(const cpu_set_t& set) {
    if (sched_setaffinity(0, sizeof set, &set) != 0)
        throw std::runtime_error("cannot choose the core to run on");
}

}  // namespace

void pin_to_one_core() {
    const cpu_set_t all = all_cores();
    cpu_set_t one;
    CPU_ZERO(&one);
    int last = 0;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(static_cast<std::size_t>(core), &all)) last = core;
    }
    CPU_SET(static_cast<std::size_t>(last), &one);
    allow(one);
}

void unpin() {
    allow(all_cores());
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

double children_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double start_up_seconds(const std::vector<std::string>& command, int repetitions) {
    std::filesystem::create_directories(ASHIMPACT_BENCH_WORK);
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const int status =
            oracles::run_program(command.front(), {command.begin() + 1, command.end()}, ASHIMPACT_BENCH_WORK);
        if (status != 0)
            throw std::runtime_error(command.front() + " ended with status " + std::to_string(status));
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(seconds);
    return seconds[seconds.size() / 2];
}

}  // namespace ashimpact::bench
