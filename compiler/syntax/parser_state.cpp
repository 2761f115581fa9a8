#include "syntax/parser_state.h"

#include "syntax/lexer.h"
#include "syntax/parser.h"

#include <algorithm>

namespace gliftc {

ast::Module parse(std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree, Diagnostics& diagnostics) {
    TokenList tokens = lex(file, sources, names, diagnostics);
    return parse(tokens, file, sources, names, tree, diagnostics);
}

ast::Module parse(TokenList& tokens, std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree,
                  Diagnostics& diagnostics) {
    return Parser(tokens, file, sources, names, tree, diagnostics).parse_module();
}

Parser::Parser(TokenList& list, std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree,
               Diagnostics& diagnostics)
    : tokens_(list.tokens), comments_(list.comments), file_(file), sources_(sources), names_(names), tree_(tree),
      diagnostics_(diagnostics), has_open_string_(list.has_open_string), first_expr_(tree.exprs.size()) {
    heights_.reserve(tokens_.size());
}

const Token& Parser::peek(std::uint32_t ahead) const {
    return tokens_[std::min<std::size_t>(std::size_t{cursor_} + ahead, tokens_.size() - 1)];
}

const Token& Parser::advance() {
    const Token& token = tokens_[cursor_];
    previous_end_ = token.end;
    if (token.kind != TokenKind::end) ++cursor_;
    return token;
}

bool Parser::accept(TokenKind kind) {
    if (!at(kind)) return false;
    advance();
    return true;
}

bool Parser::accept_word(Word word) {
    if (!at_word(word)) return false;
    advance();
    return true;
}

/// Whether the previous token is an unterminated string, which may have swallowed the expected token.
bool Parser::follows_open_string() const {
    if (!has_open_string_ || cursor_ == 0 || tokens_[cursor_ - 1].kind != TokenKind::string) return false;
    const std::string_view text = text_of(tokens_[cursor_ - 1]);
    if (text.size() < 2 || text.back() != '"') return true;
    std::size_t backslashes = 0;
    while (text[text.size() - 2 - backslashes] == '\\') ++backslashes;  // ends at the opening quote
    return backslashes % 2 == 1;                                        // the last quote is escaped
}

bool Parser::expect(TokenKind kind) {
    if (accept(kind)) return true;
    if (kind == TokenKind::semicolon && follows_open_string()) return true;
    // A ';' that is missing at the end of a line, or before a '}', is reported and then treated as present: what
    // follows is probably right.
    if (kind == TokenKind::semicolon && cursor_ > 0 && (peek().first_on_line || at(TokenKind::close_brace)) && !lost_) {
        diagnostics_.report(Diag::expected, after_previous(), {describe(kind), shown(peek())});
        return true;
    }
    fail_expected(describe(kind));
    return false;
}

bool Parser::expect_close(TokenKind kind, std::uint32_t open_token) {
    if (accept(kind)) return true;
    if (lost_) return false;
    lost_ = true;
    if (at(TokenKind::bad_character) || follows_open_string()) return false;  // reported by the lexer
    Span place = cursor_ > 0 && peek().first_on_line ? after_previous() : here();
    Diagnostic& error = diagnostics_.report(Diag::expected, place, {describe(kind), shown(peek())});
    if (std::string meant = habit(describe(kind)); !meant.empty()) error.notes.push_back({{}, std::move(meant)});
    error.notes.push_back({span_of(tokens_[open_token]), "to close this"});
    return false;
}

bool Parser::at_close_angle() const {
    using enum TokenKind;
    return at(greater) || at(greater_greater) || at(greater_equal) || at(greater_greater_equal);
}

/// Consumes one `>`, also the first character of `>>`, `>=` and `>>=`.
bool Parser::expect_close_angle(std::uint32_t open_token) {
    using enum TokenKind;
    if (!at_close_angle()) return expect_close(greater, open_token);
    set_role(Role::close_generic);
    Token& token = tokens_[cursor_];
    if (token.kind == greater) {
        advance();
        return true;
    }
    Token rest = token;
    rest.kind = token.kind == greater_greater ? greater : token.kind == greater_equal ? equal : greater_equal;
    rest.role = Role::none;
    rest.first_on_line = false;
    previous_end_ = ++rest.begin;
    token = rest;
    return true;
}

Span Parser::since(std::uint32_t first_token) const {
    std::uint32_t begin = tokens_[first_token].begin;
    return {file_, begin, std::max(begin, previous_end_)};
}

Span Parser::after_previous() const { return {file_, previous_end_, previous_end_}; }

ast::Identifier Parser::parse_name(std::string_view what) {
    if (at(TokenKind::identifier)) return identifier_of(advance());
    bool keyword = peek().name && !lost_;
    std::string note = keyword ? "'" + std::string(text_of(peek())) + "' is a keyword of the language" : "";
    fail_expected(what, note);
    return {{}, here()};
}

/// The `///` lines between a token and the one before it, without slashes and the space after them.
std::string Parser::doc_before(std::uint32_t token) const {
    auto [begin, end] =
        std::equal_range(comments_.begin(), comments_.end(), Comment{0, 0, token, false, false},
                         [](const Comment& a, const Comment& b) { return a.next_token < b.next_token; });
    std::string doc;
    for (auto comment = begin; comment != end; ++comment) {
        if (!comment->is_doc) continue;
        std::string_view text = sources_.text({file_, comment->begin + 3, comment->end});
        if (text.starts_with(' ')) text.remove_prefix(1);
        if (!doc.empty()) doc += '\n';
        doc += text;
    }
    return doc;
}

}  // namespace gliftc
