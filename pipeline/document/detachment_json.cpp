// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/detachment_json.hpp"

#include <string>

#include "solver/motion/impact.hpp"

namespace ashimpact {

Json detachments_json(const Case& data) {
    Json laws = Json::object();
    for (const LawChoice& choice : data.laws) {
        Json refused = Json::object();
        for (const Detachment detachment : all_values<Detachment>) {
            if (const auto reason = refusal(choice.law, detachment))
                refused[std::string(name_of(detachment))] = *reason;
        }
        laws[std::string(choice.law.name())] = {{"ends_at", name_of(choice.detachment)},
                                                {"refused", std::move(refused)}};
    }
    return laws;
}

}  // namespace ashimpact
