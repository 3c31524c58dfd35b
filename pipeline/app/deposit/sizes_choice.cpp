// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/deposit/sizes_choice.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/plausibility.hpp"
#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/units/units.hpp"
#include "pipeline/files/file.hpp"

namespace ashimpact {

namespace {

constexpr auto sizes_option = "--sizes";

std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts;
    for (;;) {
        const auto comma = text.find(',');
        parts.emplace_back(trimmed(text.substr(0, comma)));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

/// A diameter [m], with the doubt about one that no particle of ash has.
double size_of(const std::string& text, std::vector<Finding>& notes) {
    const double size = parse_quantity(text, Dimension::length);
    if (!(size > 0)) throw InputError("the size is " + in_quotes(text), "a positive length");
    if (const auto doubt = implausible(*plausible_range("diameter"), {size, whole_decimal(text)}))
        notes.push_back(*doubt);
    return size;
}

double number_of(const std::string& text, double least, double most, const char* name) {
    const auto number = whole_decimal(text);
    if (!number || *number < least || *number > most)
        throw InputError(fmt::format("the {} is {}", name, in_quotes(text)),
                         fmt::format("a number from {:g} to {:g}", least, most));
    return *number;
}

void require_parts(const std::vector<std::string>& parts, std::size_t least, std::size_t most,
                   const char* form) {
    if (parts.size() < least || parts.size() > most)
        throw InputError(counted(parts.size(), "value") + (parts.size() == 1 ? " is given" : " are given"),
                         form);
}

SizesChoice named_sizes(const std::string& name, const std::vector<std::string>& parts) {
    SizesChoice choice;
    if (name == "rosinrammler") {
        require_parts(parts, 2, 2,
                      "\"rosin-rammler: 20 um, 1.2\", the size above which 36.8 % are, and the exponent");
        const double scale = size_of(parts[0], choice.notes);
        const double exponent = number_of(parts[1], 0.3, 20, "exponent");
        choice.sizes = ParticleSizes::rosin_rammler(scale, exponent);
        choice.words = fmt::format("Rosin-Rammler by mass, 63.2 % finer than {}, exponent {:g}",
                                   readable(scale, "m"), exponent);
        return choice;
    }
    if (name != "lognormal") throw InputError("no distribution is called " + in_quotes(name), sizes_forms);
    require_parts(parts, 2, 3, "\"log-normal: 20 um, 1.8\", median and geometric standard deviation");
    const double median = size_of(parts[0], choice.notes);
    const double deviation = number_of(parts[1], 1.01, 10, "geometric standard deviation");
    const bool by_number = parts.size() == 3 && parts[2] == "number";
    if (parts.size() == 3 && !by_number && parts[2] != "mass")
        throw InputError("the basis is " + in_quotes(parts[2]), "mass, number");
    choice.sizes = ParticleSizes::log_normal(by_number ? mass_median(median, deviation) : median, deviation);
    choice.words = fmt::format("log-normal, median {} by {}, geometric standard deviation {:g}",
                               readable(median, "m"), by_number ? "number" : "mass", deviation);
    return choice;
}

}  // namespace

SizesChoice read_sizes(const std::string& spec, const TableOptions& options) {
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(spec, ignored);
    const std::string ending = lower_case(std::filesystem::path(spec).extension().string());
    if (is_file || ending == ".csv" || ending == ".tsv" || ending == ".txt" || ending == ".xlsx" ||
        ending == ".ods") {
        SizesChoice choice{.words = "sieve table " + spec};
        const std::string bytes = read_file(spec);
        choice.file = InputFile{spec, sha256(bytes)};
        SieveResult table = at_place(FileName{spec}, [&] { return read_sieve_table(bytes, options); });
        choice.sizes = std::move(table.sizes);
        choice.notes = std::move(table.notes);
        choice.reading = std::move(table.reading);
        return choice;
    }
    if (!options.sheet.empty() || options.decimal)
        throw InputError("belongs to a sieve table", "--sizes FILE")
            .at(options.sheet.empty() ? "--decimal" : "--sheet");
    return at_place(sizes_option, [&] {
        const auto colon = spec.find(':');
        if (colon != std::string::npos)
            return named_sizes(word_key(spec.substr(0, colon)), parts_of(spec.substr(colon + 1)));
        SizesChoice choice;
        const bool starts_as_number =
            !spec.empty() && (is_digit(spec[0]) || spec[0] == '.' || spec[0] == '-');
        if (!starts_as_number) throw InputError("cannot read " + in_quotes(spec), sizes_forms);
        const double size = size_of(spec, choice.notes);
        choice.sizes = ParticleSizes::one(size);
        choice.words = "all of " + readable(size, "m");
        return choice;
    });
}

}  // namespace ashimpact
