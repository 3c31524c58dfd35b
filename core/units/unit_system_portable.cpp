// SPDX-License-Identifier: GPL-3.0-or-later
// For machines without UDUNITS-2: its database, read by a reader of our own.
#include "core/units/unit_database.hpp"
#include "core/units/unit_system.hpp"
#include "core/units/unit_text.hpp"

namespace ashimpact {

UnitScale database_scale_to(std::string_view unit, std::string_view target) {
    static const UnitDatabase database("/units");
    const std::string text = ascii(unit);
    if (!names_a_unit(text)) return {.problem = UnitProblem::unknown};
    return database.scale(text, target);
}

UnitScale scale_to(std::string_view unit, std::string_view target) {
    return database_scale_to(unit, target);
}

}  // namespace ashimpact
