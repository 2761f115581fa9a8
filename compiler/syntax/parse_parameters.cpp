// Parameters of functions, kernels, pipelines and constructors, with directions and access patterns.
#include "syntax/parser_state.h"

#include "base/concat.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gliftc {

using ast::Direction;
using ast::ExprKind;
using ast::Pattern;

/// parameters = "(" [ parameter { "," parameter } [ "," ] ] ")" ;
/// constructor = "(" [ argument { "," argument } [ "," ] ] ")" ;    argument = parameter [ "=" expression ] ;
std::vector<ast::Param> Parser::parse_params(Params kind) {
    std::vector<ast::Param> params;
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_paren)) return params;
    while (!at(TokenKind::close_paren) && !at_end() && !lost_) {
        ast::Param param = parse_param(kind == Params::patterned ? Bare::allowed : Bare::refused);
        parse_default(param, params, kind);
        params.push_back(std::move(param));
        if (!accept(TokenKind::comma)) break;
    }
    expect_close(TokenKind::close_paren, open);
    return params;
}

/// The parameters of a kernel or function. Adds the unnamed ones among its generic parameters to `generics`: that of
/// `at` last, since its default is the structure that another pattern names.
std::vector<ast::Param> Parser::parse_patterned_params(std::vector<ast::GenericParam>& generics) {
    std::vector<ast::Param> params = parse_params(Params::patterned);
    if (lost_) return params;
    for (ast::Param& param : params)
        if (param.pattern != Pattern::at) add_unnamed(param, generics);
    ast::Param giver;  // its range is that of `at` where a call leaves the argument out; none in draws
    for (Pattern pattern : {Pattern::any, Pattern::near, Pattern::each, Pattern::target})
        if (auto found = std::ranges::find(params, pattern, &ast::Param::pattern); found != params.end())
            giver = pattern == Pattern::target ? ast::Param{} : *found;
    for (ast::Param& param : params) {
        if (param.pattern != Pattern::at) continue;
        const std::size_t before = generics.size();
        add_unnamed(param, generics);
        if (generics.size() > before) generics.back().default_value = giver.type;
    }
    return params;
}

/// Adds a generic parameter to `generics` if the parameter's pattern names no structure, as `each`, `near<1>`,
/// `scatter<_, add>` and `any<Structure<uint3, float>>`, and makes it the parameter's type.
void Parser::add_unnamed(ast::Param& param, std::vector<ast::GenericParam>& generics) {
    if (param.pattern == Pattern::none || param.pattern == Pattern::range) return;
    const auto is_of = [&](ExprKind kind) { return param.type && tree_.exprs[param.type].kind == kind; };
    const auto is_name = [&](ExprId id, std::string_view text) {
        return tree_.exprs[id].kind == ExprKind::name && names_[tree_.exprs[id].name] == text;
    };
    const Span span = param.type ? tree_.exprs[param.type].span : param.pattern_span;
    if (is_of(ExprKind::int_literal) || is_of(ExprKind::call)) {  // `near<1>`, `near<uint2(4, 0)>`
        param.extra.insert(param.extra.begin(), param.type);
        param.type = {};
    }
    ExprId constraint;
    if (is_of(ExprKind::name) && is_name(param.type, "Structure")) constraint = param.type;
    if (is_of(ExprKind::generic) && is_name(tree_.exprs[param.type].operands[0], "Structure")) constraint = param.type;
    const bool is_left_out = !param.type || is_name(param.type, "_");
    if (!is_left_out && !constraint) return;
    ast::Expr type;
    type.kind = ExprKind::name;
    type.name = names_.intern("structure of " + names_[param.name.name]);
    type.span = span;
    generics.push_back({.name = {type.name, span}, .constraint = constraint, .parameter = param.name.name});
    param.type = add(std::move(type));
}

/// Parses `= expression`, if that follows the parameter, and reports a parameter without it after one that has it.
void Parser::parse_default(ast::Param& param, const std::vector<ast::Param>& earlier, Params kind) {
    if (at(TokenKind::equal) && kind != Params::of_constructor)
        return fail_expected("')'", "only the arguments of constructors have defaults");
    if (!lost_ && accept(TokenKind::equal)) {
        param.default_value = parse_expression();
    } else if (!earlier.empty() && earlier.back().default_value) {
        diagnostics_
            .report(Diag::default_missing, param.name.span, {names_[param.name.name], names_[earlier.back().name.name]})
            .notes.push_back({{}, "arguments without a default come first"});
    }
}

