// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>

#include <doctest/doctest.h>

#include "tests/pipeline/sandbox.hpp"
#include "tests/pipeline/sweep/specs.hpp"
#include "tests/support/checks.hpp"

using namespace ashimpact;
using test::Ended;
using test::Process;
using test::Sandbox;

namespace {

constexpr double sample_count = 60'000;  // 30 chunks
const std::vector<std::string> watched_sweep{ASHIMPACT_STAND_IN, "sweep", "spec.json", "-o", "out.json",
                                             "--checkpoint",     "0",     "--threads", "1"};
/// Much longer than any moment at which a test kills a sweep, also on a machine that stalls.
const std::vector<std::string> slowly{"ASHIMPACT_PAUSE=0.1"};

/// How often something is tried: with ASHIMPACT_WHOLE, as `./dev test reliability` sets it, as often as
/// docs/reliability.md says; with sanitizers a third of the short form.
int times(int in_short, int in_whole) {
    if (std::getenv("ASHIMPACT_WHOLE") != nullptr) return in_whole;
    return test::sanitized ? (in_short + 2) / 3 : in_short;
}

void write_spec(const Sandbox& sandbox) {
    sandbox.write("spec.json", test::full_spec(sample_count).dump());
}

/// What a sweep that nothing happens to leaves: computed once.
const auto& undisturbed() {
    static const auto left = [] {
        const Sandbox sandbox;
        write_spec(sandbox);
        CHECK(test::run(sandbox, watched_sweep).status == 0);
        return sandbox.everything();
    }();
    return left;
}

void sleep_for(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Waits until a sweep has something to go on from.
void await_checkpoint(const Sandbox& sandbox) {
    for (int i = 0; i < 2000 && !sandbox.has("out.json.checkpoint"); ++i) sleep_for(0.01);
    REQUIRE(sandbox.has("out.json.checkpoint"));
}

/// Ends what was left unfinished and compares.
void check_goes_on(const Sandbox& sandbox) {
    const Ended ended = test::run(sandbox, watched_sweep);
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    CHECK(ended.err == test::containing("out.json.checkpoint: going on from chunk "));
    CHECK(sandbox.everything() == undisturbed());
}

/// 30,000 impacts on a grid of velocities from 1 to 2 m/s and ten radii.
Json velocity_grid() {
    Json spec = test::full_spec(sample_count);
    spec["variables"]["velocity"] = Json::parse(R"({"grid": "linear", "from": 1, "to": 2, "points": 3001})");
    spec["variables"]["radius"] = Json::parse(
        R"({"values": ["1 um", "2 um", "3 um", "4 um", "5 um", "6 um", "7 um", "8 um", "9 um", "10 um"]})");
    spec["sampling"] = {{"method", "grid"}};
    spec.erase("sensitivity");
    return spec;
}

}  // namespace

TEST_CASE("a sweep killed at random moments and run again leaves the bytes of an undisturbed one") {
    std::minstd_rand random(
        static_cast<unsigned>(std::chrono::steady_clock::now().time_since_epoch().count()));
    std::uniform_real_distribution<double> moment(0.0, 0.6);
    int kills = 0;
    for (int round = 0; round < 4 || kills < times(8, 300); ++round) {
        const Sandbox sandbox;
        write_spec(sandbox);
        int killed = 0;
        for (int status = -1; status != 0;) {
            const double after = moment(random);
            CAPTURE(after);
            Process process(sandbox, watched_sweep, slowly);
            sleep_for(after);
            process.signal(SIGKILL);
            status = process.wait().status;
            CHECK((status == 0 || status == 128 + SIGKILL));
            if (status != 0 && ++killed > 3) status = test::run(sandbox, watched_sweep).status;
        }
        CHECK(killed > 0);
        CHECK(sandbox.everything() == undisturbed());
        kills += killed;
    }
    MESSAGE(kills << " sweeps were killed");
}

TEST_CASE("the program itself, killed and run again with other ranks and threads, leaves the same bytes" *
          doctest::test_suite("long")) {
    const auto command = [](int ranks, int threads) {
        const std::vector<std::string> plain{
            ASHIMPACT_PROGRAM,      "sweep", "spec.json", "-o", "out.json", "--checkpoint", "0", "--threads",
            std::to_string(threads)};
        return ranks == 0 ? plain : test::under_mpi(ranks, plain);
    };
    const auto write = [](const Sandbox& sandbox) {
        sandbox.write("spec.json", test::full_spec(test::many_samples).dump());
    };
    const Sandbox whole;
    write(whole);
    REQUIRE(test::run(whole, command(0, 2)).status == 0);
    const auto expected = whole.everything();
    std::minstd_rand random(
        static_cast<unsigned>(std::chrono::steady_clock::now().time_since_epoch().count()));
    std::uniform_real_distribution<double> moment(0.0, 1.0);
    for (const int ranks : {0, 1, 2, 3}) {
        const Sandbox sandbox;
        write(sandbox);
        const double after = moment(random);
        CAPTURE(ranks);
        CAPTURE(after);
        {
            Process process(sandbox, command(ranks, 1 + ranks % 2), {});
            sleep_for(after);
            process.signal(SIGKILL);
            static_cast<void>(process.wait());
        }
        Ended ended{};
        for (int i = 0; i < 600; ++i) {  // ranks outlive a mpirun that was killed for a while
            ended = test::run(sandbox, command((ranks + 2) % 4, 2));
            if (ended.status != 2) break;
            sleep_for(0.1);
        }
        CAPTURE(ended.err);
        CHECK(ended.status == 0);
        CHECK(sandbox.everything() == expected);
    }
}

TEST_CASE("sweeps into one file exclude each other, from the checkpoint they read to the files they remove" *
          doctest::test_suite("long")) {
    constexpr double few_samples = 6000;  // 3 chunks
    const std::vector<std::string> sweep{ASHIMPACT_PROGRAM, "sweep",        "spec.json", "-o",
                                         "out.json",        "--checkpoint", "0",         "--no-report"};
    const auto write = [](const Sandbox& sandbox) {
        sandbox.write("spec.json", test::full_spec(few_samples).dump());
    };
    const Sandbox alone;
    write(alone);
    REQUIRE(test::run(alone, sweep).status == 0);
    const auto expected = alone.everything();
    int refused = 0;
    for (int round = 0; round < times(12, 1000); ++round) {
        const Sandbox sandbox;
        write(sandbox);
        std::vector<std::unique_ptr<Process>> sweeps;
        for (int i = 0; i < 6; ++i) {
            sweeps.push_back(std::make_unique<Process>(sandbox, sweep));
            sleep_for(0.006);
        }
        for (const auto& each : sweeps) {
            const Ended ended = each->wait();
            CAPTURE(ended.err);
            if (ended.status == 0) continue;
            CHECK(ended.status == 2);
            CHECK(ended.err == test::containing("another sweep writes here"));
            ++refused;
        }
        CAPTURE(round);
        CHECK(sandbox.everything() == expected);
    }
    CHECK(refused > 0);
}

TEST_CASE("a rank that dies ends the job with an error, and what is finished stays" *
          doctest::test_suite("long")) {
    std::minstd_rand random(3);
    std::vector<std::string> deaths{"1:5", "0:9", "2:3"};
    const std::size_t late = deaths.size();  // these die when a checkpoint is there
    std::size_t kept = 0;
    for (int more = times(0, 27); more > 0; --more)
        deaths.push_back(std::to_string(random() % 3) + ":" + std::to_string(2 + random() % 8));
    for (const std::string& rank_and_calls : deaths) {
        CAPTURE(rank_and_calls);
        const Sandbox sandbox;
        write_spec(sandbox);
        const Ended ended = test::run(sandbox, test::under_mpi(3, watched_sweep),
                                      {slowly.front(), "ASHIMPACT_DIE=" + rank_and_calls});
        CHECK(ended.status != 0);
        CHECK_FALSE(sandbox.has("out.json"));
        const bool has_checkpoint = sandbox.has("out.json.checkpoint");
        kept += has_checkpoint ? 1 : 0;
        if (has_checkpoint) check_goes_on(sandbox);
    }
    CHECK(kept >= std::max(late, deaths.size() / 2));
    MESSAGE(deaths.size() << " ranks died, with a checkpoint in " << kept << " cases");
}

TEST_CASE("an interruption saves what is finished and ends the program as the signal would") {
    for (const int signal : {SIGINT, SIGTERM}) {
        bool went_on = false;
        for (const double seconds : {0.5, 1.5, 4.5}) {  // a slow machine may have finished nothing, or all
            const Sandbox sandbox;
            write_spec(sandbox);
            std::vector<std::string> rarely = watched_sweep;
            rarely[6] = "1000";
            Process process(sandbox, rarely, slowly);
            sleep_for(seconds);
            process.signal(signal);
            const Ended ended = process.wait();
            if (ended.status == 0) continue;
            CHECK(ended.status == 128 + signal);
            CHECK_FALSE(sandbox.has("out.json"));
            if (!sandbox.has("out.json.checkpoint")) continue;
            const Ended again = test::run(sandbox, watched_sweep);
            CHECK(again.status == 0);
            CHECK(sandbox.everything() == undisturbed());
            went_on = went_on || test::contains(again.err, "out.json.checkpoint: going on from chunk ");
        }
        CHECK(went_on);
    }
}

TEST_CASE("more than a hundredth of impacts that do not converge have status 3, and what is finished stays") {
    for (const int ranks : {0, 2}) {
        CAPTURE(ranks);
        const Sandbox sandbox;
        sandbox.write("spec.json", velocity_grid().dump());
        const Ended ended =
            test::run(sandbox, ranks == 0 ? watched_sweep : test::under_mpi(ranks, watched_sweep),
                      {"ASHIMPACT_FAIL=1.9"});
        CHECK(ended.status == 3);
        CHECK_MESSAGE(
            ended.err.find("more than 1 % of the sweep: the stand-in was told to fail; the first one: "
                           "ashimpact impact ...") != std::string::npos,
            ended.err);
        CHECK_FALSE(sandbox.has("out.json"));
        CHECK(sandbox.has("out.json.checkpoint"));
    }
}

TEST_CASE("a few impacts that do not converge are counted, listed and left out") {
    std::string bytes;
    for (const int ranks : {0, 2}) {
        CAPTURE(ranks);
        const Sandbox sandbox;
        sandbox.write("spec.json", velocity_grid().dump());
        const Ended ended =
            test::run(sandbox, ranks == 0 ? watched_sweep : test::under_mpi(ranks, watched_sweep),
                      {"ASHIMPACT_FAIL=1.995"});
        REQUIRE_MESSAGE(ended.status == 0, ended.err);
        const Json artifact = sandbox.json("out.json");
        const Json& result = artifact["result"];
        const int failed = 16 * 10;  // velocities from 1.995 to 2 m/s, of each law
        CHECK(result["not_converged"]["count"] == 2 * failed);
        REQUIRE(result["not_converged"]["listed"].size() == 100);
        CHECK(result["not_converged"]["listed"][0]["reason"] == "the stand-in was told to fail");
        for (const Json& law : result["laws"]) {
            CHECK(law["not_converged"] == failed);
            CHECK(law["impacts"] == 30'010 - failed);
            CHECK(law["observables"][0]["count"] == 30'010 - failed);
        }
        CHECK(artifact["warnings"].back() ==
              "320 of 60020 impacts did not converge; they are left out, see /result/not_converged");
        if (ranks == 0) bytes = sandbox.read("out.json");
        CHECK(sandbox.read("out.json") == bytes);
    }
}

TEST_CASE("a checkpoint of another sweep, or a damaged one, is not touched unless asked") {
    const Sandbox sandbox;
    write_spec(sandbox);
    Process process(sandbox, watched_sweep, slowly);
    await_checkpoint(sandbox);
    process.signal(SIGKILL);
    static_cast<void>(process.wait());
    const std::string checkpoint = sandbox.read("out.json.checkpoint");

    const auto check_refused = [&](const char* says) {
        const auto before = sandbox.everything();
        const Ended ended = test::run(sandbox, watched_sweep);
        CHECK(ended.status == 2);
        CHECK(ended.err == test::containing(says));
        CHECK(test::lines_of(ended.err).size() == 1);
        CHECK(sandbox.everything() == before);
    };
    Json other = test::full_spec(sample_count);
    other["sampling"]["seed"] = 4;
    sandbox.write("spec.json", other.dump());
    check_refused("out.json.checkpoint: is the checkpoint of another sweep; allowed: --restart");
    write_spec(sandbox);
    sandbox.write("out.json.checkpoint", checkpoint.substr(0, checkpoint.size() / 2));
    check_refused("is no checkpoint, or damaged");
    std::string flipped = checkpoint;
    flipped[flipped.size() - 100] ^= 1;
    sandbox.write("out.json.checkpoint", flipped);
    check_refused("is no checkpoint, or damaged");
    sandbox.write("out.json.checkpoint", checkpoint);
    std::filesystem::resize_file(sandbox.path("out.json.rows"), 10);
    check_refused("out.json.rows: is shorter than its checkpoint says");

    std::vector<std::string> anew = watched_sweep;
    anew.emplace_back("--restart");
    CHECK(test::run(sandbox, anew).status == 0);
    CHECK(sandbox.everything() == undisturbed());
}

TEST_CASE("a flipped bit anywhere in the rows is found, with its place, and no table is written") {
    const Sandbox sandbox;
    write_spec(sandbox);
    {
        Process process(sandbox, watched_sweep, slowly);
        await_checkpoint(sandbox);
        sleep_for(0.3);
        process.signal(SIGKILL);
        static_cast<void>(process.wait());
    }
    const std::string checkpoint = sandbox.read("out.json.checkpoint");
    const std::string rows = sandbox.read("out.json.rows");
    std::minstd_rand random(7);
    int found = 0;
    const auto flip = [&](std::string& bytes, std::size_t place) {
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << (random() % 8)));
    };
    const int rounds = times(12, 300);
    for (int round = 0; round < rounds; ++round) {
        std::string flipped = rows;
        const std::size_t place = 21 + random() % (rows.size() - 21);
        flip(flipped, place);
        sandbox.write("out.json.checkpoint", checkpoint);
        sandbox.write("out.json.rows", flipped);
        const Ended ended = test::run(sandbox, watched_sweep);
        CAPTURE(place);
        if (ended.status == 0) {  // beyond what the checkpoint knows of: computed again
            CHECK(sandbox.everything() == undisturbed());
        } else {
            ++found;
            CHECK(ended.status == 2);
            CHECK_MESSAGE(ended.err.find("out.json.rows: is damaged from row ") != std::string::npos,
                          ended.err);
            CHECK_FALSE(sandbox.has("out.h5"));
            CHECK_FALSE(sandbox.has("out.json"));
        }
        for (const char* file : {"out.h5", "out.json"}) std::filesystem::remove(sandbox.path(file));
    }
    CHECK(found > 0);
    for (int round = 0; round < rounds; ++round) {
        std::string flipped = checkpoint;
        const std::size_t place = random() % checkpoint.size();
        flip(flipped, place);
        sandbox.write("out.json.checkpoint", flipped);
        sandbox.write("out.json.rows", rows);
        const Ended ended = test::run(sandbox, watched_sweep);
        CAPTURE(place);
        CHECK(ended.status == 2);
        CHECK_MESSAGE(ended.err.find("out.json.checkpoint: ") != std::string::npos, ended.err);
        CHECK(sandbox.read("out.json.rows") == rows);
        CHECK_FALSE(sandbox.has("out.json"));
    }
    MESSAGE(rounds << " bits flipped in rows, " << found << " of them found, " << rounds
                   << " in checkpoints, all found");
}

TEST_CASE("a disk that is full at any moment is said in one line; no signal, nothing lost" *
          doctest::test_suite("long")) {
    REQUIRE(undisturbed().front().first == "out.h5");
    const std::size_t blocks = undisturbed().front().second.size() / 1024;
    int refused = 0;
    const int parts = std::max(11, times(11, 150));
    for (int part = 1; part <= parts + 1; ++part) {  // with no room at all not even the message finds a place
        const Sandbox sandbox;
        write_spec(sandbox);
        const std::size_t room = std::max<std::size_t>(
            1, blocks * static_cast<std::size_t>(part) / static_cast<std::size_t>(parts));
        const std::string command = "ulimit -f " + std::to_string(room) + "; exec \"$@\"";
        std::vector<std::string> limited{"bash", "-c", command, "bash"};
        limited.insert(limited.end(), watched_sweep.begin(), watched_sweep.end());
        const Ended ended = test::run(sandbox, limited);
        CAPTURE(part);
        CAPTURE(ended.err);
        if (ended.status == 0) continue;
        ++refused;
        CHECK(ended.status == 2);
        CHECK(ended.err == test::containing("cannot be written"));
        CHECK_FALSE(sandbox.has("out.h5"));
        CHECK(test::run(sandbox, watched_sweep).status == 0);
        CHECK(sandbox.everything() == undisturbed());
    }
    CHECK(refused > 5);
}
