#include "ir/reader.h"

#include <algorithm>
#include <cctype>

namespace gliftc::ir {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

/// Skips white space and comments.
void Reader::skip_space() {
    while (at_ < text_.size()) {
        if (text_.substr(at_).starts_with("//")) at_ = std::min(text_.find('\n', at_), text_.size());
        else if (std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
        else return;
    }
}

bool Reader::at_end() {
    skip_space();
    return at_ == text_.size();
}

bool Reader::at(std::string_view token) {
    skip_space();
    if (!text_.substr(at_).starts_with(token)) return false;
    const std::size_t next = at_ + token.size();
    return !is_word(token.back()) || next == text_.size() || !is_word(text_[next]);
}

bool Reader::accept(std::string_view token) {
    if (!at(token)) return false;
    at_ += token.size();
    return true;
}

void Reader::expect(std::string_view token) {
    if (!accept(token)) fail(concat("expected '", token, "'"));
}

bool Reader::at_name() {
    skip_space();
    return at_ < text_.size() && is_word(text_[at_]) && !std::isdigit(static_cast<unsigned char>(text_[at_]));
}

std::string Reader::word() {
    if (!at_name()) fail("expected a name");
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
}

std::string Reader::name() {
    std::string found = word();
    const auto digit_at = [&](std::size_t i) {
        return i < text_.size() && std::isdigit(static_cast<unsigned char>(text_[i]));
    };
    if (at_ < text_.size() && text_[at_] == '.' && digit_at(at_ + 1)) {
        found += text_[at_++];
        while (digit_at(at_)) found += text_[at_++];
    }
    return found;
}

std::uint64_t Reader::number() {
    skip_space();
    std::uint64_t value = 0;
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])))
        value = value * 10 + static_cast<std::uint64_t>(text_[at_++] - '0');
    if (at_ == begin) fail("expected a number");
    return value;
}

void Reader::fail(std::string_view what) {
    const auto line = 1 + std::ranges::count(text_.substr(0, at_), '\n');
    const std::string_view rest = text_.substr(at_, text_.find('\n', at_) - at_);
    throw ReadError(concat("line ", std::to_string(line), ": ", what, ", found '", rest, "'"));
}

}  // namespace gliftc::ir
