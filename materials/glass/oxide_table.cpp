// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials/glass/oxide_table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <tuple>

#include "core/tables/table_reading.hpp"
#include "core/tables/table_texts.hpp"
#include "core/tables/text_lines.hpp"
#include "core/tables/vocabulary.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/table_layout.hpp"

namespace ashimpact {

namespace {

constexpr TextLimits oxide_limits{.content = "a chemical analysis", .bytes = longest_xrd_file};

/// Kind of quantity under one heading or in one row of an analysis.
enum class OxideRole { oxide, loss, total, trace, carbon, uncertainty, other };

struct OxideLine {
    OxideRole role = OxideRole::other;
    xrd::Heading heading{};  ///< unit, scale and coverage
    NamedOxide oxide{};
};

/// A line that names no oxide though it looks like one, or an element.
bool looks_like_oxide(const std::string& text) {
    static const std::regex oxide("[A-Z][a-z]?[0-9]*O[0-9]*");
    return std::regex_match(text, oxide);
}

bool is_element(const std::string& text) {
    return text != "S" && text != "Cl" && text != "F" && text != "C" &&
           std::ranges::find(oxides(), std::string_view(text), &OxideOfElement::element) != oxides().end();
}

constexpr const char* name_ends = " _()[]/:,";

/// A longer text names no oxide and no loss on ignition. Regular expressions recurse along it.
constexpr std::size_t longest_name = 60;

/// The words for a loss on ignition and for other columns.
const WordLists& column_words() {
    static const WordLists words("oxide columns");
    return words;
}

/// "wt% SiO2", "w(LOI)", "SiO2_wt" and "MnO ppm" as "SiO2 [wt%]", "LOI" and "MnO [ppm]"; empty for a text
/// with other words than one oxide, loss or element and those of a fraction by weight.
std::string unit_behind_name(const std::string& text) {
    if (text.size() > longest_name || text.find_first_of(name_ends) == std::string::npos) return {};
    std::string name;
    std::string unit;
    for (auto from = text.find_first_not_of(name_ends); from != std::string::npos;) {
        const auto end = std::min(text.find_first_of(name_ends, from), text.size());
        const std::string word = text.substr(from, end - from);
        from = text.find_first_not_of(name_ends, end);
        const xrd::Heading as_unit = xrd::read_heading("x [" + word + "]");
        if (named_oxide(word) || is_element(word) || column_words().list_of(word) == "loss") {
            if (!name.empty()) return {};
            name = word;
        } else if (word != "1" && (as_unit.states == xrd::HeadingUnit::weight ||
                                   as_unit.states == xrd::HeadingUnit::fraction)) {
            if (as_unit.scale != xrd::Scale::not_stated) unit = " [" + word + "]";
        } else {
            return {};
        }
    }
    return name.empty() ? name : name + unit;
}

/// The oxide in a text that does not name it as one: MgO in "MgO (corr.)", K2O in "K20", CaO as "Lime".
std::optional<NamedOxide> oxide_within(std::string text) {
    static const WordLists names("oxide names");
    if (const auto formula = names.list_of(text)) return named_oxide(*formula);
    text += ' ' + transliterated(text);
    static const std::regex word("[A-Za-z][A-Za-z0-9]+");
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) {
        std::string name = at->str();
        if (name.ends_with("eq")) name.resize(name.size() - 2);  // "Na2Oeq", which holds K2O as well
        if (name == "Fe") return named_oxide("Fe2O3");
        for (const char zero : {'0', 'O'}) {
            std::ranges::replace(name, '0', zero);
            if (name.find_first_of("Oo", 1) == std::string::npos) continue;
            if (const auto oxide = named_oxide(name)) return oxide;
        }
    }
    return std::nullopt;
}

/// The oxide of "S as SO3", "Fe als Fe2O3" and "CaO (total)", in which all of the element is; else empty.
std::string oxide_of_whole_element(const std::string& text) {
    static const std::regex as(
        "([A-Z][a-z]?),? +(?:(?:reported|expressed|calc\\.?|calculated|total) +)?(?:as|als) +"
        "([A-Za-z0-9]+)");
    static const std::regex total("([A-Za-z0-9]+) +\\((?:total|gesamt|tot\\.?)\\)");
    std::smatch match;
    if (text.size() > longest_name) return {};
    const bool is_as = std::regex_match(text, match, as);
    if (!is_as && !std::regex_match(text, match, total)) return {};
    const std::string oxide = match.str(is_as ? 2 : 1);
    const auto named = named_oxide(oxide);
    if (!named || (is_as && oxides()[named->index].element != match.str(1))) return {};
    return oxide.starts_with("Fe") ? oxide + "(t)" : oxide;
}

// NOLINTNEXTLINE(misc-no-recursion): once, with the plain text
OxideLine read_line(const std::string& text) {
    if (has_sign_of_bound(text)) return {.heading = xrd::read_heading(text)};
    if (text == "s" ||
        text == "MU") {  // a standard deviation, and a measurement uncertainty, mostly expanded
        OxideLine line{.role = OxideRole::uncertainty, .heading = xrd::read_heading(text)};
        if (text == "MU") line.heading.coverage.problem = "MU may be an expanded uncertainty (write \"k=2\")";
        return line;
    }
    if (const std::string oxide = oxide_of_whole_element(text); !oxide.empty()) {
        OxideLine line = read_line(oxide);
        line.heading.written = text;
        return line;
    }
    const WordLists& words = column_words();
    OxideLine line{.heading = xrd::read_heading(text)};
    const std::string& name = line.heading.text;
    const std::string whole = line.heading.coverage.rest.empty() ? text : line.heading.coverage.rest;
    const auto list = words.list_of(name);
    if (list == "loss" || xrd::names_loss(whole))
        line.role = OxideRole::loss;
    else if (list == "amount")
        line.heading.role = xrd::Role::weight;
    else if (list == "carbon")
        line.role = OxideRole::carbon;
    else if (xrd::meaning_of_row(name) == xrd::RowMeaning::total)
        line.role = OxideRole::total;
    else if (const auto oxide = named_oxide(name)) {
        line.role = OxideRole::oxide;
        line.oxide = *oxide;
    } else if (line.heading.role == xrd::Role::uncertainty) {
        line.role = OxideRole::uncertainty;
    } else if (is_element(name)) {
        line.role = OxideRole::trace;
    } else if (const std::string plain = unit_behind_name(text); !plain.empty() && plain != text) {
        return read_line(plain);
    }
    return line;
}

/// A line of text beside a table that states an amount: "LOI = 3.1 %".
struct AmountNote {
    std::size_t line = 0;
    std::string text{};
    OxideLine what{};
    std::string amount{};
};

/// The amount in a text such as "LOI (950 °C): 3.1 wt%"; none in a text of another form.
std::optional<AmountNote> read_note(const std::string& text, std::size_t line) {
    static const std::regex form(
        "(.*?[^ =:])(?: *[=:] *| +)([<0-9][0-9., ]*(?:(?:\u00b1|[+]/?-) *[0-9.,]+)?) *([^0-9=:]*)");
    std::smatch match;
    if (text.size() > longest_name || !std::regex_match(text, match, form)) return std::nullopt;
    const std::string unit = match.str(3);
    const bool is_stated = text.find_first_of("=:") != std::string::npos;
    const xrd::Heading of_unit = xrd::read_heading("x [" + unit + "]");
    if (unit.empty() ? !is_stated : of_unit.states == xrd::HeadingUnit::other) return std::nullopt;
    AmountNote note{.line = line, .text = text, .what = read_line(match.str(1)), .amount = match.str(2)};
    if (!unit.empty()) {
        note.what.heading.unit = of_unit.unit;
        note.what.heading.states = of_unit.states;
        note.what.heading.scale = of_unit.scale;
    }
    return note;
}

/// Whether a text begins with the loss on ignition.
bool begins_with_loss(const std::string& text) {
    constexpr std::size_t shortest_word = 3;
    const std::string key = word_key(text);
    return std::ranges::any_of(column_words().words(), [&](const auto& word) {
        return word.second == "loss" && word.first.size() >= shortest_word && key.starts_with(word.first);
    });
}

/// Whether a text states a loss below 700 °C, which is another quantity than the loss on ignition.
bool is_of_low_temperature(const std::string& text) {
    static const std::regex temperature("[^0-9][1-6][0-9]{2}([^0-9]|$)");
    return text.size() <= longest_name && std::regex_search(text, temperature);
}

/// Whether a cell is the heading of a column or row of units.
bool names_units(const std::string& cell) {
    static const WordLists words("unit columns");
    return words.holds(cell);
}

bool is_content(OxideRole role) {
    return role == OxideRole::oxide || role == OxideRole::loss || role == OxideRole::total;
}

std::size_t oxides_in(const std::vector<std::string>& cells) {
    return static_cast<std::size_t>(std::ranges::count_if(
        cells, [](const std::string& cell) { return read_line(cell).role == OxideRole::oxide; }));
}

/// "SiO2 u", "u(SiO2)", "SiO2 ±": the uncertainty of the oxide before it.
bool is_uncertainty_column(const std::string& cell, const OxideLine& line) {
    if (line.role == OxideRole::uncertainty) return true;
    const auto blank = cell.find_last_of(" _");
    if (blank != std::string::npos && is_uncertainty_word(cell.substr(blank + 1))) return true;
    const auto bracket = cell.find('(');
    return bracket != std::string::npos && bracket > 0 && is_uncertainty_word(cell.substr(0, bracket)) &&
           cell.ends_with(')');
}

/// One amount of a table.
struct OxideCell {
    std::size_t line = 0, column = 0;
    OxideLine what{};
    std::string text{};
    std::string uncertainty{};
    const xrd::Heading* unit = nullptr;           ///< heading that states the unit of the amount
    const xrd::Heading* error_heading = nullptr;  ///< of the uncertainty
    std::size_t error_column = 0;                 ///< of the uncertainty
};

/// The amounts of one sample.
struct OxideColumn {
    std::string sample;
    std::vector<OxideCell> cells{};
};

/// A table of oxides as text, cut into samples.
class OxideTable {
  public:
    OxideTable(const TextLines& file, std::optional<DecimalMark> decimal) : marks_(decimal, file.of_sheet()) {
        const std::vector<TextLine> lines = lines_with_content(file);
        constexpr std::size_t most_lines = 5000;
        constexpr std::size_t longest_cell = 1000;
        if (lines.size() > most_lines)
            refuse_line(lines[most_lines].number, "the table is too long for a chemical analysis",
                        std::to_string(most_lines) + " lines or fewer");
        std::map<char, std::size_t> separators;
        for (const TextLine& line : lines)  // titles and footnotes have none
            if (const char separator = separator_of(line.text);
                line.text.find(separator) != std::string::npos)
                ++separators[separator];
        if (!separators.empty())
            separator_ =
                std::ranges::max_element(separators, {}, &std::pair<const char, std::size_t>::second)->first;
        for (const TextLine& line : lines) {
            rows_.push_back(cut_row(line, separator_));
            for (std::size_t i = 0; i < rows_.back().cells.size(); ++i)
                if (rows_.back().cells[i].size() > longest_cell)
                    throw InputError("the cell is too long for a chemical analysis",
                                     std::to_string(longest_cell) + " characters or fewer")
                        .at(at_cell(line.number, i));
        }
        take_notes_below();
        take_amount_notes();
        const auto across =
            std::ranges::find_if(rows_, [](const TableRow& row) { return oxides_in(row.cells) >= 2; });
        std::optional<std::size_t> heading;  // line of it
        std::size_t label = 0;
        if (across != rows_.end()) {
            heading = across->line;
            label = read_across(static_cast<std::size_t>(across - rows_.begin()));
        } else {
            std::tie(heading, label) = read_down();
        }
        refuse_crystalline(heading.value_or(1));
        if (samples.empty())
            refuse_line(rows_.back().line, "there are no amounts of oxides", "a number for each oxide");
        add_amount_notes();
        if (auto comments = unread_comments(file, lines, glass_code, {"ignited sample"}))
            warnings.push_back(std::move(*comments));
        require_agreeing_texts(file, lines, heading, label);
        for (OxideLine& each : headings_)  // of rows "2s", which no heading states
            if (each.heading.coverage.factor == 1) each.heading.coverage.factor = row_factor_;
    }

