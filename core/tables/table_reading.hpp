// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quantities/quantity.hpp"

namespace ashimpact {

/// How a table was read, in words for a person who knows its file: counts, and each column that is used with
/// what it is taken as. Columns that are not used are findings.
class TableReading {
  public:
    /// Adds a fact about all of the table: "24 impacts, 3 captured".
    void add(std::string fact) { facts_.push_back(std::move(fact)); }

    /// Adds a heading, as written, under what it is taken as: "amounts by weight, in %". Each is shown once.
    /// @param behind it, without quotes: " of \"FA1\""
    void take(const std::string& what, std::string_view heading, const std::string& behind = {});

    /// "2 samples; amounts by weight, in %: "FA1 [wt%]", "FA2 [wt%]"". Empty for a file that is no table.
    [[nodiscard]] std::string text() const;

  private:
    struct Group {
        std::string what;
        std::vector<std::string> first{};  ///< headings that are shown
        std::set<std::string> all{};
    };
    std::vector<std::string> facts_{};
    std::vector<Group> groups_{};
};

/// " divided by 2" for uncertainties that are as many standard ones; empty for these.
[[nodiscard]] inline std::string divided_by(double coverage) {
    return coverage == 1 ? std::string() : " divided by " + readable_number(coverage);
}

}  // namespace ashimpact
