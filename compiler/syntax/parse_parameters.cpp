// Parameters of functions, kernels, pipelines and constructors, with directions and access patterns.
#include "syntax/parser_state.h"

#include "base/concat.h"

#include <array>
#include <utility>

namespace gliftc {

using ast::Direction;
using ast::Pattern;

/// parameters = "(" [ parameter { "," parameter } [ "," ] ] ")" ;
/// constructor = "(" [ argument { "," argument } [ "," ] ] ")" ;    argument = parameter [ "=" expression ] ;
std::vector<ast::Param> Parser::parse_params(Defaults defaults) {
    std::vector<ast::Param> params;
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_paren)) return params;
    while (!at(TokenKind::close_paren) && !at_end() && !lost_) {
        ast::Param param = parse_param();
        parse_default(param, params, defaults);
        params.push_back(std::move(param));
        if (!accept(TokenKind::comma)) break;
    }
    expect_close(TokenKind::close_paren, open);
    return params;
}

/// Parses `= expression`, if that follows the parameter, and reports a parameter without it after one that has it.
void Parser::parse_default(ast::Param& param, const std::vector<ast::Param>& earlier, Defaults defaults) {
    if (at(TokenKind::equal) && defaults == Defaults::refused)
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
/// Types may be left out in methods whose types the language gives, or the header of the translator, structure or view
/// (translate, invert, at, block); sema reports parameters of other functions that have none.
ast::Param Parser::parse_param() {
    ast::Param param;
    param.name = parse_name("a parameter");
    if (!accept(TokenKind::colon)) return param;
    std::uint32_t first = cursor_;
    param.direction = parse_direction();
    if (param.direction != Direction::none) param.direction_span = since(first);
    param.pattern = pattern_here();
    if (param.pattern != Pattern::none) {
        parse_pattern(param);
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

ast::Pattern Parser::pattern_here() const {
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
    // An identifier may follow instead of '<', as in `each S`: parse_pattern() reports the missing '<'.
    if (peek(1).kind != TokenKind::less && peek(1).kind != TokenKind::identifier) return Pattern::none;
    for (auto [word, pattern] : patterns)
        if (at_word(word)) return pattern;
    return Pattern::none;
}

/// pattern = ( "each" | "near" | "any" | "at" | "scatter" | "coherent" | "calls" | "target" | "instance" | "range" )
/// "<" generic-argument { "," generic-argument } ">" ;
void Parser::parse_pattern(ast::Param& param) {
    const std::string_view word = text_of(peek());
    param.pattern_span = span_of(advance());
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