    std::vector<OxideColumn> samples{};
    std::vector<Finding> warnings{};
    std::string ignited{};  ///< the text by which the oxides are those of the ignited sample

    [[nodiscard]] const NumberMarks& marks() const { return marks_; }

  private:
    void note(std::string text, Severity severity = Severity::remark) {
        warnings.push_back({glass_code, severity, std::move(text)});
    }

    /// The only text of a row; empty for a row with several.
    static std::string only_text(const TableRow& row) {
        const std::string* text = nullptr;
        for (const std::string& cell : row.cells) {
            if (!cell.empty() && text != nullptr) return {};
            if (!cell.empty()) text = &cell;
        }
        return text != nullptr ? *text : std::string();
    }

    static void refuse_loss(const TableRow& row, const std::string& text) {
        if (text.find('%') != std::string::npos && begins_with_loss(text))
            refuse_line(row.line, in_quotes(text) + " may state the loss on ignition, and is not read",
                        "\"LOI = 3.1 %\", or a row or column LOI");
    }

    /// Refuses a text that mentions a loss on ignition in per cent, where the table gives none.
    void refuse_loss_within(const std::vector<TextBeside>& texts) const {
        static const WordLists words("oxide columns", " ");
        constexpr std::size_t shortest_word = 3;
        const auto gives_loss = [](const OxideColumn& sample) {
            return std::ranges::any_of(
                sample.cells, [](const OxideCell& cell) { return cell.what.role == OxideRole::loss; });
        };
        if (std::ranges::any_of(samples, gives_loss)) return;
        for (const TextBeside& each : texts) {
            const std::vector<std::string> all = words_in(each.text);
            const bool states_number = std::ranges::find(all, "%") != all.end() &&
                                       each.text.find_first_of("0123456789") != std::string::npos &&
                                       !makes_statement(each, {"ignited sample"});
            for (const Mention& mention : mentions_in(all, words))
                if (states_number && mention.list == "loss" && !mention.negated &&
                    all[mention.first].size() >= shortest_word)
                    refuse_line(each.line,
                                in_quotes(each.text) + " may state the loss on ignition, and is not read",
                                "\"LOI = 3.1 %\", or a row or column LOI");
        }
    }

    /// Removes notes from the end of the rows; what they state is compared with the table as other texts are.
    void take_notes_below() {
        while (rows_.size() > 1 && is_note(rows_.back().cells)) {
            const TableRow& row = rows_.back();
            note(at_line(row.line) + " below the table is not read: " + title_in_quotes(joined(row.cells)));
            rows_.pop_back();
        }
    }

    /// Sets aside the lines of text that state an amount.
    void take_amount_notes() {
        std::erase_if(rows_, [&](const TableRow& row) {
            const std::string text = only_text(row);
            if (text.empty() && row.cells.front().find('=') != std::string::npos)
                refuse_loss(row, joined(row.cells));
            if (text.empty()) return false;
            const auto note = read_note(text, row.line);
            const bool states_amount =
                note && (is_content(note->what.role) || note->what.role == OxideRole::trace);
            if (states_amount)
                notes_.push_back(*note);
            else if (read_line(text).role == OxideRole::other) {
                refuse_loss(row, text);
            }
            return states_amount;
        });
    }

    void add_amount_notes() {
        for (const AmountNote& note : notes_) {
            if (samples.size() != 1)
                refuse_line(note.line, in_quotes(note.text) + " may be of any of the samples",
                            "a row or column for " + note.what.heading.text + " with an amount for each");
            OxideCell cell{
                .line = note.line, .column = headings_.size(), .what = note.what, .text = note.amount};
            if (note.what.heading.unit.empty()) cell.unit = samples.front().cells.front().unit;
            marks_.stays_below_thousand(cell.column);
            marks_.see(cell.text, cell.column);
            samples.front().cells.push_back(std::move(cell));
        }
    }

