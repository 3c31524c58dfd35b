// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <doctest/doctest.h>

#include "core/text/text.hpp"
#include "tests/core/messages.hpp"
#include "tests/materials/catalogue.hpp"

namespace ashimpact::test {

TEST_CASE("docs/phases.md shows the catalogue as it is") {
    const std::string page = file_text(ASHIMPACT_DOCS "/phases.md");
    const PhaseCatalogue catalogue = shipped_catalogue();
    for (const PhaseSet& set : catalogue.sets()) {
        for (const Phase& phase : set.phases) {
            std::string row = "| " + phase.name + " | " + phase.formula + " | " +
                              shortest(phase.density.value / 1000) + " | " +
                              shortest(phase.young_modulus.value / 1e9) + " | ";
            CAPTURE(row);
            CHECK(holds(page, row));
            if (phase.remark.empty()) continue;
            CHECK(holds(page, "**" + phase.name + "**: " + phase.remark));
        }
    }
}

}  // namespace ashimpact::test
