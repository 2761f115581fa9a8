// Declarations of functions, structs, enums, interfaces, constants, type aliases, kernels and pipelines.
#include "syntax/parser_state.h"

namespace gliftc {

/// with = "with" member-pattern { "," member-pattern } ;
/// member-pattern = ( "scatter" | "coherent" | "calls" ) "<" name { "," generic-argument } ">" ;
std::vector<ast::MemberPattern> Parser::parse_with() {
    std::vector<ast::MemberPattern> patterns;
    if (lost_ || !accept_word(Word::with)) return patterns;
    do {
        ast::MemberPattern made;
        made.pattern = pattern_here();
        const bool writes = made.pattern == ast::Pattern::scatter || made.pattern == ast::Pattern::coherent ||
                            made.pattern == ast::Pattern::calls;
        if (!writes || peek(1).kind != TokenKind::less) {
            fail_expected("'scatter<member>', 'coherent<member>' or 'calls<member>'");
            return patterns;
        }
        made.pattern_span = span_of(advance());
        const std::uint32_t open = cursor_;
        set_role(Role::open_generic);
        advance();
        ++open_angles_;
        made.member = parse_name("a member");
        while (!lost_ && accept(TokenKind::comma)) made.extra.push_back(parse_generic_argument());
        --open_angles_;
        expect_close_angle(open);
        patterns.push_back(std::move(made));
    } while (!lost_ && accept(TokenKind::comma));
    return patterns;
}

/// function = "fn" name [ generic-parameters ] parameters [ group ] [ with ] [ "->" type ] ( block | ";" ) ;
ast::Function Parser::parse_function(std::vector<ast::GenericParam>& generics) {
    ast::Function function;
    function.params = parse_patterned_params(generics);
    function.group = parse_group();
    function.with = parse_with();
    if (accept(TokenKind::arrow)) function.result = parse_type();
    if (at(TokenKind::open_brace)) {
        function.has_body = true;
        function.body = parse_block();
    } else if (!lost_ && !accept(TokenKind::semicolon)) {
        fail_expected("'{'");
    }
    return function;
}

/// extern-struct = "extern" "struct" name "from" string ";" ;
ast::Struct Parser::parse_extern_struct() {
    ast::Struct structure;
    if (!accept_word(Word::from)) {
        fail_expected("'from'", "the fields of an 'extern struct' are read from a C++ header: 'from \"file.h\";'");
        return structure;
    }
    structure.extern_span = here();
    if (at(TokenKind::string)) {
        structure.extern_header = decode_string(advance());
        end_statement();
    } else {
        fail_expected("the header's name in quotes");
    }
    return structure;
}

/// struct = "struct" name [ generic-parameters ] "{" { field } "}" ;
ast::Struct Parser::parse_struct() {
    ast::Struct structure;
    if (at_word(Word::from)) {
        fail_expected("'{'", "a struct that is read from a C++ header is an 'extern struct'");
        return structure;
    }
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_brace)) return structure;
    while (!list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        structure.fields.push_back(parse_field());
        if (lost_) recover_in_list();
        if (cursor_ == before) advance();
    }
    close_list(open);
    return structure;
}

/// field = attributes name ":" type ";" ;
ast::Field Parser::parse_field() {
    ast::Field field;
    field.doc = doc_before(cursor_);
    field.attributes = parse_attributes();
    field.name = parse_name("a field");
    expect(TokenKind::colon);
    field.type = parse_type();
    end_statement();
    return field;
}

/// enum = "enum" name "{" [ enumerator { "," enumerator } [ "," ] ] "}" ;    enumerator = name [ "=" expression ] ;
/// Keywords may be enumerators, since `none` is a common one.
ast::Enum Parser::parse_enum() {
    ast::Enum enumeration;
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_brace)) return enumeration;
    while (!at(TokenKind::close_brace) && !at_end() && !lost_) {
        if (!peek().name) {
            fail_expected("an enumerator");
            break;
        }
        ast::Enumerator enumerator;
        enumerator.name = identifier_of(advance());
        if (accept(TokenKind::equal)) enumerator.value = parse_expression();
        enumeration.enumerators.push_back(enumerator);
        if (!accept(TokenKind::comma)) break;
    }
    if (!lost_) expect_close(TokenKind::close_brace, open);
    return enumeration;
}

