// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/text/progress.hpp"

#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace ashimpact {

namespace {

constexpr std::chrono::milliseconds period{250};

/// "3.2 million impacts/s"; what takes more than a second each, "12 s for each of 6 hypotheses".
std::string rate_text(double rate, std::uint64_t total, const char* noun) {
    if (rate >= 1e6) return fmt::format("{:.3g} million {}/s", rate / 1e6, noun);
    if (rate >= 1e3) return fmt::format("{:.3g} thousand {}/s", rate / 1e3, noun);
    if (rate >= 1.0) return fmt::format("{:.3g} {}/s", rate, noun);
    return fmt::format("{:.{}f} s for each of {} {}", 1.0 / rate, rate > 0.1 ? 1 : 0, total, noun);
}

std::string time_text(double seconds) {
    if (seconds >= 100 * 3600) return fmt::format("{:.0f} days", seconds / 86400);
    const auto whole = std::lround(seconds);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(std::uint64_t total, std::uint64_t done, bool shown, const char* noun)
    : total_(total), before_(done), shown_(shown), noun_(noun) {}

Progress::~Progress() {
    if (dirty_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(std::uint64_t done) {
    const auto now = Clock::now();
    if (!shown_ || done == before_ || now - last_ < period) return;
    last_ = now;
    const double rate =
        static_cast<double>(done - before_) / std::chrono::duration<double>(now - start_).count();
    const double part = static_cast<double>(done) / static_cast<double>(total_);
    const std::string line =
        fmt::format("\r\x1b[K{:5.1f} %, {}, {} left", 100 * part, rate_text(rate, total_, noun_),
                    time_text(static_cast<double>(total_ - done) / rate));
    std::fputs(line.c_str(), stderr);
    dirty_ = true;
}

bool on_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

}  // namespace ashimpact
