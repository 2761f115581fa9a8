#include "lsp/server.h"

#include "lsp/session.h"
#include "lsp/transport.h"

#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace gliftc {

int run_language_server(const Options& options) {
    std::signal(SIGPIPE, SIG_IGN);  // an editor that is gone ends the input, too
    lsp::Reader reader(STDIN_FILENO);
    lsp::Session session(options, [](const std::string& content) { lsp::write_message(STDOUT_FILENO, content); });
    try {
        while (!session.has_ended()) {
            const std::optional<std::string> message = reader.next();
            if (!message) break;
            session.receive(*message);
            if (!reader.has_input()) session.publish();
        }
    } catch (const lsp::BadHeader& error) {
        std::fprintf(stderr, "gliftc lsp: %s\n", error.what());
    }
    return session.has_ended() ? session.exit_code() : 1;
}

}  // namespace gliftc