/// interface = "interface" name [ generic-parameters ] "{" { method } "}" ;
ast::Interface Parser::parse_interface() {
    ast::Interface interface;
    std::uint32_t open = cursor_;
    if (!expect(TokenKind::open_brace)) return interface;
    while (!list_ends()) {
        std::uint32_t before = cursor_;
        if (accept(TokenKind::semicolon)) continue;
        if (DeclId method = parse_method()) interface.members.push_back(method);
        if (lost_) recover_in_list();
        if (cursor_ == before) advance();
    }
    close_list(open);
    return interface;
}

/// method = attributes [ "pub" ] [ "fn" ] name [ generic-parameters ] parameters [ group ] [ with ] [ "->" type ]
///          ( block | ";" ) ;
ast::DeclId Parser::parse_method() {
    std::uint32_t first = cursor_;
    ast::Decl decl;
    decl.doc = doc_before(cursor_);
    decl.attributes = parse_attributes();
    decl.is_pub = accept(TokenKind::kw_pub);
    accept(TokenKind::kw_fn);
    decl.name = parse_name("a function");
    const Enclosing enclosing(*this, names_[decl.name.name]);
    decl.generics = parse_generic_params();
    if (lost_) return {};
    decl.body = parse_function(decl.generics);
    decl.span = since(first);
    return tree_.decls.add(std::move(decl));
}

/// const = "const" name [ ":" type ] "=" expression ";" ;
ast::Const Parser::parse_const() {
    ast::Const constant;
    if (accept(TokenKind::colon)) constant.type = parse_type();
    expect(TokenKind::equal);
    constant.value = lost_ ? error_expr() : parse_expression();
    end_statement();
    return constant;
}

/// type-alias = "type" name [ generic-parameters ] "=" type ";" ;
ast::Alias Parser::parse_type_alias() {
    ast::Alias alias;
    expect(TokenKind::equal);
    alias.target = parse_type();
    end_statement();
    return alias;
}

/// group = "group" "(" expression { "," expression } [ "," ] ")" ;      three at most
std::vector<ast::ExprId> Parser::parse_group() {
    std::vector<ast::ExprId> group;
    if (lost_ || !accept_word(Word::group)) return group;
    std::uint32_t open = cursor_;
    expect(TokenKind::open_paren);
    if (at(TokenKind::close_paren)) fail_expected("an extent", "group(64) or group(8, 8)");
    while (!at(TokenKind::close_paren) && !at_end() && !lost_) {
        if (group.size() == 3) fail_expected("')'", "a group has at most three extents");
        group.push_back(parse_expression());
        if (!accept(TokenKind::comma)) break;
    }
    expect_close(TokenKind::close_paren, open);
    return group;
}

/// kernel = "kernel" name [ generic-parameters ] parameters [ group ] block ;
ast::Kernel Parser::parse_kernel(std::vector<ast::GenericParam>& generics) {
    ast::Kernel kernel;
    kernel.params = parse_patterned_params(generics);
    kernel.group = parse_group();
    if (at(TokenKind::arrow)) fail_expected("'{'", "a kernel returns nothing: it writes through its 'out' parameters");
    kernel.body = parse_block();
    return kernel;
}

/// pipeline = "pipeline" name [ generic-parameters ] parameters [ result ] block ;
ast::Pipeline Parser::parse_pipeline() {
    ast::Pipeline pipeline;
    pipeline.params = parse_params();
    parse_pipeline_result(pipeline);
    pipeline.body = parse_block();
    return pipeline;
}

/// instances = "=" type { "," type } ";" ;
ast::KernelInstances Parser::parse_kernel_instances() {
    ast::KernelInstances instances;
    accept(TokenKind::equal);
    do instances.targets.push_back(parse_type());
    while (!lost_ && accept(TokenKind::comma));
    end_statement();
    return instances;
}

}  // namespace gliftc
