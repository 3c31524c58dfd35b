// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "pipeline/app/sweep/spec/plan.hpp"
#include "pipeline/app/sweep/workers/sweep_progress.hpp"

namespace ashimpact {

/// Beginning of every checkpoint, by which a sweep recognises one.
inline constexpr std::string_view checkpoint_mark = "ashimpact sweep checkpoint";

/// The finished part of a sweep.
struct Checkpoint {
    SweepProgress progress;
    std::uint64_t row_bytes = 0;  ///< of the packed rows

    template <class Archive>
    void transfer(Archive& archive) {
        archive(progress, row_bytes);
    }
};

/// Replaces the checkpoint file atomically. @throws InputError if it cannot be written
void save_checkpoint(const std::filesystem::path& file, const SweepPlan& plan, Checkpoint checkpoint);

/// The checkpoint of a sweep; none if there is no file.
/// @throws InputError if it belongs to another spec or program, or is damaged
[[nodiscard]] std::optional<Checkpoint> load_checkpoint(const std::filesystem::path& file,
                                                        const SweepPlan& plan);

}  // namespace ashimpact
