// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/phase_catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "core/quantities/checks.hpp"
#include "core/quantities/quantity.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"

namespace ashimpact {

namespace {

std::pair<double, double> read_range(const View& node, const std::string& unit, Dimension dimension,
                                     double value) {
    const auto ends = node.elements();
    if (ends.size() != 2) node.fail("not two numbers", "[lowest, highest]");
    const auto end = [&](const View& view) {
        if (!view.json().is_number()) view.fail("is not a number", "a number");
        return at_place(view.pointer(), [&] { return to_si(view.json().get<double>(), unit, dimension); });
    };
    const double low = end(ends[0]);
    const double high = end(ends[1]);
    if (!(low <= value && value <= high))
        node.fail("the value lies outside its own range", "low <= value <= high");
    return {low, high};
}

PhaseProperty read_property(const View& node, Dimension dimension) {
    if (!node.is_object()) {
        const Quantity quantity = node.quantity(dimension);
        return {.value = quantity.value, .standard_uncertainty = quantity.standard_uncertainty};
    }
    node.require_keys({"value", "unit", "standard_uncertainty", "range", "assumed", "citations"});
    Json plain = node.json();
    for (const auto* key : {"range", "assumed", "citations"}) plain.erase(key);
    const Quantity quantity = at_place(node.pointer(), [&] { return read_quantity(plain, dimension); });
    PhaseProperty property{.value = quantity.value, .standard_uncertainty = quantity.standard_uncertainty};
    if (const auto range = node.find("range"))
        property.range = read_range(*range, node.at("unit").text(), dimension, property.value);
    if (const auto assumed = node.find("assumed")) property.assumed = assumed->truth();
    if (const auto citations = node.find("citations")) property.citations = citations->texts();
    return property;
}

PhaseProperty positive(const View& node, Dimension dimension) {
    PhaseProperty property = read_property(node, dimension);
    at_place(node.pointer(), [&] { require_positive("value", property.value, dimension); });
    return property;
}

PhaseProperty poisson(const View& node) {
    PhaseProperty property = read_property(node, Dimension::fraction);
    at_place(node.pointer(), [&] { require_poisson_ratio("value", property.value); });
    return property;
}

Phase read_phase(const View& node) {
    node.require_keys({"name", "formula", "group", "amorphous", "density", "young_modulus", "poisson_ratio",
                       "synonyms", "bgmn", "remark"});
    const auto text = [&](const char* key) {
        const auto found = node.find(key);
        return found ? found->text() : std::string();
    };
    const auto texts = [&](const char* key) {
        const auto found = node.find(key);
        return found ? found->texts() : std::vector<std::string>();
    };
    Phase phase{.name = node.at("name").text()};
    phase.formula = text("formula");
    phase.group = text("group");
    if (const auto amorphous = node.find("amorphous")) phase.amorphous = amorphous->truth();
    phase.density = positive(node.at("density"), Dimension::density);
    phase.young_modulus = positive(node.at("young_modulus"), Dimension::pressure);
    if (const auto ratio = node.find("poisson_ratio")) phase.poisson_ratio = poisson(*ratio);
    phase.synonyms = texts("synonyms");
    phase.bgmn = texts("bgmn");
    phase.remark = text("remark");
    return phase;
}

std::vector<std::string> names_of(const Phase& phase) {
    std::vector<std::string> names{phase.name};
    names.insert(names.end(), phase.synonyms.begin(), phase.synonyms.end());
    names.insert(names.end(), phase.bgmn.begin(), phase.bgmn.end());
    return names;
}

void require_unambiguous(const std::vector<Phase>& phases) {
    std::map<std::string, std::string> owners;
    for (const Phase& phase : phases) {
        for (const auto& name : names_of(phase)) {
            const auto [owner, is_new] = owners.emplace(phase_key(name), phase.name);
            if (phase_key(name).empty())
                throw InputError("the phase " + in_quotes(phase.name) + " has an empty name");
            if (!is_new && owner->second != phase.name)
                throw InputError(in_quotes(name) + " stands for both " + owner->second + " and " + phase.name,
                                 "one phase for each name");
        }
    }
}

std::vector<Phase> read_phases(const View& list) {
    std::vector<Phase> phases;
    for (const View& phase : list.elements()) phases.push_back(read_phase(phase));
    at_place(list.pointer(), [&] { require_unambiguous(phases); });
    return phases;
}

LackingPhase read_lacking(const View& node) {
    node.require_keys({"name", "formula", "synonyms", "missing"});
    LackingPhase phase{.name = node.at("name").text(), .missing = node.at("missing").text()};
    if (const auto formula = node.find("formula")) phase.formula = formula->text();
    if (const auto synonyms = node.find("synonyms")) phase.synonyms = synonyms->texts();
    return phase;
}

void require_citations(const PhaseSet& set) {
    for (const Phase& phase : set.phases) {
        const bool cited = !phase.density.citations.empty() && !phase.young_modulus.citations.empty() &&
                           (!phase.poisson_ratio || !phase.poisson_ratio->citations.empty());
        if (!cited) throw InputError("the phase " + phase.name + " has a property without a citation");
    }
}

/// A key without what programs and data bases add to a name: numbers of entries, as in Quartz9000775, and
/// words for the form that is stable at room temperature, as in "Quartz low, syn".
std::string without_additions(std::string key) {
    constexpr std::array<std::string_view, 9> additions{"syn",  "synthetic", "low",   "ordered", "pdf",
                                                        "icsd", "cod",       "amcsd", "ref"};
    const auto first = key.find_first_not_of("0123456789");
    if (first != std::string::npos && first > 4) key.erase(0, first);
    for (std::size_t before = 0; before != key.size();) {
        before = key.size();
        const auto last = key.find_last_not_of("0123456789");
        if (last != std::string::npos && key.size() - last > 4) key.resize(last + 1);
        for (const std::string_view word : additions)
            if (key.size() > word.size() && key.ends_with(word)) key.resize(key.size() - word.size());
    }
    return key;
}

/// "Quartz" and "SiO2" of "Quartz - SiO2" or "Quartz (SiO2)"; "Anorthite" and "sodian" of "Anorthite,
/// sodian".
std::vector<std::string_view> parts_of(std::string_view name) {
    std::vector<std::string_view> parts;
    const auto take = [&](std::size_t length) {
        if (const auto part = trimmed(name.substr(0, length)); !part.empty()) parts.push_back(part);
    };
    constexpr std::array<std::string_view, 5> marks{" - ", " \u2013 ", " (", " [", ", "};
    for (std::size_t at = 0; at < name.size();) {
        const auto* const mark = std::ranges::find_if(
            marks, [&](std::string_view each) { return name.substr(at).starts_with(each); });
        const bool closes = (name[at] == ')' || name[at] == ']') && at + 1 == name.size();
        if (mark == marks.end() && !closes) {
            ++at;
            continue;
        }
        take(at);
        name.remove_prefix(at + (closes ? 1 : mark->size()));
        at = 0;
    }
    take(name.size());
    return parts;
}

/// Whether a name is a chemical formula, which several phases may share.
bool is_formula(std::string_view name) {
    static const std::regex symbols("([A-Z][a-z]?|[0-9.()])+");
    return name.size() < 40 && std::regex_match(std::string(name), symbols);
}

/// Whether a qualifier in a name changes the phase: another polymorph, its melt, a product of hydration,
/// carbonation or heating. "struck out" is the spreadsheet reader's mark of a deleted name.
bool names_other_form(std::string_view part, const Phase& phase) {
    static const WordLists forms("other forms");
    const auto has = [&](const char* group) { return phase.formula.find(group) != std::string::npos; };
    const bool has_water = has("OH") || has("H2O");
    const bool has_carbonate = has("CO3");
    const auto changes = [&](std::string_view list) {
        if (list == "hydrated") return !has_water;
        if (list == "carbonated") return !has_carbonate;
        if (list == "heated") return has_water || has_carbonate || phase.formula.empty();
        return true;
    };
    if (const auto list = forms.list_of(part)) return changes(*list);
    return std::ranges::any_of(words_in(part), [&](const std::string& word) {
        const auto list = forms.list_of(word);
        return list && *list != "polymorph" && changes(*list);
    });
}

bool differ_in_formula(const Phase& phase, const Phase& other) {
    return !phase.formula.empty() && !other.formula.empty() &&
           phase_key(phase.formula) != phase_key(other.formula);
}

/// The name of a phase without the mark of its set: quartz for quartz-dong2013 of the set dong2013.
std::string common_name(const Phase& phase, const PhaseSet& set) {
    const std::string mark = "-" + set.name;
    return phase.name.ends_with(mark) ? phase.name.substr(0, phase.name.size() - mark.size()) : phase.name;
}

/// How many unknown names a message lists.
constexpr std::size_t most_listed = 8;

constexpr const char* known_phases =
    "a phase that `ashimpact phases` lists, or one of your own: --phases FILE, or \"phases\" in a case";

}  // namespace

std::optional<double> PhaseProperty::uncertainty() const {
    if (standard_uncertainty) return standard_uncertainty;
    if (range) return (range->second - range->first) / std::sqrt(12.0);
    return std::nullopt;
}

std::string phase_key(std::string_view name) {
    return word_key(name);
}

PhaseSet read_phase_set(std::string_view json_text) {
    const Json document = parse_json(json_text);
    const View root(document);
    root.require_keys({"set", "title", "group_representatives", "lacking", "phases"});
    PhaseSet set{.name = root.at("set").text(), .phases = read_phases(root.at("phases"))};
    if (const auto groups = root.find("group_representatives"))
        for (const auto& [group, phase] : groups->members())
            set.group_representatives.emplace_back(group, phase.text());
    if (const auto lacking = root.find("lacking"))
        for (const View& phase : lacking->elements()) set.lacking.push_back(read_lacking(phase));
    require_citations(set);
    return set;
}

PhaseSet read_user_phases(const View& list) {
    PhaseSet set{.name = "user", .phases = read_phases(list)};
    if (set.phases.empty()) list.fail("there is no phase", "a list of at least one phase");
    std::set<std::string> names;
    for (std::size_t i = 0; i < set.phases.size(); ++i)
        if (!names.insert(phase_key(set.phases[i].name)).second)
            list.elements()[i].fail("two phases are called " + in_quotes(set.phases[i].name),
                                    "each phase once");
    return set;
}

PhaseCatalogue::PhaseCatalogue(std::vector<PhaseSet> sets) : sets_(std::move(sets)) {
    for (std::size_t i = 0; i < sets_.size(); ++i)
        for (std::size_t k = 0; k < sets_[i].phases.size(); ++k)
            for (const auto& name : names_of(sets_[i].phases[k]))
                places_.try_emplace(phase_key(name), Position{i, k});
}

PhaseCatalogue PhaseCatalogue::preferring(std::string_view set) const {
    std::vector<PhaseSet> sets = sets_;
    const auto wanted =
        std::find_if(sets.begin(), sets.end(), [&](const PhaseSet& s) { return s.name == set; });
    if (wanted == sets.end()) {
        std::vector<std::string> names;
        for (const PhaseSet& s : sets_) names.push_back(s.name);
        throw unknown_name("phase set", set, names);
    }
    std::rotate(sets.begin(), wanted, wanted + 1);
    return PhaseCatalogue(std::move(sets));
}

PhaseCatalogue PhaseCatalogue::overridden_by(PhaseSet set) const {
    std::vector<PhaseSet> sets{std::move(set)};
    sets.insert(sets.end(), sets_.begin(), sets_.end());
    return PhaseCatalogue(std::move(sets));
}

PhaseCatalogue::Found PhaseCatalogue::find(const std::string& key, std::size_t sets) const {
    const auto found = places_.find(key);
    if (found == places_.end() || found->second.set >= sets) return {};
    const auto& [set, phase] = found->second;
    return {.phase = &sets_[set].phases[phase], .set = set};
}

std::optional<ResolvedPhase> PhaseCatalogue::named(std::string_view name, const std::string& key) const {
    const Found found = find(key, sets_.size());
    if (!found.phase) return std::nullopt;
    if (key == phase_key(found.phase->name)) return ResolvedPhase{.phase = *found.phase};
    const std::string common = common_name(*found.phase, sets_[found.set]);
    const Found first = find(phase_key(common), found.set);
    if (!first.phase) return ResolvedPhase{.phase = *found.phase};
    return ResolvedPhase{.phase = *first.phase,
                         .note = in_quotes(name) + " is " + common + ": " + first.phase->name +
                                 " of the set " + sets_[first.set].name + " is taken"};
}

std::vector<std::string> PhaseCatalogue::nearest_names(std::string_view name) const {
    std::map<std::string, std::string> spellings;  // one for each key: the first
    for (const PhaseSet& set : sets_)
        for (const Phase& phase : set.phases)
            for (const std::string& known : names_of(phase)) spellings.emplace(phase_key(known), known);
    std::vector<std::string> names;
    names.reserve(spellings.size());
    for (auto& [_, spelling] : spellings) names.push_back(std::move(spelling));
    return nearest(name, names, 3);
}

std::optional<ResolvedPhase> PhaseCatalogue::known(std::string_view name, std::string_view part) const {
    const std::string key = phase_key(part);
    if (auto phase = named(name, key)) return phase;
    return named(name, without_additions(key));
}

std::optional<ResolvedPhase> PhaseCatalogue::by_parts(std::string_view name) const {
    std::optional<ResolvedPhase> found;
    static const WordLists rows("XRD rows", "+");
    bool by_formula = false;
    bool crystalline = false;
    std::vector<std::string_view> unknown;
    for (const std::string_view part : parts_of(name)) {
        auto phase = known(name, part);
        if (!phase) {
            if (!without_additions(phase_key(part)).empty()) unknown.push_back(part);
            crystalline = crystalline || rows.list_of(part) == "crystalline_total";
            continue;
        }
        const bool formula = is_formula(part);
        const bool differs = found && (formula == by_formula ? found->phase.name != phase->phase.name
                                                             : differ_in_formula(found->phase, phase->phase));
        if (differs)
            throw InputError(in_quotes(name) + " may be " + found->phase.name + " or " + phase->phase.name,
                             "one of the two");
        if (found && formula && !by_formula) continue;
        found = std::move(phase);
        by_formula = formula;
    }
    if (unknown.empty() || !found) return found;
    for (const std::string_view part : unknown) {
        if (names_other_form(part, found->phase)) return std::nullopt;
        if (const LackingPhase* other = lacking(part))
            throw InputError(in_quotes(name) + " may be " + found->phase.name + " or " + other->name,
                             "one of the two");
    }
    if (found->phase.amorphous && crystalline)
        throw InputError(in_quotes(name) + " may be " + found->phase.name + " or a crystalline phase",
                         "one of the two");
    if (by_formula) return std::nullopt;  // "SiO2 (tridymite)"
    if (found->note.empty()) found->note = in_quotes(name) + " is read as " + found->phase.name;
    return found;
}

std::optional<ResolvedPhase> PhaseCatalogue::of_group(std::string_view name) const {
    for (const PhaseSet& set : sets_)
        for (const auto& [group, representative] : set.group_representatives)
            if (phase_key(group) == phase_key(name))
                return ResolvedPhase{.phase = resolve(representative).phase,
                                     .note = in_quotes(name) +
                                             " may be one of several phases: " + representative + " is used"};
    return std::nullopt;
}

std::optional<ResolvedPhase> PhaseCatalogue::by_stem(std::string_view name) const {
    // Shares of an end member, as in "An65" or "Ab 30", and the order of Al and Si in feldspars.
    static const std::regex share("(an|ab|or|fo|fa|en|fs|di|hd|geh|ak|sp|mg|fe) *[0-9]{1,3} *%?");
    static const std::regex order("high|low|intermediate|ordered|disordered|monoclinic|triclinic");
    const auto end = name.find_first_of(" _-(,");
    if (end == std::string_view::npos || end == 0) return std::nullopt;
    std::string rest = lower_case(name.substr(end));
    std::erase_if(rest, [](char c) { return std::string_view("_-(,)").find(c) != std::string_view::npos; });
    rest = std::string(trimmed(rest));
    auto phase = known(name, name.substr(0, end));
    if (!phase) phase = of_group(name.substr(0, end));
    if (!phase) return std::nullopt;
    const bool is_share = std::regex_match(rest, share);
    if (!is_share && !(phase->phase.group == "feldspar" && std::regex_match(rest, order)))
        return std::nullopt;
    phase->note = in_quotes(name) + (is_share ? " is a solid solution: " : " is another form: ") +
                  phase->phase.name + " is used";
    return phase;
}

void PhaseCatalogue::refuse_shared_formula(std::string_view name) const {
    const std::string key = without_additions(phase_key(name));
    const Found found = find(key, sets_.size());
    if (!found.phase || phase_key(found.phase->formula) != key) return;
    std::vector<std::string> readings;
    for (const Phase& phase : sets_[found.set].phases)
        if (phase_key(phase.formula) == key) readings.push_back(phase.name);
    for (const LackingPhase& phase : sets_[found.set].lacking)
        if (phase_key(phase.formula) == key) readings.push_back(phase.name);
    if (readings.size() > 1)
        throw InputError(in_quotes(name) + " is the formula of " + joined(readings),
                         "one of them by its name");
}

const LackingPhase* PhaseCatalogue::lacking(std::string_view name) const {
    const std::string key = phase_key(name);
    const std::string stem = without_additions(key);
    const auto is_named = [&](const std::string& each) {
        return phase_key(each) == key || phase_key(each) == stem;
    };
    for (const PhaseSet& set : sets_)
        for (const LackingPhase& phase : set.lacking)
            if (is_named(phase.name) || std::ranges::any_of(phase.synonyms, is_named)) return &phase;
    return nullptr;
}

ResolvedPhase PhaseCatalogue::resolve(std::string_view name) const {
    const std::string key = phase_key(name);
    const auto members_of = [&](const std::string& group) {
        std::vector<std::string> members;
        for (const PhaseSet& set : sets_)
            for (const Phase& phase : set.phases)
                if (!phase.group.empty() && phase_key(phase.group) == group) members.push_back(phase.name);
        return members;
    };
    if (auto phase = known(name, name)) {
        refuse_shared_formula(name);
        const std::string group = phase_key(phase->phase.group);
        const bool is_group =
            !group.empty() && key.starts_with(group) && group == phase_key(phase->phase.name);
        if (is_group && members_of(group).size() > 1 && phase->note.empty())  // spinel
            phase->note =
                in_quotes(name) + " may be one of several phases: " + phase->phase.formula + " is used";
        return *phase;
    }
    if (auto phase = by_parts(name)) return *phase;
    if (auto phase = of_group(name)) return *phase;
    const std::vector<std::string> members = members_of(key);
    if (!members.empty())
        throw InputError(in_quotes(name) + " is a mineral group", "one of its phases: " + joined(members));
    if (auto phase = by_stem(name)) return *phase;
    if (const LackingPhase* phase = lacking(name))
        throw InputError("no phase is called " + in_quotes(name) +
                             " with all its properties: " + phase->missing + " is missing" +
                             (phase->formula.empty() ? "" : " (" + phase->formula + ")"),
                         known_phases);
    const auto candidates = nearest_names(name);
    throw InputError("no phase is called " + in_quotes(name),
                     candidates.empty() ? known_phases : "nearest: " + joined(candidates));
}

bool PhaseCatalogue::knows(std::string_view name) const {
    const auto is_group = [&](const PhaseSet& set) {
        return std::ranges::any_of(set.phases, [&](const Phase& phase) {
            return !phase.group.empty() && phase_key(phase.group) == phase_key(name);
        });
    };
    if (lacking(name) != nullptr || std::ranges::any_of(sets_, is_group)) return true;
    try {
        return known(name, name) || by_parts(name) || of_group(name) || by_stem(name);
    } catch (const InputError&) {
        return true;  // it names two
    }
}

std::vector<ResolvedPhase> PhaseCatalogue::resolve_all(const std::vector<PlacedName>& names) const {
    std::vector<ResolvedPhase> resolved;
    std::string problems;
    std::string first_place;
    std::size_t unknown = 0;
    for (const auto& [name, place] : names) {
        try {
            resolved.push_back(resolve(name));
        } catch (const InputError& error) {
            if (++unknown > most_listed) {
                problems += "; and more";
                break;
            }
            if (unknown == 1) first_place = place;
            if (unknown > 1) problems += "; " + (place.empty() ? "" : place + ": ");
            problems += error.problem();
            if (error.allowed() != known_phases) problems += " (" + error.allowed() + ")";
        }
    }
    if (unknown == 0) return resolved;
    throw InputError(problems, known_phases).at(first_place);
}

}  // namespace ashimpact
