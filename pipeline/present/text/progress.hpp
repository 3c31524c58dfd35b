// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace ashimpact {

/// One line on standard error that tells how far a computation is, at which rate, and how long it will take.
class Progress {
  public:
    /// @param done what was there when it began; of the rest the rate is taken
    /// @param noun what is counted, such as "impacts"
    Progress(std::uint64_t total, std::uint64_t done, bool shown, const char* noun = "impacts");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// Shows that @p done of the total are done, a few times a second.
    void update(std::uint64_t done);

  private:
    using Clock = std::chrono::steady_clock;

    std::uint64_t total_;
    std::uint64_t before_;
    bool shown_;
    const char* noun_;
    bool dirty_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_{};
};

/// Whether standard error is a terminal.
[[nodiscard]] bool on_terminal();

}  // namespace ashimpact
