// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>

#include "pipeline/app/command.hpp"
#include "pipeline/app/sweep/sweep.hpp"
#include "pipeline/app/sweep/workers.hpp"

/// ashimpact-sweep with a formula in place of the solver, so that everything around the impacts can be tested
/// with many of them. ASHIMPACT_PAUSE: seconds every chunk takes at least; ASHIMPACT_FAIL: a velocity [m/s]
/// from which on an impact does not converge; ASHIMPACT_DIE: rank:n, a rank that is killed at its n-th chunk,
/// once there is a checkpoint.
namespace ashimpact {

namespace {

double number_from(const char* variable, double otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::stod(text) : otherwise;
}

void die_if_told_to() {
    static std::atomic<int> calls = 0;
    const char* told = std::getenv("ASHIMPACT_DIE");
    const char* rank = std::getenv("OMPI_COMM_WORLD_RANK");
    if (told == nullptr || rank == nullptr) return;
    if (std::string(rank) + ":" + std::to_string(++calls) != told) return;
    // Ranks start at moments of their own: not before there is something that has to stay.
    constexpr int most_waits = 2000;
    for (int i = 0; i < most_waits && !std::filesystem::exists("out.json.checkpoint"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::raise(SIGKILL);
}

ResultColumns stand_in(const ImpactModel& model, const ImpactColumns& impacts, const WantedResults& wanted) {
    static const double pause = number_from("ASHIMPACT_PAUSE", 0);
    static const double failure = number_from("ASHIMPACT_FAIL", std::numeric_limits<double>::infinity());
    die_if_told_to();
    if (pause > 0) std::this_thread::sleep_for(std::chrono::duration<double>(pause));
    ResultColumns results;
    const std::size_t count = impacts.velocity.size();
    results.restitution.resize(count);
    if (wanted.contact_time) results.contact_time.resize(count);
    if (wanted.maximum_overlap) results.maximum_overlap.resize(count);
    const double critical = 0.5 * static_cast<double>(model.law.index() + 1);
    for (std::size_t i = 0; i < count; ++i) {
        const double v = impacts.velocity[i];
        if (v >= failure) {
            const double unknown = std::numeric_limits<double>::quiet_NaN();
            results.restitution[i] = unknown;
            if (wanted.contact_time) results.contact_time[i] = unknown;
            if (wanted.maximum_overlap) results.maximum_overlap[i] = unknown;
            results.failed.push_back({i, "the stand-in was told to fail", "ashimpact impact ..."});
            continue;
        }
        const double e = v > critical ? 0.9 * (v - critical) / v : 0.0;
        results.restitution[i] = e;
        if (wanted.contact_time)
            results.contact_time[i] =
                e > 0 ? value_at(impacts.effective_radius, i) / v : std::numeric_limits<double>::quiet_NaN();
        if (wanted.maximum_overlap)
            results.maximum_overlap[i] = value_at(impacts.effective_radius, i) * v * 1e-3;
    }
    return results;
}

}  // namespace

}  // namespace ashimpact

int main(int argc, char** argv) {
    ashimpact::MpiSession session;
    const int status =
        ashimpact::run_program(argc, argv,
                               [&](const ashimpact::CommandOptions& options, std::ostream& out) {
                                   ashimpact::run_sweep_command(options, session, ashimpact::stand_in, out);
                               },
                               {});
    return session.leave(status);
}
