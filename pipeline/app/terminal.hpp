// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
class Error;
}  // namespace CLI

namespace ashimpact {

/// Sets --color: "always", "never", or "auto": on a terminal unless NO_COLOR is set or TERM is dumb.
void choose_color(std::string_view when);

/// Whether the output to this file descriptor is colored.
[[nodiscard]] bool is_colored(int descriptor);

/// The text for a terminal: headings of tables bold, "warning:" yellow.
[[nodiscard]] std::string with_colors(std::string_view text);

/// An error message for a terminal: red.
[[nodiscard]] std::string error_in_color(std::string_view text);

/// Wrapped messages on standard error; errors in one line, which drop the warnings held so far. Thread-safe.
class Messages : public spdlog::sinks::base_sink<std::mutex> {
  public:
    ~Messages() override;

    /// Prints the held warnings.
    void release();
    /// Discards the held warnings.
    void drop();

  protected:
    void sink_it_(const spdlog::details::log_msg& message) override;
    void flush_() override;

  private:
    std::string held_;
};

/// The word that starts this program in the user's shell: as it was typed.
[[nodiscard]] const std::string& program_word();
void set_program_word(const char* typed);

/// Help in lines of at most @p width characters, descriptions wrapped in their column, examples so that they
/// can be pasted, beginning with program_word().
[[nodiscard]] std::string help_layout(const std::string& help, std::size_t width);

/// One line on a command line that could not be parsed: command, problem, what is allowed, where help is.
[[nodiscard]] std::string usage_error(const CLI::App& program, const CLI::Error& error);

/// Progress of a computation as one line on standard error: the share done, the rate, the time left.
class Progress {
  public:
    /// @param total 0 if it is not known @param done at the start, not counted in the rate
    /// @param noun such as "impacts"
    Progress(std::uint64_t total, std::uint64_t done, bool shown, const char* noun = "impacts");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

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

/// The step of a computation as one line on standard error, shown from its begin on; removed at the end.
class StepLine {
  public:
    explicit StepLine(bool shown) : shown_(shown) {}
    ~StepLine() { clear(); }
    StepLine(const StepLine&) = delete;
    StepLine& operator=(const StepLine&) = delete;

    void show(const std::string& step);
    void clear();

  private:
    bool shown_;
    bool dirty_ = false;
};

/// Whether standard error is a terminal.
[[nodiscard]] bool on_terminal();

}  // namespace ashimpact
