// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/run_identity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/json/writer.hpp"
#include "core/quantities/checks.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "core/version.hpp"
#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

constexpr auto run_key = "run";
constexpr auto result_key = "result_sha256";

bool is_quantity(const Json& node) {
    return node.is_object() && node.contains("value") && node["value"].is_number() && node.contains("unit") &&
           node["unit"].is_string();
}

std::string text_of(const Json& quantity) {
    return shortest(quantity.at("value").get<double>()) + " " + quantity.at("unit").get<std::string>();
}

/// Refuses a quantity that no computation can have written.
void require_possible(const Json& quantity, const std::string& pointer) {
    constexpr std::array not_negative{"m", "m/s", "kg", "s", "Pa", "kg/m3", "J/m2"};
    const double value = quantity.at("value").get<double>();
    const bool is_signed =
        std::find(not_negative.begin(), not_negative.end(), quantity["unit"]) == not_negative.end();
    const auto refuse = [&](const char* allowed) {
        throw InputError("is " + text_of(quantity), allowed).at(child_pointer(pointer, "value"));
    };
    if (!std::isfinite(value) || std::abs(value) > 1e40) refuse("a number up to 1e40");
    if (value < 0 && !is_signed) refuse("0 or more");
}

/// Refuses a quantity outside of its interval. An end that is null is no bound.
void require_inside(const Json& quantity, const Json& interval, const std::string& pointer) {
    if (!is_quantity(quantity) || !interval.is_object()) return;
    for (const char* key : {"lower", "upper"}) {
        const Json end = interval.value(key, Json());
        if (!is_quantity(end)) continue;
        const double beyond = quantity["value"].get<double>() - end["value"].get<double>();
        if (end["unit"] == quantity["unit"] && !(key == std::string_view("lower") ? beyond < 0 : beyond > 0))
            continue;
        throw InputError("is " + text_of(quantity) + ", outside of its interval",
                         std::string(key) + " end " + text_of(end) + "; edit or remove the interval as well")
            .at(pointer);
    }
}

/// Checks the quantities of a part of a result. The interval of a quantity is inside of it, or beside it
/// under "interval" or the name of the quantity with "_interval".
void require_possible_part(const Json& node, const std::string& pointer) {
    if (is_quantity(node)) {
        require_possible(node, pointer);
        require_inside(node, node.value("interval", Json()), pointer);
    }
    if (!node.is_structured()) return;
    for (const auto& [key, member] : node.items()) {
        const std::string place = child_pointer(pointer, key);
        require_possible_part(member, place);
        if (!node.is_object()) continue;
        require_inside(member, node.value(key + "_interval", Json()), place);
        if (key == "critical_velocity") require_inside(member, node.value("interval", Json()), place);
    }
}

}  // namespace

std::string run_identity(const Json& case_result, const Json& inputs) {
    std::string told = std::string(program_version()) + "\n" + std::string(program_revision()) + "\n";
    for (const Json& input : inputs) told += input.at("sha256").get<std::string>() + "\n";
    return sha256(told + case_result.dump());
}

void seal(Json& document, const std::string& run) {
    Json& provenance = document["provenance"];
    provenance[run_key] = run;
    provenance[result_key] = sha256(parse_json(write_json(document["result"])).dump());  // as it will be read
}

std::string run_of(const Json& document) {
    const Json& provenance = document.at("provenance");
    if (!provenance.contains(run_key))
        throw InputError("\"run\" is missing: the artifact of no run", "an artifact as ashimpact wrote it")
            .at("/provenance");
    return provenance[run_key].get<std::string>();
}

bool is_edited(const Json& document) {
    const Json& provenance = document.at("provenance");
    return !provenance.contains(result_key) || provenance[result_key] != sha256(document.at("result").dump());
}

void require_one_run(const std::vector<Artifact>& artifacts) {
    for (const Artifact& artifact : artifacts) {
        const Artifact& first = artifacts.front();
        const std::string& place = artifact.place.empty() ? artifact.file : artifact.place;
        if (at_place(FileName{place}, [&] { return run_of(artifact.document); }) == run_of(first.document))
            continue;
        throw InputError("is of another run than " + first.file + " beside it",
                         "artifacts of one run; `ashimpact run` with the case writes all of them anew")
            .at(FileName{place});
    }
}

void require_possible_result(const Json& document) {
    require_possible_part(document.at("result"), "/result");
}

std::vector<std::string> outdated(const std::vector<Artifact>& artifacts) {
    std::vector<std::string> told;
    for (const Artifact& artifact : artifacts)
        for (const Json& input : artifact.document.at("provenance").at("inputs"))
            for (const Artifact& other : artifacts)
                if (other.file == input.at("file") && sha256(other.bytes) != input.at("sha256"))
                    told.push_back(artifact.file + " was computed from another " + other.file +
                                   " than the one beside it");
    return told;
}

}  // namespace ashimpact
