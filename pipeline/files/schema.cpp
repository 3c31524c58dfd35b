// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/files/schema.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "core/embedded.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "materials/contact_properties.hpp"
#include "materials/modulus.hpp"
#include "solver/contact/law.hpp"
#include "solver/contact/law_parameters.hpp"
#include "solver/contact/pair.hpp"
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

/// The part of a schema that describes the value under @p path (keys and indices, outermost first),
/// references resolved; null if there is none.
const Json* schema_part(const Json& schema, const std::vector<std::string>& path) {
    const Json* node = &dereferenced(schema, schema);
    for (const std::string& key : path) {
        node = child_schema(schema, *node, key);
        if (node == nullptr) return nullptr;
        node = &dereferenced(schema, *node);
    }
    return node;
}

using Path = std::vector<std::string>;
using Error = valijson::ValidationResults::Error;

/// valijson names a place "<root>", "[samples]", "[0]".
Path path_of(const Error& error) {
    Path path;
    for (std::size_t i = 1; i < error.context.size(); ++i)
        path.push_back(error.context[i].substr(1, error.context[i].size() - 2));
    return path;
}

/// The first error, or the choice ("anyOf") that encloses it.
Error decisive(const valijson::ValidationResults& results) {
    Error first = *results.begin();
    for (const Error& error : results) {
        const bool choice = error.description.find("Of constraint") != std::string::npos &&
                            error.description.find("allOf") == std::string::npos;
        if (choice && error.context.size() <= first.context.size()) return error;
    }
    return first;
}

const Json& value_at(const Json& document, const Path& path) {
    const Json* value = &document;
    for (const std::string& key : path)
        value = value->is_array() ? &value->at(std::stoul(key)) : &value->at(key);
    return *value;
}

std::string shown(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    return value.is_string() ? in_quotes(value.get<std::string>()) : value.dump();
}

/// The names that a part of the schema lists; none if it lists no names.
std::vector<std::string> names_in(const Json* part) {
    return part != nullptr && part->contains("enum") ? (*part)["enum"].get<std::vector<std::string>>()
                                                     : std::vector<std::string>{};
}

/// What the schema allows for a value, in words.
std::string allowed_by(const Json& schema, const Path& path) {
    const Json* part = schema_part(schema, path);
    if (part == nullptr) return {};
    return part->contains("enum") ? joined(names_in(part)) : part->value("description", "");
}

/// The text between the last pair of single quotes.
std::string last_quoted(const std::string& text) {
    const auto end = text.rfind('\'');
    const auto start = text.rfind('\'', end - 1);
    return text.substr(start + 1, end - start - 1);
}

std::string pointer_to(const Path& path) {
    std::string pointer;
    for (const std::string& key : path) pointer = child_pointer(pointer, key);
    return pointer.empty() ? "/" : pointer;
}

Path member_of(Path path, const std::string& key) {
    path.push_back(key);
    return path;
}

/// The keys of the object at @p path, behind "allOf" too.
std::vector<std::string> keys_allowed(const Json& schema, const Path& path) {
    const Json* part = schema_part(schema, path);
    while (part != nullptr && !part->contains("properties") && part->contains("allOf")) {
        const auto reference = (*part)["allOf"][0].value("$ref", "#");
        part = &schema.at(Json::json_pointer(reference.substr(1)));
    }
    std::vector<std::string> keys;
    if (part != nullptr && part->contains("properties"))
        for (const auto& [key, _] : (*part)["properties"].items()) keys.push_back(key);
    return keys;
}

struct SizeKeys {
    const char* key;
    const char* other;
    const char* form;
};

constexpr SizeKeys size_keys[]{
    {"diameter", "radius", "\"diameter\": \"88 um\" in place of \"radius\": \"44 um\""},
    {"radius", "diameter", "\"radius\": \"44 um\" in place of \"diameter\": \"88 um\""}};