/// parameter = name [ ":" [ direction ] ( pattern | type ) ] ;
/// Types may be left out in methods whose types the language gives, or the header of the translator or structure
/// (translate, invert, at, block); sema reports parameters of other functions that have none.
ast::Param Parser::parse_param(Bare bare) {
    ast::Param param;
    param.name = parse_name("a parameter");
    if (!accept(TokenKind::colon)) return param;
    std::uint32_t first = cursor_;
    param.direction = parse_direction();
    if (param.direction != Direction::none) param.direction_span = since(first);
    param.pattern = pattern_here(bare);
    if (param.pattern != Pattern::none) {
        parse_pattern(param, bare);
    } else if (at_word(Word::activate) && peek(1).kind == TokenKind::less) {
        fail_reserved("iterators that ask for residency come in a later version");
    } else {
        param.type = parse_type();
    }
    return param;
}

/// direction = "in" | "out" | "inout" ;
ast::Direction Parser::parse_direction() {
    if (accept(TokenKind::kw_in)) return Direction::in;
    if (at_word_before_name(Word::out)) {
        advance();
        return Direction::out;
    }
    if (at_word_before_name(Word::inout)) {
        advance();
        return Direction::inout;
    }
    return Direction::none;
}

ast::Pattern Parser::pattern_here(Bare bare) const {
    static constexpr std::array<std::pair<Word, Pattern>, 10> patterns{{
        {Word::each, Pattern::each},
        {Word::near, Pattern::near},
        {Word::any, Pattern::any},
        {Word::at, Pattern::at},
        {Word::scatter, Pattern::scatter},
        {Word::coherent, Pattern::coherent},
        {Word::calls, Pattern::calls},
        {Word::target, Pattern::target},
        {Word::instance, Pattern::instance},
        {Word::range, Pattern::range},
    }};
    const TokenKind next = peek(1).kind;
    const bool ends = next == TokenKind::comma || next == TokenKind::close_paren;
    // An identifier may follow instead of '<', as in `each S`: parse_pattern() reports the missing '<'.
    if (next != TokenKind::less && next != TokenKind::identifier && !(ends && bare == Bare::allowed))
        return Pattern::none;
    for (auto [word, pattern] : patterns)
        if (at_word(word) && !(ends && pattern == Pattern::range)) return pattern;
    return Pattern::none;
}

/// pattern = ( "each" | "near" | "any" | "at" | "scatter" | "coherent" | "calls" | "target" | "instance" | "range" )
///           [ "<" generic-argument { "," generic-argument } ">" ] ;      the brackets may be left out in kernels and
///           functions
void Parser::parse_pattern(ast::Param& param, Bare bare) {
    const std::string_view word = text_of(peek());
    param.pattern_span = span_of(advance());
    if (bare == Bare::allowed && !at(TokenKind::less) && !at(TokenKind::identifier)) return;
    if (!at(TokenKind::less))
        return fail_expected("'<'", concat("the structure is written in angle brackets: '", word, "<…>'"));
    std::uint32_t open = cursor_;
    set_role(Role::open_generic);
    advance();
    ++open_angles_;
    param.type = parse_generic_argument();
    while (!lost_ && accept(TokenKind::comma)) param.extra.push_back(parse_generic_argument());
    --open_angles_;
    expect_close_angle(open);
}

/// result = "->" ( "range" "<" generic-argument "," generic-argument ">" | type ) ;
void Parser::parse_pipeline_result(ast::Pipeline& pipeline) {
    if (!accept(TokenKind::arrow)) return;
    if (pattern_here() != Pattern::range) {
        pipeline.result = parse_type();
        return;
    }
    ast::Param result;
    parse_pattern(result);
    pipeline.result_pattern = Pattern::range;
    pipeline.result = result.type;
    if (result.extra.size() == 1) {
        pipeline.result_extra = result.extra.front();
    } else {
        fail(Diag::expected, result.pattern_span,
             {"'range<N, T>'", concat("'range' of ", std::to_string(1 + result.extra.size()), " arguments")});
    }
}

}  // namespace gliftc
