// Statements.
#include "syntax/parser_state.h"

#include <array>
#include <optional>
#include <utility>

namespace gliftc {

using ast::BinaryOp;
using ast::Stmt;
using ast::StmtKind;

namespace {

std::optional<BinaryOp> assignment_of(TokenKind kind) {
    using enum TokenKind;
    static constexpr std::array<std::pair<TokenKind, BinaryOp>, 10> operators{{
        {plus_equal, BinaryOp::add},
        {minus_equal, BinaryOp::subtract},
        {star_equal, BinaryOp::multiply},
        {slash_equal, BinaryOp::divide},
        {percent_equal, BinaryOp::remainder},
        {ampersand_equal, BinaryOp::bit_and},
        {bar_equal, BinaryOp::bit_or},
        {caret_equal, BinaryOp::bit_xor},
        {less_less_equal, BinaryOp::shift_left},
        {greater_greater_equal, BinaryOp::shift_right},
    }};
    for (auto [token, op] : operators)
        if (token == kind) return op;
    return std::nullopt;
}

}  // namespace

ast::StmtId Parser::finish(Stmt statement, std::uint32_t first) {
    statement.span = since(first);
    return tree_.stmts.add(std::move(statement));
}

void Parser::end_statement() {
    if (!lost_) expect(TokenKind::semicolon);
}

/// block = "{" { statement } "}" ;
std::vector<ast::StmtId> Parser::parse_block() {
    std::vector<StmtId> body;
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_brace)) return body;
    while (!list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        body.push_back(parse_statement());
        if (lost_) recover_in_list();
        if (cursor_ == before) advance();
    }
    close_list(open);
    return body;
}

/// statement = let | shared | temp | if | for | while | switch | jump | return | block | expression-statement ;
ast::StmtId Parser::parse_statement() {
    using enum TokenKind;
    Nesting nesting(*this);
    if (!nesting.ok) return finish({}, cursor_);
    if (at(kw_let) || at(kw_var) || at(kw_const)) return parse_let();
    if (at(kw_if)) return parse_if();
    if (at(kw_for)) return parse_for();
    if (at(kw_while)) return parse_while();
    if (at(kw_switch)) return parse_switch();
    if (at(kw_return)) return parse_return();
    if (at(kw_break)) return parse_jump(StmtKind::break_);
    if (at(kw_continue)) return parse_jump(StmtKind::continue_);
    if (at(open_brace)) return parse_block_statement();
    if (at_word(Word::discard) && peek(1).kind == semicolon) return parse_jump(StmtKind::discard);
    if (at_word_before_name(Word::shared)) return parse_shared();
    if (at_word_before_name(Word::temp) || at_word_before_name(Word::uninitialized)) return parse_temp();
    return parse_expression_statement();
}

/// let = ( "let" | "var" | "const" ) name [ ":" type ] "=" expression ";" | "var" name ":" type ";" ;
ast::StmtId Parser::parse_let() {
    std::uint32_t first = cursor_;
    Stmt let;
    let.kind = StmtKind::let;
    TokenKind word = advance().kind;
    let.binding = word == TokenKind::kw_let   ? ast::Binding::let
                  : word == TokenKind::kw_var ? ast::Binding::var
                                              : ast::Binding::const_;
    let.name = parse_name("a name");
    if (accept(TokenKind::colon)) let.type = parse_type();
    bool begins_as_zero = let.binding == ast::Binding::var && let.type && at(TokenKind::semicolon);
    if (begins_as_zero) {
        end_statement();
        let.span = since(first);
        return tree_.stmts.add(std::move(let));
    }
    if (at(TokenKind::equal)) {
        advance();
    } else {
        fail_expected("'='", "every variable is initialised; 'var name: type;' with zeros");
    }
    let.value = lost_ ? error_expr() : parse_expression();
    end_statement();
    return finish(std::move(let), first);
}

