// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <regex>

#include "core/quantities/quantity.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/table_headings.hpp"

namespace ashimpact::xrd {

namespace {

/// A word, a quoted text, or one of the characters ( ) , ; with its line.
struct Token {
    std::string text;
    std::size_t line = 0;
    bool quoted = false;
};

struct TopasPhase {
    ListedPhase listed{};                   ///< the amount is in [%] of the crystalline part
    bool has_weight = false;                ///< by its keyword, which comes before MVW
    bool of_peaks = false;                  ///< peaks without a structure, such as a hump, which need no name
    std::optional<PrintedNumber> spiked{};  ///< [%] of the mixture, as weighed
};

struct TopasPattern {
    std::string name;
    std::size_t line = 0;
    std::vector<TopasPhase> phases;
    std::optional<PrintedNumber> amorphous{};  ///< [%] of the mixture
    bool has_corrected = false;                ///< whether there are corrected_weight_percent of phases
};

/// The words of a file without its comments: ' to the end of the line, /* ... */ over lines.
/// @param comments receives them, line by line
std::vector<Token> tokens_of(const TextLines& file, std::vector<TextBeside>& comments) {
    std::vector<Token> tokens;
    bool in_comment = false;
    std::size_t comment_line = 0;
    for (const auto& [number, raw] : file.lines()) {
        std::string_view text = raw;
        while (!text.empty()) {
            if (in_comment) {
                const auto end = text.find("*/");
                comments.push_back({.line = number, .text = std::string(text.substr(0, end))});
                if (end == std::string_view::npos) break;
                text.remove_prefix(end + 2);
                in_comment = false;
            } else if (text.starts_with("/*")) {
                in_comment = true;
                comment_line = number;
                text.remove_prefix(2);
            } else if (text.front() == '\'') {
                comments.push_back({.line = number, .text = std::string(text.substr(1))});
                break;
            } else if (text.front() == '"') {
                const auto end = text.find('"', 1);
                if (end == std::string_view::npos)
                    refuse_line(number, "a quote is not closed", "\"...\" on one line");
                tokens.push_back({std::string(text.substr(1, end - 1)), number, true});
                text.remove_prefix(end + 1);
            } else if (std::string_view(" \t").find(text.front()) != std::string_view::npos) {
                text.remove_prefix(1);
            } else if (std::string_view("(),;{}=").find(text.front()) != std::string_view::npos) {
                tokens.push_back({std::string(1, text.front()), number});
                text.remove_prefix(1);
            } else {
                auto end = std::min(text.find_first_of(" \t(),;{}=\"'"), text.size());
                end = std::min(end, text.find("/*"));
                tokens.push_back({std::string(text.substr(0, end)), number});
                text.remove_prefix(end);
            }
        }
    }
    if (in_comment)
        refuse_line(comment_line, "a comment is not closed: the file seems to be cut off", "/* ... */");
    return tokens;
}

/// "12.3", "12.3`" (refined), "12.3`_0.12" (with its standard deviation); nothing for any other word.
std::optional<PrintedNumber> printed_number(std::string_view word) {
    const auto mark = word.find('`');
    auto number = read_number(word.substr(0, mark));
    if (!number || mark == std::string_view::npos) return number;
    std::string_view rest = word.substr(mark + 1);
    rest = rest.substr(0, rest.find("_LIMIT"));
    if (rest.empty()) return number;
    const auto deviation = rest.starts_with('_') ? read_number(rest.substr(1)) : std::nullopt;
    if (!deviation || deviation->per_cent) return std::nullopt;
    if (deviation->value > 0) number->standard_uncertainty = deviation->value;
    return number;
}

/// Whether a word may be between a keyword and its number: @, or the name of a parameter.
bool is_parameter_name(const std::string& word) {
    const char c = word.front();
    return c == '@' || c == '!' || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

class TopasReader {
  public:
    explicit TopasReader(const TextLines& file) : file_(file), tokens_(tokens_of(file, comments_)) {}

    [[nodiscard]] const std::vector<TextBeside>& comments() const { return comments_; }

    std::vector<TopasPattern> read() {
        while (at_ < tokens_.size()) {
            const Token& token = tokens_[at_++];
            if (!token.quoted) read_keyword(token);
        }
        return std::move(patterns_);
    }

  private:
    [[noreturn]] void cut_off(const Token& token) const {
        refuse_line(file_.last_line(),
                    "nothing follows " + in_quotes(token.text) + ": the file seems to be cut off",
                    "a complete file");
    }

    /// Refuses phases and weights that count only where a macro is defined. @throws InputError
    void require_unconditional(std::size_t line) const {
        if (conditions_.empty()) return;
        refuse_line(line, "the line counts only if the " + conditions_.back() + " above it holds",
                    "a file without the lines that do not count, and without #if ... #endif");
    }

    /// The pattern being read; a file of phases alone has one without an xdd.
    TopasPattern& any_pattern(std::size_t line) {
        if (patterns_.empty()) patterns_.push_back({.name = {}, .line = line, .phases = {}});
        return patterns_.back();
    }

    /// The same where the line counts in any case. @throws InputError
    TopasPattern& pattern(std::size_t line) {
        require_unconditional(line);
        return any_pattern(line);
    }

    /// The phase being read. @throws InputError at @p token where none has begun
    TopasPhase& phase(const Token& token) {
        require_unconditional(token.line);
        if (patterns_.empty() || patterns_.back().phases.empty())
            refuse_line(token.line, in_quotes(token.text) + " stands before the first phase", "str above it");
        return patterns_.back().phases.back();
    }

    PrintedNumber number_after(const Token& keyword) {
        while (at_ < tokens_.size() && !tokens_[at_].quoted && is_parameter_name(tokens_[at_].text)) ++at_;
        if (at_ >= tokens_.size()) cut_off(keyword);
        const Token& token = tokens_[at_++];
        const auto number = printed_number(token.text);
        // "12,3", "12.3(4)", "12.3` _0.4"
        const std::string next = at_ < tokens_.size() && !tokens_[at_].quoted ? tokens_[at_].text : "";
        const bool is_deviation = next.size() > 1 && next.front() == '_' && is_digit(next[1]);
        const bool goes_on = next == "," || next == "(" || is_deviation;
        if (!number || number->value < 0 || goes_on)
            refuse_line(token.line, "cannot read " + in_quotes(token.text) + " behind " + keyword.text,
                        "a number that is not negative, such as 12.3, 12.3` or 12.3`_0.4");
        return *number;
    }

    /// The arguments of a macro; none for an argument that is not a number.
    std::vector<std::optional<PrintedNumber>> arguments_after(const Token& macro) {
        if (at_ >= tokens_.size()) cut_off(macro);
        if (tokens_[at_].text != "(")
            refuse_line(macro.line, "no bracket follows " + macro.text, macro.text + "( ... )");
        std::vector<std::optional<PrintedNumber>> arguments(1);
        while (++at_ < tokens_.size()) {
            const std::string& text = tokens_[at_].text;
            if (text == ")") {
                ++at_;
                return arguments;
            }
            if (text == ",")
                arguments.emplace_back();
            else if (const auto number = printed_number(text))
                arguments.back() = number;
        }
        cut_off(macro);
    }

    /// Refuses a keyword that a phase or pattern has already.
    static void require_first(const Token& token, bool is_first) {
        if (!is_first)
            refuse_line(token.line, in_quotes(token.text) + " stands twice",
                        "once, with the number that counts");
    }
    void read_keyword(const Token& token) {
        const std::string& word = token.text;
        if (word.starts_with("#if")) {
            conditions_.push_back(word);
        } else if (word == "#endif") {
            if (!conditions_.empty()) conditions_.pop_back();
        } else if (word == "xdd" || word == "xdd_scr") {
            require_unconditional(token.line);
            patterns_.push_back({.name = {}, .line = token.line, .phases = {}});
            if (at_ >= tokens_.size()) cut_off(token);
            patterns_.back().name = tokens_[at_++].text;
        } else if (word == "str" || word == "hkl_Is" || word == "dummy_str") {
            pattern(token.line).phases.push_back({.listed = {.name = {}, .line = token.line}});
        } else if (word == "xo_Is" || word == "d_Is" || word == "fit_obj") {
            // Peaks that only describe the background may depend on a macro.
            any_pattern(token.line)
                .phases.push_back({.listed = {.name = {}, .line = token.line}, .of_peaks = true});
        } else if (word == "phase_name") {
            if (at_ >= tokens_.size()) cut_off(token);
            ListedPhase& listed = phase(token).listed;
            require_first(token, listed.name.empty());
            listed.name = tokens_[at_].text;
            listed.line = tokens_[at_++].line;
        } else if (word == "weight_percent") {
            require_first(token, !phase(token).has_weight);
            phase(token).listed.amount = number_after(token);
            phase(token).has_weight = true;
        } else if (word == "spiked_phase_measured_weight_percent") {
            require_first(token, !phase(token).spiked);
            phase(token).spiked = number_after(token);
        } else if (word == "corrected_weight_percent") {
            pattern(token.line).has_corrected = true;
        } else if (word == "weight_percent_amorphous") {
            require_first(token, !pattern(token.line).amorphous);
            pattern(token.line).amorphous = number_after(token);
        } else if (word == "MVW") {
            const auto arguments = arguments_after(token);
            if (arguments.size() != 3)
                refuse_line(token.line, "MVW has " + std::to_string(arguments.size()) + " arguments",
                            "MVW( cell mass, cell volume, weight per cent)");
            if (!phase(token).has_weight) phase(token).listed.amount = arguments[2];
        } else if (word == "Phase_Density_g_on_cm3") {
            const auto arguments = arguments_after(token);
            if (arguments.front() && arguments.front()->value > 0)
                phase(token).listed.density = arguments.front();
        }
    }

    const TextLines& file_;
    std::vector<TextBeside> comments_{};  ///< before the tokens, with which it is filled
    std::vector<Token> tokens_;
    std::vector<TopasPattern> patterns_;
    std::vector<std::string> conditions_;  ///< #ifdef and the like that are open
    std::size_t at_ = 0;
};

/// Adds the amorphous part, which the refinement states or which follows from a spiked standard.
XrdSample completed(XrdSample sample, const TopasPattern& pattern) {
    const TopasPhase* standard = nullptr;
    for (const TopasPhase& phase : pattern.phases) {
        if (!phase.spiked || phase.spiked->value == 0) continue;
        if (standard != nullptr)
            refuse_line(phase.listed.line, "there are two spiked phases", "one a pattern");
        standard = &phase;
    }
    if (pattern.has_corrected)
        sample.warnings.push_back({xrd_code, Severity::remark,
                                   "corrected_weight_percent is not used: weight_percent counts, with the "
                                   "amorphous part or the spiked standard of the file"});
    if (standard == nullptr) {
        if (pattern.amorphous) {
            auto uncertainty = pattern.amorphous->standard_uncertainty;
            if (uncertainty) *uncertainty /= 100;
            sample.analysis.amorphous = AmorphousFraction{pattern.amorphous->value / 100, uncertainty};
        }
        return sample;
    }
    const std::string& name = standard->listed.name;
    const auto same = [&](const PhaseFraction& phase) { return phase.name == name; };
    const auto& phases = sample.analysis.phases;
    const auto found = std::find_if(phases.begin(), phases.end(), same);
    const double weighed = standard->spiked->value / 100;
    auto weighing = standard->spiked->standard_uncertainty;
    if (weighing) *weighing /= 100;
    if (found != phases.end() && pattern.amorphous && found->fraction > 0) {
        const double ours = 100 * (1 - weighed / found->fraction);
        constexpr double rounding = 0.5;  // [%]
        if (std::abs(ours - pattern.amorphous->value) > rounding)
            sample.warnings.push_back({xrd_code, Severity::remark,
                                       "the file's amorphous part of the mixture is " +
                                           shortest(pattern.amorphous->value) + " %, the standard gives " +
                                           shortest(std::round(100 * ours) / 100) + " %, which is used"});
    }
    if (pattern.amorphous && pattern.amorphous->standard_uncertainty)
        sample.warnings.push_back({xrd_code, Severity::doubt,
                                   "the uncertainty of weight_percent_amorphous is not used: that of the "
                                   "standard counts"});
    return at_place(at_line(standard->listed.line),
                    [&] { return with_internal_standard(sample, name, weighed, weighing); });
}

XrdSample sample_of(const TopasPattern& pattern) {
    XrdSample sample{.name = file_stem(pattern.name)};
    std::vector<ListedPhase> phases;
    for (const TopasPhase& phase : pattern.phases) {
        if (phase.of_peaks && phase.listed.name.empty() && !phase.listed.amount) continue;
        if (phase.listed.name.empty())
            refuse_line(phase.listed.line, "a phase has no phase_name", "phase_name \"...\" in each phase");
        phases.push_back(phase.listed);
    }
    const double total = add_fractions(
        sample, phases, "weight", "weight_percent or MVW with a weight per cent above zero", pattern.line);
    sample = completed(std::move(sample), pattern);
    if (std::abs(total - 100) > 100 * default_closure_tolerance)
        refuse_line(pattern.line,
                    "the weights of the phases add up to " + shortest(std::round(total * 1e3) / 1e3) +
                        " %: the file seems to be cut off or edited",
                    "100 % within 0.5 %, the crystalline part as TOPAS writes it");
    return sample;
}

/// Gives unnamed or equally named patterns a number.
void number_patterns(std::vector<XrdSample>& samples) {
    if (samples.size() < 2) return;
    std::map<std::string, std::size_t> count;
    for (const XrdSample& sample : samples) ++count[sample.name];
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::string& name = samples[i].name;
        const std::string number = "pattern " + std::to_string(i + 1);
        if (name.empty())
            name = number;
        else if (count[name] > 1)
            name += " (" + number + ")";
    }
}

}  // namespace

bool looks_like_topas(const TextLines& file) {
    constexpr std::array<std::string_view, 3> weights{"MVW(", "MVW (", "weight_percent"};
    const std::string& text = file.text();
    static const std::regex name("phase_name[ \t]+(?!weight)");  // unlike the headings of a table
    return std::regex_search(text, name) &&
           std::any_of(weights.begin(), weights.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

XrdResult read_topas(const TextLines& file) {
    XrdResult result{.format = XrdFormat::topas_out, .samples = {}};
    TopasReader reader(file);
    for (const TopasPattern& pattern : reader.read()) result.samples.push_back(sample_of(pattern));
    StandardsInTexts comments;
    for (const TextBeside& comment : reader.comments()) comments.take(comment);
    for (XrdSample& sample : result.samples)
        for (PhaseFraction& phase : sample.analysis.phases)
            phase.is_standard = phase.is_standard || comments.hold(phase.name);
    if (result.samples.empty())
        refuse_line(file.last_line(), "there is no phase", "str with phase_name and weight_percent");
    number_patterns(result.samples);
    return result;
}

}  // namespace ashimpact::xrd
