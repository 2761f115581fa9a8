#include "syntax/lexer.h"

#include "syntax/habits.h"

#include <array>
#include <cstring>
#include <string>

namespace gliftc {

namespace {

enum CharClass : std::uint8_t { other, space, newline, letter, digit };

constexpr std::array<CharClass, 256> make_classes() {
    std::array<CharClass, 256> classes{};
    for (int c = 'a'; c <= 'z'; ++c) classes[static_cast<std::size_t>(c)] = letter;
    for (int c = 'A'; c <= 'Z'; ++c) classes[static_cast<std::size_t>(c)] = letter;
    for (int c = '0'; c <= '9'; ++c) classes[static_cast<std::size_t>(c)] = digit;
    classes['_'] = letter;
    classes[' '] = classes['\t'] = classes['\r'] = classes['\v'] = classes['\f'] = space;
    classes['\n'] = newline;
    return classes;
}
constexpr auto classes = make_classes();

CharClass class_of(char c) { return classes[static_cast<unsigned char>(c)]; }
bool is_beyond_ascii(char c) { return (c & 0x80) != 0; }
bool continues_word(char c) { return class_of(c) >= letter; }

/// Keywords and contextual keywords, indexed by Name::index. They are interned before other names, so that the table is
/// short.
class WordTable {
public:
    explicit WordTable(Names& names) {
#define PUNCTUATION(name, text)
#define KEYWORD(text) set(names.intern(#text), {TokenKind::kw_##text, Word::no_word});
#define WORD(text) set(names.intern(#text), {TokenKind::identifier, Word::text});
#include "syntax/tokens.def"
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
    }
    struct Entry {
        TokenKind kind = TokenKind::identifier;
        Word word = Word::no_word;
    };
    Entry operator[](Name name) const { return name.index < entries_.size() ? entries_[name.index] : Entry{}; }

private:
    void set(Name name, Entry entry) {
        if (entries_.size() <= name.index) entries_.resize(name.index + 1);
        entries_[name.index] = entry;
    }
    std::vector<Entry> entries_;
};

/// Scans the text from its beginning to its end. look() beyond the end gives '\0'.
class Lexer {
public:
    Lexer(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics)
        : file_(file), text_(sources[file].text), names_(names), words_(names), diagnostics_(diagnostics) {
        list_.tokens.reserve(text_.size() / 4 + 16);
    }

    TokenList run() {
        std::size_t bad = find_invalid_utf8(text_);
        valid_ = bad == text_.size();
        if (!valid_) diagnostics_.report(Diag::not_utf8, {file_, offset(bad), offset(bad + 1)});
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
        check_line_ends();
        while (at_ < text_.size()) next();
        push(TokenKind::end, at_);
        return std::move(list_);
    }

private:
    /// Reports the first carriage return without a line feed. C++ ends a line there, a comment included.
    void check_line_ends() {
        std::size_t at = text_.find('\r');
        while (at != std::string_view::npos && at + 1 < text_.size() && text_[at + 1] == '\n')
            at = text_.find('\r', at + 1);
        if (at == std::string_view::npos) return;
        auto& error = diagnostics_.report(Diag::bad_character, {file_, offset(at), offset(at + 1)},
                                          {"U+000D, a carriage return without a line feed"});
        error.notes.push_back({{}, "end lines with a line feed, or with a carriage return and a line feed"});
    }