    /// Refuses what the texts beside the amounts state and their headings do not: fractions by mole, or the
    /// coverage of the uncertainties. @param heading of the columns; none: there is no such row
    void require_agreeing_texts(const TextLines& file, const std::vector<TextLine>& lines,
                                std::optional<std::size_t> heading, std::size_t label) {
        std::vector<TextLine> table;
        std::vector<TextBeside> names;
        std::vector<TextBeside> labels;  // "FA 7 (2 sigma)"
        for (const TextLine& line : lines) {
            const TableRow row = cut_row(line, separator_);
            if (only_text(row).empty() && !is_note(row.cells)) table.push_back(line);
            for (std::size_t k = 0; k < row.cells.size(); ++k)
                if ((row.line != heading || k == label) && !row.cells[k].empty() &&
                    !read_number(row.cells[k], true))
                    names.push_back({row.line, row.cells[k], true});
            if (row.line != heading && label < row.cells.size())
                labels.push_back({row.line, row.cells[label]});
            for (std::size_t k = 0; k < std::min(row.cells.size(), headings_.size()); ++k)
                if (std::string stated = coverage_in_cell(headings_[k].heading.written, row.cells[k]);
                    row.line != heading && headings_[k].role == OxideRole::other && !stated.empty())
                    labels.push_back({row.line, std::move(stated)});
        }
        std::vector<TextBeside> texts = texts_beside(file, table);
        refuse_loss_within(texts);
        refuse_factors(texts);
        if (label < headings_.size())
            texts.push_back({heading.value_or(1), headings_[label].heading.written});
        std::set<xrd::Scale> scales;
        for (std::size_t k = 0; k < headings_.size(); ++k)
            if (k != label) scales.insert(headings_[k].heading.scale);
        for (const OxideColumn& sample : samples)
            for (const OxideCell& cell : sample.cells) scales.insert(cell.what.heading.scale);
        scales.erase(xrd::Scale::not_stated);
        if (scales.empty()) scales = {xrd::Scale::per_cent, xrd::Scale::fraction};
        xrd::require_scale(texts, scales);
        names.insert(names.end(), texts.begin(), texts.end());
        require_basis(names, "weight");
        UncertainColumns columns(headings_.size());
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const xrd::Heading& each = headings_[k].heading;
            if (k != label)
                columns[k] = {each.written, each.coverage, is_uncertainty_column(each.written, headings_[k])};
        }
        std::vector<TextBeside> bases;           // "wt% (ignited)"; a title may be "LOI: ignited at 950 C"
        for (const OxideLine& each : headings_)  // "wt% (LOI-free)", unlike "SiO2"
            if (!is_content(each.role) && !each.heading.written.empty())
                bases.push_back({heading.value_or(1), each.heading.written});
        require_basis(bases, "weight");
        names.insert(names.end(), bases.begin(), bases.end());
        for (const auto& [statement, of] : {std::pair{"ignited sample", &names}, {"ignited heading", &bases}})
            if (const auto found = statements_in(*of); ignited.empty() && found.contains(statement))
                ignited = in_quotes(found.at(statement).text);
        texts.insert(texts.end(), labels.begin(), labels.end());
        check_coverage(glass_code, texts, columns, table, separator_, warnings);
        if (label < headings_.size())
            xrd::refuse_unread_heading(headings_[label].heading, heading.value_or(1));
    }

    /// Refuses amounts of the crystalline part, "SiO2 crystalline" or "wt% (crystalline)".
    void refuse_crystalline(std::size_t heading) const {
        for (const OxideColumn& sample : samples)
            for (const OxideCell& cell : sample.cells)
                for (const xrd::Heading* each : {cell.unit, &cell.what.heading})
                    if (each != nullptr && each->of_crystalline)
                        refuse_line(each == cell.unit ? heading : cell.line,
                                    in_quotes(each->written) + " states oxides of the crystalline part",
                                    "oxides of the whole sample, without \"crystalline\"");
    }

    void take_titles(std::size_t heading) {
        for (std::size_t i = 0; i < heading; ++i) {
            const std::string title = joined(rows_[i].cells);
            if (makes_statement({rows_[i].line, title}, {"ignited sample"}))
                continue;  // the balance states it
            require_basis({{rows_[i].line, title}}, "weight");
            note(at_line(rows_[i].line) + ", above the heading, is not read: " + title_in_quotes(title));
        }
    }

    /// Refuses what looks like an oxide or contains one that no other heading or row of the table gives.
    void refuse_unknown(const TableRow& row, std::size_t column, const OxideLine& line,
                        const std::vector<OxideLine>& others) const {
        if (line.role != OxideRole::other) return;
        const std::string& name = line.heading.text;
        if (looks_like_oxide(name))
            throw InputError("no oxide is called " + in_quotes(name),
                             "nearest: " + joined(nearest_oxides(name)))
                .at(at_cell(row.line, column));
        const bool has_loss =
            std::ranges::any_of(others, [](const OxideLine& each) { return each.role == OxideRole::loss; });
        if (!has_loss && begins_with_loss(line.heading.written) &&
            !is_of_low_temperature(line.heading.written))
            throw InputError(
                in_quotes(line.heading.written) + " may be the loss on ignition, and nothing else gives it",
                in_quotes("LOI") + " for it")
                .at(at_cell(row.line, column));
        const auto within = oxide_within(line.heading.written);
        if (!within || is_gas(oxides()[within->index].formula) ||
            std::ranges::any_of(others, [&](const OxideLine& each) {
                return each.role == OxideRole::oxide && each.oxide.index == within->index;
            }))
            return;
        const std::string formula(oxides()[within->index].formula);
        throw InputError(
            in_quotes(line.heading.written) + " is not read as an oxide, and nothing else gives " + formula,
            in_quotes(formula == "Fe2O3" ? "Fe2O3(t)" : formula) + " for it")
            .at(at_cell(row.line, column));
    }

    /// Takes a row of units below a heading into it: "Unit;wt%;wt%".
    static bool take_row_of_units(TableRow& heading, TableRow units) {
        const auto is_unit = [](std::string_view cell) {
            return xrd::read_heading("x [" + std::string(cell) + "]").states != xrd::HeadingUnit::other ||
                   word_key(cell) == "mgkg" || word_key(cell, "%") == "mol%";
        };
        for (std::string& cell : units.cells)
            if (names_units(cell)) cell.clear();
        return take_units(heading, units, is_unit);
    }

    /// A column for each oxide, a row for each sample. @return the column of their names
    std::size_t read_across(std::size_t first) {
        take_titles(first);
        TableRow names = rows_[first];
        std::size_t next = first + 1;
        if (next < rows_.size() && take_row_of_units(names, rows_[next])) ++next;
        read_headings(names);
        const std::size_t label = label_column(names);
        std::vector<std::string> unused;
        for (std::size_t i = 0; i < headings_.size(); ++i) {
            if (i != label) refuse_unknown(names, i, headings_[i], headings_);
            if (i > 0 && is_uncertainty_column(names.cells[i], headings_[i]) &&
                is_uncertainty_column(names.cells[i - 1], headings_[i - 1]))
                throw InputError("the uncertainties in column " + in_quotes(names.cells[i]) +
                                     " stand behind others: they may be of any oxide",
                                 "each column of uncertainties behind its oxide")
                    .at(at_cell(names.line, i));
            const bool used =
                i == label || is_content(headings_[i].role) || headings_[i].role == OxideRole::trace ||
                names.cells[i].empty() ||
                (is_uncertainty_column(names.cells[i], headings_[i]) && i > 0 &&
                 (is_content(headings_[i - 1].role) || headings_[i - 1].role == OxideRole::trace));
            if (used) continue;
            unused.push_back(with_texts(next, i, names.cells[i]));
        }
        if (!unused.empty()) note("columns not used: " + joined(unused));
        mark_thousands();
        refuse_coverages(next);
        bool amounts_follow = false;
        for (std::size_t r = rows_.size(); r-- > next;) {
            const std::string text = only_text(rows_[r]);
            const xrd::Heading as_heading = xrd::read_heading(text);
            const bool heads = text.ends_with(':') || (text.size() > 1 && is_summary(text)) ||
                               as_heading.states == xrd::HeadingUnit::other;
            if (amounts_follow && heads && !xrd::heads_alike(text, "oxides"))
                refuse_line(
                    rows_[r].line,
                    in_quotes(text) + " has no amounts: it may head the rows below it, or be a sample",
                    "a file without what such a row heads");
            amounts_follow = amounts_follow || xrd::holds_numbers(rows_[r], label);
        }
        row_factor_ = xrd::take_rows_of_uncertainties(rows_, next, label, glass_code, warnings);
        for (std::size_t r = next; r < rows_.size(); ++r) add_row(rows_[r], names, label);
        if (label < headings_.size() && samples.size() > 1 && samples.front().sample.empty())
            refuse_line(samples.front().cells.front().line, "the line names no sample, and others do",
                        "a name for each sample");
        return label;
    }