/// shared = "shared" name ":" type ";" ;
ast::StmtId Parser::parse_shared() {
    std::uint32_t first = cursor_;
    Stmt shared;
    shared.kind = StmtKind::shared;
    advance();
    shared.name = parse_name("a name");
    expect(TokenKind::colon);
    shared.type = parse_type();
    end_statement();
    return finish(std::move(shared), first);
}

/// temp = [ "uninitialized" ] "temp" name [ ":" type ] "=" expression ";" ;
ast::StmtId Parser::parse_temp() {
    std::uint32_t first = cursor_;
    Stmt temp;
    temp.kind = StmtKind::temp;
    temp.is_uninitialized = accept_word(Word::uninitialized);
    if (!accept_word(Word::temp)) fail_expected("'temp'", "'uninitialized' applies to temporaries");
    temp.name = parse_name("a name");
    if (accept(TokenKind::colon)) temp.type = parse_type();
    expect(TokenKind::equal);
    temp.value = lost_ ? error_expr() : parse_expression();
    end_statement();
    return finish(std::move(temp), first);
}

/// if = "if" ( expression | "let" name "=" expression ) block [ "else" ( if | block ) ] ;
ast::StmtId Parser::parse_if() {
    std::uint32_t first = cursor_;
    Stmt branch;
    branch.kind = StmtKind::if_;
    advance();
    if (accept(TokenKind::kw_let)) {
        branch.name = parse_name("a name");
        expect(TokenKind::equal);
    }
    branch.value = lost_ ? error_expr() : parse_expression();
    branch.body = parse_block();
    if (!lost_ && accept(TokenKind::kw_else)) {
        branch.has_else = true;
        if (at(TokenKind::kw_if)) {
            branch.otherwise.push_back(parse_statement());
        } else {
            branch.otherwise = parse_block();
        }
    }
    return finish(std::move(branch), first);
}

/// for = "for" name "in" expression [ "while" expression ] block ;
ast::StmtId Parser::parse_for() {
    std::uint32_t first = cursor_;
    Stmt loop;
    loop.kind = StmtKind::for_;
    advance();
    if (at(TokenKind::open_paren)) fail_expected("a name", "loops are written 'for i in 0..n { }'");
    loop.name = parse_name("a name");
    expect(TokenKind::kw_in);
    loop.value = lost_ ? error_expr() : parse_expression();
    if (at(TokenKind::kw_while)) {
        advance();
        loop.condition = parse_expression();
    }
    loop.body = parse_block();
    return finish(std::move(loop), first);
}

/// while = "while" expression block ;
ast::StmtId Parser::parse_while() {
    std::uint32_t first = cursor_;
    Stmt loop;
    loop.kind = StmtKind::while_;
    advance();
    loop.value = parse_expression();
    loop.body = parse_block();
    return finish(std::move(loop), first);
}

ast::ExprId Parser::compare(BinaryOp op, ExprId left, ExprId right) {
    ast::Expr expr;
    expr.kind = ast::ExprKind::binary;
    expr.binary = op;
    expr.span = expr.name_span = tree_.exprs[right].span;
    expr.operands = {left, right};
    return add(std::move(expr));
}

/// case = conditional [ ".." conditional ] ;      as a condition on the variable `name`
ast::ExprId Parser::parse_case(ast::Identifier name) {
    const ExprId value = parse_range();
    ast::Expr variable;
    variable.kind = ast::ExprKind::name;
    variable.name = name.name;
    variable.span = name.span;
    const ExprId tested = add(std::move(variable));
    const ast::Expr written = tree_.exprs[value];
    if (written.kind != ast::ExprKind::range) return compare(BinaryOp::equal, tested, value);
    const ExprId inside = compare(BinaryOp::logical_and, compare(BinaryOp::greater_equal, tested, written.operands[0]),
                                  compare(BinaryOp::less, tested, written.operands[1]));
    tree_.exprs[inside].span = written.span;
    return inside;
}

