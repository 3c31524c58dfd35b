// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/files/schema.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include "core/embedded.hpp"
#include "core/text/error.hpp"
#include "materials/modulus.hpp"
#include "materials/work_of_adhesion.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/damping/damping.hpp"
#include "solver/inference/calibration/calibration.hpp"

namespace ashimpact {

namespace {

constexpr std::string_view schema_folder = "schemas/";
constexpr std::string_view suffix = ".json";

/// The names that replace "@..." in the schema files; they are defined in the code.
std::vector<std::string> listed(const std::string& mark) {
    if (mark == "@laws") return names_of_laws();
    if (mark == "@detachments") return names_of<Detachment>();
    if (mark == "@damping_laws") return names_of<DampingLaw>();
    if (mark == "@calibration_quantities") return names_of<CalibrationQuantity>();
    if (mark == "@mixture_rules") return names_of<MixtureRule>();
    if (mark == "@porosity_laws") return names_of<PorosityLaw>();
    if (mark == "@adhesion_rules") return names_of<AdhesionRule>();
    throw std::logic_error("no list for " + mark);
}

/// Replaces "@law_parameters" by a property for each parameter of a contact law.
void list_parameters(Json& properties) {
    constexpr auto mark = "@law_parameters";
    const bool quantity = properties.at(mark) == "quantity";
    properties.erase(mark);
    for (const LawParameter& parameter : law_parameters()) {
        const std::string text = std::string(parameter.description) + ": a number in " +
                                 std::string(si_unit(parameter.dimension)) + " or such as \"" +
                                 std::string(parameter.example) + '"';
        properties[std::string(parameter.name)] =
            quantity ? Json{{"description", text},
                            {"allOf", {{{"$ref", "common.json#/definitions/quantity_form"}}}}}
                     : Json{{"$ref", "#/definitions/variable"}};
    }
}

Json schema_file(const std::string& name) {
    const auto text = embedded_file(std::string(schema_folder) + name + std::string(suffix));
    if (!text) throw std::logic_error("no schema file " + name);
    return parse_json(*text);
}

/// Gathers a schema and the files it refers to into one document.
class Bundle {
  public:
    explicit Bundle(const std::string& name) : root_(schema_file(name)) {
        const Json own = root_.contains("definitions") ? root_["definitions"] : Json::object();
        root_.erase("definitions");
        resolve(root_);
        take_definitions(own);
        for (auto& [key, definition] : definitions_) root_["definitions"][key] = std::move(definition);
    }

    [[nodiscard]] Json take() && { return std::move(root_); }

  private:
    /// Turns every reference into one to "#/definitions/...", and every "@..." into a list of the program's
    /// names.
    void resolve(Json& node) {
        if (node.is_object() && node.contains("enum") && node["enum"].size() == 1) {
            const auto only = node["enum"][0].get<std::string>();
            if (only.starts_with('@')) node["enum"] = listed(only);
        }
        if (node.is_object() && node.contains("@law_parameters")) list_parameters(node);
        if (node.is_object() && node.contains("$ref")) node["$ref"] = reference(node["$ref"]);
        if (node.is_structured())
            for (Json& child : node) resolve(child);
    }

    std::string reference(const std::string& target) {
        const auto hash = target.find('#');
        const std::string other = target.substr(0, hash == std::string::npos ? target.size() : hash);
        if (!other.empty()) include(other.substr(0, other.size() - suffix.size()));
        if (hash != std::string::npos) return target.substr(hash);
        return "#/definitions/" + other.substr(0, other.size() - suffix.size());
    }

    void include(const std::string& name) {
        if (!included_.insert(name).second) return;
        Json file = schema_file(name);
        const Json own = file.contains("definitions") ? file["definitions"] : Json::object();
        for (const auto* key : {"definitions", "$schema"}) file.erase(key);
        resolve(file);
        take_definitions(own);
        if (file.contains("type")) definitions_[name] = std::move(file);
    }

    void take_definitions(const Json& definitions) {
        for (const auto& [key, value] : definitions.items()) {
            Json definition = value;
            resolve(definition);
            definitions_[key] = std::move(definition);
        }
    }

    Json root_;
    std::map<std::string, Json> definitions_;
    std::set<std::string> included_;
};

void allow_comments(Json& node) {
    if (node.is_object() && node.contains("additionalProperties"))
        node["patternProperties"] = Json{{"^//", Json::object()}};
    if (node.is_structured())
        for (Json& child : node) allow_comments(child);
}

const Json& dereferenced(const Json& schema, const Json& node) {
    const Json* at = &node;
    while (at->contains("$ref"))
        at = &schema.at(Json::json_pointer(at->at("$ref").get<std::string>().substr(1)));
    return *at;
}

/// The schema of a member or element of a value described by @p node.
const Json* child_schema(const Json& schema, const Json& node, const std::string& key) {
    if (node.contains("properties") && node["properties"].contains(key)) return &node["properties"][key];
    for (const auto* combined : {"allOf", "oneOf", "anyOf"}) {
        if (!node.contains(combined)) continue;
        for (const Json& branch : node[combined])
            if (const Json* found = child_schema(schema, dereferenced(schema, branch), key)) return found;
    }
    const bool index = !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
    if (index && node.contains("items") && node["items"].is_object()) return &node["items"];
    if (node.contains("additionalProperties") && node["additionalProperties"].is_object())
        return &node["additionalProperties"];
    return nullptr;
}

}  // namespace

std::vector<std::string> schema_names() {
    std::vector<std::string> names;
    for (const std::string_view path : embedded_files(schema_folder)) {
        const std::string name(
            path.substr(schema_folder.size(), path.size() - schema_folder.size() - suffix.size()));
        if (name != "common") names.push_back(name);
    }
    return names;
}

Json schema_named(std::string_view name) {
    const auto names = schema_names();
    for (const std::string& known : names)
        if (known == name) return Bundle(known).take();
    throw unknown_name("schema", name, names);
}

Json schema_with_comments(std::string_view name) {
    Json schema = schema_named(name);
    allow_comments(schema);
    return schema;
}

const Json* schema_part(const Json& schema, const std::vector<std::string>& path) {
    const Json* node = &dereferenced(schema, schema);
    for (const std::string& key : path) {
        node = child_schema(schema, *node, key);
        if (node == nullptr) return nullptr;
        node = &dereferenced(schema, *node);
    }
    return node;
}

}  // namespace ashimpact
