#include "driver/explain_diagnostic.h"

#include "driver/command_line.h"
#include "driver/file_system.h"
#include "emit/json/text.h"

#include <algorithm>
#include <cstdio>

namespace gliftc {

namespace {

/// The id in `unknown-name`, in `[unknown-name]`, as messages show it, or in `E-unknown-name` or `W-unknown-name`.
std::string id_in(std::string word) {
    if (word.size() > 2 && word.front() == '[' && word.back() == ']') word = word.substr(1, word.size() - 2);
    return word.starts_with("E-") || word.starts_with("W-") ? word.substr(2) : word;
}

std::string example_of(std::string id) {
    std::replace(id.begin(), id.end(), '-', '_');
    return disk().read(diagnostics_beside_executable() + "/" + id + ".glift").text;
}

/// Replaces placeholders such as `{0}` by "…".
std::string readable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}') {
            shown += "…";
            i += 2;
        } else {
            shown += text[i];
        }
    }
    return shown;
}

std::string indented(const std::string& text) {
    std::string shown;
    bool begins_line = true;
    for (char c : text) {
        if (begins_line && c != '\n') shown += "    ";
        shown += c;
        begins_line = c == '\n';
    }
    return shown;
}

}  // namespace

bool names_diagnostic(const Options& options) {
    const std::string& word = options.files.front();
    const bool looks_like_file = word == "-" || word.find_first_of("./") != std::string::npos || disk().exists(word);
    return options.files.size() == 1 && !looks_like_file;
}

int explain_diagnostic(const Options& options) {
    const std::string id = id_in(options.files.front());
    const std::optional<Diag> diag = find_diagnostic(id);
    if (!diag) {
        std::string message = "gliftc: there is no file and no diagnostic '" + id + "'";
        if (const std::string_view meant = nearest_diagnostic(id); !meant.empty())
            message += "; did you mean '" + std::string(meant) + "'?";
        std::fprintf(stderr, "%s\n", message.c_str());
        return static_cast<int>(ExitCode::wrong_usage);
    }
    const char* severity = severity_of(*diag) == Severity::warning ? "warning" : "error";
    const std::string example = example_of(id);
    if (options.explain_as_json) {
        json::Text out;
        out.object([&] {
            out.field("id", id);
            out.field("severity", severity);
            out.field("text", text_of(*diag));
            out.field("example", example);
        });
        std::printf("%s\n", out.take().c_str());
        return 0;
    }
    std::printf("%s: %s [%s]\n", severity, readable(text_of(*diag)).c_str(), id.c_str());
    if (!example.empty())
        std::printf("\nFor example; //~ is followed by the diagnostic of the line above:\n\n%s",
                    indented(example).c_str());
    return 0;
}

}  // namespace gliftc
