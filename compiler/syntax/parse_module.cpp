// A file: its header, its imports, its declarations.
#include "syntax/habits.h"
#include "syntax/parser_state.h"

#include <utility>

namespace gliftc {

using ast::Decl;

namespace {

const std::vector<std::string_view> declaration_spellings{"fn",       "struct",    "enum",       "interface", "const",
                                                          "type",     "structure", "translator", "kernel",    "raster",
                                                          "pipeline", "test",      "pub",        "use",       "extern"};

}  // namespace

/// file = "module" path ";" { use | declaration | ";" } ;
ast::Module Parser::parse_module() {
    ast::Module module;
    module.file = file_;
    parse_module_header(module);
    while (!at_end() && !diagnostics_.at_limit()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        if (at(TokenKind::kw_use)) {
            ast::Use use = parse_use();
            if (!use.path.empty()) module.uses.push_back(std::move(use));
        } else if (DeclId decl = parse_declaration()) {
            module.decls.push_back(decl);
        }
        if (lost_) recover_in_module();
        if (cursor_ == before) advance();
    }
    return module;
}

void Parser::parse_module_header(ast::Module& module) {
    module.doc = doc_before(0);
    if (!at(TokenKind::kw_module)) {
        diagnostics_.report(Diag::expected_module, here());
        return;
    }
    advance();
    std::uint32_t first = cursor_;
    std::string path;
    if (parse_path(path)) {
        module.name = {names_.intern(path), since(first)};
        end_statement();
    }
    if (lost_) recover_in_module();
}

/// path = name { "." name } ;
bool Parser::parse_path(std::string& path) {
    do {
        if (!peek().name) {
            fail_expected("the name of a module");
            return false;
        }
        path += text_of(advance());
    } while (at(TokenKind::dot) && (path += text_of(advance()), true));
    return true;
}

/// use = "use" ( path | ( "./" | "../" { "../" } ) name { "/" name } ) ";" ;
/// For a relative path more is accepted: any names, `.`, `..` and `/` that begin with `./` or `../` and do not end in
/// `/`.
ast::Use Parser::parse_use() {
    advance();
    std::uint32_t first = cursor_;
    ast::Use use;
    if (!at(TokenKind::dot) && !at(TokenKind::dot_dot)) {
        if (!parse_path(use.path)) return {};
    } else {
        while (at(TokenKind::dot) || at(TokenKind::dot_dot) || at(TokenKind::slash) || peek().name)
            use.path += text_of(advance());
        bool relative = use.path.starts_with("./") || use.path.starts_with("../");
        if (!relative || use.path.back() == '/') {
            fail(Diag::expected, since(first), {"'./name'", "'" + use.path + "'"});
            return {};
        }
    }
    use.span = since(first);
    end_statement();
    return use;
}

/// attributes = { "@" name [ "(" [ expression { "," expression } [ "," ] ] ")" ] } ;
std::vector<ast::Attribute> Parser::parse_attributes() {
    std::vector<ast::Attribute> attributes;
    while (at(TokenKind::at_sign) && !lost_) {
        std::uint32_t first = cursor_;
        ast::Attribute attribute;
        advance();
        attribute.name = parse_name("the name of an attribute");
        if (at(TokenKind::open_paren)) {
            std::uint32_t open = cursor_;
            advance();
            while (!at(TokenKind::close_paren) && !at_end() && !lost_) {
                attribute.arguments.push_back(parse_expression());
                if (!accept(TokenKind::comma)) break;
            }
            expect_close(TokenKind::close_paren, open);
        }
        attribute.span = since(first);
        attributes.push_back(std::move(attribute));
    }
    return attributes;
}

/// declaration = attributes [ "pub" ] [ "extern" (* only before a struct *) ]
///               ( function | struct | enum | interface | const | type-alias | translator | structure | kernel
///               | raster | pipeline | test ) ;
ast::DeclId Parser::parse_declaration() {
    Nesting nesting(*this);
    if (!nesting.ok) return {};
    std::uint32_t first = cursor_;
    Decl decl;
    decl.doc = doc_before(cursor_);
    decl.attributes = parse_attributes();
    decl.is_pub = accept(TokenKind::kw_pub);
    decl.is_extern = accept(TokenKind::kw_extern);
    if (decl.is_extern && !at(TokenKind::kw_struct)) fail_expected("'struct'");
    if (lost_) return {};
    parse_declaration_body(decl);
    if (std::holds_alternative<std::monostate>(decl.body)) return {};
    decl.span = since(first);
    return tree_.decls.add(std::move(decl));
}

void Parser::parse_declaration_body(Decl& decl) {
    using enum TokenKind;
    std::uint32_t keyword = cursor_;
    if (at_word(Word::test) && peek(1).kind == string) {
        advance();
        ast::Test test;
        test.title = decode_string(advance());
        const Enclosing enclosing(*this, "test");
        test.body = parse_block();
        decl.body = std::move(test);
        return;
    }
    bool known = at(kw_fn) || at(kw_struct) || at(kw_enum) || at(kw_interface) || at(kw_const) || at_declaration_word();
    if (!known) {
        std::string note = hint_for_declaration(text_of(peek()));
        std::string_view meant = did_you_mean(text_of(peek()), declaration_spellings);
        if (note.empty() && !meant.empty()) note = "did you mean '" + std::string(meant) + "'?";
        fail(Diag::expected_declaration, here(), {shown(peek())}, std::move(note));
        return;
    }
    advance();
    decl.name = parse_name("a name");
    if (lost_) return;
    const Enclosing enclosing(*this, names_[decl.name.name]);
    const Token what = tokens_[keyword];
    const bool is_generic = what.kind != kw_enum && what.kind != kw_const && !decl.is_extern;
    if (is_generic) decl.generics = parse_generic_params();
    parse_body_after_name(decl, what);
}

/// Parses what follows the name, depending on the keyword before it.
void Parser::parse_body_after_name(Decl& decl, const Token& keyword) {
    using enum TokenKind;
    if (keyword.kind == kw_fn) decl.body = parse_function(decl.generics);
    if (keyword.kind == kw_struct) decl.body = decl.is_extern ? parse_extern_struct() : parse_struct();
    if (keyword.kind == kw_enum) decl.body = parse_enum();
    if (keyword.kind == kw_interface) decl.body = parse_interface();
    if (keyword.kind == kw_const) decl.body = parse_const();
    if (keyword.word == Word::type) decl.body = parse_type_alias();
    if (keyword.word == Word::translator) parse_translator(decl);
    if (keyword.word == Word::structure) parse_structure(decl);
    if (keyword.word == Word::kernel && at(equal)) decl.body = parse_kernel_instances();
    else if (keyword.word == Word::kernel) decl.body = parse_kernel(decl.generics);
    if (keyword.word == Word::raster) decl.body = parse_raster(decl.generics);
    if (keyword.word == Word::pipeline) decl.body = parse_pipeline();
}

}  // namespace gliftc
