// Error reporting and recovery of the parser.
#include "syntax/parser_state.h"
#include "syntax/token_set.h"

namespace gliftc {

namespace {
constexpr int deepest = 256;

using enum TokenKind;
constexpr TokenSet statement_keywords{kw_let,    kw_var,   kw_const,    kw_if,     kw_for, kw_while,
                                      kw_switch, kw_break, kw_continue, kw_return, kw_fn};
constexpr WordSet item_words{Word::memory,        Word::via,    Word::structure, Word::translator,
                             Word::pipeline,      Word::host,   Word::shared,    Word::temp,
                             Word::uninitialized, Word::vertex, Word::fragment};
constexpr TokenSet declaration_keywords{kw_pub,       kw_extern, kw_fn,  kw_struct, kw_enum,
                                        kw_interface, kw_const,  kw_use, at_sign};
constexpr WordSet declaration_words{Word::type,   Word::structure, Word::translator,
                                    Word::kernel, Word::pipeline,  Word::raster};
constexpr TokenSet open_brackets{open_brace, open_paren, open_bracket};
constexpr TokenSet close_brackets{close_brace, close_paren, close_bracket};
}  // namespace

Parser::Nesting::Nesting(Parser& outer) : parser(outer), ok(++outer.depth_ <= deepest) {
    if (ok) return;
    parser.fail(Diag::too_deep, parser.here(), {},
                "each link of a chain of '?:' or 'else if' counts: look the value up in an array, or use a loop");
    // Skip the rest of the file: unclosed brackets at this depth would only give errors that follow from this one.
    parser.cursor_ = static_cast<std::uint32_t>(parser.tokens_.size() - 1);
    parser.unclosed_at_ = parser.cursor_;
}

std::string Parser::shown(const Token& token) const {
    if (token.kind == end) return "the end of the file";
    std::string_view text = text_of(token);
    constexpr std::size_t longest = 40;
    if (text.size() <= longest) return "'" + std::string(text) + "'";
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xc0) == 0x80) --cut;
    return "'" + std::string(text.substr(0, cut)) + "…'";
}

void Parser::fail(Diag id, Span span, std::initializer_list<std::string_view> arguments, std::string note) {
    if (lost_) return;
    lost_ = true;
    if (at(bad_character) || follows_open_string()) return;  // reported by the lexer
    Diagnostic& error = diagnostics_.report(id, span, arguments);
    if (!note.empty()) error.notes.push_back({{}, std::move(note)});
}

void Parser::fail_expected(std::string_view what, std::string note) {
    if (lost_) return;
    if (std::string meant = habit(what); !meant.empty()) note = std::move(meant);
    bool at_line_end = cursor_ > 0 && (peek().first_on_line || at_end());
    fail(Diag::expected, at_line_end ? after_previous() : here(), {what, shown(peek())}, std::move(note));
}

void Parser::fail_reserved(std::string_view reason) {
    fail(Diag::reserved_name, here(), {text_of(peek()), reason});
    advance();
}

void Parser::report_unclosed(std::uint32_t open_token) {
    if (lost_ || unclosed_at_ == cursor_ || has_open_string_) return;
    unclosed_at_ = cursor_;
    Diagnostic& error =
        diagnostics_.report(Diag::unclosed, span_of(tokens_[open_token]), {text_of(tokens_[open_token])});
    error.notes.push_back({here(), at_end() ? "the file ends here" : "a '}' is missing before this"});
    if (badly_indented_ != 0xffffffffu && badly_indented_ > open_token)
        error.notes.push_back(
            {span_of(tokens_[badly_indented_]), "by its indentation, this is the one that lacks its '}'"});
}

/// Called at a `}`: records the first `{` whose line is indented differently than its `}`, if the `}` begins a line.
void Parser::check_indentation(std::uint32_t open_token) {
    if (badly_indented_ != 0xffffffffu || !peek().first_on_line) return;
    std::string_view text = sources_[file_].text;
    auto indentation = [&](std::uint32_t offset) {
        std::size_t start = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
        start = start == std::string_view::npos ? 0 : start + 1;
        std::size_t first = text.find_first_not_of(" \t", start);
        return text.substr(start, first - start);
    };
    if (indentation(tokens_[open_token].begin) != indentation(peek().begin)) badly_indented_ = open_token;
}

/// Skips from an opening bracket past its closing one; stops early at a declaration in the first column.
void Parser::skip_balanced() {
    int open = 0;
    do {
        if (open_brackets.has(peek().kind)) ++open;
        if (close_brackets.has(peek().kind)) --open;
        advance();
    } while (open > 0 && !at_end() && !at_declaration_in_first_column());
}

/// Skips past the next `;` or `{ … }`, or to a `}`, to a line that begins with a keyword of a statement or item that
/// at_statement_keyword() knows, or to a declaration in the first column, whichever comes first. A `{ … }` before
/// `else` does not end the skipping, nor does that of a `do … while`, which C has and the language does not.
void Parser::recover_in_list() {
    lost_ = false;
    while (!at_end() && !at(close_brace) && !at_declaration_in_first_column()) {
        if (accept(semicolon)) return;
        if (peek().first_on_line && at_statement_keyword()) return;
        if (at(open_brace)) {
            const bool is_do = cursor_ > 0 && text_of(tokens_[cursor_ - 1]) == "do";
            skip_balanced();
            if (!at(kw_else) && !(is_do && at(kw_while))) return;
            continue;
        }
        if (open_brackets.has(peek().kind)) {
            skip_balanced();
        } else {
            advance();
        }
    }
}

/// Skips to a line that begins a declaration.
void Parser::recover_in_module() {
    lost_ = false;
    while (!at_end()) {
        if (peek().first_on_line && at_declaration()) return;
        if (open_brackets.has(peek().kind)) {
            skip_balanced();
        } else {
            advance();
        }
    }
}

bool Parser::at_statement_keyword() const {
    const bool begins_part = at_word(Word::vertex) || at_word(Word::fragment);
    return statement_keywords.has(peek().kind) ||
           (item_words.has(peek().word) && peek(1).kind == (begins_part ? open_brace : identifier));
}

/// Whether the token is a contextual keyword that begins declarations. False for `test`, which the caller checks.
bool Parser::at_declaration_word() const { return declaration_words.has(peek().word); }

bool Parser::at_declaration() const {
    if (declaration_keywords.has(peek().kind)) return true;
    if (at_word(Word::test)) return peek(1).kind == string;
    return declaration_words.has(peek().word) && peek(1).kind == identifier;
}

/// Whether a declaration begins in the first column here, other than a `const`, which may be a statement. Within braces
/// that means that a `}` is missing: the list in them ends before the declaration.
bool Parser::at_declaration_in_first_column() const {
    if (!peek().first_on_line || !at_declaration() || at(kw_const)) return false;
    std::uint32_t begin = peek().begin;
    return begin == 0 || sources_[file_].text[begin - 1] == '\n';
}

bool Parser::list_ends() const { return at(close_brace) || at_end() || at_declaration_in_first_column(); }

bool Parser::close_list(std::uint32_t open_token) {
    if (at(close_brace)) {
        check_indentation(open_token);
        advance();
        return true;
    }
    report_unclosed(open_token);
    return false;
}

}  // namespace gliftc
