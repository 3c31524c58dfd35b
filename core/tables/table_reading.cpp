// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_reading.hpp"

#include <algorithm>

#include "core/text/text.hpp"

namespace ashimpact {

void TableReading::take(const std::string& what, std::string_view heading, const std::string& behind) {
    const std::string shown = (heading.empty() ? "a column without a heading" : in_quotes(heading)) + behind;
    auto group = std::ranges::find(groups_, what, &Group::what);
    if (group == groups_.end()) group = groups_.insert(group, {what});
    if (std::ranges::find(group->headings, shown) == group->headings.end()) group->headings.push_back(shown);
}

std::string TableReading::text() const {
    constexpr std::size_t most = 12;  // a table may have thousands of samples
    std::vector<std::string> parts = facts_;
    for (const Group& group : groups_) {
        std::vector<std::string> shown = group.headings;
        if (shown.size() > most) {
            shown.resize(most);
            shown.push_back("and " + std::to_string(group.headings.size() - most) + " more");
        }
        parts.push_back(group.what + ": " + joined(shown));
    }
    std::string text;
    for (const std::string& part : parts) (text += text.empty() ? "" : "; ") += part;
    return text;
}

}  // namespace ashimpact