    static std::uint32_t offset(std::size_t at) { return static_cast<std::uint32_t>(at); }
    char look(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    void push(TokenKind kind, std::size_t begin, Name name = {}, Word word = Word::no_word) {
        list_.tokens.push_back({kind, word, Role::none, first_on_line_, offset(begin), offset(at_), name});
        first_on_line_ = false;
    }

    void next() {
        char c = text_[at_];
        switch (class_of(c)) {
        case space: ++at_; return;
        case newline:
            ++at_;
            first_on_line_ = true;
            return;
        case letter: return word();
        case digit: return number();
        case other: break;
        }
        if (c == '/' && look(1) == '/') return line_comment();
        if (c == '/' && look(1) == '*') return block_comment();
        if (c == '"') return string();
        if (is_beyond_ascii(c)) return foreign_word(at_);
        if (c == '.' && class_of(look(1)) == digit && !after_value()) return number_without_integer_part();
        punctuation(c);
    }

    void word() {
        std::size_t begin = at_;
        while (at_ < text_.size() && continues_word(text_[at_])) ++at_;
        if (at_ < text_.size() && is_beyond_ascii(text_[at_])) return foreign_word(begin);
        Name name = names_.intern(text_.substr(begin, at_ - begin));
        auto [kind, meaning] = words_[name];
        push(kind, begin, name, meaning);
    }

    /// A word with characters beyond ASCII: one error, unless the text is not valid UTF-8, which run() has reported. It
    /// counts as an identifier if it has an ASCII letter, digit or '_', else as a bad_character.
    void foreign_word(std::size_t begin) {
        std::size_t first = begin;
        while (first < text_.size() && !is_beyond_ascii(text_[first])) ++first;
        bool any_ascii = false;
        while (at_ < text_.size() && (continues_word(text_[at_]) || is_beyond_ascii(text_[at_])))
            any_ascii |= continues_word(text_[at_++]);
        any_ascii |= first > begin;
        std::size_t end = first + 1;
        while (end < at_ && (text_[end] & 0xc0) == 0x80) ++end;
        std::string shown = "'" + std::string(text_.substr(first, end - first)) + "'";
        if (valid_) {
            auto& error = diagnostics_.report(Diag::bad_character, {file_, offset(first), offset(end)}, {shown});
            if (any_ascii)
                error.notes.push_back({{}, "names are made of the letters a to z and A to Z, digits and '_'"});
        }
        if (any_ascii) return push(TokenKind::identifier, begin, names_.intern(text_.substr(begin, at_ - begin)));
        push(TokenKind::bad_character, begin);
    }

    /// Whether a name, a `)` or a `]` ends right here. If so, as in `x.0`, a point accesses a member, and the digit
    /// after it is a wrong name; else, as in `= .5`, the point begins a malformed number.
    bool after_value() const {
        if (list_.tokens.empty() || list_.tokens.back().end != at_) return false;
        TokenKind before = list_.tokens.back().kind;
        return before == TokenKind::identifier || before == TokenKind::close_paren ||
               before == TokenKind::close_bracket;
    }

    void digits() {
        while (class_of(look()) == digit) ++at_;
    }

    /// integer: (digit+ | ("0x" | "0X") hex+) ["u" | "l" | "ul"];
    /// floating: digit+ ("." digit+ [exponent] | exponent) ["f" | "h" | "d"];
    /// exponent: ("e" | "E") ["+" | "-"] digit+
    void number() {
        std::size_t begin = at_;
        bool floating = false;
        if (look() == '0' && (look(1) == 'x' || look(1) == 'X')) {
            at_ += 2;
            return finish_integer(begin, hex_digits());
        }
        digits();
        if (look() == '.' && class_of(look(1)) == digit) {
            floating = true;
            ++at_;
            digits();
        }
        if (look() == 'e' || look() == 'E') {
            std::size_t sign = look(1) == '+' || look(1) == '-' ? 2 : 1;
            if (class_of(look(sign)) == digit) {
                floating = true;
                at_ += sign;
                digits();
            }
        }
        if (!floating) return finish_integer(begin, true);
        std::string_view suffix = take_suffix();
        bool good = suffix.empty() || suffix == "f" || suffix == "h" || suffix == "d";
        push(good ? TokenKind::floating : TokenKind::bad_number, begin);
    }

    bool hex_digits() {
        std::size_t begin = at_;
        auto is_hex = [](char c) { return class_of(c) == digit || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); };
        while (is_hex(look())) ++at_;
        return at_ > begin;
    }

