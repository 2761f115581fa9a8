#include "lsp/protocol.h"

namespace gliftc::lsp {

const nlohmann::json& member(const nlohmann::json& value, const char* key) {
    if (!value.is_object() || !value.contains(key)) throw InvalidParams(std::string("'") + key + "' is missing");
    return value[key];
}

const std::string& string_member(const nlohmann::json& value, const char* key) {
    const nlohmann::json& found = member(value, key);
    if (!found.is_string()) throw InvalidParams(std::string("'") + key + "' is no string");
    return found.get_ref<const std::string&>();
}

const nlohmann::json& array_member(const nlohmann::json& value, const char* key) {
    const nlohmann::json& found = member(value, key);
    if (!found.is_array()) throw InvalidParams(std::string("'") + key + "' is no array");
    return found;
}

}  // namespace gliftc::lsp
