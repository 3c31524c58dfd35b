// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document/run_identity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/checks.hpp"
#include "core/error.hpp"
#include "core/json/writer.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/files/sha256.hpp"

namespace ashimpact {

namespace {

constexpr auto run_key = "run";
constexpr auto result_key = "result_sha256";
constexpr auto intervals_key = "intervals";
constexpr auto originals_key = "originals";

/// Calls @p visit with every object of a document and its pointer.
void for_each_object(Json& node, const std::string& pointer,
                     const std::function<void(Json&, const std::string&)>& visit) {
    if (node.is_object()) {
        visit(node, pointer);
        for (auto& [key, member] : node.items()) for_each_object(member, child_pointer(pointer, key), visit);
    } else if (node.is_array()) {
        for (std::size_t i = 0; i < node.size(); ++i)
            for_each_object(node[i], child_pointer(pointer, std::to_string(i)), visit);
    }
}

/// The number of a quantity; null where there is none.
Json number_of(const Json& quantity) {
    if (quantity.is_number()) return quantity;
    return quantity.is_object() && quantity.contains("value") && quantity["value"].is_number()
               ? quantity["value"]
               : Json(nullptr);
}

/// The value that an interval beside it is of: a quantity with its interval inside, or a critical velocity
/// with the interval next to it; null where there is none.
Json value_beside_interval(const Json& object) {
    if (!object.contains("interval") || !object["interval"].is_object()) return nullptr;
    if (object.contains("value")) return number_of(object);
    return object.contains("critical_velocity") ? number_of(object["critical_velocity"]) : Json(nullptr);
}

/// Whether an interval holds a value; an end that is not there is no bound.
bool holds(const Json& interval, double value) {
    const auto end = [&](const char* key) {
        return interval.contains(key) ? number_of(interval[key]) : Json(nullptr);
    };
    const Json lower = end("lower");
    const Json upper = end("upper");
    return (lower.is_null() || lower.get<double>() <= value) &&
           (upper.is_null() || value <= upper.get<double>());
}

/// What was written of the value at a pointer; null if nothing.
Json recorded(const Json& provenance, const std::string& pointer) {
    if (!provenance.contains(intervals_key)) return nullptr;
    for (const Json& entry : provenance[intervals_key])
        if (entry.at("at") == pointer) return entry;
    return nullptr;
}

/// Takes an interval away. Inside a quantity its ends go; beside one it goes whole, and with it the verdict
/// of a check that was made with it.
void drop_interval(Json& object) {
    if (object.contains("value")) {
        for (const char* end : {"lower", "upper"}) object["interval"][end] = nullptr;
        return;
    }
    object["interval"] = nullptr;
    if (object.contains("check")) object["check"] = nullptr;
}

/// Refuses a quantity of a result that no computation can have written.
void require_possible(const Json& object, const std::string& pointer) {
    if (!object.contains("value") || !object["value"].is_number() || !object.contains("unit")) return;
    constexpr std::array not_negative{"m", "m/s", "kg", "s", "Pa", "kg/m3", "J/m2"};
    const double value = object["value"].get<double>();
    const auto refuse = [&](const std::string& allowed) {
        throw InputError("is " + shortest(value) + " " + object["unit"].get<std::string>(), allowed)
            .at(child_pointer(pointer, "value"));
    };
    if (!std::isfinite(value) || std::abs(value) > 1e40) refuse("a number up to 1e40");
    if (value < 0 &&
        std::find(not_negative.begin(), not_negative.end(), object["unit"]) != not_negative.end())
        refuse("0 or more");
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
    Json intervals = Json::array();
    for_each_object(document["result"], "/result", [&](const Json& object, const std::string& pointer) {
        const Json value = value_beside_interval(object);
        if (value.is_number())
            intervals.push_back({{"at", pointer}, {"value", value}, {"interval", object["interval"]}});
    });
    if (!intervals.empty()) provenance[intervals_key] = std::move(intervals);
    Json originals = originals_of(document.at("schema"), document.at("result"));
    if (!originals.empty()) provenance[originals_key] = std::move(originals);
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

std::vector<std::string> accept_edits(Json& document) {
    std::vector<std::string> dropped;
    const Json provenance = document.at("provenance");
    for_each_object(document["result"], "/result", [&](Json& object, const std::string& pointer) {
        require_possible(object, pointer);
        const Json value = value_beside_interval(object);
        if (!value.is_number()) return;
        const Json before = recorded(provenance, pointer);
        const bool left =
            !before.is_null() && before.at("value") != value && before.at("interval") == object["interval"];
        if (!left && holds(object["interval"], value.get<double>())) return;
        drop_interval(object);
        dropped.push_back(pointer + ": the value " + shortest(value.get<double>()) +
                          " was edited without its interval, which is dropped");
    });
    if (provenance.contains(originals_key))
        for (std::string& done :
             reconcile(document.at("schema"), document["result"], provenance[originals_key]))
            dropped.push_back(std::move(done));
    return dropped;
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
