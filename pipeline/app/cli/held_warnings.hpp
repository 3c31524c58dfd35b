// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <string>

#include <spdlog/sinks/base_sink.h>

namespace ashimpact {

/// Standard error. Warnings wait until it is known whether the command's input is right at all: an error in
/// the input is told in one line, without remarks on results that there are not. Messages that are no errors
/// are broken at 80 characters. Safe for several threads.
class HeldWarnings : public spdlog::sinks::base_sink<std::mutex> {
  public:
    HeldWarnings() = default;
    ~HeldWarnings() override;
    HeldWarnings(const HeldWarnings&) = delete;
    HeldWarnings& operator=(const HeldWarnings&) = delete;
    HeldWarnings(HeldWarnings&&) = delete;
    HeldWarnings& operator=(HeldWarnings&&) = delete;

    /// Writes what waits.
    void release();
    /// Forgets what waits.
    void drop();

  protected:
    void sink_it_(const spdlog::details::log_msg& message) override;
    void flush_() override;

  private:
    std::string held_;
};

}  // namespace ashimpact
