// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

namespace ashimpact {

/// Progress of a computation as one line on standard error: the share done, the rate, the time left.
class Progress {
  public:
    /// @param done at the start; it does not count for the rate
    /// @param noun what is counted, such as "impacts"
    Progress(std::uint64_t total, std::uint64_t done, bool shown, const char* noun = "impacts");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// Shows that @p done of the total are done; called often, it prints a few times a second.
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