    std::string_view take_suffix() {
        std::size_t begin = at_;
        while (continues_word(look())) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    void finish_integer(std::size_t begin, bool good) {
        std::string_view suffix = take_suffix();
        good = good && (suffix.empty() || suffix == "u" || suffix == "l" || suffix == "ul");
        push(good ? TokenKind::integer : TokenKind::bad_number, begin);
    }

    void number_without_integer_part() {
        std::size_t begin = at_++;
        digits();
        take_suffix();
        push(TokenKind::bad_number, begin);
    }

    void string() {
        std::size_t begin = at_++;
        while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n')
            at_ += text_[at_] == '\\' && look(1) != '\n' ? 2 : 1;
        if (at_ > text_.size()) at_ = text_.size();
        if (look() == '"') {
            ++at_;
        } else {
            diagnostics_.report(Diag::unterminated_string, {file_, offset(begin), offset(begin + 1)});
            list_.has_open_string = true;
        }
        push(TokenKind::string, begin);
    }

    void line_comment() {
        std::size_t begin = at_;
        std::size_t end = text_.find('\n', at_);
        at_ = end == std::string_view::npos ? text_.size() : end;
        std::size_t last = at_ > begin && text_[at_ - 1] == '\r' ? at_ - 1 : at_;
        bool is_doc = text_.substr(begin, 3) == "///" && text_.substr(begin, 4) != "////";
        list_.comments.push_back({offset(begin), offset(last), offset(list_.tokens.size()), is_doc, first_on_line_});
    }

    /// Block comments do not nest, as in C.
    void block_comment() {
        std::size_t begin = at_;
        bool first = first_on_line_;
        std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) {
            diagnostics_.report(Diag::unterminated_comment, {file_, offset(begin), offset(begin + 2)});
            at_ = text_.size();
        } else {
            at_ = end + 2;
        }
        if (text_.substr(begin, at_ - begin).find('\n') != std::string_view::npos) first_on_line_ = true;
        list_.comments.push_back({offset(begin), offset(at_), offset(list_.tokens.size()), false, first});
    }

    void take(TokenKind kind, std::size_t length) {
        std::size_t begin = at_;
        at_ += length;
        push(kind, begin);
    }

    /// Takes the longest of `c`, `c=`, `cc`, `cc=` that is a token. A kind of TokenKind::end: there is no such token.
    void family(char c, TokenKind one, TokenKind with_equal, TokenKind two, TokenKind two_with_equal) {
        bool doubled = two != TokenKind::end && look(1) == c;
        if (doubled && two_with_equal != TokenKind::end && look(2) == '=') return take(two_with_equal, 3);
        if (doubled) return take(two, 2);
        if (with_equal != TokenKind::end && look(1) == '=') return take(with_equal, 2);
        take(one, 1);
    }

    void punctuation(char c) {
        using enum TokenKind;
        switch (c) {
        case '(': return take(open_paren, 1);
        case ')': return take(close_paren, 1);
        case '[': return take(open_bracket, 1);
        case ']': return take(close_bracket, 1);
        case '{': return take(open_brace, 1);
        case '}': return take(close_brace, 1);
        case ',': return take(comma, 1);
        case ';': return take(semicolon, 1);
        case ':': return take(colon, 1);
        case '@': return take(at_sign, 1);
        case '~': return take(tilde, 1);
        case '.': return family(c, dot, end, dot_dot, end);
        case '?': return family(c, question, end, question_question, end);
        case '=': return family(c, equal, equal_equal, end, end);
        case '!': return family(c, exclaim, exclaim_equal, end, end);
        case '<': return family(c, less, less_equal, less_less, less_less_equal);
        case '>': return family(c, greater, greater_equal, greater_greater, greater_greater_equal);
        case '+': return family(c, plus, plus_equal, end, end);
        case '-': return look(1) == '>' ? take(arrow, 2) : family(c, minus, minus_equal, end, end);
        case '*': return family(c, star, star_equal, end, end);
        case '/': return family(c, slash, slash_equal, end, end);
        case '%': return family(c, percent, percent_equal, end, end);
        case '&': return family(c, ampersand, ampersand_equal, ampersand_ampersand, end);
        case '|': return family(c, bar, bar_equal, bar_bar, end);
        case '^': return family(c, caret, caret_equal, end, end);
        }
        bad_characters();
    }

