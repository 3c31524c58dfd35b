// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/json/view.hpp"

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
    /// A glass whose moduli were computed from its density (Makishima & Mackenzie): E is proportional to it,
    /// 1/2 - nu inversely. The uncertainty of E has that of the density in it.
    bool follows_density = false;
    std::vector<std::string> synonyms{};
    std::vector<std::string> bgmn{};  ///< identifiers in BGMN structure files
    std::string remark{};
};

/// A phase of ashes that a set cannot have, because a property is not known.
struct LackingPhase {
    std::string name;
    std::string formula{};  ///< empty for a group
    std::vector<std::string> synonyms{};
    std::string missing;  ///< "a measured Young's modulus"
};

/// Phases from one origin, chosen together by its name: "literature", "dong2013", "user".
struct PhaseSet {
    std::string name;
    std::vector<Phase> phases;
    std::vector<std::pair<std::string, std::string>> group_representatives{};  ///< group name, phase name
    std::vector<LackingPhase> lacking{};
};

/// Reads a catalogue file (data/phases/*.json). Every property must cite its source.
/// Errors: InputError with line number or JSON pointer; also when two phases of the set share a name.
[[nodiscard]] PhaseSet read_phase_set(std::string_view json_text);

/// Reads the phases of a case file, a list of the same form; citations may be missing. The set is called
/// "user".
[[nodiscard]] PhaseSet read_user_phases(const View& list);

/// A phase found under the name a file uses.
struct ResolvedPhase {
    Phase phase;
    std::string note{};  ///< why the phase is not simply the one named; usually empty
};

/// A name in a file.
struct PlacedName {
    std::string name;
    std::string place{};  ///< where the file has it, "line 12"; may be empty
};

/// Phase sets in order of preference: a name is looked for in the first set, then in the next.
class PhaseCatalogue {
  public:
    explicit PhaseCatalogue(std::vector<PhaseSet> sets);

    /// The same sets with `set` (its name) in front. Errors: InputError that lists the sets.
    [[nodiscard]] PhaseCatalogue preferring(std::string_view set) const;

    /// The same sets behind `set`: its phases hide phases of the same name, under all their synonyms.
    [[nodiscard]] PhaseCatalogue overridden_by(PhaseSet set) const;

    /// The phase of a name: its own name, a synonym, a BGMN identifier, or a mineral group with a
    /// representative. Case, blanks and punctuation do not matter, nor what programs add: "Quartz9000775",
    /// "Quartz, syn", "Quartz - SiO2". A name counts before a formula beside it: "SiO2 (cristobalite)". A
    /// member of a solid solution is found by its stem, with a note: "Anorthite_An65", "Albite high". Errors:
    /// InputError with the nearest candidates, the members of a group that has no representative, or what is
    /// missing of a phase that no set can have.
    [[nodiscard]] ResolvedPhase resolve(std::string_view name) const;

    /// The same for several names. Errors: one InputError for all unknown names, each with its place.
    [[nodiscard]] std::vector<ResolvedPhase> resolve_all(const std::vector<PlacedName>& names) const;

    /// Whether a name is that of a phase, of a mineral group or of a phase without all its properties.
    [[nodiscard]] bool knows(std::string_view name) const;

    [[nodiscard]] const std::vector<PhaseSet>& sets() const& { return sets_; }

  private:
    struct Found {
        const Phase* phase = nullptr;
        std::size_t set = 0;
    };
    /// The first phase with that key among the names of the first `sets` sets.
    [[nodiscard]] Found find(const std::string& key, std::size_t sets) const;
    /// The phase with that key. If a synonym led to it and an earlier set has a phase of the same name, that
    /// of the earlier set.
    [[nodiscard]] std::optional<ResolvedPhase> named(std::string_view name, const std::string& key) const;
    /// The phase of a part of @p name, with or without what programs add.
    [[nodiscard]] std::optional<ResolvedPhase> known(std::string_view name, std::string_view part) const;
    /// The phase that the parts of a name agree on. @throws InputError if they name two
    [[nodiscard]] std::optional<ResolvedPhase> by_parts(std::string_view name) const;
    /// Representative phase of a mineral group.
    [[nodiscard]] std::optional<ResolvedPhase> of_group(std::string_view name) const;
    /// The phase of the stem of a solid solution.
    [[nodiscard]] std::optional<ResolvedPhase> by_stem(std::string_view name) const;
    /// Refuses a formula that several phases of a set have: "SiO2". @throws InputError with their names
    void refuse_shared_formula(std::string_view name) const;
    /// The phase of a name that a set cannot have, if it is one.
    [[nodiscard]] const LackingPhase* lacking(std::string_view name) const;
    [[nodiscard]] std::vector<std::string> nearest_names(std::string_view name) const;

    /// Position of a phase: its set, and its place in that.
    struct Position {
        std::size_t set;
        std::size_t phase;
    };

    std::vector<PhaseSet> sets_;
    std::unordered_map<std::string, Position> places_;  ///< of the first phase with a key
};

/// The form in which names are compared: ASCII lower case, Greek letters spelled, subscripts as digits,
/// blanks and punctuation dropped.
[[nodiscard]] std::string phase_key(std::string_view name);

}  // namespace ashimpact