    /// Reads the headings of columns; "SiO2 2s" behind "SiO2" is of its uncertainties.
    void read_headings(const TableRow& row) {
        refuse_two_methods(row.cells, row.line);
        std::vector<std::optional<UncertaintySide>> sides;
        for (const std::string& cell : row.cells) sides.push_back(uncertainty_side(cell));
        const auto below =
            std::ranges::find_if(rows_, [&](const TableRow& each) { return each.line > row.line; });
        const std::span<const TableRow> rows(rows_);
        const auto repeated =
            repeated_sides(sides, row, rows.subspan(static_cast<std::size_t>(below - rows_.begin())));
        std::string name;
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            const std::string& cell = sides[k] ? sides[k]->text : row.cells[k];  // "err" of "-err"
            const auto beside = uncertainty_beside(cell, name);
            headings_.push_back(beside ? OxideLine{.role = OxideRole::uncertainty,
                                                   .heading = xrd::read_heading_beside(cell, name)}
                                       : read_line(cell));
            OxideLine& line = headings_.back();
            if (sides[k]) line.heading.written = row.cells[k];
            if (std::ranges::find(repeated, k) != repeated.end()) {
                line.role = OxideRole::other;
                continue;
            }
            if (!beside && line.role != OxideRole::uncertainty) name = line.heading.text;
            if (k > 0 && line.role == OxideRole::uncertainty)
                take_coverage_of_amounts(
                    {headings_[k - 1].heading.written, headings_[k - 1].heading.coverage}, cell,
                    headings_[k].heading.coverage, row.line);
        }
    }

    /// States in which columns a number may be a thousand: "4.000" ppm, but not "52.312" %.
    void mark_thousands(bool rows_in_ppm = false) {
        for (std::size_t i = 0; i < headings_.size(); ++i)
            if (is_uncertainty_column(headings_[i].heading.written, headings_[i]))
                marks_.holds_uncertainties(i);
            else if (headings_[i].heading.scale == xrd::Scale::ppm)
                marks_.may_hold_thousands(i);
            else if (!rows_in_ppm)
                marks_.stays_below_thousand(i);
    }

    /// The column of the names of samples; headings_.size() if there is none.
    [[nodiscard]] std::size_t label_column(const TableRow& names) const {
        for (std::size_t i = 0; i < headings_.size(); ++i)
            if (headings_[i].heading.role == xrd::Role::sample || word_key(names.cells[i]) == "name")
                return i;
        const bool first_is_oxide = headings_.front().role != OxideRole::other;
        return first_is_oxide ? headings_.size() : 0;
    }

    /// Notes a text in a column without a heading. @throws InputError for a number, or a text that calls the
    /// row invalid
    void refuse_nameless(const TableRow& row, std::size_t column) {
        const std::string& cell = row.cells[column];
        const bool has_heading = column < headings_.size() && !headings_[column].heading.written.empty();
        if (has_heading || trimmed(cell).empty()) return;
        if (calls_invalid(cell)) refuse_invalid_row(cell, "a column without a heading", row.line, column);
        if (read_number(cell, true))
            throw InputError(in_quotes(cell) +
                                 " stands below no heading: it may be an amount, or the part of "
                                 "a number behind its comma",
                             "a heading for each column with numbers")
                .at(at_cell(row.line, column));
        note(at_cell(row.line, column) + ", below no heading, is not read: " + in_quotes(cell));
    }

    void add_row(const TableRow& row, const TableRow& names, std::size_t label) {
        const std::string name = label < row.cells.size() ? row.cells[label] : std::string();
        if (!samples.empty() && (is_summary(name) || xrd::coverage_of_row(name, samples.back().sample))) {
            warnings.push_back(left_out(glass_code, row, "sample", name));
            return;
        }
        OxideColumn sample{.sample = name};
        bool after_oxide = false;
        for (std::size_t i = 0; i < std::min(row.cells.size(), headings_.size()); ++i) {
            if (i == label) continue;
            const OxideLine& what = headings_[i];
            if (is_uncertainty_column(names.cells[i], what)) {
                if (!after_oxide) continue;
                sample.cells.back().uncertainty = row.cells[i];
                sample.cells.back().error_heading = &what.heading;
                sample.cells.back().error_column = i;
                continue;
            }
            after_oxide = is_content(what.role) || what.role == OxideRole::trace;
            if (!after_oxide) {
                const auto amounts = std::ranges::find(headings_, OxideRole::oxide, &OxideLine::role);
                xrd::refuse_other_unit(row.cells[i], "column " + in_quotes(names.cells[i]),
                                       scale_or_per_cent(amounts->heading), row.line, i);
                continue;
            }
            sample.cells.push_back(
                {.line = row.line, .column = i, .what = what, .text = row.cells[i], .unit = &what.heading});
            marks_.see(row.cells[i], i);
        }
        const bool is_named = label >= headings_.size() || !name.empty() || samples.empty();
        const bool blank = std::ranges::all_of(
            sample.cells, [](const OxideCell& cell) { return trimmed(cell.text).empty(); });
        for (std::size_t i = label < headings_.size() ? label + 1 : 0; !blank && i < row.cells.size(); ++i)
            refuse_nameless(row, i);
        if (!blank && !is_named)
            refuse_line(row.line,
                        "the line names no sample: it may be another one, or hold a second run or the "
                        "uncertainties of " +
                            in_quotes(samples.back().sample),
                        "a name for each sample");
        if (!blank)
            samples.push_back(std::move(sample));
        else if (const std::string text = only_text(row); !text.empty())
            note(at_line(row.line) + " is not read: " + in_quotes(text));
    }

    /// Takes the names of samples in the row above units into their heading: ";FA1;;FA2;" above
    /// "Oxide;wt%;esd;wt%;esd". @return whether the row has them
    static bool take_names_above(TableRow& heading, const TableRow& above, std::size_t label) {
        const auto is_unit = [](const std::string& cell) {
            return read_line(cell).heading.role == xrd::Role::weight;
        };
        if (above.cells.size() > heading.cells.size() || label >= above.cells.size() ||
            std::ranges::count_if(heading.cells, is_unit) < 2 ||
            (!above.cells[label].empty() && above.cells[label] != heading.cells[label]))
            return false;
        for (std::size_t k = 0; k < heading.cells.size(); ++k) {
            const bool is_named = k < above.cells.size() && k != label && !above.cells[k].empty();
            if (is_named != (k != label && is_unit(heading.cells[k]))) return false;
        }
        for (std::size_t k = 0; k < above.cells.size(); ++k)
            if (k != label && !above.cells[k].empty())
                heading.cells[k] = above.cells[k] + " [" + heading.cells[k] + "]";
        return true;
    }

    /// Refuses a row with numbers that names no oxide, and quotes one with other texts.
    void refuse_unnamed(const TableRow& row) {
        const auto filled =
            std::ranges::find_if(row.cells, [](const std::string& cell) { return !cell.empty(); });
        if (filled == row.cells.end()) return;
        const auto is_number = [](std::string_view cell) {
            const auto first = cell.find_first_not_of("\u00b1+-( <");
            return first != std::string_view::npos && is_digit(cell[first]);
        };
        if (std::ranges::any_of(row.cells, is_number))
            refuse_line(
                row.line,
                "the line names no oxide: it may hold uncertainties, or a second determination, of the "
                "oxide above it",
                "a name for each line, and uncertainties in a column of their own or as \"60 \u00b1 1\"");
        note(at_line(row.line) + " is not used: " + ashimpact::with_texts(*filled, row));
    }

    /// A row for each oxide, a column for each sample. @return line of the heading, column of the names
    std::pair<std::optional<std::size_t>, std::size_t> read_down() {
        const auto [names, oxide] = first_row_down();
        const auto is_heading = [&, column = names](const TableRow& row) {
            if (row.cells.size() <= std::max<std::size_t>(column, 1)) return false;
            if (xrd::role_of_text(row.cells[column]) == xrd::Role::phase) return true;
            return !std::ranges::any_of(
                row.cells, [](const std::string& cell) { return read_number(cell, true).has_value(); });
        };
        std::size_t first = oxide;  // of the rows: others than oxides may stand before these
        while (first > 0 && !is_heading(rows_[first - 1])) --first;
        const auto texts_in = [](const TableRow& row) {
            return std::ranges::count_if(row.cells, [](const std::string& cell) { return !cell.empty(); });
        };
        while (first > 1 && names < rows_[first - 1].cells.size() &&  // "Leachate:;" below the heading
               only_text(rows_[first - 1]) == rows_[first - 1].cells[names] && is_heading(rows_[first - 2]) &&
               texts_in(rows_[first - 2]) > 1)
            --first;
        const bool has_heading = first > 0;
        if (!has_heading) first = oxide;
        if (first > 1 && names_units(rows_[first - 1].cells.front()) &&
            take_row_of_units(rows_[first - 2], rows_[first - 1]))
            rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(--first));
        if (first > 1 && take_names_above(rows_[first - 1], rows_[first - 2], names))
            rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(--first) - 1);
        const std::size_t width = rows_[first].cells.size();
        if (has_heading) read_headings(rows_[first - 1]);
        headings_.resize(std::max(headings_.size(), width));
        units_ = static_cast<std::size_t>(
            std::ranges::find_if(headings_,
                                 [](const OxideLine& line) { return names_units(line.heading.text); }) -
            headings_.begin());
        take_titles(has_heading ? first - 1 : first);
        const std::vector<std::size_t> amounts = amount_columns(first, names);
        if (amounts.empty())
            refuse_line(rows_[first].line, "no column holds the amounts of the oxides",
                        "\"weight %\" or the name of a sample above it");
        for (const std::size_t column : amounts) {
            const xrd::Heading& heading = headings_[column].heading;
            const bool is_unit = heading.role == xrd::Role::weight;
            samples.push_back({.sample = is_unit ? std::string() : heading.text});
        }
        drop_errors_of_unused(amounts, names);
        errors_ = error_columns(amounts, rows_[has_heading ? first - 1 : first].line);
        refuse_headed_rows(first, names);
        refuse_coverages(first);
        std::vector<OxideLine> lines;
        for (std::size_t r = first; r < rows_.size(); ++r) lines.push_back(line_of(rows_[r], names));
        mark_thousands(std::ranges::any_of(
            lines, [](const OxideLine& line) { return line.heading.scale == xrd::Scale::ppm; }));
        for (std::size_t r = first; r < rows_.size(); ++r) add_oxide_row(rows_[r], names, amounts, lines);
        return {has_heading ? std::optional(rows_[first - 1].line) : std::nullopt, names};
    }

    /// The column of the names of oxides, and the first row with one.
    [[nodiscard]] std::pair<std::size_t, std::size_t> first_row_down() const {
        constexpr std::size_t widest = 20;
        for (std::size_t column = 0; column < widest; ++column) {
            std::size_t count = 0;
            std::size_t first = rows_.size();
            for (std::size_t r = 0; r < rows_.size(); ++r) {
                if (column >= rows_[r].cells.size()) continue;
                if (read_line(rows_[r].cells[column]).role != OxideRole::oxide) continue;
                first = std::min(first, r);
                ++count;
            }
            if (count >= 2) return {column, first};
        }
        refuse_line(rows_.empty() ? 1 : rows_.front().line, "no two oxides are named",
                    "a table with a row or a column for each oxide: SiO2, Al2O3, ...");
    }

    [[nodiscard]] bool holds_numbers(std::size_t column) const {
        return std::ranges::any_of(rows_, [&](const TableRow& row) {
            return column < row.cells.size() && read_number(row.cells[column], true).has_value();
        });
    }

    /// Columns of amounts: those with a heading for a weight, else all with numbers and the name of a sample.
    [[nodiscard]] std::vector<std::size_t> amount_columns(std::size_t first, std::size_t names) {
        std::vector<std::size_t> by_name;
        std::vector<std::size_t> by_number;
        std::vector<std::string> unused;
        for (std::size_t i = 0; i < headings_.size(); ++i) {
            if (i == names || i == units_ || headings_[i].role == OxideRole::uncertainty) continue;
            const xrd::Heading& heading = headings_[i].heading;
            const bool numbers = holds_numbers(i);
            if (heading.role == xrd::Role::weight)
                by_name.push_back(i);
            else if (numbers && heading.role == xrd::Role::other && !names_other_basis(heading))
                by_number.push_back(i);
            else if (!heading.text.empty())
                unused.push_back(with_texts(first, i, heading.written));
        }
        if (!by_name.empty())
            for (const std::size_t i : by_number) unused.push_back(in_quotes(headings_[i].heading.text));
        if (by_name.empty() && by_number.empty() && !unused.empty())
            refuse_line(rows_[first].line, "no column holds amounts of oxides by weight: " + joined(unused),
                        "\"weight %\" or the name of a sample above them");
        if (by_name.size() > 1)
            refuse_line(rows_[first].line,
                        "there are " + std::to_string(by_name.size()) + " columns of amounts",
                        "the name of a sample above each, or one column");
        if (!unused.empty()) note("columns not used: " + joined(unused));
        return by_name.empty() ? by_number : by_name;
    }

    /// The heading of a column and the texts below it: "Remark" ("as Fe").
    [[nodiscard]] std::string with_texts(std::size_t first, std::size_t column,
                                         const std::string& heading) const {
        const auto texts = texts_in_column(std::span(rows_).subspan(first), column);
        return in_quotes(heading) + (texts.empty() ? "" : " (" + joined(texts) + ")");
    }

    /// Leaves out uncertainties without a name behind a column that is not used: they are of that column.
    void drop_errors_of_unused(const std::vector<std::size_t>& amounts, std::size_t names) {
        std::vector<std::string> unused;
        for (std::size_t i = 1; i < headings_.size(); ++i) {
            const OxideLine& before = headings_[i - 1];
            const bool is_used = i - 1 == names || i - 1 == units_ || before.role == OxideRole::uncertainty ||
                                 std::ranges::find(amounts, i - 1) != amounts.end();
            if (headings_[i].role != OxideRole::uncertainty || is_used ||
                !xrd::is_uncertainty_of_unused(headings_[i].heading, before.heading, holds_numbers(i - 1)))
                continue;
            headings_[i].role = OxideRole::other;
            unused.push_back(in_quotes(headings_[i].heading.written));
        }
        if (!unused.empty()) note("columns not used: " + joined(unused));
    }

    /// Of each column of amounts that of its uncertainties: the one behind it, or the only one of the table.
    [[nodiscard]] std::vector<std::optional<std::size_t>> error_columns(
        const std::vector<std::size_t>& amounts, std::size_t line) const {
        std::vector<std::optional<std::size_t>> errors(amounts.size());
        for (std::size_t i = 0; i < headings_.size(); ++i) {
            if (headings_[i].role != OxideRole::uncertainty) continue;
            const auto before = i > 0 ? std::ranges::find(amounts, i - 1) : amounts.end();
            const auto k = before == amounts.end() && amounts.size() == 1 ? 0 : before - amounts.begin();
            if (k == std::ssize(amounts) || errors[static_cast<std::size_t>(k)])
                refuse_line(line,
                            "the uncertainties in column " + in_quotes(headings_[i].heading.written) +
                                " may be of any column",
                            "each column of uncertainties behind its amounts");
            errors[static_cast<std::size_t>(k)] = i;
        }
        return errors;
    }

    static xrd::Scale scale_or_per_cent(const xrd::Heading& heading) {
        return heading.scale == xrd::Scale::not_stated ? xrd::Scale::per_cent : heading.scale;
    }

    /// Refuses a row that a cell beside its amounts calls invalid, or a bound, or gives another unit.
    void refuse_marked(const TableRow& row, std::size_t names, const std::vector<std::size_t>& amounts,
                       const OxideLine& what) const {
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const bool read = i == names || i == units_ || std::ranges::find(amounts, i) != amounts.end() ||
                              std::ranges::find(errors_, std::optional(i)) != errors_.end();
            if (read) continue;
            const std::string column =
                i < headings_.size() ? "column " + in_quotes(headings_[i].heading.written) : "a column";
            if (calls_invalid(row.cells[i])) refuse_invalid_row(row.cells[i], column, row.line, i);
            refuse_sign_of_bound(row.cells[i], column, row.line, i);
            for (const std::size_t amount : amounts) {
                const xrd::Heading& heading =
                    what.heading.unit.empty() ? headings_[amount].heading : what.heading;
                xrd::refuse_other_unit(row.cells[i], column, scale_or_per_cent(heading), row.line, i);
            }
        }
    }

    /// The oxide of a row, with the unit of its own.
    [[nodiscard]] OxideLine line_of(const TableRow& row, std::size_t names) const {
        if (names >= row.cells.size() || row.cells[names].empty()) return {};
        const bool has_unit = units_ < row.cells.size() && !row.cells[units_].empty();
        return read_line(row.cells[names] + (has_unit ? " [" + row.cells[units_] + "]" : ""));
    }

    /// Whether a row has no cell but that of its name, and names nothing that is in the table itself.
    [[nodiscard]] static bool may_head_rows(const TableRow& row, std::size_t names) {
        const std::string text = only_text(row);
        if (names >= row.cells.size() || row.cells[names].empty() || text != row.cells[names]) return false;
        static const std::regex element("[A-Z][a-z]?");
        return read_line(text).role == OxideRole::other && !xrd::heads_alike(text, "oxides") &&
               !std::regex_match(text.substr(0, longest_name), element);
    }

    /// Refuses rows that may head the amounts below them, "Leachate [mg/l]". @throws InputError
    void refuse_headed_rows(std::size_t first, std::size_t names) const {
        bool amounts_follow = false;
        for (std::size_t r = rows_.size(); r-- > first;) {
            if (amounts_follow && may_head_rows(rows_[r], names))
                refuse_line(rows_[r].line,
                            in_quotes(rows_[r].cells[names]) +
                                " has no cells: it may head the rows below it, or be a quantity without "
                                "amount",
                            "a file without what such a row heads");
            const bool is_amount =
                names < rows_[r].cells.size() && is_content(read_line(rows_[r].cells[names]).role);
            amounts_follow = amounts_follow || (is_amount && xrd::holds_numbers(rows_[r], names));
        }
    }

    /// Refuses coverages in a column of their own beside uncertainties that are not divided for them.
    /// @throws InputError
    void refuse_coverages(std::size_t first) const {
        std::vector<double> divisors;
        for (const OxideLine& line : headings_)
            if (is_uncertainty_column(line.heading.written, line) && line.heading.coverage.problem.empty())
                divisors.push_back(line.heading.coverage.factor);
        for (std::size_t k = 0; k < headings_.size(); ++k)
            if (headings_[k].role == OxideRole::other)
                ashimpact::refuse_coverages(headings_[k].heading.written, std::span(rows_).subspan(first), k,
                                            divisors);
    }

    void add_oxide_row(const TableRow& row, std::size_t names, const std::vector<std::size_t>& amounts,
                       const std::vector<OxideLine>& all) {
        if (names >= row.cells.size() || row.cells[names].empty()) {
            for (const std::string& cell : row.cells)
                if (!read_coverage(cell).stated.empty())
                    refuse_line(row.line, in_quotes(cell) + " in a second line of headings is not read",
                                "one line of headings: \"Oxide;wt%;2 sigma\"");
            refuse_unnamed(row);
            return;
        }
        const OxideLine what = line_of(row, names);
        refuse_unknown(row, names, what, all);
        if (!is_content(what.role) && what.role != OxideRole::trace) {
            refuse_coverage_in_row(row, names);
            note(at_line(row.line) + " is not used: " + ashimpact::with_texts(row.cells[names], row));
            return;
        }
        refuse_marked(row, names, amounts, what);
        for (std::size_t i = names + 1; i < row.cells.size(); ++i)
            if ((i != units_ || i >= headings_.size()) && std::ranges::find(amounts, i) == amounts.end() &&
                std::ranges::find(errors_, std::optional(i)) == errors_.end())
                refuse_nameless(row, i);
        for (std::size_t k = 0; k < amounts.size(); ++k) {
            const std::size_t column = amounts[k];
            if (column >= row.cells.size()) continue;
            OxideCell cell{.line = row.line, .column = column, .what = what, .text = row.cells[column]};
            const bool own_unit = !what.heading.unit.empty();
            cell.what = what;
            cell.unit = own_unit ? nullptr : &headings_[column].heading;
            if (const auto errors = errors_[k]; errors && *errors < row.cells.size()) {
                cell.uncertainty = row.cells[*errors];
                cell.error_heading = &headings_[*errors].heading;
                cell.error_column = *errors;
            }
            marks_.see(cell.text, column);
            samples[k].cells.push_back(std::move(cell));
        }
    }

    NumberMarks marks_;
    char separator_ = ',';  ///< of most lines
    std::vector<TableRow> rows_{};
    std::vector<AmountNote> notes_{};
    std::vector<OxideLine> headings_{};
    std::vector<std::optional<std::size_t>> errors_{};  ///< columns of uncertainties, by those of amounts
    double row_factor_ = 1;                             ///< by which rows of uncertainties are divided
    std::size_t units_ = std::string::npos;  ///< column of the units of single rows, if there is one
};

