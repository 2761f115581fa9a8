#include "lsp/transport.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <poll.h>
#include <unistd.h>

namespace gliftc::lsp {

namespace {

constexpr std::string_view line_end = "\r\n";
constexpr std::size_t longest_line = 4096;

/// The length that the line gives; absent if it is another header.
std::optional<std::size_t> content_length(std::string_view line) {
    constexpr std::string_view name = "content-length:";
    if (line.size() < name.size()) return std::nullopt;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = line[i];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != name[i]) return std::nullopt;
    }
    std::string_view digits = line.substr(name.size());
    while (digits.starts_with(' ') || digits.starts_with('\t')) digits.remove_prefix(1);
    while (digits.ends_with(' ') || digits.ends_with('\t')) digits.remove_suffix(1);
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size())
        throw BadHeader("the Content-Length '" + std::string(digits) + "' is not a number");
    if (length > Reader::longest) throw BadHeader("a message of " + std::string(digits) + " bytes is too long");
    return length;
}

}  // namespace

bool Reader::fill() {
    std::array<char, 65536> bytes{};
    while (true) {
        const ssize_t count = read(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        buffer_.append(bytes.data(), static_cast<std::size_t>(count));
        return true;
    }
}

bool Reader::has_input() const {
    if (!buffer_.empty()) return true;
    pollfd input{descriptor_, POLLIN, 0};
    return poll(&input, 1, 0) > 0;
}

std::optional<std::string> Reader::next() {
    std::optional<std::size_t> length;
    while (true) {
        const std::size_t end = buffer_.find(line_end);
        if (end == std::string::npos) {
            if (buffer_.size() > longest_line) throw BadHeader("a line of the header is too long");
            if (!fill()) return std::nullopt;
            continue;
        }
        const std::string line = buffer_.substr(0, end);
        buffer_.erase(0, end + line_end.size());
        if (line.empty()) break;
        if (line.find(':') == std::string::npos) throw BadHeader("'" + line + "' is no line of a header");
        if (const auto given = content_length(line)) length = given;
    }
    if (!length) throw BadHeader("the header has no Content-Length");
    while (buffer_.size() < *length)
        if (!fill()) return std::nullopt;
    std::string content = buffer_.substr(0, *length);
    buffer_.erase(0, *length);
    return content;
}

bool write_message(int descriptor, std::string_view content) {
    std::string bytes = "Content-Length: " + std::to_string(content.size()) + "\r\n\r\n";
    bytes += content;
    for (std::size_t written = 0; written < bytes.size();) {
        const ssize_t count = write(descriptor, bytes.data() + written, bytes.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        written += static_cast<std::size_t>(count);
    }
    return true;
}

}  // namespace gliftc::lsp
