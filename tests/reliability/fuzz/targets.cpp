// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include <zlib.h>

#include "core/tables/text_lines.hpp"
#include "core/tables/workbook/workbook.hpp"
#include "core/text/error.hpp"
#include "core/units/units.hpp"
#include "materials/xrd/readers.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/sweep/block.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/files/schema.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "solver/batch/batch.hpp"
#include "solver/inference/impacts/measurement.hpp"

namespace ashimpact::test {

namespace {

/// A promise that was broken: no InputError, so a finding.
void require(bool holds, const char* promise) {
    if (!holds) throw std::logic_error(promise);
}

void feed_case(std::string_view bytes) {
    const Json document = parse_json(bytes);
    validate_document(document, "case");
    InputFiles files = InputFiles::built_in("cases/example/case.json");  // no file of this machine
    static_cast<void>(read_case(View(document), built_in_phases(), files));
}

void check_xrd(const XrdResult& result) {
    require(!result.samples.empty(), "a result has a sample");
    const auto nameless = [](const XrdSample& sample) { return sample.name.empty(); };
    require(std::count_if(result.samples.begin(), result.samples.end(), nameless) <= 1,
            "of several samples one at most takes the name of the file");
    for (const XrdSample& sample : result.samples)
        for (const PhaseFraction& phase : sample.analysis.phases) {
            require(phase.fraction >= 0.0 && std::isfinite(phase.fraction), "a fraction is zero or more");
            require(!phase.standard_uncertainty ||
                        (*phase.standard_uncertainty >= 0.0 && std::isfinite(*phase.standard_uncertainty)),
                    "an uncertainty is zero or more");
        }
}

constexpr TextLimits limits{};

/// A reader gets what it takes for its own.
template <bool (*recognises)(const TextLines&), XrdResult (*read)(const TextLines&)>
void feed_reader(std::string_view bytes) {
    const TextLines file(bytes, limits);
    if (recognises(file)) check_xrd(read(file));
}

/// A file of an archive.
struct ZipMember {
    std::string_view name;
    std::string_view content;
};

/// Appends the lowest bytes of a number, lowest first.
void append(std::string& bytes, std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i, number >>= 8U) bytes += static_cast<char>(number & 0xFFU);
}

/// What a member's header and its entry in the directory have in common (PKWARE's APPNOTE, 4.3.7 and 4.3.12).
std::string description_of(const ZipMember& member) {
    std::string bytes;
    append(bytes, 20, 2);         // version needed: 2.0
    append(bytes, 0, 2 + 2 + 4);  // flags, method: stored, time and date
    append(bytes,
           crc32(0, reinterpret_cast<const Bytef*>(member.content.data()),
                 static_cast<uInt>(member.content.size())),
           4);
    append(bytes, member.content.size(), 4);  // as it is stored
    append(bytes, member.content.size(), 4);  // as it is unpacked
    append(bytes, member.name.size(), 2);
    append(bytes, 0, 2);  // no extra field
    return bytes;
}

/// A zip archive of these members, not compressed: bytes of a member are bytes of the archive.
std::string stored_zip(const std::vector<ZipMember>& members) {
    std::string bytes, directory;
    for (const ZipMember& member : members) {
        const std::string description = description_of(member);
        directory += "PK\1\2";
        append(directory, 20, 2);  // version of the writer
        directory += description;
        append(directory, 0, 2 + 2 + 2 + 4);  // no comment, first disk, attributes
        append(directory, bytes.size(), 4);
        directory += member.name;
        bytes += "PK\3\4";
        bytes += description;
        bytes += member.name;
        bytes += member.content;
    }
    const std::size_t begin = bytes.size();
    bytes += directory;
    bytes += "PK\5\6";
    append(bytes, 0, 2 + 2);  // one disk
    append(bytes, members.size(), 2);
    append(bytes, members.size(), 2);
    append(bytes, directory.size(), 4);
    append(bytes, begin, 4);
    append(bytes, 0, 2);  // no comment
    return bytes;
}

/// The parts of a spreadsheet, uncompressed: "o" and the content of an .ods, or any other byte and the sheet,
/// the styles and the strings of an .xlsx with a NUL between them.
std::string workbook_from(std::string_view bytes) {
    if (bytes.starts_with('o')) return stored_zip({{"content.xml", bytes.substr(1)}});
    std::array<std::string_view, 3> parts;
    bytes.remove_prefix(std::min<std::size_t>(1, bytes.size()));
    for (std::string_view& part : parts) {
        part = bytes.substr(0, bytes.find('\0'));
        bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
    }
    static const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";
    static const std::string root = "<Relationships><Relationship Id='r' Type='" + office +
                                    "officeDocument' Target='xl/workbook.xml'/></Relationships>";
    static const std::string relations =
        "<Relationships><Relationship Id='a' Type='" + office + "worksheet' Target='worksheets/s.xml'/>" +
        "<Relationship Id='b' Type='" + office + "styles' Target='styles.xml'/>" +
        "<Relationship Id='c' Type='" + office + "sharedStrings' Target='strings.xml'/></Relationships>";
    return stored_zip(
        {{"_rels/.rels", root},
         {"xl/workbook.xml",
          "<workbook xmlns:r='x'><sheets><sheet name='S' sheetId='1' r:id='a'/></sheets></workbook>"},
         {"xl/_rels/workbook.xml.rels", relations},
         {"xl/worksheets/s.xml", parts[0]},
         {"xl/styles.xml", parts[1]},
         {"xl/strings.xml", parts[2]}});
}

void feed_workbook(std::string_view bytes) {
    const std::string archive = workbook_from(bytes);
    require(is_workbook(archive), "a zip archive is taken for a spreadsheet");
    for (const Sheet& sheet : read_workbook(archive)) static_cast<void>(sheet.as_text());
    check_xrd(read_xrd(archive, "input"));
}

void feed_artifact(std::string_view bytes) {
    Json document = parse_json(bytes);
    const std::string schema =
        document.is_object() && document.contains("schema") && document["schema"].is_string()
            ? document["schema"].get<std::string>()
            : "3-analytic";
    validate_document(document, schema);
    if (schema == "case" || schema == "sweep" || schema == "published") return;
    if (is_edited(document)) require_possible_result(document);
    require(!artifact_text(document).empty(), "an artifact has a text");
}

void feed_sweep(std::string_view bytes) {
    const SweepPlan plan{std::string(bytes)};
    require(plan.points_in(0) > 0 && plan.chunks() > 0, "a sweep has points");
}

void feed_quantity(std::string_view bytes) {
    if (bytes.empty()) return;
    const auto dimension = static_cast<Dimension>(static_cast<unsigned char>(bytes.front()) % 13);
    require(std::isfinite(parse_quantity(bytes.substr(1), dimension)), "a quantity is finite");
}

/// Numbers for an impact from bytes: exponents within 16 decades around those of ash, any digits.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] std::size_t below(std::size_t count) { return next() % count; }
    [[nodiscard]] double around(double value) {
        const double digits = (next() * 256.0 + next()) / 65536.0;
        return value * std::pow(10.0, 16.0 * (next() / 255.0 - 0.5) + digits);
    }