/// Heading that states the unit of a cell.
const xrd::Heading& unit_heading(const OxideCell& cell) {
    return cell.unit != nullptr ? *cell.unit : cell.what.heading;
}

/// Scale of the numbers under a heading: none if nothing states it.
std::optional<double> stated_scale(const xrd::Heading& heading, bool per_cent, std::size_t line) {
    if (word_key(heading.unit, "%").find("mol") != std::string::npos ||
        word_key(heading.text, "%").find("mol%") != std::string::npos)
        throw InputError("the amounts are in " + heading.unit, "% by weight, as \"wt%\"").at(at_line(line));
    if (per_cent && heading.scale != xrd::Scale::not_stated && heading.scale != xrd::Scale::per_cent)
        throw InputError("a cell is per cent, and " + in_quotes(heading.written) + " states another unit",
                         "one of the two")
            .at(at_line(line));
    if (heading.scale == xrd::Scale::ppm) return 1e-6;
    const bool by_weight =
        heading.states != xrd::HeadingUnit::other && heading.states != xrd::HeadingUnit::volume;
    if (by_weight && heading.scale == xrd::Scale::per_mille) return 1e-3;
    if (by_weight && (per_cent || heading.scale == xrd::Scale::per_cent)) return 0.01;
    if (by_weight && heading.scale == xrd::Scale::fraction) return 1;
    if (!heading.unit.empty())
        throw InputError("the amounts are in " + in_quotes(heading.unit),
                         "% by weight, g/kg, ppm or fractions")
            .at(at_line(line));
    return std::nullopt;
}

