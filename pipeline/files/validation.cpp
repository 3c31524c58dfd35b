// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/files/schema.hpp"

namespace ashimpact {

namespace {

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
    if (part != nullptr && !part->contains("properties") && part->contains("allOf")) {
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
    const auto says = [&](const char* text) { return error.description.find(text) != std::string::npos; };
    for (const SizeKeys& size : size_keys) refuse_other_size(value, schema, path, size);
    if (says("Missing required property")) {
        const std::string key = last_quoted(error.description);
        throw InputError(in_quotes(key) + " is missing", allowed_by(schema, member_of(path, key)))
            .at(pointer_to(path));
    }
    if (says("could not be validated using 'properties'")) {
        const std::string key = last_quoted(error.description);
        const auto keys = keys_allowed(schema, path);
        throw InputError("unknown key" + did_you_mean(key, keys), joined(keys))
            .at(pointer_to(member_of(path, key)));
    }
    const Json* part = schema_part(schema, path);
    std::string problem = says("uniqueness") ? "holds the same value twice" : "is " + shown(value);
    if (value.is_string()) {
        const auto text = value.get<std::string>();
        if (says("enum")) problem = "unknown name " + shown(value) + did_you_mean(text, names_in(part));
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

void validate_document(const Json& document, std::string_view schema_name) {
    const Json schema = schema_named(schema_name);
    Path path;
    refuse_long_lists(document, schema, path);
    const nlohmann::json plain_schema(schema);
    const nlohmann::json plain_document(document);
    valijson::Schema compiled;
    valijson::SchemaParser parser;
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(plain_schema), compiled);
    valijson::Validator validator;
    const valijson::adapters::NlohmannJsonAdapter target(plain_document);
    if (validator.validate(compiled, target, nullptr)) return;
    // The validator lists every error of a document, so beginnings of increasing length are validated until
    // one has an error.
    for (std::size_t most = 16;; most *= 2) {
        const nlohmann::json beginning = beginning_of(document, most);
        valijson::ValidationResults results;
        const valijson::adapters::NlohmannJsonAdapter part(beginning);
        if (!validator.validate(compiled, part, &results)) refuse(document, schema, decisive(results));
    }
}

}  // namespace ashimpact
