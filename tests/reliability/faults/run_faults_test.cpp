// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever fails or kills a run while it writes, its folder is the old run or the new one. ASHIMPACT_WHOLE:
// whole runs instead of single stages.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "tests/pipeline/sandbox.hpp"

using namespace ashimpact;
using test::containing;
using test::Ended;
using test::Process;
using test::Sandbox;
using Files = std::vector<std::pair<std::string, std::string>>;

namespace {

bool whole() {
    return std::getenv("ASHIMPACT_WHOLE") != nullptr;
}

const std::vector<std::string>& command() {
    static const std::vector<std::string> full{ASHIMPACT_PROGRAM, "run", "case.json", "-o", "out"};
    static const std::vector<std::string> short_one{ASHIMPACT_PROGRAM, "run",       "-o", "out",
                                                    "--only",          "comparison"};
    return whole() ? full : short_one;
}

Json small_case(double velocity) {
    Json document = test::with_one_sample(test::example_case(), {"hertz"});
    document["samples"][0]["measured_critical_velocity"] = velocity;
    return document;
}

/// A folder with an old run in "out", a file of someone else there, and what a new run will make of it.
class Scene {
  public:
    Scene() {
        test::write_example(sandbox_, small_case(1.5));
        CHECK(test::run(sandbox_, {ASHIMPACT_PROGRAM, "run", "case.json", "-o", "out"}).status == 0);
        sandbox_.write("out/notes.txt", "mine");
        Json artifact = sandbox_.json("out/3-analytic.json");
        artifact["result"]["samples"][0]["critical_velocity"]["value"] = 0.5;
        if (whole())
            test::write_example(sandbox_, small_case(2.5));
        else
            sandbox_.write("out/3-analytic.json", artifact.dump());
        old_ = sandbox_.everything();
        const Ended ended = test::run(sandbox_, command());
        CHECK_MESSAGE(ended.status == 0, ended.err);
        new_ = sandbox_.everything();
        CHECK(old_ != new_);
    }

    /// The folder as it was before the new run.
    void restore(const Sandbox& sandbox) const {
        std::filesystem::remove_all(sandbox.folder() / "out");
        for (const auto& [name, content] : old_)
            if (!std::filesystem::is_directory(sandbox_.folder() / name)) sandbox.write(name, content);
    }
    [[nodiscard]] bool is_old(const Sandbox& sandbox) const { return visible(sandbox) == visible(old_); }
    [[nodiscard]] bool is_new(const Sandbox& sandbox) const { return visible(sandbox) == visible(new_); }
    [[nodiscard]] const Files& after() const { return new_; }

  private:
    static Files visible(Files files) {
        std::erase_if(files, [](const auto& file) { return file.first.find("/.") != std::string::npos; });
        return files;
    }
    static Files visible(const Sandbox& sandbox) { return visible(sandbox.everything()); }

    Sandbox sandbox_;
    Files old_;
    Files new_;
};

std::vector<std::string> with_fault(const Sandbox& counts, long call, const std::string& error) {
    return {std::string("LD_PRELOAD=") + ASHIMPACT_FAIL_CALL, "ASHIMPACT_FAULT_CALL=" + std::to_string(call),
            "ASHIMPACT_FAULT_ERROR=" + error, "ASHIMPACT_FAULT_COUNT=" + counts.path("calls")};
}

/// The system calls of a write phase in which nothing fails, a letter each.
std::string letters_of(const Scene& scene) {
    const Sandbox sandbox;
    const Sandbox counts;
    scene.restore(sandbox);
    CHECK(test::run(sandbox, command(), with_fault(counts, 0, "kill")).status == 0);
    return counts.read("calls");
}

/// How many they are.
long calls_of(const Scene& scene) {
    return static_cast<long>(letters_of(scene).size());
}

/// Has a reader complete what a killed run has decided. @return whether there was such a thing
bool complete_by_reading(const Sandbox& sandbox) {
    if (!sandbox.has("out/.ashimpact-run")) return false;
    const Sandbox page;
    const Ended read = test::run(sandbox, {ASHIMPACT_PROGRAM, "report", "out", "-o", page.path("page.html")});
    CHECK_MESSAGE(read.status == 0, read.err);
    return true;
}

/// The next run finds its way, whatever the one before left.
void check_goes_on(const Scene& scene, const Sandbox& sandbox) {
    const Ended ended = test::run(sandbox, command());
    CHECK_MESSAGE(ended.status == 0, ended.err);
    CHECK(sandbox.everything() == scene.after());
}

}  // namespace

