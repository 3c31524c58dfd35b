// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/json/document.hpp"
#include "pipeline/app/commands/contact_options.hpp"
#include "solver/motion/impact.hpp"
#include "solver/motion/regime.hpp"

namespace ashimpact {

struct ImpactOptions {
    ContactOptions contact;
    std::string velocity;
    std::string method = "taylor";  ///< or "paper-explicit", Eqs. 31-34 of Dong et al. 2013
    std::string time_step;          ///< of the explicit method; empty: 10000 steps a Hertz contact
    std::string trajectory;         ///< CSV file to write; empty: none
    int points = 201;               ///< of the trajectory
    bool json = false;
};

/// `ashimpact impact`: solves one impact and prints it; writes its trajectory where one is asked for.
void run_impact_command(const ImpactOptions& options, std::ostream& out);

/// An impact and what it did, with the keys of the command's --json.
[[nodiscard]] Json impact_json(const Impact& impact, const ImpactResult& result);

/// The lines a reader gets of it.
[[nodiscard]] std::string impact_text(const Impact& impact, const ImpactResult& result);

/// The lines on the regime of an impact.
[[nodiscard]] std::string regime_text(const Regime& regime);

/// Puts the warnings of a regime on standard error.
void warn_of_regime(const Regime& regime);

}  // namespace ashimpact
