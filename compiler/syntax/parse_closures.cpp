// Closures: `|a, b| a * b`, arguments of calls.
#include "syntax/parser_state.h"

namespace gliftc {

using ast::Expr;
using ast::ExprKind;

/// argument = [ name ":" ] ( expression | closure ) ;      parse_arguments() has parsed the name
ast::ExprId Parser::parse_argument() {
    return at(TokenKind::bar) || at(TokenKind::bar_bar) ? parse_closure() : parse_expression();
}

/// closure = ( "|" [ parameter { "," parameter } ] "|" | "||" ) ( conditional | block ) ;
ast::ExprId Parser::parse_closure() {
    Nesting nesting(*this);
    if (!nesting.ok) return error_expr();
    const Brackets brackets(*this);
    const std::uint32_t first = cursor_;
    Expr expr;
    expr.kind = ExprKind::closure;
    ast::Decl decl;
    decl.name.name = closure_name();
    ast::Function function;
    function.has_body = true;
    function.params = parse_closure_params();
    decl.name.span = since(first);
    if (lost_) return error_expr();
    function.body = parse_closure_body(expr);
    if (lost_) return error_expr();
    decl.span = expr.span = since(first);
    decl.body = std::move(function);
    expr.decl = tree_.decls.add(std::move(decl));
    return add(std::move(expr));
}

/// The parameters and the bars around them.
std::vector<ast::Param> Parser::parse_closure_params() {
    std::vector<ast::Param> params;
    if (accept(TokenKind::bar_bar)) return params;
    set_role(Role::open_tuple);
    advance();
    while (!at(TokenKind::bar) && !at_end() && !lost_) {
        ast::Param param;
        param.name = parse_name("a parameter");
        if (!lost_ && accept(TokenKind::colon)) param.type = parse_type();
        params.push_back(std::move(param));
        if (!accept(TokenKind::comma)) break;
    }
    set_role(Role::close_tuple);
    expect(TokenKind::bar);
    return params;
}

/// The statements of the body. That of an expression is `return expression;`; the expression becomes the closure's
/// operand, too.
std::vector<ast::StmtId> Parser::parse_closure_body(Expr& closure) {
    if (at(TokenKind::open_brace)) return parse_block();
    ast::Stmt result;
    result.kind = ast::StmtKind::return_;
    result.value = parse_conditional();
    result.span = tree_.exprs[result.value].span;
    closure.operands = {result.value};
    return {tree_.stmts.add(std::move(result))};
}

/// `smoke_step_closure_1`: by the declarations around it and its place among their closures.
Name Parser::closure_name() {
    return names_.intern(enclosing_ + "_closure_" + std::to_string(++closures_[enclosing_]));
}

}  // namespace gliftc