/// A sphere's size has one key, "diameter" in a case and "radius" in a sweep: reports the other
/// one.
void refuse_other_size(const Json& value, const Json& schema, const Path& path, const SizeKeys& size) {
    if (!value.is_object() || !value.contains(size.other)) return;
    const auto keys = keys_allowed(schema, path);
    const auto allowed = [&](const char* key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    if (!allowed(size.key) || allowed(size.other)) return;
    throw InputError("unknown key, the size of a sphere is its " + std::string(size.key) + " here", size.form)
        .at(pointer_to(member_of(path, size.other)));
}

[[noreturn]] void refuse(const Json& document, const Json& schema, const Error& error) {
    const Path path = path_of(error);
    const Json& value = value_at(document, path);
    const auto mentions = [&](const char* text) { return error.description.find(text) != std::string::npos; };
    for (const SizeKeys& size : size_keys) refuse_other_size(value, schema, path, size);
    if (mentions("Missing required property")) {
        const std::string key = last_quoted(error.description);
        throw InputError(in_quotes(key) + " is missing", allowed_by(schema, member_of(path, key)))
            .at(pointer_to(path));
    }
    if (mentions("could not be validated using 'properties'")) {
        const std::string key = last_quoted(error.description);
        const auto keys = keys_allowed(schema, path);
        throw InputError("unknown key" + did_you_mean(key, keys), joined(keys))
            .at(pointer_to(member_of(path, key)));
    }
    const Json* part = schema_part(schema, path);
    std::string problem = mentions("uniqueness") ? "holds the same value twice" : "is " + shown(value);
    if (value.is_string()) {
        const auto text = value.get<std::string>();
        if (mentions("enum")) problem = "unknown name " + shown(value) + did_you_mean(text, names_in(part));
        const Json type = part != nullptr ? part->value("type", Json()) : Json();
        if (type == "number" || type == "integer") problem += remedy_for_number_in_quotes(text);
    }
    throw InputError(problem, allowed_by(schema, path)).at(pointer_to(path));
}

constexpr std::size_t longest_set = 64;           ///< entries of a list without repetitions
constexpr std::size_t longest_list = 10'000'000;  ///< of any list

/// Refuses lists that are too long, before the validator sees them. @throws InputError
void refuse_long_lists(const Json& node, const Json& schema, Path& path) {
    if (node.is_array() && node.size() > longest_set) {
        const Json* part = schema_part(schema, path);
        const bool is_set = part != nullptr && part->value("uniqueItems", false);
        const std::size_t most = is_set ? longest_set : longest_list;
        if (node.size() > most)
            throw InputError("is " + shown(node) + " entries", "at most " + std::to_string(most))
                .at(pointer_to(path));
    }
    if (!node.is_structured()) return;
    for (const auto& [key, member] : node.items()) {
        if (!member.is_structured()) continue;
        path.push_back(key);
        refuse_long_lists(member, schema, path);
        path.pop_back();
    }
}

/// A document with no more than @p most entries of each list.
nlohmann::json beginning_of(const Json& node, std::size_t most) {
    if (!node.is_structured()) return nlohmann::json(node);
    nlohmann::json copy = node.is_array() ? nlohmann::json::array() : nlohmann::json::object();
    if (node.is_array())
        for (std::size_t i = 0; i < std::min(most, node.size()); ++i)
            copy.push_back(beginning_of(node[i], most));
    else
        for (const auto& [key, member] : node.items()) copy[key] = beginning_of(member, most);
    return copy;
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

void validate_document(const Json& document, std::string_view schema_name) {
    const Json schema = schema_named(schema_name);
    Path path;
    refuse_long_lists(document, schema, path);
    const nlohmann::json plain_schema(schema);
    const nlohmann::json plain_document(as_read_back(document));  // 2.0 is a whole number
    valijson::Schema compiled;
    valijson::SchemaParser parser;
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(plain_schema), compiled);
    valijson::Validator validator;
    const valijson::adapters::NlohmannJsonAdapter target(plain_document);
    if (validator.validate(compiled, target, nullptr)) return;
    // The validator lists every error of a document, so beginnings of increasing length are validated until
    // one has an error.
    for (std::size_t most = 16;; most *= 2) {
        const nlohmann::json beginning = beginning_of(as_read_back(document), most);
        valijson::ValidationResults results;
        const valijson::adapters::NlohmannJsonAdapter part(beginning);
        if (!validator.validate(compiled, part, &results)) refuse(document, schema, decisive(results));
    }
}

}  // namespace ashimpact
