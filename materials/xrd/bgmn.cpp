// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "core/quantities/quantity.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"

namespace ashimpact::xrd {

namespace {

constexpr std::string_view block_heading = "Local parameters and GOALs for phase";
constexpr std::string_view goals_heading = "Global parameters and GOALs";
constexpr std::string_view title = "Rietveld refinement to file(s)";

/// A value: a number, or none if a word states that there is none.
struct Value {
    std::optional<PrintedNumber> number{};
    std::size_t line = 0;
};

struct Block {
    std::string name;
    std::optional<Value> weight{};           ///< GEWICHT; nothing if the block has no such line
    std::optional<PrintedNumber> density{};  ///< [g/cm3]
    bool has_positions = false;
};

/// Goals are written by hand: "QQuartz" is of the block "quartz".
struct WithoutCase {
    using is_transparent = void;
    bool operator()(std::string_view one, std::string_view other) const {
        return lower_case(one) < lower_case(other);
    }
};

struct Contents {
    std::string sample;
    std::vector<Block> blocks;
    std::map<std::string, std::size_t, WithoutCase> first_lines;  ///< of the blocks, by phase
    std::map<std::string, Value, WithoutCase> goals;              ///< Q-goals, without the Q
    std::vector<Finding> unused;                                  ///< other goals
};

/// Refuses a goal that states an amorphous part: the weights of the phases may be of the whole or not.
/// @throws InputError
void refuse_amorphous_goal(std::string_view name, std::string_view written, std::size_t line) {
    static const WordLists words("statements", " ");
    for (const Mention& mention : mentions_in(words_in(name), words))
        if (mention.list == "amorphous")
            refuse_line(
                line,
                "the goal " + in_quotes(written) +
                    " states an amorphous part: the phases may be fractions of the whole sample, or of "
                    "its crystalline part",
                "--amorphous-fraction (in a case \"amorphous\"), and a file without this goal");
}

/// A goal that is no fraction of a phase. The zero-point errors EPS1 to EPS4 are of the instrument.
void take_other_goal(Contents& contents, std::string_view text, std::string_view name, std::size_t line) {
    refuse_amorphous_goal(name, text, line);
    const bool has_value = !says_no_number(text.substr(name.size() + 1));  // unlike "layer=UNDEF"
    if (has_value && !name.starts_with("EPS"))
        contents.unused.push_back(
            {xrd_code, Severity::remark,
             "the goal " + in_quotes(text) + " (line " + std::to_string(line) + ") is not used"});
}

Value read_value(std::string_view text, std::size_t line) {
    const auto comma = text.find(',');
    if (comma != std::string_view::npos && comma > 0 && comma + 1 < text.size() &&
        is_digit(text[comma - 1]) && is_digit(text[comma + 1]))
        refuse_line(line, in_quotes(trimmed(text)) + " has a decimal comma",
                    "a decimal point, as BGMN writes it");
    const std::string_view value = trimmed(text.substr(0, text.find(',')));
    if (says_no_number(value)) return {.line = line};
    const auto number = read_number(value);
    if (!number || number->per_cent)
        refuse_line(line, "cannot read " + in_quotes(value),
                    "a number, possibly with +- and its uncertainty");
    return {.number = number, .line = line};
}

/// Reads GEWICHT. An anisotropic one has its mean behind MeanValue(GEWICHT)=.
Value read_weight(std::string_view text, std::size_t line) {
    constexpr std::string_view mean = "MeanValue(GEWICHT)=";
    const auto found = text.find(mean);
    return read_value(found == std::string_view::npos ? text : text.substr(found + mean.size()), line);
}

void read_member(Block& block, std::string_view key, std::string_view value, std::size_t line) {
    if (key == "GEWICHT") {
        if (block.weight)
            refuse_line(line, "GEWICHT is there twice in the block of " + in_quotes(block.name),
                        "once in a block");
        block.weight = read_weight(value, line);
    } else if (key == "XrayDensity") {
        const Value density = read_value(value, line);
        if (density.number && !(density.number->value > 0))
            refuse_line(line, "XrayDensity is " + shortest(density.number->value),
                        "a positive density [g/cm3]");
        if (density.number) block.density = density.number;
    }
}

void start_block(Contents& contents, std::string_view name, std::size_t line) {
    if (name.empty()) refuse_line(line, "the heading has no phase name", "a phase name");
    const auto [first, is_new] = contents.first_lines.emplace(name, line);
    if (!is_new)
        refuse_line(line,
                    "the phase " + in_quotes(name) + " is there twice, first in line " +
                        std::to_string(first->second),
                    "each phase once");
    contents.blocks.push_back({.name = std::string(name)});
}

void add_goal(Contents& contents, const std::string& phase, const Value& value) {
    if (!contents.goals.emplace(phase, value).second)
        refuse_line(value.line, "the goal " + in_quotes("Q" + phase) + " is there twice", "each goal once");
}

Contents scan(const TextLines& file) {
    Contents contents;
    bool in_goals = false;
    for (const auto& [number, raw] : file.lines()) {
        const std::string_view text = trimmed(raw);
        const auto equals = text.find('=');
        if (text.starts_with(block_heading)) {
            start_block(contents, trimmed(text.substr(block_heading.size())), number);
        } else if (text.starts_with(goals_heading)) {
            in_goals = true;
        } else if (text.starts_with(title)) {
            const std::string_view name = trimmed(text.substr(title.size()));
            contents.sample = std::string(name.substr(0, name.rfind('.')));
        } else if (text.starts_with("Atomic positions for phase") && !contents.blocks.empty()) {
            contents.blocks.back().has_positions = true;
        } else if (equals != std::string_view::npos) {
            if (!contents.blocks.empty())
                read_member(contents.blocks.back(), text.substr(0, equals), text.substr(equals + 1), number);
            else if (in_goals && (text.starts_with('Q') || text.starts_with('q')))
                add_goal(contents, std::string(text.substr(1, equals - 1)),
                         read_value(text.substr(equals + 1), number));
            else if (in_goals)
                take_other_goal(contents, text, text.substr(0, equals), number);
        }
    }
    for (const Block& block :
         contents.blocks) {  // "Quartz=0.3" of a block "quartz", without the mark of a goal
        const bool is_bare = block.name.starts_with('Q') || block.name.starts_with('q');
        auto goal = contents.goals.extract(is_bare ? block.name.substr(1) : std::string());
        if (goal.empty()) continue;
        goal.key() = block.name;
        contents.goals.insert(std::move(goal));
    }
    return contents;
}

[[noreturn]] void cut_off(const std::string& reason, const TextLines& file) {
    refuse_line(file.last_line(), reason + ": the file seems to be cut off", "a complete list file");
}

/// Refuses a file that was cut off. It has no end mark, but its goals name the blocks that must follow.
void require_complete(const Contents& contents, const TextLines& file) {
    if (contents.blocks.empty()) cut_off("there is no block of a phase", file);
    for (const Block& block : contents.blocks)
        if (!block.weight) cut_off("the block of " + in_quotes(block.name) + " has no GEWICHT", file);
    double present = 0;
    std::string missing;
    for (const auto& [name, goal] : contents.goals) {
        if (!goal.number) continue;
        if (contents.first_lines.contains(name))
            present += goal.number->value;
        else if (goal.number->value > 0 && missing.empty())
            missing = name;
    }
    // Goals of groups of phases have no block either, but then the blocks add up to one without them.
    if (!missing.empty() && present < 0.99) cut_off("the goal Q" + missing + " has no block", file);
    const auto positions = [](const Block& block) { return block.has_positions; };
    if (contents.goals.empty() && std::any_of(contents.blocks.begin(), contents.blocks.end(), positions) &&
        !contents.blocks.back().has_positions)
        cut_off("the last block has no atomic positions", file);
}

/// Refuses a last number at the very end of the file, which may lack digits, unless a goal agrees with it.
void require_whole_number(const XrdSample& sample, const Contents& contents, const TextLines& file) {
    const Block& last = contents.blocks.back();
    const char end = file.text().back();
    if (end == '\n' || end == '\r' || last.weight->line != file.last_line()) return;
    constexpr double rounding = 0.00051;
    const auto goal = contents.goals.find(last.name);
    bool agrees = last.weight->number && goal != contents.goals.end() && goal->second.number;
    if (agrees) {
        const PhaseFraction& read = sample.analysis.phases.back();
        const PrintedNumber& expected = *goal->second.number;
        agrees = std::abs(expected.value - read.fraction) < rounding &&
                 (read.standard_uncertainty || !expected.standard_uncertainty);
    }
    if (!agrees) cut_off("the last line is a GEWICHT without an end", file);
}

void compare_with_goal(const PhaseFraction& phase, const Contents& contents, std::vector<Finding>& warnings) {
    const auto goal = contents.goals.find(phase.name);
    if (goal == contents.goals.end()) return;
    if (!goal->second.number) {
        warnings.push_back({xrd_code, Severity::remark,
                            "the goal Q" + phase.name + " could not be computed by the refinement"});
        return;
    }
    const double fraction = goal->second.number->value;
    if (!(fraction >= 0 && fraction <= 1))
        refuse_line(goal->second.line, "the goal Q" + phase.name + " is " + shortest(fraction),
                    "a fraction, 0 to 1");
    constexpr double largest_rounding = 0.002;
    const double u = phase.standard_uncertainty.value_or(0);
    if (std::abs(fraction - phase.fraction) > std::max(largest_rounding, 3 * u))
        warnings.push_back({xrd_code, Severity::remark,
                            "the goal Q" + phase.name + " is " + shortest(fraction) + ", GEWICHT gives " +
                                shortest(std::round(phase.fraction * 1e4) / 1e4) +
                                " (a correction for microabsorption is only in the goal)"});
}

/// Warns of goals without a block: their phases may be missing.
void report_goals_alone(const Contents& contents, std::vector<Finding>& warnings) {
    for (const auto& [name, goal] : contents.goals) {
        if (contents.first_lines.contains(name) || (goal.number && goal.number->value == 0)) continue;
        refuse_amorphous_goal(name, "Q" + name, goal.line);
        warnings.push_back({xrd_code, Severity::remark,
                            "the goal Q" + name + " (line " + std::to_string(goal.line) +
                                (goal.number ? "), " + shortest(goal.number->value) + ", is not used"
                                             : ") could not be computed by the refinement") +
                                ", and no block has that name"});
    }
}

}  // namespace

bool looks_like_bgmn(const TextLines& file) {
    const std::string& text = file.text();
    return text.find(block_heading) != std::string::npos || text.find("BGMN version") != std::string::npos ||
           text.find(title) != std::string::npos;
}

XrdResult read_bgmn(const TextLines& file) {
    const Contents contents = scan(file);
    require_complete(contents, file);
    XrdSample sample{.name = contents.sample};
    std::vector<ListedPhase> phases;
    for (const Block& block : contents.blocks) {
        const auto& [weight, line] = *block.weight;
        if (weight && weight->value < 0)
            refuse_line(line, "the weight of " + in_quotes(block.name) + " is below zero", "zero or more");
        phases.push_back({block.name, line, weight, block.density});
    }
    add_fractions(sample, phases, "weight", "GEWICHT above zero", file.last_line());
    for (const PhaseFraction& phase : sample.analysis.phases)
        compare_with_goal(phase, contents, sample.warnings);
    report_goals_alone(contents, sample.warnings);
    std::ranges::copy(contents.unused, std::back_inserter(sample.warnings));
    require_whole_number(sample, contents, file);
    return {.format = XrdFormat::bgmn_lst, .samples = {std::move(sample)}};
}

}  // namespace ashimpact::xrd
