// Reflections (what gliftc writes of a module as JSON) conform to docs/reference/reflection.schema.json.
#include "driver/compile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gliftc {
namespace {

using Json = nlohmann::json;

/// Validates JSON by the part of JSON Schema that the schema uses. Gives the first violation, else an empty string.
struct Validator {
    const Json& root;

    std::string check(const Json& value, const Json& schema, const std::string& where) const {
        if (schema.contains("$ref"))
            return check(value, root.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))), where);
        if (schema.contains("oneOf")) return one_of(value, schema["oneOf"], where);
        if (schema.contains("enum")) {
            for (const Json& allowed : schema["enum"])
                if (allowed == value) return "";
            return where + ": " + value.dump() + " is not one of " + schema["enum"].dump();
        }
        const std::string type = schema.at("type");
        if (type == "object") return object(value, schema, where);
        if (type == "array") return array(value, schema, where);
        bool right = type == "string"    ? value.is_string()
                     : type == "boolean" ? value.is_boolean()
                     : type == "integer" ? value.is_number_unsigned()
                                         : value.is_null();
        return right ? "" : where + ": " + value.dump() + " is no " + type;
    }

    std::string one_of(const Json& value, const Json& choices, const std::string& where) const {
        std::string error;
        for (const Json& choice : choices) {
            error = check(value, choice, where);
            if (error.empty()) return "";
        }
        return error;
    }

    std::string object(const Json& value, const Json& schema, const std::string& where) const {
        if (!value.is_object()) return where + " is no object";
        for (const Json& name : schema.value("required", Json::array()))
            if (!value.contains(name.get<std::string>())) return where + " has no " + name.get<std::string>();
        const Json none = Json::object(), &properties = schema.contains("properties") ? schema["properties"] : none;
        for (const auto& [name, part] : value.items()) {
            std::string error = properties.contains(name) ? check(part, properties[name], where + "/" + name)
                                : schema["additionalProperties"].is_object()
                                    ? check(part, schema["additionalProperties"], where + "/" + name)
                                    : where + " has a " + name;
            if (!error.empty()) return error;
        }
        return "";
    }

    std::string array(const Json& value, const Json& schema, const std::string& where) const {
        if (!value.is_array()) return where + " is no array";
        if (value.size() < schema.value("minItems", 0u) || value.size() > schema.value("maxItems", ~0u))
            return where + " has another length";
        for (std::size_t i = 0; i < value.size(); ++i)
            if (std::string error = check(value[i], schema["items"], where + "/" + std::to_string(i)); !error.empty())
                return error;
        return "";
    }
};

std::string reflection_of_file(const std::string& path) {
    Options options;
    options.files = {std::string(GLIFT_SOURCE_DIR) + "/" + path};
    options.library_folder = std::string(GLIFT_SOURCE_DIR) + "/stdlib";
    options.targets = {Target::json};
    Compilation compilation;
    Result result = compile(options, disk(), compilation);
    EXPECT_FALSE(compilation.diagnostics.has_errors()) << path;
    for (const Output& output : result.outputs)
        if (output.name.ends_with(".glift.json")) return output.bytes;
    return "";
}

/// The modules whose reflections are checked: those of structures and of a few examples, draws among them.
std::vector<std::string> modules() {
    std::vector<std::string> found;
    for (const char* folder : {"/stdlib/structures", "/examples/laplacian", "/examples/mesh", "/examples/narrow_band"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(GLIFT_SOURCE_DIR + std::string(folder)))
            if (entry.path().extension() == ".glift")
                found.push_back(entry.path().lexically_relative(GLIFT_SOURCE_DIR).string());
    std::ranges::sort(found);
    return found;
}

class Reflection : public testing::TestWithParam<std::string> {};

TEST_P(Reflection, HasTheShapeOfTheSchema) {
    std::ifstream file(std::string(GLIFT_SOURCE_DIR) + "/docs/reference/reflection.schema.json");
    const Json schema = Json::parse(file);
    const std::string text = reflection_of_file(GetParam());
    ASSERT_NE(text, "");
    EXPECT_EQ(Validator{schema}.check(Json::parse(text), schema, ""), "");
}

INSTANTIATE_TEST_SUITE_P(Files, Reflection, testing::ValuesIn(modules()));

}  // namespace
}  // namespace gliftc