/// An amount in the unit of its table.
struct OxideNumber {
    double value = 0;
    std::optional<double> uncertainty{};
    std::optional<double> scale{};
};

/// Whether a cell is a limit or "n.d.": the oxide was determined and not found.
bool says_not_found(std::string_view text) {
    static const WordLists words("not detected", all_marks);
    return words.holds(text) || text.starts_with('<') || text.starts_with("\u2264");
}

/// The number of a cell; none where the oxide was not determined.
std::optional<OxideNumber> number_of(const OxideCell& cell, const NumberMarks& marks) {
    const std::string_view text = trimmed(cell.text);
    const auto place = at_cell(cell.line, cell.column);
    if (says_not_found(text)) {
        std::string_view limit = text;
        for (const std::string_view sign : {"<", "\u2264", "=", " "})
            if (limit.starts_with(sign)) limit = trimmed(limit.substr(sign.size()));
        static const WordLists words("not detected", all_marks);
        if (words.holds(text) || words.holds(limit)) return OxideNumber{0, std::nullopt, 0.01};
        const auto most = at_place(place, [&] { return marks.read(limit, cell.column); });
        if (!most)
            throw InputError("cannot read " + in_quotes(text), "a number, \"<0.05\" or \"n.d.\"").at(place);
        const double half = most->value / 2;
        return OxideNumber{half, half / std::sqrt(3.0),
                           stated_scale(unit_heading(cell), most->per_cent, cell.line)};
    }
    if (says_no_number(text)) return std::nullopt;
    return at_place(place, [&]() -> std::optional<OxideNumber> {
        const auto read =
            marks.read(xrd::without_fraction_unit(std::string(text), xrd::HeadingUnit::weight), cell.column);
        if (!read) throw InputError("cannot read " + in_quotes(text), "a number, \"<0.05\" or \"n.d.\"");
        if (read->value < 0)
            throw InputError("the amount of " + cell.what.heading.text + " is " + shortest(read->value),
                             "zero or more");
        OxideNumber number{read->value, read->standard_uncertainty,
                           stated_scale(unit_heading(cell), read->per_cent, cell.line)};
        const auto& coverage = unit_heading(cell).coverage;
        if (!coverage.problem.empty()) number.uncertainty.reset();
        if (number.uncertainty) *number.uncertainty /= coverage.factor;
        if (cell.error_heading != nullptr && !says_no_number(cell.uncertainty)) {
            if (number.uncertainty)
                throw InputError(in_quotes(text) + " and its column state an uncertainty", "one of them");
            if (xrd::may_be_relative(*cell.error_heading))
                throw InputError("the uncertainty in [%] may be of the sample or of the amount",
                                 "the unit of the amounts, such as [wt%]");
            const auto error = marks.read(cell.uncertainty, cell.error_column);
            if (!error || error->value < 0)
                throw InputError("cannot read the uncertainty " + in_quotes(cell.uncertainty),
                                 "a number, zero or more");
            if (read->per_cent && !error->per_cent && cell.error_heading->scale == xrd::Scale::not_stated)
                xrd::refuse_bare_uncertainty(text, cell.uncertainty, *read, error->value, cell.line,
                                             cell.error_column);
            const auto scale = stated_scale(*cell.error_heading, error->per_cent, cell.line);
            if (scale && !number.scale)
                throw InputError(
                    "the uncertainty " + in_quotes(cell.uncertainty) + " has a unit and its amount has none",
                    "units for both or for neither");
            const double factor = scale ? *scale / *number.scale : 1;
            if (cell.error_heading->coverage.problem.empty())
                number.uncertainty = factor * error->value / cell.error_heading->coverage.factor;
        }
        return number;
    });
}

constexpr const char* all_iron_once =
    "\"Fe2O3(t)\" for all iron, alone or beside \"FeO\", which then is not added";

/// That two forms of iron, as Fe2O3, have two readings.
std::string two_irons(const std::string& name, const OxideShare& one, const std::string& other_name,
                      const OxideShare& other) {
    return "iron is there as " + name + " and " + other_name + ": " + name + " may be all of it, " +
           per_cent(one.fraction) + " as Fe2O3, or a part of " + per_cent(one.fraction + other.fraction);
}

/// Makes the analysis of one sample.
class OxideSampleMaker {
  public:
    OxideSampleMaker(const OxideColumn& column, const NumberMarks& marks) : column_(column), marks_(marks) {
        sample_.name = column.sample;
    }

