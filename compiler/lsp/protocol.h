// Errors of the protocol, and checked access to the parameters of messages.
#pragma once

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>

namespace gliftc::lsp {

/// Codes of JSON-RPC and of the protocol.
enum class ErrorCode : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    server_not_initialized = -32002,
    request_failed = -32803,
};

/// The answer to a request is this error.
struct RequestError : std::runtime_error {
    RequestError(ErrorCode error, const std::string& text) : std::runtime_error(text), code(error) {}
    ErrorCode code;
};

struct InvalidParams : RequestError {
    explicit InvalidParams(const std::string& text) : RequestError(ErrorCode::invalid_params, text) {}
};

/// The member `key`, which must be of the type that the function names. Throws InvalidParams if it is missing or of
/// another type, or if `value` is no object.
const nlohmann::json& member(const nlohmann::json& value, const char* key);
const std::string& string_member(const nlohmann::json& value, const char* key);
const nlohmann::json& array_member(const nlohmann::json& value, const char* key);

}  // namespace gliftc::lsp