TEST_CASE("each system call of the write phase fails once: the folder is the old run or the new one") {
    const Scene scene;
    for (const int error : {ENOSPC, EIO, EINTR, EACCES}) {
        const long calls = calls_of(scene);
        int refused = 0;
        for (long call = 1; call <= calls; ++call) {
            const Sandbox sandbox;
            const Sandbox counts;
            scene.restore(sandbox);
            const Ended ended =
                test::run(sandbox, command(), with_fault(counts, call, std::to_string(error)));
            CAPTURE(error);
            CAPTURE(call);
            CAPTURE(ended.err);
            CHECK((ended.status == 0 || ended.status == 2));
            if (ended.status == 0) CHECK(scene.is_new(sandbox));
            if (ended.status == 2) CHECK(scene.is_old(sandbox));
            if (ended.status == 2) CHECK(test::lines_of(ended.err).back() == containing("out"));
            refused += ended.status == 2 ? 1 : 0;
            if (call % 5 == 0) check_goes_on(scene, sandbox);
        }
        MESSAGE(std::string(std::strerror(error))
                << ": " << calls << " calls, " << refused << " runs refused");
        CHECK(calls > 20);
        if (error != EINTR) CHECK(refused > 5);
    }
}

TEST_CASE("new files and their folder are on the disk before they count, and in place before the end") {
    const std::string calls = letters_of(Scene());
    CAPTURE(calls);
    REQUIRE(calls == containing("R"));
    CHECK(calls.find('f') < calls.find('F'));
    CHECK(calls.find('F') < calls.find('R'));
    const std::string until_end = calls.substr(0, calls.rfind('R'));  // of the folder that was decided
    REQUIRE(until_end.rfind('R') != std::string::npos);
    CHECK(until_end.rfind('F') > until_end.rfind('R'));
}

TEST_CASE("killed at each system call of the write phase, the folder is the old run or the new one") {
    const Scene scene;
    const long calls = calls_of(scene);
    int killed = 0;
    int completed = 0;
    for (long call = 1; call <= calls; ++call) {
        const Sandbox sandbox;
        const Sandbox counts;
        scene.restore(sandbox);
        const Ended ended = test::run(sandbox, command(), with_fault(counts, call, "kill"));
        CAPTURE(call);
        CAPTURE(ended.err);
        CHECK((ended.status == 0 || ended.status == 128 + SIGKILL));
        killed += ended.status != 0 ? 1 : 0;
        if (call % 3 == 0) {
            check_goes_on(scene, sandbox);
            continue;
        }
        completed += complete_by_reading(sandbox) ? 1 : 0;
        CHECK((scene.is_old(sandbox) || scene.is_new(sandbox)));
    }
    CHECK(killed > 20);
    CHECK(completed > 3);
}

TEST_CASE("killed at random moments, the folder is the old run or the new one") {
    const Scene scene;
    std::minstd_rand random(5);
    const int kills = whole() ? 300 : 8;
    const auto start = std::chrono::steady_clock::now();
    {
        const Sandbox sandbox;
        scene.restore(sandbox);
        REQUIRE(test::run(sandbox, command()).status == 0);
    }
    std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    int killed = 0;
    int round = 0;
    for (; killed < kills && round < 20 * kills; ++round) {
        const Sandbox sandbox;
        scene.restore(sandbox);
        Process process(sandbox, command(), {});
        // Most of them in the last part, where it writes. What that is changes with the load of the machine:
        // of these kills, about half come before the end.
        const bool late = round % 3 != 0;
        const double part = std::uniform_real_distribution<double>(late ? 0.8 : 0.0, 1.0)(random);
        std::this_thread::sleep_for(took * part);
        process.signal(SIGKILL);
        const bool in_time = process.wait().status != 0;
        killed += in_time ? 1 : 0;
        if (late) took *= in_time ? 1.05 : 0.95;
        static_cast<void>(complete_by_reading(sandbox));
        CAPTURE(round);
        CHECK((scene.is_old(sandbox) || scene.is_new(sandbox)));
    }
    MESSAGE(killed << " of " << round << " runs were killed");
    CHECK(killed == kills);
}

