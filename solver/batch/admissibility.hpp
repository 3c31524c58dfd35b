// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "solver/motion/impact.hpp"

namespace ashimpact::batch {

/// Checks that a law admits a detachment, as refusal() does. The answers are computed once per process,
/// because refusal() takes longer than a batch of one impact. @throws InputError
inline void require_admissible(Law law, Detachment detachment) {
    constexpr std::size_t ends = all_values<Detachment>.size();
    static const auto reasons = [] {
        std::array<std::optional<std::string>, Law::count() * ends> all;
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = refusal(Law::at(i / ends), static_cast<Detachment>(i % ends));
        }
        return all;
    }();
    const auto& reason = reasons[law.index() * ends + static_cast<std::size_t>(detachment)];
    if (reason) throw InputError(*reason, admissible_detachments(law));
}

}  // namespace ashimpact::batch
