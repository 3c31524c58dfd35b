// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/unit_database.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include <pugixml.hpp>

#include "core/units/unit_expression.hpp"

namespace ashimpact {

namespace {

using Unit = UnitDatabase::Unit;

constexpr std::string_view base_mark = "#";  // "#2" is the third base unit, "#" one without dimension

bool is_ascii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// English, as UDUNITS-2 forms it.
std::string plural_of(const std::string& name) {
    const auto ends = [&](std::string_view end) { return name.ends_with(end); };
    if (ends("y") && name.size() > 1 &&
        std::string_view("aeiou").find(name[name.size() - 2]) == std::string_view::npos)
        return name.substr(0, name.size() - 1) + "ies";
    return name + (ends("s") || ends("x") || ends("z") || ends("ch") || ends("sh") ? "es" : "s");
}

/// The length of the longest prefix that a text begins with; zero if there is none.
template <class Prefixes>
std::size_t longest_prefix(const Prefixes& prefixes, std::string_view text) {
    std::size_t longest = 0;
    for (const auto& [prefix, factor] : prefixes)
        if (text.starts_with(prefix)) longest = std::max(longest, prefix.size());
    return longest;
}

}  // namespace

UnitDatabase::UnitDatabase(const std::string& folder) {
    for (const char* part : {"prefixes", "base", "derived", "accepted", "common"})
        read(folder + "/udunits2-" + part + ".xml");
}

void UnitDatabase::read(const std::string& file) {
    pugi::xml_document document;
    if (!document.load_file(file.c_str())) return;
    for (const pugi::xml_node& prefix : document.child("unit-system").children("prefix")) {
        const double value = prefix.child("value").text().as_double();
        for (const pugi::xml_node& name : prefix.children("name"))
            name_prefixes_.emplace(lower(name.text().get()), value);
        for (const pugi::xml_node& symbol : prefix.children("symbol"))
            symbol_prefixes_.emplace(symbol.text().get(), value);
    }
    for (const pugi::xml_node& unit : document.child("unit-system").children("unit")) {
        std::string definition = unit.child("def").text().get();
        if (unit.child("base")) definition = std::string(base_mark) + std::to_string(bases_++);
        if (unit.child("dimensionless")) definition = base_mark;
        for (const pugi::xml_node& owner : {unit, unit.child("aliases")}) {
            for (const pugi::xml_node& name : owner.children("name")) {
                const std::string singular = lower(name.child("singular").text().get());
                if (singular.empty()) continue;
                names_.emplace(singular, definition);
                const std::string plural = lower(name.child("plural").text().get());
                if (!name.child("noplural") && !owner.child("noplural"))
                    names_.emplace(plural.empty() ? plural_of(singular) : plural, definition);
            }
            for (const pugi::xml_node& symbol : owner.children("symbol"))
                symbols_.emplace(symbol.text().get(), definition);
        }
    }
}

const std::string* UnitDatabase::definition(std::string_view name) const {
    if (const auto found = names_.find(lower(name)); found != names_.end()) return &found->second;
    const auto found = symbols_.find(name);
    return found != symbols_.end() ? &found->second : nullptr;
}

std::optional<Unit> UnitDatabase::named(std::string_view name) const {
    double factor = 1;
    bool symbol_seen = false;
    const std::string* found = nullptr;
    while (!name.empty() && (found = definition(name)) == nullptr) {
        const std::string in_lower_case = lower(name);
        std::size_t size = longest_prefix(name_prefixes_, in_lower_case);
        if (size > 0) {
            factor *= name_prefixes_.at(in_lower_case.substr(0, size));
        } else {
            size = symbol_seen ? 0 : longest_prefix(symbol_prefixes_, name);
            if (size == 0) return std::nullopt;
            factor *= symbol_prefixes_.at(std::string(name.substr(0, size)));
            symbol_seen = true;
        }
        name.remove_prefix(size);
    }
    if (!found) return std::nullopt;
    if (!found->starts_with(base_mark)) {
        std::optional<Unit> unit = read_unit(*this, *found);
        if (unit) unit->factor *= factor;
        return unit;
    }
    Unit base{.factor = factor};
    if (found->size() > 1) base.powers.at(std::strtoul(found->c_str() + 1, nullptr, 10)) = 1;
    return base;
}

UnitScale UnitDatabase::scale(std::string_view unit, std::string_view target) const {
    const std::optional<Unit> from = read_unit(*this, unit);
    if (!from) return {.problem = UnitProblem::unknown};
    const std::optional<Unit> to = read_unit(*this, target);
    if (!to || !from->proportional || !to->proportional || from->powers != to->powers)
        return {.problem = UnitProblem::other_dimension};
    return {.scale = from->factor / to->factor};
}

std::vector<std::string> UnitDatabase::names() const {
    std::vector<std::string> all;
    for (const auto* table : {&names_, &symbols_})
        for (const auto& [name, unit] : *table)
            if (std::all_of(name.begin(), name.end(), is_ascii)) all.push_back(name);
    return all;
}

}  // namespace ashimpact
