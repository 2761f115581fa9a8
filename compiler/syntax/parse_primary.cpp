// Names, literals, calls, indices, members, generic arguments.
#include "syntax/parser_state.h"
#include "syntax/token_set.h"

#include <charconv>
#include <limits>

namespace gliftc {

using ast::Expr;
using ast::ExprKind;

namespace {

using enum TokenKind;
constexpr TokenSet literal_tokens{integer, floating, bad_number, string, kw_true, kw_false, kw_none};
/// Tokens that may occur in generic arguments outside of parentheses and brackets, besides `<`, `>`, `>>`, `>>=`, `?`
/// and `??`.
constexpr TokenSet in_generic_arguments{identifier, integer, floating, kw_true, kw_false, kw_none, comma, dot,
                                        plus,       minus,   star,     slash,   percent,  exclaim, tilde};
constexpr TokenSet never_in_brackets{semicolon, open_brace, close_brace, end};
constexpr TokenSet after_generic_arguments{
    open_paren, close_paren, open_bracket, close_bracket, open_brace,  close_brace,   comma,   semicolon, colon, dot,
    dot_dot,    greater,     question,     equal,         equal_equal, exclaim_equal, kw_then, bar,       end};
constexpr TokenSet after_optional{comma, greater, greater_greater, question, question_question};

/// The digits and the suffix of an integer's text, without the prefix 0x, and its base.
struct NumberParts {
    std::string_view digits, suffix;
    int base = 10;
};

/// Whether a number beyond the range of double is too small for it, not too large. std::from_chars() does not say.
bool is_tiny(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    std::string_view exponent = number.substr(std::min(e + 1, number.size())), digits = number.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size()), first = digits.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::int64_t power = 0;
    const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (read.ec == std::errc::result_out_of_range) return exponent.starts_with('-');
    return power + static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) < 0;
}

NumberParts split_integer(std::string_view text) {
    NumberParts parts{text, {}, 10};
    if (text.starts_with("0x") || text.starts_with("0X")) {
        parts.base = 16;
        parts.digits.remove_prefix(2);
    }
    std::size_t end = parts.digits.find_last_not_of("ul") + 1;
    parts.suffix = parts.digits.substr(end);
    parts.digits = parts.digits.substr(0, end);
    return parts;
}

void set_suffix(Expr& expr, std::string_view suffix) {
    for (std::size_t i = 0; i < suffix.size() && i + 1 < sizeof expr.suffix; ++i) expr.suffix[i] = suffix[i];
}

}  // namespace

/// postfix = primary { generic-arguments | call | index | member } ;
ast::ExprId Parser::parse_postfix() {
    using enum TokenKind;
    std::uint32_t first = cursor_;
    ExprId base = parse_primary();
    while (!lost_) {
        if (at(open_paren)) {
            base = parse_call(base, first);
        } else if (at(open_bracket)) {
            base = parse_index(base, first);
        } else if (at(dot)) {
            base = parse_member(base, first);
        } else if (at(less)) {
            ExprKind kind = tree_.exprs[base].kind;
            bool named = kind == ExprKind::name || kind == ExprKind::member;
            if (!named || !generic_arguments_follow()) break;
            base = parse_generic_arguments(base, first);
        } else {
            break;
        }
    }
    return base;
}

/// primary = name | literal | "(" expression ")" | tuple ;
ast::ExprId Parser::parse_primary() {
    using enum TokenKind;
    if (at(identifier)) return parse_name_expression();
    if (literal_tokens.has(peek().kind)) return parse_literal();
    if (at(open_brace)) return parse_tuple();
    if (at(open_paren)) return parse_parenthesized();
    auto before = [&](std::uint32_t back) { return cursor_ >= back ? tokens_[cursor_ - back] : Token{}; };
    bool twice = (before(1).kind == plus || before(1).kind == minus) && before(1).kind == before(2).kind &&
                 before(1).begin == before(2).end;
    std::string note = twice ? "there is no '++' and no '--': write 'i += 1'" : "";
    if (at(bar) || at(bar_bar))
        note = "a closure is an argument of a call: it stands directly after '(' or ',', as in "
               "'transform(a, |x| x * x, b)'";
    Span place = peek().first_on_line && cursor_ > 0 ? after_previous() : here();
    fail(Diag::expected_expression, place, {shown(peek())}, note);
    return error_expr();
}

