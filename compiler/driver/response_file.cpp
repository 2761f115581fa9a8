#include "driver/response_file.h"

namespace gliftc {

namespace {

constexpr unsigned deepest = 16;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    bool inside = false;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (!quote && is_space(c)) {
            inside = false;
            continue;
        }
        if (!inside) words.emplace_back();
        inside = true;
        if (c == '\\' && i + 1 < text.size()) words.back() += text[++i];
        else if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? 0 : c;
        else words.back() += c;
    }
    return words;
}

std::string append(const std::string& word, std::vector<std::string>& words, const FileSystem& files, unsigned depth) {
    if (word.size() < 2 || word[0] != '@') {
        words.push_back(word);
        return {};
    }
    if (depth == deepest) return "'" + word + "' names itself, or files that name files, more than 16 deep";
    ReadResult read = files.read(word.substr(1));
    if (!read.error.empty()) return "cannot read '" + word.substr(1) + "': " + read.error;
    for (const std::string& each : words_of(read.text))
        if (std::string error = append(each, words, files, depth + 1); !error.empty()) return error;
    return {};
}

}  // namespace

std::string expand_response_files(std::vector<std::string>& words, const FileSystem& files) {
    std::vector<std::string> expanded;
    for (const std::string& word : words)
        if (std::string error = append(word, expanded, files, 0); !error.empty()) return error;
    words = std::move(expanded);
    return {};
}

}  // namespace gliftc