    OxideSample make() {
        find_scale();
        for (const OxideCell& cell : column_.cells) add(cell);
        const auto in_per_cent = [](const OxideCell& cell) { return cell.uncertainty.ends_with('%'); };
        if (std::ranges::any_of(column_.cells, in_per_cent))
            sample_.warnings.push_back(uncertainties_in_per_cent(glass_code));
        if (const auto doubt = small_.finding(glass_code)) sample_.warnings.push_back(*doubt);
        if (!not_found_.empty())
            note("read as not found, zero: " + joined(not_found_) +
                 "; the cell of an oxide that was not determined is empty or \"-\"");
        if (!missing_.empty()) note("no amount is given of " + joined(missing_) + ": not in the glass");
        merge_iron();
        check_total();
        if (traces_ > 0)
            note("elements in ppm are traces and left out, together " + per_cent(traces_) +
                     " of the sample: " + joined(trace_names_),
                 Severity::background);
        return std::move(sample_);
    }
    /// Of the oxides, as the numbers stand there or in per cent.
    [[nodiscard]] double sum() const { return sum_; }

  private:
    struct Iron {
        OxideShare share;
        bool is_total;
        std::string name;
        double listed;  ///< fraction of that form
    };

    void note(std::string text, Severity severity = Severity::remark) {
        sample_.warnings.push_back({glass_code, severity, std::move(text)});
    }

    /// Refuses an amount up to 1 without a sign beside others "52.3 %": it may be a fraction.
    void refuse_small_without_sign() const {
        const auto has_sign = [](const OxideCell& cell) {
            return cell.what.role == OxideRole::oxide && trimmed(cell.text).ends_with('%');
        };
        if (!std::ranges::any_of(column_.cells, has_sign)) return;
        for (const OxideCell& cell : column_.cells) {
            if (cell.what.role != OxideRole::oxide || has_sign(cell) || says_not_found(trimmed(cell.text)))
                continue;
            const auto number = number_of(cell, marks_);
            if (number && number->value > 0 && number->value <= 1 && number->scale.value_or(0.01) == 0.01)
                throw InputError("the amount " + in_quotes(trimmed(cell.text)) + " of " +
                                     cell.what.heading.text +
                                     " has no sign, others are in %: it may be per cent or a fraction",
                                 "% in all cells (in a spreadsheet one number format for all)")
                    .at(at_cell(cell.line, cell.column));
        }
    }

    /// Scale of amounts without a unit, from their sum.
    void find_scale() {
        double sum = 0;
        bool any = false;
        bool in_per_cent = false;
        for (const OxideCell& cell : column_.cells) {
            if (cell.what.role != OxideRole::oxide) continue;
            const auto number = number_of(cell, marks_);
            if (!number) continue;
            sum_ += number->value * (number->scale ? *number->scale / 0.01 : 1);
            in_per_cent = in_per_cent || (number->scale == 0.01 && number->value > 0);
            if (number->scale) continue;
            sum += number->value;
            any = true;
        }
        if (!any) return refuse_small_without_sign();
        constexpr double between = 2;  // sums near 1 and near 100
        scale_ = sum > between ? 0.01 : 1;
        if (in_per_cent && scale_ == 1)
            refuse_line(
                column_.cells.front().line,
                "some amounts are per cent, and others state no unit: they may be fractions or per cent",
                "one unit for all");
        note(std::string("the table states no unit: by their sum the amounts are ") +
                 (sum > between ? "per cent" : "fractions"),
             Severity::background);
    }

    void add(const OxideCell& cell) {
        const auto number = number_of(cell, marks_);
        const std::string name = cell.what.heading.text;
        if (!number && cell.what.role == OxideRole::oxide) missing_.push_back(name);
        if (!number && !cell.uncertainty.empty() && !says_no_number(cell.uncertainty))
            note(at_line(cell.line) + ": " + in_quotes(cell.uncertainty) + " beside " + name +
                 ", which has no amount, is not read");
        if (!number) return;
        const std::string_view text = trimmed(cell.text);
        if (cell.what.role == OxideRole::oxide && says_not_found(text) && number->value == 0)
            not_found_.push_back(name + " (" + in_quotes(text) + ")");
        const double scale = number->scale.value_or(scale_);
        if (cell.what.role == OxideRole::trace) {
            if (scale > 1e-6)
                throw InputError(name + " is an element", "its oxide, or traces in ppm")
                    .at(at_cell(cell.line, cell.column));
            traces_ += number->value * scale;
            trace_names_.push_back(name);
            return;
        }
        OxideShare share{.oxide = "LOI", .fraction = number->value * scale};
        if (number->uncertainty) share.standard_uncertainty = *number->uncertainty * scale;
        if (cell.what.role == OxideRole::total) {
            if (number->uncertainty.value_or(0) > 0) note("the uncertainty of the total is not used");
            total_ = share.fraction;
            return;
        }
        if (cell.what.role == OxideRole::loss) {
            if (sample_.analysis.loss_on_ignition)
                throw InputError("the loss on ignition is there twice", "once")
                    .at(at_cell(cell.line, cell.column));
            if (number->uncertainty.value_or(0) > 0 && !says_not_found(trimmed(cell.text)))
                note("the uncertainty of the LOI, " + per_cent(*share.standard_uncertainty) +
                     ", is not used");
            share.standard_uncertainty.reset();
            sample_.analysis.loss_on_ignition = share;
            return;
        }
        listed_ += share.fraction;
        constexpr double trace = 1e-3;  // an amount below may be lost in its uncertainty
        if (share.fraction > trace && share.standard_uncertainty.value_or(0) > share.fraction)
            note("the uncertainty of " + name + ", " + per_cent(*share.standard_uncertainty) +
                     ", is above its amount, " + per_cent(share.fraction) + ": is it one?",
                 Severity::doubt);
        const bool is_bare = cell.error_heading != nullptr && !cell.uncertainty.ends_with('%') &&
                             cell.error_heading->scale == xrd::Scale::not_stated;
        if (is_bare && scale == 0.01 && number->uncertainty)
            small_.take(number->value, cell.uncertainty, *number->uncertainty);
        share.oxide = oxides()[cell.what.oxide.index].formula;
        share.fraction *= cell.what.oxide.factor;
        if (share.standard_uncertainty) *share.standard_uncertainty *= cell.what.oxide.factor;
        if (share.oxide == "Fe2O3") {
            iron_.push_back({share, cell.what.oxide.is_total, name, number->value * scale});
            return;
        }
        auto& oxides_listed = sample_.analysis.oxides;
        const auto same = std::ranges::find(oxides_listed, share.oxide, &OxideShare::oxide);
        const bool is_kind_of_water = name.ends_with('+') || name.ends_with('-');
        if (same == oxides_listed.end())
            oxides_listed.push_back(share);
        else if (share.oxide == "H2O" && is_kind_of_water)
            same->fraction += share.fraction;
        else
            throw InputError(name + " is there twice, as " + share.oxide + " or in another form",
                             "each oxide once")
                .at(at_cell(cell.line, cell.column));
    }

    /// Two forms of iron are its parts, or one of them is all of it. A name or the total of the table
    /// decides.
    void merge_iron() {
        if (iron_.empty()) return;
        const auto totals = std::ranges::count_if(iron_, &Iron::is_total);
        if (totals > 1 || (totals == 0 && iron_.size() > 2) ||
            (totals == 0 && iron_.size() == 2 && word_key(iron_[0].name) == word_key(iron_[1].name)))
            refuse_line(column_.cells.front().line, "iron is there more than once",
                        "FeO and Fe2O3, or one total such as \"Fe2O3(t)\"");
        if (totals == 1)
            std::stable_partition(iron_.begin(), iron_.end(), [](const Iron& iron) { return iron.is_total; });
        else
            std::stable_partition(iron_.begin(), iron_.end(),
                                  [](const Iron& iron) { return !iron.name.starts_with("FeO"); });
        OxideShare sum = iron_.front().share;
        if (iron_.size() > 1 && (totals == 1 || !are_parts(iron_[0], iron_[1]))) {
            note(iron_.front().name + " is the total iron: the other form is not added");
            for (std::size_t i = 1; i < iron_.size(); ++i) listed_ -= iron_[i].listed;
        } else if (iron_.size() > 1) {
            note(iron_[0].name + " and " + iron_[1].name + " are added, as in the total of the table");
            sum.fraction += iron_[1].share.fraction;
            const auto& a = iron_[0].share.standard_uncertainty;
            const auto& b = iron_[1].share.standard_uncertainty;
            if (a && b) sum.standard_uncertainty = std::hypot(*a, *b);
        }
        sample_.analysis.oxides.push_back(sum);
    }

    /// Whether the total of the table counts both forms. @throws InputError where it does not decide
    [[nodiscard]] bool are_parts(const Iron& one, const Iron& other) const {
        constexpr double near = 0.1;  // of the gap that the other reading leaves
        const double both = total_ ? gap(listed_) : 0;
        const double first = total_ ? gap(listed_ - other.listed) : 0;
        if (both < near * first) return true;
        if (first < near * both) return false;
        refuse_line(column_.cells.front().line, two_irons(one.name, one.share, other.name, other.share),
                    all_iron_once);
    }

