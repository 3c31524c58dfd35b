#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "pipeline/sweep/crew/chunk.hpp"

namespace ashimpact {

/// A block that was computed.
struct FinishedBlock {
    Block block;
    double seconds = 0;  ///< that a thread took for it
    std::string bytes;   ///< what the work returned

    template <class Archive>
    void transfer(Archive& archive) {
        archive(block, seconds, bytes);
    }
};

/// Computes a block and returns its result in bytes.
using Work = std::function<std::string(const Block&)>;

/// Those who do the work: threads of this process, or those of all processes of an MPI job.
class Team {
  public:
    Team() = default;
    virtual ~Team() = default;
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    Team(Team&&) = delete;
    Team& operator=(Team&&) = delete;

    /// How many blocks keep everyone busy.
    [[nodiscard]] virtual std::size_t capacity() const = 0;
    /// How many more blocks may be assigned now.
    [[nodiscard]] virtual std::size_t vacancies() const = 0;
    /// Has a block computed by someone; needs a vacancy.
    virtual void assign(const Block& block) = 0;
    /// A block that is finished, waiting for one at most that long. Rethrows what the work threw.
    [[nodiscard]] virtual std::optional<FinishedBlock> finished(std::chrono::microseconds patience) = 0;
};

}  // namespace ashimpact