  private:
    unsigned next() {
        if (at_ == bytes_.size()) return 128;
        return static_cast<unsigned char>(bytes_[at_++]);
    }
    std::string_view bytes_;
    std::size_t at_ = 0;
};

Impact impact_from(std::string_view bytes) {
    Numbers numbers(bytes);
    const Law law = Law::at(numbers.below(Law::count()));
    const auto detachment = all_values<Detachment>[numbers.below(all_values<Detachment>.size())];
    const auto damping_law = all_values<DampingLaw>[numbers.below(all_values<DampingLaw>.size())];
    const bool damped = numbers.below(4) != 0;
    const bool adhesive = numbers.below(4) != 0;
    return {.law = law,
            .detachment = detachment,
            .damping = {damping_law,
                        damped ? numbers.around(damping_law == DampingLaw::tsuji ? 0.3 : 0.01) : 0.0},
            .contact = {.mass = numbers.around(1e-9),
                        .effective_radius = numbers.around(44e-6),
                        .contact_modulus = numbers.around(90e9),
                        .work_of_adhesion = adhesive ? numbers.around(0.3) : 0.0,
                        .yield_pressure = numbers.around(1e9)},
            .velocity = numbers.around(1.0)};
}

void feed_solver(std::string_view bytes) {
    const Impact impact = impact_from(bytes);
    const ImpactResult alone = solve_impact(impact);
    require(alone.restitution >= 0.0 && alone.restitution <= 1.0, "0 <= e <= 1");
    require((alone.outcome == Outcome::rebound) == (alone.restitution > 0.0), "a rebound has a restitution");
    require(!alone.contact_time || *alone.contact_time > 0.0, "a contact takes time");
    const ImpactBatchResult with_turn = solve_impacts(ImpactList({impact}).batch());
    const ImpactBatchResult without = solve_impacts(ImpactList({impact}).batch(), {.turning_point = false});
    const double conditioning = 1.0 + std::abs(alone.energy.minimum) / alone.energy.incident;
    const double difference = std::abs(std::pow(without.restitution[0], 2) - std::pow(alone.restitution, 2));
    require(difference <= 2e-12 * conditioning, "the batch agrees with the scalar solver");
    require(with_turn.restitution[0] == without.restitution[0], "asking for more changes nothing");
    require(std::abs(with_turn.maximum_overlap[0] / alone.maximum_overlap - 1.0) <= 1e-8, "overlaps agree");
}

XrdResult read_undecided_table(const TextLines& file) {
    return xrd::read_table(file, std::nullopt);
}

}  // namespace

const std::map<std::string, FuzzTarget>& fuzz_targets() {
    static const std::map<std::string, FuzzTarget> targets{
        {"case", feed_case},
        {"xrd-bgmn", feed_reader<xrd::looks_like_bgmn, xrd::read_bgmn>},
        {"xrd-gsas2", feed_reader<xrd::looks_like_gsas2, xrd::read_gsas2>},
        {"xrd-fullprof", feed_reader<xrd::looks_like_fullprof, xrd::read_fullprof>},
        {"xrd-topas", feed_reader<xrd::looks_like_topas, xrd::read_topas>},
        {"xrd-table", feed_reader<xrd::looks_like_table, read_undecided_table>},
        {"xrd-json", feed_reader<xrd::looks_like_json, xrd::read_json>},
        {"xrd", [](std::string_view bytes) { check_xrd(read_xrd(bytes, "input")); }},
        {"workbook", feed_workbook},
        {"impacts", [](std::string_view bytes) { static_cast<void>(read_measurements(bytes, "input")); }},
        {"artifact", feed_artifact},
        {"sweep", feed_sweep},
        {"quantity", feed_quantity},
        {"solver", feed_solver},
    };
    return targets;
}

void feed(const FuzzTarget& target, std::string_view bytes) {
    try {
        target(bytes);
    } catch (const InputError& error) {
        require(std::strlen(error.what()) > 0, "a refusal says why");
        require(error.problem().find('\n') == std::string::npos, "a refusal is one line");
    } catch (const ConvergenceError&) {
        return;
    }
}

}  // namespace ashimpact::test
