// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/document.hpp"

namespace ashimpact {

Json without_comments(const Json& document) {
    if (document.is_array()) {
        Json plain = Json::array();
        for (const Json& element : document) plain.push_back(without_comments(element));
        return plain;
    }
    if (!document.is_object()) return document;
    Json plain = Json::object();
    for (const auto& [key, value] : document.items())
        if (!is_comment(key)) plain[key] = without_comments(value);
    return plain;
}

}  // namespace ashimpact
