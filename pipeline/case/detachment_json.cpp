#include "pipeline/case/detachment_json.hpp"

#include <string>

#include "solver/motion/impact.hpp"

namespace ashimpact {

Json detachments_json(const Case& data) {
    Json laws = Json::object();
    for (const LawChoice& choice : data.laws) {
        Json refused = Json::object();
        for (const DetachmentName& entry : detachment_names) {
            if (const auto reason = refusal(choice.law, entry.detachment))
                refused[std::string(entry.name)] = *reason;
        }
        laws[std::string(choice.law.name())] = {{"ends_at", name_of(choice.detachment)},
                                                {"refused", std::move(refused)}};
    }
    return laws;
}

}  // namespace ashimpact
