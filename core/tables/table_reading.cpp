// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_reading.hpp"

#include <algorithm>

#include "core/text/text.hpp"

namespace ashimpact {

void TableReading::take(const std::string& what, std::string_view heading, const std::string& behind) {
    constexpr std::size_t most = 12;  // a table may have thousands of samples
    const std::string shown = (heading.empty() ? "a column without a heading" : in_quotes(heading)) + behind;
    auto group = std::ranges::find(groups_, what, &Group::what);
    if (group == groups_.end()) group = groups_.insert(group, {what});
    if (group->all.insert(shown).second && group->first.size() < most) group->first.push_back(shown);
}

std::string TableReading::text() const {
    std::vector<std::string> parts = facts_;
    for (const Group& group : groups_) {
        const std::size_t more = group.all.size() - group.first.size();
        parts.push_back(group.what + ": " + joined(group.first) +
                        (more > 0 ? ", and " + std::to_string(more) + " more" : ""));
    }
    std::string text;
    for (const std::string& part : parts) (text += text.empty() ? "" : "; ") += part;
    return text;
}

}  // namespace ashimpact
