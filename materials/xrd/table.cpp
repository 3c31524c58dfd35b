// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "core/json/document.hpp"
#include "core/quantities/checks.hpp"
#include "core/tables/table_reading.hpp"
#include "core/tables/table_texts.hpp"
#include "core/text/text.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/table_layout.hpp"

namespace ashimpact::xrd {

namespace {

/// Whether "%" at the end of a name may belong to a number in it: "FA 5 %".
bool may_end_with_per_cent(const std::string& name) {
    static const std::regex form(".*[ _(/+-][0-9][0-9.,]* *%");
    return name.size() <= longest_heading && std::regex_match(name, form);
}

/// Factor from amounts to fractions, if headings or cells state it, else by the size of the amounts.
double scale_of(const Table& table, const std::vector<Entry>& entries, std::vector<Finding>& warnings) {
    bool per_cent = false;
    bool fraction = false;
    const std::string* named = nullptr;  // a sample "FA 5 %"
    for (const Heading& heading : table.headings) {
        if (heading.role == Role::standard || heading.role == Role::uncertainty || stands_beside(heading))
            continue;
        if (heading.scale == Scale::ppm) return 1e-6;  // by_volume() has refused other units beside it
        if (heading.scale == Scale::per_mille) return 1e-3;
        if (may_end_with_per_cent(heading.written))
            named = &heading.written;
        else
            per_cent = per_cent || heading.scale == Scale::per_cent;
        fraction = fraction || heading.scale == Scale::fraction;
    }
    double largest = 0;
    const Entry* bare = nullptr;
    const Entry* signed_cell = nullptr;
    const Entry* small = nullptr;  // without a sign, up to 1: a cell of a sheet that shows others in per cent
    for (const Entry& entry : entries) {
        if (!entry.amount) continue;
        if (entry.amount->value > 0) (entry.amount->per_cent ? signed_cell : bare) = &entry;
        if (entry.amount->value > 0 && entry.amount->value <= 1 && !entry.amount->per_cent) small = &entry;
        largest = std::max(largest, entry.amount->value);
    }
    if (per_cent) bare = small;
    if (signed_cell != nullptr && bare != nullptr)
        refuse_line(bare->line,
                    fmt::format("the amount {} of {} has no sign, others of the table are in %: it may be "
                                "per cent or a fraction",
                                shortest(bare->amount->value), in_quotes(bare->phase)),
                    "% in all cells (in a spreadsheet one number format for all)");
    per_cent = per_cent || signed_cell != nullptr;
    if (per_cent != fraction) return per_cent ? 0.01 : 1;
    const bool seems_per_cent = largest > 1;
    for (const Entry& entry : entries)
        if (may_end_with_per_cent(entry.sample)) named = &entry.sample;
    if (named != nullptr && !per_cent && !seems_per_cent)
        refuse_line(table.heading_line,
                    "the sample " + in_quotes(*named) + " has amounts up to " + shortest(largest) +
                        ": they may be fractions, or in the \"%\" of its name",
                    "the unit of the amounts in brackets: [1], [wt%]");
    warnings.push_back(
        {xrd_code, Severity::remark,
         std::string("the table does not say whether its amounts are per cent or fractions: by their "
                     "size they are ") +
             (seems_per_cent ? "per cent" : "fractions")});
    return seems_per_cent ? 0.01 : 1;
}

/// Refuses uncertainties in another unit than the amounts, which state it in their cells or not at all.
/// @throws InputError
void require_scale_of_uncertainties(const Table& table, Scale amounts) {
    for (const Heading& heading : table.headings)
        if (heading.role == Role::uncertainty && heading.coverage.problem.empty() &&
            heading.scale != Scale::not_stated && heading.scale != amounts)
            refuse_line(table.heading_line,
                        "the uncertainties in column " + in_quotes(heading.written) +
                            " state another unit than that in which the amounts are read",
                        "the unit in the headings of both");
}

constexpr std::array factors{std::pair{Scale::fraction, 1.0}, std::pair{Scale::per_cent, 0.01},
                             std::pair{Scale::per_mille, 1e-3}, std::pair{Scale::ppm, 1e-6}};

/// The scale of a factor from scale_of().
Scale named_scale(double factor) {
    return std::ranges::find(factors, factor, &std::pair<Scale, double>::second)->first;
}

/// Factor from the number of an added standard to its weight fraction, by its unit or its size.
/// @param amounts that of the amounts @throws InputError for a number without a unit beside g/kg or ppm
double scale_of_standard(const PrintedNumber& number, const Heading& heading, double amounts) {
    const auto* const stated = std::ranges::find(factors, heading.scale, &std::pair<Scale, double>::first);
    if (stated != factors.end()) return stated->second;
    constexpr double per_cent = 0.01;
    if (!number.per_cent && amounts == per_cent && number.value < 1)
        throw InputError(fmt::format("the amount of the standard, {0}, may be {0} % or {1} %",
                                     readable_number(number.value), readable_number(100 * number.value)),
                         "a unit in the heading " + in_quotes(heading.written) + ": [wt%], [1]");
    if (!number.per_cent && amounts < per_cent)
        throw InputError("the amount of the standard, " + readable_number(number.value) +
                             ", may be in the unit of the amounts, or per cent or a fraction",
                         "a unit in the heading " + in_quotes(heading.written) + ": [wt%], [g/kg], [1]");
    return number.per_cent || number.value > 1 ? per_cent : 1;
}

/// Refuses a chemical analysis, whose oxides are no phases. @throws InputError
void refuse_oxides(const std::vector<Entry>& entries, std::size_t heading_line) {
    static const WordLists words("oxides");
    std::vector<std::string> oxides;
    std::size_t phases = 0;
    const std::string& sample = entries.front().sample;
    for (const Entry& entry : entries) {
        if (entry.sample != sample || meaning_of_row(entry.phase) != RowMeaning::phase) continue;
        ++phases;
        if (words.holds(entry.phase)) oxides.push_back(in_quotes(entry.phase));
    }
    const std::size_t fewest = oxides.size() == phases ? 2 : 3;
    if (oxides.size() < fewest || 2 * oxides.size() <= phases) return;
    const bool by_columns = entries.size() > 1 && entries[1].line == entries.front().line;
    refuse_line(by_columns ? heading_line : entries.front().line,
                joined(oxides) + " are oxides of a chemical analysis (XRF): they do not state the phases",
                "the phases of an XRD result under their names, such as quartz and hematite; the analysis as "
                "--oxides FILE (in a case \"oxides\")");
}

/// The entries of one sample, in the order of the file.
struct Group {
    std::string sample;
    std::vector<Entry> entries;
};

std::vector<Group> groups_of(std::vector<Entry> entries) {
    std::vector<Group> groups;
    std::map<std::string, std::size_t> places;
    for (Entry& entry : entries) {
        const auto [place, is_new] = places.emplace(entry.sample, groups.size());
        if (is_new) groups.push_back({.sample = entry.sample, .entries = {}});
        groups[place->second].entries.push_back(std::move(entry));
    }
    return groups;
}

/// "the sample" with its name, if the file gives one.
std::string sample_named(const std::string& sample) {
    return "the sample" + (sample.empty() ? "" : " " + in_quotes(sample));
}

/// Refuses a table that ends with a separator before its last amount: it was cut off. @throws InputError
void require_complete(const TextLines& file, const Table& table, const Entry& last) {
    if (!last.amount && last.mark == PhaseMark::none && file.text().back() == table.separator)
        refuse_line(last.line, "the last line stops before its amount: the file seems to be cut off",
                    "a complete table");
}

void refuse_repeated(const std::vector<Entry>& entries) {
    std::map<std::string, std::size_t> first;
    for (const Entry& entry : entries) {
        const auto [earlier, is_new] = first.emplace(phase_key(entry.phase), entry.line);
        if (!is_new)
            refuse_line(entry.line,
                        "the phase " + in_quotes(entry.phase) + " is there twice in " +
                            sample_named(entry.sample) + ", first in line " + std::to_string(earlier->second),
                        "each phase once in a sample");
    }
}

void check_total(double sum, double stated, const Entry& entry) {
    if (std::abs(sum - stated) > default_closure_tolerance)
        refuse_line(entry.line,
                    "the total of " + sample_named(entry.sample) + " is given as " + per_cent(stated) +
                        ", the phases above add up to " + per_cent(sum),
                    "the same within " + per_cent(default_closure_tolerance));
}

/// Fractions of one sample. A stated total is checked; a stated crystalline total gives the amorphous part.
/// @param blank_rows those that may head the rows below them
XrdSample sample_of_fractions(const Group& group, double scale, const BlankRows& blank_rows) {
    XrdSample sample{.name = group.sample};
    std::string whole;  // name of a crystalline total of 100 %
    double sum = 0;
    std::size_t in_total = 0;  // phases before the last total
    bool has_total = false;
    for (const Entry& entry : group.entries) {
        if (!entry.amount) {
            if (const auto row = blank_rows.find(entry.line); row != blank_rows.end())
                sample.analysis.blank_rows.push_back({.name = row->second, .place = at_line(entry.line)});
            sample.warnings.push_back(
                {xrd_code, Severity::remark,
                 fmt::format("{}{} has no amount (line {}{}) and is left out", in_quotes(entry.phase),
                             group.sample.empty() ? "" : " in " + in_quotes(group.sample), entry.line,
                             entry.without_number.empty() ? "" : ": " + in_quotes(entry.without_number))});
            continue;
        }
        const double fraction = entry.amount->value * scale;
        if (entry.mark == PhaseMark::not_detected && fraction > 0)
            refuse_line(
                entry.line,
                in_quotes(entry.phase) + " is called not detected, and its amount is " + per_cent(fraction),
                "one of the two");
        if (!(fraction >= 0 && fraction <= 1 + default_closure_tolerance))
            refuse_line(entry.line,
                        "the amount of " + in_quotes(entry.phase) +
                            (group.sample.empty() ? "" : " in " + in_quotes(group.sample)) + " is " +
                            per_cent(fraction),
                        "0 % to 100 %");
        auto uncertainty = entry.uncertainty ? entry.uncertainty : entry.amount->standard_uncertainty;
        if (uncertainty) *uncertainty *= scale;
        if (uncertainty && *uncertainty > fraction && fraction > 0.01)
            sample.warnings.push_back(
                {xrd_code, Severity::doubt,
                 fmt::format("the uncertainty of {} (line {}), {}, is above its amount, {}: is it one?",
                             in_quotes(entry.phase), entry.line, per_cent(*uncertainty),
                             per_cent(fraction))});
        const RowMeaning meaning = meaning_of_row(entry.phase);
        if (meaning == RowMeaning::total) {
            check_total(sum, fraction, entry);
            has_total = true;
            in_total = sample.analysis.phases.size();
            if (uncertainty)
                sample.warnings.push_back(
                    {xrd_code, Severity::remark, "the uncertainty of the total is not used"});
            continue;
        }
        if (meaning == RowMeaning::crystalline_total) {
            if (fraction > 0 && fraction <= 0.01 && !entry.amount->per_cent)
                refuse_line(entry.line,
                            fmt::format("{} is {}: it may be that in the unit of the table, or a fraction",
                                        in_quotes(entry.phase), shortest(entry.amount->value)),
                            "the same unit as that of the phases, or % in its cell");
            sample.analysis.amorphous =
                CrystallineTotal{.value = std::min(fraction, 1.0), .standard_uncertainty = uncertainty};
            if (fraction > 1 - default_closure_tolerance) whole = entry.phase;
            continue;
        }
        sum += fraction;
        if (sum > 1 + default_closure_tolerance && std::abs(sum - fraction - 1) <= default_closure_tolerance)
            refuse_line(entry.line,
                        "the fractions of " + sample_named(group.sample) + " add up to 100 % without " +
                            in_quotes(entry.phase) + ", and to " + per_cent(sum) + " with it",
                        "fractions of the whole sample; or those of its crystalline part alone, and the "
                        "amorphous fraction as --amorphous-fraction (in a case \"amorphous\")");
        if (sum > 1 + default_closure_tolerance)
            refuse_line(
                entry.line,
                "the fractions of " + sample_named(group.sample) + " add up to " + per_cent(sum) + " or more",
                "100 % or less");
        sample.analysis.phases.push_back({.name = entry.phase,
                                          .fraction = fraction,
                                          .standard_uncertainty = uncertainty,
                                          .density = entry.density,
                                          .place = at_line(entry.line),
                                          .is_standard = entry.mark == PhaseMark::standard});
    }
    for (std::size_t i = in_total; has_total && i < sample.analysis.phases.size(); ++i) {
        PhaseFraction& phase = sample.analysis.phases[i];
        phase.behind_total = phase.fraction > 0 && !phase.is_standard;
    }
    if (sample.analysis.phases.empty())
        refuse_line(group.entries.front().line, sample_named(group.sample) + " has no phase with an amount",
                    "at least one");
    if (!whole.empty() && std::abs(sum - 1) <= default_closure_tolerance) {  // it may be their sum
        sample.analysis.amorphous = AmorphousNotStated{};
        sample.analysis.of_crystalline_part = in_quotes(whole) + " of 100 %";
    }
    return sample;
}

/// Refuses numbers with which fractions would overflow. @throws InputError
void require_computable(const PeakIntensity& peak) {
    constexpr auto number = Dimension::fraction;
    require_not_negative("intensity of " + peak.name, peak.intensity, number);
    require_positive("rir of " + peak.name, peak.reference_intensity_ratio, number);
    require_not_negative("uncertainty of the intensity of " + peak.name,
                         peak.intensity_uncertainty.value_or(0), number);
    require_not_negative("uncertainty of the rir of " + peak.name, peak.ratio_uncertainty.value_or(0),
                         number);
}

XrdSample sample_of_peaks(const Group& group) {
    const auto in_per_cent = [](const Entry& entry) { return entry.intensity && entry.intensity->per_cent; };
    const auto mixed = std::ranges::count_if(group.entries, in_per_cent);
    if (mixed > 0 && mixed < std::ssize(group.entries))
        refuse_line(std::ranges::find_if(group.entries, in_per_cent)->line,
                    "some intensities are in % and others are not", "one unit for all");
    std::vector<PeakIntensity> peaks;
    for (const Entry& entry : group.entries) {
        if (!entry.intensity || !entry.ratio)
            refuse_line(entry.line, "intensity or rir of " + in_quotes(entry.phase) + " is missing",
                        "both numbers");
        if (!(entry.intensity->value >= 0) || !(entry.ratio->value > 0))
            refuse_line(entry.line, "intensity or rir of " + in_quotes(entry.phase) + " is out of range",
                        "intensity zero or more, rir above zero");
        peaks.push_back({.name = entry.phase,
                         .intensity = entry.intensity->value,
                         .reference_intensity_ratio = entry.ratio->value,
                         .intensity_uncertainty =
                             entry.uncertainty ? entry.uncertainty : entry.intensity->standard_uncertainty,
                         .ratio_uncertainty = entry.ratio_uncertainty ? entry.ratio_uncertainty
                                                                      : entry.ratio->standard_uncertainty});
        at_place(at_line(entry.line), [&] { require_computable(peaks.back()); });
    }
    return at_place(at_line(group.entries.front().line), [&] {
        XrdSample sample{.name = group.sample};
        sample.analysis.phases = adiabatic_fractions(peaks);
        for (std::size_t i = 0; i < peaks.size(); ++i) {
            sample.analysis.phases[i].density = group.entries[i].density;
            sample.analysis.phases[i].place = at_line(group.entries[i].line);
            sample.analysis.phases[i].is_standard = group.entries[i].mark == PhaseMark::standard;
        }
        return sample;
    });
}

/// Rescales a sample that contains an internal standard, a phase whose weight in the mixture is known.
/// @param amounts their factor, from scale_of()
XrdSample standardised(const XrdSample& sample, const Group& group, const Table& table, double amounts) {
    const Entry* standard = nullptr;
    for (const Entry& entry : group.entries) {
        if (!entry.standard) continue;
        if (standard)
            refuse_line(entry.line,
                        "there are two internal standards, " + in_quotes(standard->phase) + " and " +
                            in_quotes(entry.phase),
                        "one a sample");
        standard = &entry;
    }
    if (!standard) return sample;
    return at_place(at_line(standard->line), [&] {
        const double scale =
            scale_of_standard(*standard->standard, table.headings[*table.column(Role::standard)], amounts);
        auto uncertainty = standard->standard->standard_uncertainty;
        if (uncertainty) *uncertainty *= scale;
        return with_internal_standard(sample, standard->phase, standard->standard->value * scale,
                                      uncertainty);
    });
}

/// Whether a layout does not use a column, other than one without a heading.
bool is_ignored(const Heading& heading, Layout layout) {
    const Role role = heading.role;
    if (layout == Layout::one_column_a_phase) return stands_beside(heading);
    if (layout == Layout::one_column_a_sample) return stands_beside(heading) && role != Role::density;
    const bool peaks = role == Role::intensity || role == Role::ratio || role == Role::ratio_uncertainty;
    return role == Role::other || role == Role::measure || (layout == Layout::fractions && peaks);
}

/// Remarks on what headings leave open: whether a word is a sample, and which intensities they are.
void note_readings(const Table& table, Layout layout, std::vector<Finding>& warnings) {
    const auto is_sample = [](const Heading& heading) {
        return heading.role == Role::other && !heading.text.empty();
    };
    const auto found = std::ranges::find_if(table.headings, is_sample);
    const bool is_word = found != table.headings.end() && found->states == HeadingUnit::fraction &&
                         found->text.find_first_of("0123456789") == std::string::npos;
    if (layout == Layout::one_column_a_sample && is_word &&
        std::ranges::count_if(table.headings, is_sample) == 1)
        warnings.push_back({xrd_code, Severity::remark,
                            "the column " + in_quotes(found->written) + " is taken as the sample " +
                                in_quotes(found->text) + ", in % by weight"});
    if (layout != Layout::peaks) return;
    static const WordLists units("units of intensities", "%");
    for (const auto& [role, taken_as] : {std::pair{Role::intensity, "net intensities of the strongest peaks"},
                                         {Role::ratio, "reference intensity ratios, I/Ic"}}) {
        const auto column = table.column(role);
        if (!column) continue;
        const std::string& written = table.headings[*column].written;
        const auto open = written.find_first_of("([");
        if (open == std::string::npos) continue;
        const auto close = std::min(written.find_first_of(")]", open), written.size());
        if (!units.holds(written.substr(open + 1, close - open - 1)) || close + 1 < written.size())
            warnings.push_back({xrd_code, Severity::remark,
                                "the column " + in_quotes(written) + " is taken as " + taken_as});
    }
}

void warn_of_ignored(const Table& table, Layout layout, std::vector<Finding>& warnings) {
    for (std::size_t k = 0; k < table.headings.size(); ++k) {
        const Heading& heading = table.headings[k];
        std::string column;
        if (!heading.text.empty() && is_ignored(heading, layout)) column = in_quotes(heading.written);
        const bool nameless = heading.text.empty() && heading.role == Role::other;
        if (nameless &&
            std::ranges::any_of(table.rows, [&](const TableRow& row) { return !row.cells[k].empty(); }))
            column = std::to_string(k + 1) + ", which has no heading,";
        if (column.empty()) continue;
        const std::vector<std::string> texts = texts_in_column(table.rows, k);
        warnings.push_back(
            {xrd_code, Severity::remark,
             "column " + column + " is not used" + (texts.empty() ? "" : ": " + joined(texts))});
    }
}

/// Fractions of the crystalline part, scaled to 1. @throws InputError where more than rounding is missing
void take_crystalline_part(XrdSample& sample, const std::string& stated_by) {
    double sum = 0;
    for (const PhaseFraction& phase : sample.analysis.phases) sum += phase.fraction;
    constexpr double rounding = 0.02;  // of some whole per cent
    if (std::abs(sum - 1) > rounding)
        throw InputError("the fractions of the crystalline part add up to " + per_cent(sum) +
                             ": a phase may be missing, or they be of the whole sample",
                         "100 % within 2 %, or a file without \"crystalline\" in " + stated_by)
            .at(sample.analysis.phases.back().place);
    normalise(sample.analysis.phases, sum);
    sample.analysis.of_crystalline_part = stated_by;
    constexpr double shown = 5e-4;
    sample.warnings.push_back(
        {xrd_code, Severity::remark,
         "the fractions are those of the crystalline part, as " + stated_by +
             " states: an amorphous part is not among them" +
             (std::abs(sum - 1) > shown ? "; they are scaled from " + per_cent(sum) : "")});
}

/// A remark on samples whose names may state more than a sample, such as a basis or a coverage in words that
/// are not known: "FA1 particle %", "FA1 (alpha = 0.05)", and on those without a unit beside others with one.
std::optional<Finding> names_alone(const std::vector<XrdSample>& samples, const Table& table, bool volumes) {
    const auto has_unit = [](const Heading& heading) {
        return heading.role == Role::other && !heading.unit.empty();
    };
    const bool any_unit = std::ranges::any_of(table.headings, has_unit);
    const bool divided = std::ranges::any_of(
        table.headings, [](const Heading& heading) { return heading.coverage.factor != 1; });
    const auto is_alone = [&](const XrdSample& sample) {
        const auto heading = std::ranges::find(table.headings, sample.name, &Heading::text);
        const bool is_column = heading != table.headings.end() && heading->role == Role::other;
        return may_state_more(sample.name) ||
               (is_column &&
                (heading->written.find('#') != std::string::npos || (any_unit && !has_unit(*heading))));
    };
    std::vector<std::string> names;
    for (const XrdSample& sample : samples)
        if (is_alone(sample)) names.push_back(sample.name);
    return names_not_read(xrd_code, std::move(names),
                          std::string("the amounts count by ") + (volumes ? "volume" : "weight") +
                              (divided ? "" : ", the uncertainties as standard ones"));
}

/// A remark on names of phases that state an amount: "Corundum (added 20 %)".
std::optional<Finding> amounts_in_names(const Table& table) {
    std::vector<std::string> names;
    const auto take = [&](const std::string& name) {
        if (name.find('%') != std::string::npos && std::ranges::any_of(name, is_digit))
            names.push_back(in_quotes(name));
    };
    if (const auto label = table.column(Role::phase))
        for (const TableRow& row : table.rows) take(row.cells[*label]);
    else
        for (const Heading& heading : table.headings) take(heading.text);
    if (names.empty()) return std::nullopt;
    return Finding{xrd_code, Severity::remark, "the amounts in these names are not read: " + joined(names)};
}

/// What the columns of a table of fractions or peaks are taken as.
/// @param scale of the amounts to fractions @param in_cells whether cells hold uncertainties
std::string reading_of(const Table& table, Layout layout, bool volumes, double scale, bool in_cells,
                       std::size_t samples) {
    static constexpr std::array units{"in parts of 1", "in %", "in parts per thousand",
                                      "in ppm"};  // by factors
    const auto unit = static_cast<std::size_t>(
        std::ranges::find(factors, scale, &std::pair<Scale, double>::second) - factors.begin());
    const bool peaks = layout == Layout::peaks;
    const std::string amounts =
        fmt::format("amounts by {}, {}", volumes ? "volume" : "weight", units.at(unit));
    TableReading reading;
    reading.add(counted(samples, "sample"));
    const Heading* before = nullptr;  // the last with amounts
    for (const Heading& heading : table.headings) {
        const bool is_amount =
            layout == Layout::fractions
                ? heading.role == Role::weight || heading.role == Role::volume
                : !peaks && heading.role == Role::other && !heading.text.empty() && !heading.sums_up;
        if (is_amount) {
            const double coverage = heading.coverage.factor;
            reading.take(amounts, heading.written,
                         coverage == 1 ? "" : " (uncertainties" + divided_by(coverage) + ")");
            before = &heading;
        } else if (heading.role == Role::phase || heading.role == Role::sample) {
            reading.take(heading.role == Role::phase ? "phases" : "samples", heading.written);
        } else if (heading.role == Role::uncertainty && heading.coverage.problem.empty() &&
                   !heading.sums_up) {
            const bool of_one = !peaks && before != nullptr && before->written != heading.written;
            reading.take(
                "standard uncertainties", heading.written,
                (of_one ? " of " + in_quotes(before->written) : "") + divided_by(heading.coverage.factor));
        } else if (heading.role == Role::density && layout != Layout::one_column_a_phase) {
            reading.take("densities", heading.written);
        } else if (heading.role == Role::standard) {
            reading.take("weight of the internal standard", heading.written);
        } else if (peaks && heading.role == Role::intensity) {
            reading.take("net intensities", heading.written);
        } else if (peaks && heading.role == Role::ratio) {
            reading.take("reference intensity ratios", heading.written);
        } else if (peaks && heading.role == Role::ratio_uncertainty) {
            reading.take("standard uncertainties of the ratios", heading.written,
                         divided_by(heading.coverage.factor));
        }
    }
    if (in_cells) reading.add("standard uncertainties in the cells or in rows");
    return reading.text();
}

/// A remark on the name of a sheet, unless it is one that spreadsheets give.
std::optional<Finding> sheet_not_read(const std::vector<TextBeside>& texts) {
    static const WordLists words("names of sheets");
    for (const TextBeside& text : texts) {
        if (!text.text.starts_with(sheet_name_mark)) continue;
        const std::string name = text.text.substr(sheet_name_mark.size());
        const std::string word(trimmed(name.substr(0, name.find_first_of("0123456789"))));
        if (!words.holds(word))
            return Finding{xrd_code, Severity::remark,
                           "the name of the sheet, " + in_quotes(name) + ", is not read"};
    }
    return std::nullopt;
}

}  // namespace

XrdResult read_table(const TextLines& file, std::optional<DecimalMark> decimal) {
    const Table table = parse_table(file, decimal);
    const Layout layout = layout_of(table);
    const bool volumes = layout != Layout::peaks && by_volume(table, layout);
    XrdResult result{.format = XrdFormat::table, .samples = {}, .warnings = table.warnings};
    std::vector<Entry> entries = entries_of(table, layout);
    for (Finding& each : table.marks.findings(xrd_code)) result.warnings.push_back(std::move(each));
    if (layout == Layout::fractions) require_complete(file, table, entries.back());
    if (std::ranges::any_of(entries, &Entry::uncertainty_in_per_cent))
        result.warnings.push_back(uncertainties_in_per_cent(xrd_code));
    const double scale = layout == Layout::peaks ? 1 : scale_of(table, entries, result.warnings);
    if (layout != Layout::peaks) require_scale_of_uncertainties(table, named_scale(scale));
    constexpr double of_per_cent = 0.01;
    const auto states_scale = [](const Heading& heading) {
        return heading.role == Role::uncertainty && heading.scale != Scale::not_stated;
    };
    SmallUncertainties small;
    if (layout != Layout::peaks && scale == of_per_cent && !std::ranges::any_of(table.headings, states_scale))
        for (const Entry& entry : entries)
            if (entry.amount && entry.uncertainty && !entry.uncertainty_in_per_cent)
                small.take(entry.amount->value, shortest(*entry.uncertainty), *entry.uncertainty);
    if (const auto doubt = small.finding(xrd_code)) result.warnings.push_back(*doubt);
    if (layout != Layout::peaks) {
        std::vector<TextBeside> texts = table.texts;
        if (const auto label = table.column(Role::sample))
            for (const TableRow& row : table.rows) texts.push_back({row.line, row.cells[*label], true});
        require_scale(texts, {named_scale(scale)});
    }
    warn_of_ignored(table, layout, result.warnings);
    note_readings(table, layout, result.warnings);
    refuse_oxides(entries, table.heading_line);
    const bool in_cells = std::ranges::any_of(entries, [](const Entry& entry) {
        return (entry.amount && entry.amount->standard_uncertainty) ||
               (entry.intensity && entry.intensity->standard_uncertainty);
    });
    for (const Group& group : groups_of(std::move(entries))) {
        refuse_repeated(group.entries);
        XrdSample sample = layout == Layout::peaks ? sample_of_peaks(group)
                                                   : sample_of_fractions(group, scale, table.blank_rows);
        if (volumes) sample.analysis.basis = FractionBasis::volume;
        if (!table.crystalline.empty()) take_crystalline_part(sample, table.crystalline);
        constexpr double not_stated = of_per_cent;  // of peaks: a number below 1 has two readings
        result.samples.push_back(
            standardised(sample, group, table, layout == Layout::peaks ? not_stated : scale));
    }
    result.reading = reading_of(table, layout, volumes, scale, in_cells, result.samples.size());
    for (auto& remark :
         {names_alone(result.samples, table, volumes), amounts_in_names(table), sheet_not_read(table.texts)})
        if (remark) result.warnings.push_back(*remark);
    std::vector<NamedSum> sums;
    if (layout == Layout::fractions || layout == Layout::peaks) return result;  // a column names the samples
    for (const XrdSample& sample : result.samples) {
        sums.push_back({sample.name, 0});
        for (const PhaseFraction& phase : sample.analysis.phases) sums.back().sum += phase.fraction;
    }
    const auto namesakes = small_namesakes(xrd_code, sums);
    for (std::size_t i = 0; i < namesakes.size(); ++i)
        if (namesakes[i]) result.samples[i].warnings.push_back(*namesakes[i]);
    return result;
}

}  // namespace ashimpact::xrd
