// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace ashimpact {

/// Sets --color: "always", "never", or "auto", which is color on a terminal unless NO_COLOR is set or TERM is
/// dumb.
void choose_color(std::string_view when);

/// Whether the output to this file descriptor is colored.
[[nodiscard]] bool is_colored(int descriptor);

/// The text for a terminal: headings of tables bold, "warning:" yellow.
[[nodiscard]] std::string with_colors(std::string_view text);

/// An error message for a terminal: red.
[[nodiscard]] std::string error_in_color(std::string_view text);

/// Messages on standard error. Warnings are held until the command has accepted its input: an input error
/// prints one line, without warnings about results. Messages other than errors are wrapped at 80 characters.
/// Safe for several threads.
class Messages : public spdlog::sinks::base_sink<std::mutex> {
  public:
    Messages() = default;
    ~Messages() override;
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;
    Messages(Messages&&) = delete;
    Messages& operator=(Messages&&) = delete;

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

}  // namespace ashimpact
