// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "pipeline/app/sweep/workers/chunk.hpp"

namespace ashimpact {

/// A computed block.
struct FinishedBlock {
    Block block;
    double seconds = 0;  ///< computing time of its thread [s]
    std::string bytes;   ///< result of the work

    template <class Archive>
    void transfer(Archive& archive) {
        archive(block, seconds, bytes);
    }
};

/// Computes a block and returns its result in bytes.
using Work = std::function<std::string(const Block&)>;

/// The workers of a sweep: threads of this process, or those of all processes of an MPI job.
class Workers {
  public:
    Workers() = default;
    virtual ~Workers() = default;
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    Workers(Workers&&) = delete;
    Workers& operator=(Workers&&) = delete;

    /// Number of blocks that keep all workers busy.
    [[nodiscard]] virtual std::size_t capacity() const = 0;
    /// How many more blocks may be assigned now.
    [[nodiscard]] virtual std::size_t vacancies() const = 0;
    /// Gives a block to a worker; requires vacancies() > 0.
    virtual void assign(const Block& block) = 0;
    /// A finished block; none if none is finished within @p patience. Rethrows what the work threw.
    [[nodiscard]] virtual std::optional<FinishedBlock> finished(std::chrono::microseconds patience) = 0;
};

}  // namespace ashimpact
