// Declarations of draws (`raster`): states, varyings, and the vertex and fragment parts.
#include "syntax/parser_state.h"

namespace gliftc {

/// raster = "raster" name [ generic-parameters ] parameters "{" { state | varying | vertex | fragment } "}" ;
/// One vertex part, and at most one fragment part.
ast::Kernel Parser::parse_raster(std::vector<ast::GenericParam>& generics) {
    ast::Kernel kernel;
    kernel.raster.emplace();
    kernel.params = parse_patterned_params(generics);
    if (at(TokenKind::arrow)) fail_expected("'{'", "a raster returns nothing: it writes through its targets");
    std::uint32_t open = cursor_;
    if (lost_ || !expect(TokenKind::open_brace)) return kernel;
    while (!list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        parse_raster_item(kernel);
        if (lost_) recover_in_list();
        if (cursor_ == before) advance();
    }
    const bool is_whole = at(TokenKind::close_brace);
    close_list(open);
    if (is_whole && !kernel.raster->vertex_span && !lost_)
        diagnostics_.report(Diag::raster_without_vertex, span_of(tokens_[open]));
    return kernel;
}

/// Consumes the word that begins a part. Sets `first` to its place; if `first` is set already, reports that the draw
/// has a second part of this name.
void Parser::begin_raster_part(Span& first) {
    const Span here = span_of(advance());
    if (!first) {
        first = here;
        return;
    }
    Diagnostic& error = diagnostics_.report(Diag::raster_repeated, here, {sources_.text(here)});
    error.notes.push_back({first, "this is the first one"});
}

/// vertex = "vertex" block ;    fragment = "fragment" block ;
void Parser::parse_raster_item(ast::Kernel& kernel) {
    ast::Raster& raster = *kernel.raster;
    const bool is_part = peek(1).kind == TokenKind::open_brace;
    if (at_word(Word::vertex) && is_part) {
        begin_raster_part(raster.vertex_span);
        kernel.body = parse_block();
        return;
    }
    if (at_word(Word::fragment) && is_part) {
        begin_raster_part(raster.fragment_span);
        raster.fragment = parse_block();
        return;
    }
    if (at_word_before_name(Word::cull) || at_word_before_name(Word::draw)) return parse_raster_state(raster);
    if (at_word_before_name(Word::smooth) || at_word_before_name(Word::linear) || at_word_before_name(Word::flat))
        return parse_varying(raster);
    fail_expected("a part of a raster", "these are 'cull', 'draw', what is interpolated ('smooth', 'linear' or 'flat' "
                                        "before a name), 'vertex { … }' and 'fragment { … }'");
}

/// state = ( "cull" | "draw" ) name ";" ;
void Parser::parse_raster_state(ast::Raster& raster) {
    ast::RasterState state;
    state.word = peek().word;
    state.span = here();
    advance();
    state.value = parse_name("a state");
    end_statement();
    raster.states.push_back(state);
}

/// varying = ( "smooth" | "linear" | "flat" ) name ":" type ";" ;
void Parser::parse_varying(ast::Raster& raster) {
    ast::Varying varying;
    varying.interpolation = peek().word;
    advance();
    varying.name = parse_name("a name");
    expect(TokenKind::colon);
    varying.type = parse_type();
    end_statement();
    if (varying.type) raster.varyings.push_back(varying);
}

}  // namespace gliftc
