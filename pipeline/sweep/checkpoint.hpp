#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "pipeline/sweep/crew/tally.hpp"
#include "pipeline/sweep/spec/plan.hpp"

namespace ashimpact {

/// What a checkpoint says it is, so that a sweep knows its own.
inline constexpr std::string_view checkpoint_mark = "ashimpact sweep checkpoint";

/// What is finished of a sweep.
struct Checkpoint {
    Tally tally;
    std::uint64_t row_bytes = 0;  ///< of the packed rows

    template <class Archive>
    void transfer(Archive& archive) {
        archive(tally, row_bytes);
    }
};

/// Replaces the checkpoint file at once. @throws InputError if it cannot be written
void save_checkpoint(const std::filesystem::path& file, const SweepPlan& plan, Checkpoint checkpoint);

/// The checkpoint of a sweep; nothing if there is no file.
/// @throws InputError if it is one of another spec or program, or damaged
[[nodiscard]] std::optional<Checkpoint> load_checkpoint(const std::filesystem::path& file,
                                                        const SweepPlan& plan);

}  // namespace ashimpact