/// branch = ( case { "," case } | "else" ) ":" block ;      as an `if`; of `else` without a condition
ast::Stmt Parser::parse_branch(ast::Stmt& of) {
    Stmt branch;
    branch.kind = StmtKind::if_;
    branch.span = here();
    of.has_else = accept(TokenKind::kw_else);
    const bool was_before_colon = std::exchange(is_before_colon_, true);
    if (!of.has_else) branch.value = parse_case(of.name);
    while (!of.has_else && !lost_ && accept(TokenKind::comma))
        branch.value = compare(BinaryOp::logical_or, branch.value, parse_case(of.name));
    is_before_colon_ = was_before_colon;
    if (!lost_) expect(TokenKind::colon);
    branch.body = parse_block();
    return branch;
}

/// switch = "switch" expression "{" { branch } "}" ;
ast::StmtId Parser::parse_switch() {
    const std::uint32_t first = cursor_;
    Stmt chosen;
    chosen.kind = StmtKind::switch_;
    advance();
    chosen.value = parse_expression();
    chosen.name = {names_.intern("switch value"), tree_.exprs[chosen.value].span};
    const std::uint32_t open = cursor_;
    std::vector<Stmt> branches;
    if (!lost_ && expect(TokenKind::open_brace)) {
        while (!list_ends()) {
            const std::uint32_t before = cursor_;
            if (accept(TokenKind::semicolon)) continue;
            if (chosen.has_else) fail_expected("'}'", "'else' comes last");
            if (!lost_) branches.push_back(parse_branch(chosen));
            if (lost_) recover_in_list();
            if (cursor_ == before) advance();
        }
        close_list(open);
    }
    if (chosen.has_else) chosen.body = std::move(branches.back().body), branches.pop_back();
    chosen.branches = static_cast<std::uint32_t>(branches.size());
    bool has_else = chosen.has_else;
    for (; !branches.empty(); branches.pop_back()) {
        branches.back().otherwise = std::exchange(chosen.body, {});
        branches.back().has_else = std::exchange(has_else, true);
        chosen.body = {tree_.stmts.add(std::move(branches.back()))};
    }
    return finish(std::move(chosen), first);
}

/// jump = ( "break" | "continue" | "discard" ) ";" ;
ast::StmtId Parser::parse_jump(StmtKind kind) {
    std::uint32_t first = cursor_;
    Stmt jump;
    jump.kind = kind;
    advance();
    end_statement();
    return finish(std::move(jump), first);
}

/// return = "return" [ expression ] ";" ;
ast::StmtId Parser::parse_return() {
    std::uint32_t first = cursor_;
    Stmt result;
    result.kind = StmtKind::return_;
    advance();
    bool ends_line = peek().first_on_line && at_statement_keyword();
    if (!at(TokenKind::semicolon) && !at(TokenKind::close_brace) && !ends_line) result.value = parse_expression();
    end_statement();
    return finish(std::move(result), first);
}

ast::StmtId Parser::parse_block_statement() {
    std::uint32_t first = cursor_;
    Stmt block;
    block.kind = StmtKind::block;
    block.body = parse_block();
    return finish(std::move(block), first);
}

/// expression-statement = expression [ assignment-operator expression ] ";" ;
ast::StmtId Parser::parse_expression_statement() {
    std::uint32_t first = cursor_;
    Stmt statement;
    ExprId expr = parse_expression();
    auto op = assignment_of(peek().kind);
    if (!lost_ && (op || at(TokenKind::equal))) {
        statement.kind = StmtKind::assign;
        statement.target = expr;
        statement.op = op;
        statement.op_span = span_of(advance());
        statement.value = parse_expression();
    } else {
        statement.kind = StmtKind::expression;
        statement.value = expr;
    }
    end_statement();
    return finish(std::move(statement), first);
}

}  // namespace gliftc
