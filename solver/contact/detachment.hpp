#pragma once

#include <array>
#include <string_view>

namespace ashimpact {

/// Where a contact ends; part of the physics, so recorded with every result.
enum class Detachment {
    zero_overlap,     ///< the surfaces are back where they first touched: delta = 0
    zero_force,       ///< the total force, damping included, has fallen to zero
    pull_off,         ///< displacement-controlled break (the fold of the JKR curve)
    load_controlled,  ///< greatest tension
};

struct DetachmentName {
    Detachment detachment;
    std::string_view name;
};

inline constexpr std::array<DetachmentName, 4> detachment_names{{
    {Detachment::zero_overlap, "zero-overlap"},
    {Detachment::zero_force, "zero-force"},
    {Detachment::pull_off, "pull-off"},
    {Detachment::load_controlled, "load-controlled"},
}};

/// Name as used on the command line and in artifacts.
[[nodiscard]] std::string_view name_of(Detachment detachment);

/// The detachment of that name. @throws InputError naming the allowed ones
[[nodiscard]] Detachment detachment_named(std::string_view name);

}  // namespace ashimpact