    static bool is_bad(char c) {
        if (class_of(c) != other || is_beyond_ascii(c)) return false;
        return !std::strchr("()[]{},;:@~.?=!<>+-*/%&|^\"", c) || c == '\0';
    }

    /// Reports a run of characters that begin no token as one error.
    void bad_characters() {
        std::size_t begin = at_++;
        auto code = static_cast<unsigned char>(text_[begin]);
        bool printable = code > 0x20 && code < 0x7f;
        std::string shown = printable ? std::string("'") + text_[begin] + "'" : "with code " + std::to_string(code);
        while (at_ < text_.size() && is_bad(text_[at_])) ++at_;
        auto& error = diagnostics_.report(Diag::bad_character, {file_, offset(begin), offset(at_)}, {shown});
        if (text_[begin] == '#') {
            std::size_t end = at_;
            while (end < text_.size() && continues_word(text_[end])) ++end;
            if (std::string hint = hint_for_directive(text_.substr(at_, end - at_)); !hint.empty())
                error.notes.push_back({{}, std::move(hint)});
        }
        push(TokenKind::bad_character, begin);
    }

    std::uint32_t file_;
    std::string_view text_;
    Names& names_;
    WordTable words_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    bool first_on_line_ = true;
    bool valid_ = true;  // the text is valid UTF-8; if not, characters beyond ASCII are not reported one by one
    TokenList list_;
};

/// The length in bytes of the UTF-8 character at `at`; 0 if it is invalid.
std::size_t sequence_length(std::string_view text, std::size_t at) {
    auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u; };
    auto continues = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
    unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first <= 0xdf) return continues(1) ? 2 : 0;
    if (first >= 0xe0 && first <= 0xef) {
        if (first == 0xe0 && byte(1) < 0xa0) return 0;  // overlong
        if (first == 0xed && byte(1) > 0x9f) return 0;  // surrogate
        return continues(1) && continues(2) ? 3 : 0;
    }
    if (first >= 0xf0 && first <= 0xf4) {
        if (first == 0xf0 && byte(1) < 0x90) return 0;
        if (first == 0xf4 && byte(1) > 0x8f) return 0;
        return continues(1) && continues(2) && continues(3) ? 4 : 0;
    }
    return 0;
}

}  // namespace

TokenList lex(std::uint32_t file, const Sources& sources, Names& names, Diagnostics& diagnostics) {
    return Lexer(file, sources, names, diagnostics).run();
}

std::size_t find_invalid_utf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        std::uint64_t eight;
        if (at + sizeof eight <= text.size()) {
            std::memcpy(&eight, text.data() + at, sizeof eight);
            if ((eight & 0x8080808080808080u) == 0) {
                at += sizeof eight;
                continue;
            }
        }
        std::size_t length = sequence_length(text, at);
        if (length == 0) return at;
        at += length;
    }
    return at;
}

std::string_view describe(TokenKind kind) {
    switch (kind) {
    case TokenKind::end: return "the end of the file";
    case TokenKind::identifier: return "a name";
    case TokenKind::integer:
    case TokenKind::floating:
    case TokenKind::bad_number: return "a number";
    case TokenKind::string: return "a string";
    case TokenKind::bad_character:
        return "an unexpected character";
// clang-format off
#define PUNCTUATION(name, text) \
    case TokenKind::name: return "'" text "'";
#define KEYWORD(text) \
    case TokenKind::kw_##text: return "'" #text "'";
#define WORD(text)
#include "syntax/tokens.def"
// clang-format on
#undef PUNCTUATION
#undef KEYWORD
#undef WORD
    }
    return "";
}

}  // namespace gliftc
