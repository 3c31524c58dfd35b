// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ashimpact {

/// How the impacts of a batch are solved; both keep the bound of solve_impacts().
enum class BatchMethod {
    integration,  ///< each impact is integrated
    table,  ///< e and contact time come from a table of the law's impacts. Its parts are integrated when they
            ///< are first needed, then kept. Impacts next to the edge of capture are integrated. Faster from
            ///< about 100,000 impacts on.
};

}  // namespace ashimpact