ast::ExprId Parser::parse_parenthesized() {
    Brackets brackets(*this);
    std::uint32_t open = cursor_;
    advance();
    ExprId inner = parse_expression();
    expect_close(TokenKind::close_paren, open);
    return inner;
}

ast::ExprId Parser::parse_name_expression() {
    Expr expr;
    expr.kind = ExprKind::name;
    expr.span = here();
    expr.name = advance().name;
    return add(std::move(expr));
}

/// literal = integer | floating | string | "true" | "false" | "none" ;
ast::ExprId Parser::parse_literal() {
    using enum TokenKind;
    Expr expr;
    expr.span = here();
    if (at(integer)) return parse_integer(std::move(expr));
    if (at(floating)) return parse_float(std::move(expr));
    if (at(string)) return parse_string_literal(std::move(expr));
    if (at(bad_number)) return parse_bad_number();
    expr.kind = at(kw_none) ? ExprKind::none_literal : ExprKind::bool_literal;
    expr.value = at(kw_true);
    advance();
    return add(std::move(expr));
}

/// Reports a malformed number. The parser then continues as after a valid one, so that this is the only error.
ast::ExprId Parser::parse_bad_number() {
    std::string_view text = text_of(peek());
    std::string note = text.starts_with('.') ? "write 0" + std::string(text)
                                             : "suffixes: u, l, ul after integers; f, h, d after numbers with a point";
    diagnostics_.report(Diag::bad_number, here(), {text}).notes.push_back({{}, std::move(note)});
    ExprId error = error_expr();
    advance();
    return error;
}

ast::ExprId Parser::parse_integer(Expr expr) {
    expr.kind = ExprKind::int_literal;
    std::string_view text = text_of(advance());
    NumberParts parts = split_integer(text);
    set_suffix(expr, parts.suffix);
    auto result =
        std::from_chars(parts.digits.data(), parts.digits.data() + parts.digits.size(), expr.value, parts.base);
    constexpr std::uint64_t least = std::uint64_t{1} << 63;  // of int64, without its sign, which is checked in sema
    std::uint64_t most = parts.suffix == "u"   ? std::numeric_limits<std::uint32_t>::max()
                         : parts.suffix == "l" ? least
                                               : std::numeric_limits<std::uint64_t>::max();
    if (result.ec != std::errc() || expr.value > most) {
        std::string_view type = parts.suffix == "u" ? "uint" : parts.suffix == "l" ? "int64" : "uint64";
        diagnostics_.report(Diag::number_too_large, expr.span, {text, type});
        expr.value = 0;
    }
    return add(std::move(expr));
}

ast::ExprId Parser::parse_float(Expr expr) {
    expr.kind = ExprKind::float_literal;
    std::string_view text = text_of(advance());
    std::size_t end = text.find_last_not_of("fhd") + 1;
    std::string_view suffix = text.substr(end);
    set_suffix(expr, suffix);
    auto result = std::from_chars(text.data(), text.data() + end, expr.number);
    double most = suffix == "f"   ? double{std::numeric_limits<float>::max()}
                  : suffix == "h" ? 65504.0
                                  : std::numeric_limits<double>::max();
    const bool is_outside = result.ec == std::errc::result_out_of_range;
    const bool is_too_small = is_outside && is_tiny(text.substr(0, end));
    if (is_outside) expr.number = 0;
    if ((result.ec != std::errc() && !is_too_small) || expr.number > most) {
        std::string_view type = suffix == "f" ? "float" : suffix == "h" ? "half" : "double";
        diagnostics_.report(Diag::number_too_large, expr.span, {text, type});
        expr.number = 0;
    }
    return add(std::move(expr));
}