    /// Between the stated total, with the loss or without, and some listed amounts [1].
    [[nodiscard]] double gap(double listed) const {
        const auto& loss = sample_.analysis.loss_on_ignition;
        const double rest = *total_ - listed - traces_;
        return std::min(std::abs(rest), std::abs(rest - (loss ? loss->fraction : 0)));
    }

    void check_total() {
        constexpr double tolerance = 0.01;
        if (!total_ || gap(listed_) <= tolerance) return;
        const auto& loss = sample_.analysis.loss_on_ignition;
        note("the total is given as " + per_cent(*total_) + ", the oxides that are read add up to " +
                 per_cent(listed_) +
                 (loss && loss->fraction > 0 ? ", with LOI to " + per_cent(listed_ + loss->fraction) : ""),
             Severity::doubt);
    }

    const OxideColumn& column_;
    const NumberMarks& marks_;
    OxideSample sample_{};
    SmallUncertainties small_{};
    double scale_ = 0.01;
    double sum_ = 0;
    double listed_ = 0;
    double traces_ = 0;
    std::vector<std::string> trace_names_{};
    std::vector<std::string> missing_{};    ///< oxides without a number
    std::vector<std::string> not_found_{};  ///< with what their cells say
    std::optional<double> total_{};
    std::vector<Iron> iron_{};
};

/// What the columns and rows are taken as.
std::string reading_of(const std::vector<OxideColumn>& columns, const std::vector<OxideSample>& samples) {
    constexpr std::size_t most = 4;  // samples with their sums
    TableReading reading;
    reading.add(counted(samples.size(), "sample"));
    for (const OxideSample& sample : samples) {
        if (samples.size() > most) break;
        double sum = 0;
        for (const OxideShare& share : sample.analysis.oxides) sum += share.fraction;
        const auto& loss = sample.analysis.loss_on_ignition;
        reading.add((samples.size() > 1 ? sample.name + " " : "") + per_cent(sum) + " by weight in oxides" +
                    (loss ? ", LOI " + per_cent(loss->fraction) : ""));
    }
    for (const OxideColumn& column : columns)
        for (const OxideCell& cell : column.cells) {
            const std::string& name = cell.what.heading.written;
            switch (cell.what.role) {
                case OxideRole::oxide:
                    reading.take("oxides", name);
                    break;
                case OxideRole::loss:
                    reading.take("loss on ignition", name);
                    break;
                case OxideRole::total:
                    reading.take("total", name);
                    break;
                default:
                    continue;
            }
            if (cell.unit != nullptr && cell.unit->written != name)
                reading.take("amounts", cell.unit->written);
            if (cell.unit != nullptr && cell.unit->coverage.factor != 1)
                reading.take("uncertainties in the cells" + divided_by(cell.unit->coverage.factor), name);
            if (cell.error_heading != nullptr && cell.error_heading->coverage.problem.empty())
                reading.take("standard uncertainties", cell.error_heading->written,
                             divided_by(cell.error_heading->coverage.factor));
        }
    return reading.text();
}

OxideResult read_oxide_lines(const TextLines& file, std::optional<DecimalMark> decimal) {
    const OxideTable table(file, decimal);
    OxideResult result{.samples = {}, .warnings = table.warnings};
    std::vector<NamedSum> sums;
    for (const OxideColumn& column : table.samples) {
        OxideSampleMaker maker(column, table.marks());
        OxideSample sample = maker.make();
        if (sample.analysis.oxides.empty()) continue;
        sums.push_back({sample.name, maker.sum()});
        sample.analysis.ignited = table.ignited;
        const auto same = std::ranges::find(result.samples, sample.name, &OxideSample::name);
        if (same != result.samples.end())
            refuse_line(column.cells.front().line,
                        sample.name.empty() ? "there are several samples without a name"
                                            : "the sample " + in_quotes(sample.name) + " is there twice",
                        "a name for each sample");
        result.samples.push_back(std::move(sample));
    }
    std::vector<std::string> names;
    for (const OxideSample& sample : result.samples)
        if (may_state_more(sample.name)) names.push_back(sample.name);
    if (auto remark = names_not_read(glass_code, std::move(names),
                                     "the amounts count by weight, the uncertainties as standard ones"))
        result.warnings.push_back(*std::move(remark));
    const auto namesakes = small_namesakes(glass_code, sums);
    for (std::size_t i = 0; i < namesakes.size(); ++i)
        if (namesakes[i]) result.samples[i].warnings.push_back(*namesakes[i]);
    for (Finding& each : table.marks().findings(glass_code)) result.warnings.push_back(std::move(each));
    if (result.samples.empty())
        refuse_line(file.last_line(), "there are no amounts of oxides", "a number for each oxide");
    result.reading = reading_of(table.samples, result.samples);
    return result;
}

OxideResult read_any(std::string_view bytes, const TableOptions& options) {
    const TableFile file(bytes,
                         {.name = options.sheet,
                          .option = "the name of a sheet (in a case \"oxides_sheet\")",
                          .code = glass_code,
                          .limits = oxide_limits,
                          .holds_table = [](const TextLines& lines) { return OxideTable(lines, {}), true; }});
    return file.read([&](const TextLines& lines) {
        OxideResult result = read_oxide_lines(lines, options.decimal);
        file.add_findings(result.warnings);
        return result;
    });
}

OxideShare share_in(const std::string& name, const View& node) {
    const Quantity fraction = node.quantity(Dimension::fraction);
    if (!(fraction.value >= 0 && fraction.value <= 1))
        node.fail("the fraction is " + per_cent(fraction.value), "0 % to 100 % (0 to 1), as \"52.1 %\"");
    return {name, fraction.value, fraction.standard_uncertainty};
}

void add_share(const std::string& name, const View& node, OxideAnalysis& analysis) {
    OxideShare share = share_in(name, node);
    if (read_line(name).role == OxideRole::loss) {
        share.oxide = "LOI";
        static_cast<void>(node.certain_number(Dimension::fraction, "the loss alone"));
        if (analysis.loss_on_ignition) node.fail("the loss on ignition is there twice", "once");
        analysis.loss_on_ignition = share;
        return;
    }
    const auto oxide = has_sign_of_bound(name) ? std::nullopt : named_oxide(name);
    if (!oxide) {
        const auto near = nearest_oxides(name);
        node.fail("no oxide is called " + in_quotes(name),
                  near.empty() ? "a formula such as \"SiO2\", or \"LOI\"" : "nearest: " + joined(near));
    }
    share.oxide = oxides()[oxide->index].formula;
    share.fraction *= oxide->factor;
    if (share.standard_uncertainty) *share.standard_uncertainty *= oxide->factor;
    const auto same = std::ranges::find(analysis.oxides, share.oxide, &OxideShare::oxide);
    if (same != analysis.oxides.end() && share.oxide == "Fe2O3")
        node.fail(two_irons("one form", *same, "\"" + name + "\"", share), "all iron once, as \"Fe2O3\"");
    if (same != analysis.oxides.end()) node.fail(share.oxide + " is there twice", "each oxide once");
    analysis.oxides.push_back(share);
}

}  // namespace

OxideResult read_oxides(std::string_view text, std::string_view name, const TableOptions& options) {
    return at_place(FileName{std::string(name)}, [&] {
        OxideResult result = read_any(text, options);
        for (OxideSample& sample : result.samples) {
            sample.analysis.source = std::string(name);
            if (sample.name.empty()) sample.name = xrd::file_stem(name);
        }
        return result;
    });
}

const OxideSample& oxide_sample(const OxideResult& result, const std::string& name, bool must_match) {
    const auto& samples = result.samples;
    if (const auto same = std::ranges::find(samples, name, &OxideSample::name); same != samples.end())
        return *same;
    const auto is_alike = [key = sample_key(name)](const OxideSample& sample) {
        return sample_key(sample.name) == key;
    };
    if (std::ranges::count_if(samples, is_alike) == 1) return *std::ranges::find_if(samples, is_alike);
    if (samples.size() == 1 && !must_match) return samples.front();
    std::vector<std::string> names;
    for (const OxideSample& sample : samples) names.push_back(sample.name);
    throw InputError("the oxides have no sample " + in_quotes(name), joined(names));
}

std::optional<Finding> other_sample_finding(const OxideSample& oxides, const std::string& sample) {
    return other_sample_finding(glass_code, "oxides", oxides.name, oxides.analysis.source, sample);
}

OxideAnalysis read_oxides_json(const View& node) {
    OxideAnalysis analysis;
    if (node.json().is_array()) {
        for (const View& each : node.elements()) {
            each.require_keys({"oxide", "weight_fraction"});
            add_share(each.at("oxide").text(), each.at("weight_fraction"), analysis);
        }
    } else {
        for (const auto& [name, value] : node.members()) add_share(name, value, analysis);
    }
    if (analysis.oxides.empty()) node.fail("there are no oxides", "at least SiO2 with its amount");
    return analysis;
}

}  // namespace ashimpact
