// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/finding.hpp"

namespace ashimpact {

/// Texts of rooms that make no findings yet, as findings of one code.
[[nodiscard]] inline std::vector<Finding> findings_of(std::string_view code,
                                                      const std::vector<std::string>& texts) {
    constexpr std::string_view background[]{"\" is taken as ",
                                            "no uncertainty of Young's modulus is known",
                                            "the Poisson ratio is assumed",
                                            " of the variance of E",
                                            " leaves out the adhesion of ",
                                            "Tabor parameter ",
                                            " above the heading not read",
                                            " is read, not ",
                                            "was read as Latin-1",
                                            " is used; the catalogue has "};
    std::vector<Finding> findings;
    for (const std::string& text : texts) {
        bool decides = !text.ends_with("\" is not used");
        for (const std::string_view part : background)
            decides = decides && text.find(part) == std::string::npos;
        findings.push_back({code, decides ? Severity::remark : Severity::background, text});
    }
    return findings;
}

}  // namespace ashimpact
