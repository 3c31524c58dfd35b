#pragma once

namespace ashimpact {

/// How the impacts of a batch are solved; both keep the bound of solve_impacts().
enum class BatchMethod {
    integration,  ///< each impact is integrated
    table,  ///< e and contact time are read from a table of the law's impacts, which is made by integration
            ///< where it is asked for, and kept; integrated where the table does not tell. Pays from some
            ///< 100,000 impacts on.
};

}  // namespace ashimpact
