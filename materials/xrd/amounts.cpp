// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "core/tables/text_lines.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

void normalise(std::vector<PhaseFraction>& phases, double total) {
    for (PhaseFraction& phase : phases) {
        phase.fraction /= total;
        if (phase.standard_uncertainty) *phase.standard_uncertainty /= total;
    }
}

double add_fractions(XrdSample& sample, const std::vector<ListedPhase>& phases, const std::string& amount,
                     const std::string& needed, std::size_t line) {
    double total = 0;
    std::set<std::string> keys;
    for (const ListedPhase& phase : phases) {
        if (!keys.insert(phase_key(phase.name)).second)
            refuse_line(phase.line, "the phase " + in_quotes(phase.name) + " is there twice",
                        "each phase once");
        if (!phase.amount) {
            sample.warnings.push_back({xrd_code, Severity::remark,
                                       "the phase " + in_quotes(phase.name) + " has no " + amount +
                                           " (line " + std::to_string(phase.line) + ") and is left out"});
            continue;
        }
        sample.analysis.phases.push_back({.name = phase.name,
                                          .fraction = phase.amount->value,
                                          .standard_uncertainty = phase.amount->standard_uncertainty,
                                          .density = phase.density,
                                          .place = at_line(phase.line)});
        total += phase.amount->value;
    }
    if (!(total > 0)) refuse_line(line, "no phase has a " + amount, needed);
    normalise(sample.analysis.phases, total);
    return total;
}

}  // namespace ashimpact::xrd