TEST_CASE("twenty runs into one folder: one at a time, the others say so, and the folder is whole") {
    const Scene scene;
    const Sandbox sandbox;
    scene.restore(sandbox);
    std::vector<std::unique_ptr<Process>> runs;
    runs.reserve(20);
    for (int i = 0; i < 20; ++i)
        runs.push_back(std::make_unique<Process>(sandbox, command(), std::vector<std::string>{}));
    int done = 0;
    for (const auto& run : runs) {
        const Ended ended = run->wait();
        CAPTURE(ended.err);
        CHECK((ended.status == 0 || ended.status == 2));
        if (ended.status == 2) CHECK(ended.err == containing("another run is at work in this folder"));
        done += ended.status == 0 ? 1 : 0;
    }
    CHECK(done >= 1);
    CHECK(sandbox.everything() == scene.after());
}

TEST_CASE("a flipped bit in an artifact is refused, said to be an edit, or changes no result") {
    const Sandbox sandbox;
    test::write_example(sandbox, small_case(1.5));
    REQUIRE(test::run(sandbox, {ASHIMPACT_PROGRAM, "run", "case.json", "-o", "out", "--no-report"}).status ==
            0);
    const std::vector<std::string> again{ASHIMPACT_PROGRAM, "run",        "-o",         "out",
                                         "--only",          "comparison", "--no-report"};
    const Json expected = sandbox.json("out/comparison.json")["result"];
    std::minstd_rand random(9);
    int refused = 0;
    int edited = 0;
    const int rounds = whole() ? 300 : 30;
    for (int round = 0; round < rounds; ++round) {
        static const std::vector<std::string> files{
            "0-case", "1-modulus", "2-contact", "3-analytic", "6-fit", "7-critical-velocity", "8-histories"};
        const std::string file = "out/" + files[random() % files.size()] + ".json";
        const std::string bytes = sandbox.read(file);
        std::string flipped = bytes;
        const std::size_t place = random() % bytes.size();
        flipped[place] = static_cast<char>(flipped[place] ^ (1 << (random() % 8)));
        sandbox.write(file, flipped);
        const Ended ended = test::run(sandbox, again);
        sandbox.write(file, bytes);
        CAPTURE(file);
        CAPTURE(place);
        CAPTURE(ended.err);
        CHECK((ended.status == 0 || ended.status == 2));
        if (ended.status == 2) {
            ++refused;
            CHECK(test::lines_of(ended.err).size() == 1);
            CHECK(ended.err == containing(file.substr(4)));
        } else if (ended.err.find("was edited") != std::string::npos) {
            ++edited;
        } else {
            CHECK(sandbox.json("out/comparison.json")["result"] == expected);
        }
    }
    MESSAGE(rounds << " bits flipped in artifacts: " << refused << " refused, " << edited
                   << " said to be edits");
    CHECK(refused + edited > rounds / 4);
}

TEST_CASE("a pipe in the way is refused at once, and an interruption ends a run at any time") {
    const Scene scene;
    const Sandbox sandbox;
    scene.restore(sandbox);
    std::filesystem::remove(sandbox.path("out/manifest.json"));
    REQUIRE(mkfifo(sandbox.path("out/manifest.json").c_str(), 0600) == 0);
    const Ended ended = test::run(sandbox, command());
    CHECK(ended.status == 2);
    CHECK(ended.err == containing("manifest.json: cannot be written: it is no plain file"));
}
