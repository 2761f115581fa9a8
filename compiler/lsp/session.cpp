#include "lsp/session.h"

#include "lsp/features.h"
#include "lsp/protocol.h"
#include "lsp/uris.h"

#include <map>

namespace gliftc::lsp {

namespace {

using Feature = nlohmann::json (*)(Workspace&, const nlohmann::json&);

const std::map<std::string, Feature>& features() {
    static const std::map<std::string, Feature> table = {
        {"textDocument/hover", hover},
        {"textDocument/definition", definition},
        {"textDocument/references", references},
        {"textDocument/prepareRename", prepare_rename},
        {"textDocument/rename", rename},
        {"textDocument/completion", completion},
        {"textDocument/signatureHelp", signature_help},
        {"textDocument/documentSymbol", document_symbols},
        {"textDocument/semanticTokens/full", semantic_tokens},
        {"textDocument/formatting", formatting},
        {"textDocument/codeAction", code_actions},
        {"textDocument/codeLens", code_lenses},
    };
    return table;
}

nlohmann::json capabilities() {
    return {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"completionProvider", {{"triggerCharacters", {".", "/"}}}},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
            {"documentSymbolProvider", true},
            {"semanticTokensProvider", {{"legend", semantic_tokens_legend()}, {"full", true}}},
            {"documentFormattingProvider", true},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
            {"codeLensProvider", {{"resolveProvider", false}}}};
}

/// The folders that the parameters of `initialize` name.
std::vector<std::string> folders_in(const nlohmann::json& params) {
    std::vector<std::string> folders;
    if (params.contains("workspaceFolders") && params["workspaceFolders"].is_array()) {
        for (const nlohmann::json& folder : params["workspaceFolders"])
            folders.push_back(path_of(string_member(folder, "uri")));
    } else if (params.contains("rootUri") && params["rootUri"].is_string()) {
        folders.push_back(path_of(params["rootUri"].get<std::string>()));
    }
    return folders;
}

nlohmann::json error_response(const nlohmann::json& id, ErrorCode code, const std::string& text) {
    return {{"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", text}}}};
}

bool is_id(const nlohmann::json& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

void Session::send(nlohmann::json message) {
    message["jsonrpc"] = "2.0";
    // Texts of files need not be valid UTF-8, JSON must be.
    send_(message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void Session::log(const std::string& text) {
    send({{"method", "window/logMessage"}, {"params", {{"type", 2}, {"message", text}}}});
}

void Session::receive(const std::string& content) {
    const nlohmann::json message = nlohmann::json::parse(content, nullptr, false);
    if (message.is_discarded()) return send(error_response(nullptr, ErrorCode::parse_error, "the message is no JSON"));
    const bool has_method = message.is_object() && message.contains("method") && message["method"].is_string();
    if (message.is_object() && message.contains("id") && (message.contains("result") || message.contains("error")))
        return;  // a response; the server sends no requests
    if (message.is_object() && message.contains("id")) {
        if (has_method && is_id(message["id"])) return request(message);
        return send(error_response(is_id(message["id"]) ? message["id"] : nullptr, ErrorCode::invalid_request,
                                   "the request has no method, or its id is no string and no number"));
    }
    if (!has_method)
        return send(error_response(nullptr, ErrorCode::invalid_request, "the message has no method and no id"));
    const nlohmann::json params = message.contains("params") ? message["params"] : nlohmann::json::object();
    try {
        notification(message["method"], params);
    } catch (const std::exception& error) {
        log("'" + message["method"].get<std::string>() + "' is ignored: " + error.what());
    }
}

void Session::request(const nlohmann::json& message) {
    const nlohmann::json& id = message["id"];
    try {
        const nlohmann::json params = message.contains("params") ? message["params"] : nlohmann::json::object();
        send({{"id", id}, {"result", answer(message["method"], params)}});
    } catch (const RequestError& error) {
        send(error_response(id, error.code, error.what()));
    } catch (const std::exception& error) {
        send(error_response(id, ErrorCode::internal_error, error.what()));
    }
}

nlohmann::json Session::answer(const std::string& method, const nlohmann::json& params) {
    if (method == "initialize") return initialize(params);
    if (state_ == State::created) throw RequestError(ErrorCode::server_not_initialized, "'initialize' must come first");
    if (state_ == State::shut_down)
        throw RequestError(ErrorCode::invalid_request, "after 'shutdown' only 'exit' may come");
    if (method == "shutdown") {
        state_ = State::shut_down;
        return nullptr;
    }
    const auto feature = features().find(method);
    if (feature == features().end())
        throw RequestError(ErrorCode::method_not_found, "there is no method '" + method + "'");
    return feature->second(workspace_, params);
}

nlohmann::json Session::initialize(const nlohmann::json& params) {
    if (state_ != State::created) throw RequestError(ErrorCode::invalid_request, "the session is initialized already");
    if (!params.is_object()) throw InvalidParams("the parameters are no object");
    workspace_.folders = folders_in(params);
    state_ = State::initialized;
    return {{"capabilities", capabilities()}, {"serverInfo", {{"name", "gliftc"}}}};
}

void Session::notification(const std::string& method, const nlohmann::json& params) {
    if (method == "exit") {
        has_ended_ = true;
        return;
    }
    if (state_ != State::initialized) return;  // as the protocol demands
    if (method == "textDocument/didOpen") {
        const std::string path = workspace_.documents.open(params);
        saved_.insert(path);
        changed(path);
    } else if (method == "textDocument/didChange") {
        changed(workspace_.documents.change(params));
    } else if (method == "textDocument/didSave") {
        const std::string path = path_of(string_member(member(params, "textDocument"), "uri"));
        saved_.insert(path);
        changed(path);
    } else if (method == "textDocument/didClose") {
        const std::string uri = string_member(member(params, "textDocument"), "uri");
        const std::string path = workspace_.documents.close(params);
        changed(path);
        changed_.erase(path);
        send({{"method", "textDocument/publishDiagnostics"},
              {"params", {{"uri", uri}, {"diagnostics", nlohmann::json::array()}}}});
    } else if (method == "workspace/didChangeWatchedFiles") {
        workspace_.forget({});
        for (const auto& [path, document] : workspace_.documents.all()) changed_.insert(path);
    }
}

/// The open documents that import the file are published anew, too.
void Session::changed(const std::string& path) {
    for (const auto& [other, document] : workspace_.documents.all())
        if (other == path || workspace_.reads(other, path)) changed_.insert(other);
    workspace_.forget(path);
}

void Session::publish() {
    for (const std::string& path : changed_) {
        if (workspace_.documents.find(path) == nullptr) continue;
        const Analysis& analysis = workspace_.analysis(path);
        if (!analysis.failure.empty()) log("internal error in '" + path + "': " + analysis.failure);
        const auto publish = [&](const std::vector<Diagnostic>& found) {
            send({{"method", "textDocument/publishDiagnostics"},
                  {"params", diagnostics(workspace_, path, analysis, found)}});
        };
        const Diagnostics& found = analysis.compilation.diagnostics;
        publish(found.all());
        if (saved_.contains(path) && !found.has_errors() && analysis.failure.empty()) {
            std::vector<Diagnostic> all = workspace_.errors_of_lowering(path);
            if (all.size() != found.all().size()) publish(all);
        }
    }
    changed_.clear();
    saved_.clear();
}

}  // namespace gliftc::lsp
