// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>

namespace ashimpact::batch {

/// The state of a piece of a table: unknown, the first of its values, until it is computed, once; from then
/// on the piece is immutable.
template <class State>
class Settled {
  public:
    [[nodiscard]] State state() const { return state_.load(std::memory_order_acquire); }

    /// Computes the state; other threads wait for the first.
    /// @param compute returns the state, after all else of the piece is in its place
    template <class Compute>
    void settle(const Compute& compute) {
        std::call_once(settled_, [&] { state_.store(compute(), std::memory_order_release); });
    }

  private:
    std::atomic<State> state_{};
    std::once_flag settled_;
};

}  // namespace ashimpact::batch
