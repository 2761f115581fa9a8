// Types, and the generic parameters of declarations.
#include "syntax/parser_state.h"

namespace gliftc {

using ast::Expr;
using ast::ExprKind;

/// type = name { generic-arguments | index | member-access | "?" } ;      "??" is "?" twice here
ast::ExprId Parser::parse_type() {
    using enum TokenKind;
    Nesting nesting(*this);
    if (!nesting.ok) return error_expr();
    std::uint32_t first = cursor_;
    if (!at(identifier)) {
        fail_expected("a type");
        return error_expr();
    }
    ExprId type = parse_name_expression();
    while (!lost_) {
        if (at(less)) {
            type = parse_generic_arguments(type, first);
        } else if (at(dot)) {
            type = parse_member(type, first);
        } else if (at(open_bracket)) {
            type = parse_index(type, first);
        } else if (at_optional_mark()) {
            type = parse_optional(type, first);
        } else {
            break;
        }
    }
    return type;
}

bool Parser::at_optional_mark() const { return at(TokenKind::question) || at(TokenKind::question_question); }

/// Consumes one `?`, which may be the first half of a `??`: in types that is an optional of an optional.
ast::ExprId Parser::parse_optional(ExprId type, std::uint32_t first) {
    set_role(Role::optional);
    Expr expr;
    expr.kind = ExprKind::optional;
    expr.name_span = here();
    if (at(TokenKind::question)) {
        advance();
    } else {
        Token& token = tokens_[cursor_];
        token.kind = TokenKind::question;
        previous_end_ = ++token.begin;
        expr.name_span.end = previous_end_;
    }
    expr.operands = {type};
    expr.span = since(first);
    return add(std::move(expr));
}

/// generic-parameters = "<" [ generic-parameter { "," generic-parameter } [ "," ] ] ">" ;
/// generic-parameter = name ":" type [ "=" generic-argument ] ;
std::vector<ast::GenericParam> Parser::parse_generic_params() {
    std::vector<ast::GenericParam> params;
    if (!at(TokenKind::less)) return params;
    std::uint32_t open = cursor_;
    set_role(Role::open_generic);
    advance();
    ++open_angles_;
    while (!at_close_angle() && !at_end() && !lost_) {
        ast::GenericParam param;
        param.name = parse_name("a generic parameter");
        if (at(TokenKind::colon)) {
            advance();
            param.constraint = parse_type();
        } else {
            fail_expected("':'", "a generic parameter has a constraint: 'T: type', 'N: uint'");
        }
        if (!lost_ && accept(TokenKind::equal)) param.default_value = parse_generic_argument();
        if (param.name.name) params.push_back(param);
        if (!accept(TokenKind::comma)) break;
    }
    --open_angles_;
    expect_close_angle(open);
    return params;
}

}  // namespace gliftc
