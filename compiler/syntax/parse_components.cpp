// Declarations of translators and structures.
#include "syntax/parser_state.h"

namespace gliftc {

/// translator = "translator" name [ generic-parameters ]
///              ( ":" type "->" type "{" { field | method } "}" | "=" expression ";" ) ;
void Parser::parse_translator(ast::Decl& decl) {
    if (accept(TokenKind::equal)) {
        ast::Alias alias{parse_expression()};
        end_statement();
        decl.body = alias;
        return;
    }
    ast::Translator translator;
    if (!at(TokenKind::colon))
        fail_expected("':'", "a translator declares its address types: 'translator Name : uint3 -> uint'");
    set_role(Role::spaced);
    accept(TokenKind::colon);
    translator.virtual_type = parse_type();
    expect(TokenKind::arrow);
    translator.physical_type = parse_type();
    std::uint32_t open = cursor_;
    expect(TokenKind::open_brace);
    while (!lost_ && !list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        bool is_field = at(TokenKind::identifier) && peek(1).kind == TokenKind::colon;
        if (is_field) {
            translator.fields.push_back(parse_field());
        } else if (DeclId method = parse_method()) {
            translator.methods.push_back(method);
        }
        if (lost_) recover_in_list();
        if (cursor_ == before) advance();
    }
    if (!lost_) close_list(open);
    decl.body = std::move(translator);
}

/// structure = "structure" name [ generic-parameters ]
///             ( constructor [ ":" type "->" type ] "{" { item } "}" | "=" expression ";" ) ;
void Parser::parse_structure(ast::Decl& decl) {
    if (accept(TokenKind::equal)) {
        ast::Alias alias{parse_expression()};
        end_statement();
        decl.body = alias;
        return;
    }
    ast::Structure structure;
    if (!at(TokenKind::open_paren)) fail_expected("'=' or '('");
    structure.constructor = parse_params(Params::of_constructor);
    if (at(TokenKind::colon)) {
        set_role(Role::spaced);
        accept(TokenKind::colon);
        structure.virtual_type = parse_type();
        expect(TokenKind::arrow);
        structure.element_type = parse_type();
    }
    structure.items = parse_items();
    decl.body = std::move(structure);
}

}  // namespace gliftc