ast::ExprId Parser::parse_string_literal(Expr expr) {
    expr.kind = ExprKind::string_literal;
    expr.name = names_.intern(decode_string(peek()));
    advance();
    return add(std::move(expr));
}

/// Decodes the escapes \n \t \\ \" and reports others. The lexer has reported a string that is not closed.
std::string Parser::decode_string(const Token& token) {
    std::string_view text = text_of(token).substr(1);
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') break;
        if (text[i] != '\\' || i + 1 == text.size()) {
            decoded += text[i];
            continue;
        }
        char c = text[++i];
        std::uint32_t place = token.begin + static_cast<std::uint32_t>(i);
        switch (c) {
        case 'n': decoded += '\n'; break;
        case 't': decoded += '\t'; break;
        case '\\':
        case '"': decoded += c; break;
        default:
            std::size_t length = 1;
            while (i + length < text.size() && (static_cast<unsigned char>(text[i + length]) & 0xc0) == 0x80) ++length;
            Span span{file_, place, place + 1 + static_cast<std::uint32_t>(length)};
            diagnostics_.report(Diag::bad_escape, span, {text.substr(i, length)});
        }
    }
    return decoded;
}

/// tuple = "{" [ arguments ] "}" ;
ast::ExprId Parser::parse_tuple() {
    std::uint32_t first = cursor_;
    Expr expr;
    expr.kind = ExprKind::tuple;
    set_role(Role::open_tuple);
    advance();
    parse_arguments(expr, TokenKind::close_brace);
    set_role(Role::close_tuple);
    if (!expect_close(TokenKind::close_brace, first)) return error_expr();
    expr.span = since(first);
    return add(std::move(expr));
}

/// call = "(" [ arguments ] ")" ;
ast::ExprId Parser::parse_call(ExprId callee, std::uint32_t first) {
    std::uint32_t open = cursor_;
    Expr expr;
    expr.kind = ExprKind::call;
    expr.operands.push_back(callee);
    advance();
    parse_arguments(expr, TokenKind::close_paren);
    expect_close(TokenKind::close_paren, open);
    expr.span = since(first);
    return add(std::move(expr));
}

/// arguments = argument { "," argument } [ "," ] ;    argument = [ name ":" ] ( expression | closure ) ;
void Parser::parse_arguments(Expr& expr, TokenKind close) {
    Brackets brackets(*this);
    std::vector<ast::Identifier> labels;
    bool any_label = false;
    while (!at(close) && !at_end() && !lost_) {
        ast::Identifier label;
        if (at(TokenKind::identifier) && peek(1).kind == TokenKind::colon) {
            label = identifier_of(advance());
            advance();
            any_label = true;
        }
        labels.push_back(label);
        is_before_colon_ = static_cast<bool>(label.name);
        expr.operands.push_back(parse_argument());
        if (!accept(TokenKind::comma)) break;
    }
    if (any_label) expr.labels = std::move(labels);
}

/// index = "[" [ expression { "," expression } [ "," ] ] "]" ;
ast::ExprId Parser::parse_index(ExprId base, std::uint32_t first) {
    Brackets brackets(*this);
    std::uint32_t open = cursor_;
    Expr expr;
    expr.kind = ExprKind::index;
    expr.operands.push_back(base);
    advance();
    while (!at(TokenKind::close_bracket) && !at_end() && !lost_) {
        expr.operands.push_back(parse_expression());
        if (!accept(TokenKind::comma)) break;
    }
    expect_close(TokenKind::close_bracket, open);
    expr.span = since(first);
    return add(std::move(expr));
}

