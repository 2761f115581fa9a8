// A session: its life cycle, and which function handles which message.
#pragma once

#include "lsp/workspace.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <set>
#include <string>

namespace gliftc::lsp {

class Session {
public:
    /// `send` takes the contents of messages to the editor.
    Session(Options options, std::function<void(const std::string&)> send)
        : workspace_(std::move(options)), send_(std::move(send)) {}

    /// Handles one message: JSON of a request, a notification or a response. Answers requests, also malformed ones,
    /// and messages that are no JSON; reports problems with notifications as `window/logMessage`.
    void receive(const std::string& content);
    /// Publishes the diagnostics of documents that changed. To be called when no further message waits.
    void publish();

    bool has_ended() const { return has_ended_; }
    /// The exit code: 0 if `shutdown` came before `exit`, else 1.
    int exit_code() const { return state_ == State::shut_down ? 0 : 1; }

private:
    enum class State : std::uint8_t { created, initialized, shut_down };

    void request(const nlohmann::json& message);
    void notification(const std::string& method, const nlohmann::json& params);
    nlohmann::json answer(const std::string& method, const nlohmann::json& params);
    nlohmann::json initialize(const nlohmann::json& params);
    void changed(const std::string& path);
    void send(nlohmann::json message);
    void log(const std::string& text);

    Workspace workspace_;
    std::function<void(const std::string&)> send_;
    State state_ = State::created;
    bool has_ended_ = false;
    std::set<std::string> changed_;  ///< documents whose diagnostics are to be published
    std::set<std::string> saved_;    ///< those of them that are also lowered: just opened or saved
};

}  // namespace gliftc::lsp
