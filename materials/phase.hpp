// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ashimpact {

/// One property of a phase, with what is known of its reliability.
struct PhaseProperty {
    double value = 0;                                  ///< [SI]
    std::optional<double> standard_uncertainty{};      ///< [SI], as the source states it
    std::optional<std::pair<double, double>> range{};  ///< lowest and highest literature value [SI]
    bool assumed = false;                              ///< not known for this phase, taken from a similar one
    std::vector<std::string> citations{};              ///< BibTeX keys of data/references.bib

    /// Returns the standard uncertainty [SI]: as stated, else that of a rectangular distribution over the
    /// range, (high - low)/sqrt(12) (JCGM 100:2008, 4.3.7), else nothing.
    [[nodiscard]] std::optional<double> uncertainty() const;
};

/// A phase of an ash: crystalline or glass, as a dense isotropic solid.
struct Phase {
    std::string name;
    std::string formula{};
    std::string group{};  ///< mineral group; may be empty
    bool amorphous = false;
    PhaseProperty density{};                       ///< [kg/m3]
    PhaseProperty young_modulus{};                 ///< [Pa]
    std::optional<PhaseProperty> poisson_ratio{};  ///< [1]
    std::vector<std::string> synonyms{};
    std::vector<std::string> bgmn{};  ///< identifiers in BGMN structure files
    std::string remark{};
};

}  // namespace ashimpact