/// member = "." name ;      keywords are names here, as in `Boundary.none`
ast::ExprId Parser::parse_member(ExprId base, std::uint32_t first) {
    advance();
    Expr expr;
    expr.kind = ExprKind::member;
    expr.operands = {base};
    if (!peek().name) {
        fail_expected("the name of a member");
        return base;
    }
    expr.name_span = here();
    expr.name = advance().name;
    expr.span = since(first);
    return add(std::move(expr));
}

/// generic-arguments = "<" [ argument { "," argument } [ "," ] ] ">" ;    argument = [ name ":" ] generic-argument ;
ast::ExprId Parser::parse_generic_arguments(ExprId base, std::uint32_t first) {
    std::uint32_t open = cursor_;
    Expr expr;
    expr.kind = ExprKind::generic;
    expr.operands.push_back(base);
    set_role(Role::open_generic);
    advance();
    ++open_angles_;
    while (!at_close_angle() && !at_end() && !lost_) {
        const bool is_after_name =
            expr.operands.size() > 1 && tree_.exprs[expr.operands.back()].kind == ExprKind::named;
        const bool is_named = at(TokenKind::identifier) && peek(1).kind == TokenKind::colon;
        if (is_after_name && !is_named) fail_expected("a name and ':'", "arguments without a name come first");
        expr.operands.push_back(is_named ? parse_named_argument() : parse_generic_argument());
        if (!accept(TokenKind::comma)) break;
    }
    --open_angles_;
    expect_close_angle(open);
    expr.span = since(first);
    return add(std::move(expr));
}

ast::ExprId Parser::parse_named_argument() {
    const std::uint32_t first = cursor_;
    Expr expr;
    expr.kind = ExprKind::named;
    expr.name_span = here();
    expr.name = advance().name;
    advance();
    expr.operands = {parse_generic_argument()};
    expr.span = since(first);
    return add(std::move(expr));
}

/// Whether the token is `>>`, `>=` or `>>=` and generic arguments are open around those that
/// generic_arguments_follow() looks at, so that its first `>` can close them.
bool Parser::closes_outer(TokenKind kind) const {
    return open_angles_ > 0 && (kind == greater_greater || kind == greater_greater_equal || kind == greater_equal);
}

/// Whether the `<` here opens generic arguments: all tokens up to its `>` may occur in generic arguments, and the token
/// after the `>` may follow them. As in C#, `f(a < b, c > (d))` is parsed as a call of the generic `a<b, c>`. A `:`
/// must follow the name of an argument, unless it has another meaning here (is_before_colon_).
bool Parser::generic_arguments_follow() const {
    constexpr std::uint32_t farthest = 512;
    int angles = 0, brackets = 0;
    for (std::uint32_t i = 0; i < farthest; ++i) {
        TokenKind kind = peek(i).kind;
        if (kind == open_paren || kind == open_bracket) {
            ++brackets;
        } else if (kind == close_paren || kind == close_bracket) {
            if (--brackets < 0) return false;
        } else if (brackets > 0) {
            if (never_in_brackets.has(kind)) return false;
        } else if (kind == less) {
            ++angles;
        } else if (kind == greater || kind == greater_greater) {
            angles -= kind == greater ? 1 : 2;
            if (angles < 0) return open_angles_ > 0;  // `>>` closes an enclosing list, too
            if (angles == 0) return after_generic_arguments.has(peek(i + 1).kind) || closes_outer(peek(i + 1).kind);
        } else if (kind == greater_greater_equal) {
            return angles == 1 && open_angles_ > 0;
        } else if (kind == question || kind == question_question) {
            if (!after_optional.has(peek(i + 1).kind)) return false;
        } else if (kind == colon) {
            const bool begins = i > 1 && (peek(i - 2).kind == less || peek(i - 2).kind == comma);
            if (is_before_colon_ || !begins || peek(i - 1).kind != identifier) return false;
        } else if (!in_generic_arguments.has(kind)) {
            return false;
        }
    }
    return false;
}

}  // namespace gliftc
