// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/case/laws.hpp"

#include <algorithm>

#include "solver/motion/impact.hpp"

namespace ashimpact {

void read_detachments(const std::optional<View>& node, std::vector<LawChoice>& choices,
                      const std::string& known_laws) {
    if (!node) return;
    for (const auto& [name, value] : node->members()) {
        const Law law = at_place(value.pointer(), [&key = name] { return Law::named(key); });
        const Detachment detachment = named<Detachment>(value.text());
        if (const auto reason = refusal(law, detachment)) value.fail(*reason, admissible_detachments(law));
        const auto chosen = std::find_if(choices.begin(), choices.end(),
                                         [&](const LawChoice& choice) { return choice.law == law; });
        if (chosen == choices.end()) value.fail("the law is not among \"laws\"", known_laws);
        chosen->detachment = detachment;
    }
}

}  // namespace ashimpact
