// The recursive-descent parser: its position, error reporting and recovery.
//
// After an error from which it cannot go on the parser is `lost_` (panic mode): nothing more is reported and every loop
// ends, up to that of the nearest list of statements, fields, items or declarations, which skips to a synchronisation
// point.
#pragma once

#include "diag/diagnostics.h"
#include "syntax/ast.h"
#include "syntax/token.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gliftc {

class Parser {
public:
    Parser(TokenList& list, std::uint32_t file, const Sources& sources, Names& names, ast::Tree& tree,
           Diagnostics& diagnostics);

    ast::Module parse_module();

private:
    using ExprId = ast::ExprId;
    using StmtId = ast::StmtId;
    using DeclId = ast::DeclId;

    // ---- tokens (parser_state.cpp; at_optional_mark and parse_optional: parse_types.cpp)
    const Token& peek(std::uint32_t ahead = 0) const;
    bool at(TokenKind kind) const { return tokens_[cursor_].kind == kind; }
    bool at_word(Word word) const { return tokens_[cursor_].word == word; }
    bool at_word_before_name(Word word) const { return at_word(word) && peek(1).kind == TokenKind::identifier; }
    bool at_end() const { return at(TokenKind::end); }
    const Token& advance();
    bool accept(TokenKind kind);
    bool follows_open_string() const;
    bool accept_word(Word word);
    bool expect(TokenKind kind);
    bool expect_close(TokenKind kind, std::uint32_t open_token);
    void set_role(Role role) { tokens_[cursor_].role = role; }
    bool at_close_angle() const;
    bool at_optional_mark() const;
    ExprId parse_optional(ExprId type, std::uint32_t first);
    bool expect_close_angle(std::uint32_t open_token);
    Span span_of(const Token& token) const { return {file_, token.begin, token.end}; }
    Span here() const { return span_of(tokens_[cursor_]); }
    Span since(std::uint32_t first_token) const;
    Span after_previous() const;
    std::string_view text_of(const Token& token) const { return sources_.text(span_of(token)); }
    ast::Identifier parse_name(std::string_view what);
    ast::Identifier identifier_of(const Token& token) const { return {token.name, span_of(token)}; }
    std::string doc_before(std::uint32_t token) const;

    // ---- errors (recovery.cpp)
    std::string shown(const Token& token) const;
    void fail(Diag id, Span span, std::initializer_list<std::string_view> arguments = {}, std::string note = {});
    void fail_expected(std::string_view what, std::string note = {});
    void fail_reserved(std::string_view reason);
    const Token& head() const;                         // habits.cpp
    std::string habit(std::string_view wanted) const;  // habits.cpp
    void report_unclosed(std::uint32_t open_token);
    void check_indentation(std::uint32_t open_token);
    void skip_balanced();
    void recover_in_list();
    void recover_in_module();
    bool at_statement_keyword() const;
    bool at_declaration() const;
    bool at_declaration_in_first_column() const;
    bool close_list(std::uint32_t open_token);
    bool list_ends() const;

    /// Counts the nesting depth; `ok` is false, with an error reported, beyond the limit.
    struct Nesting {
        explicit Nesting(Parser& outer);
        ~Nesting() { --parser.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        Parser& parser;
        bool ok;
    };

    /// Exists while the parser is inside parentheses, brackets or the braces of a tuple: a `>` there is a comparison,
    /// even if the brackets are part of a generic argument.
    struct Brackets {
        explicit Brackets(Parser& outer)
            : parser(outer), angles(std::exchange(outer.open_angles_, 0)),
              is_before_colon(std::exchange(outer.is_before_colon_, false)) {}
        ~Brackets() { parser.open_angles_ = angles, parser.is_before_colon_ = is_before_colon; }
        Brackets(const Brackets&) = delete;
        Brackets& operator=(const Brackets&) = delete;
        Parser& parser;
        int angles;
        bool is_before_colon;
    };

    /// While an object of this class lives, the parser is inside the declaration of that name.
    struct Enclosing {
        Enclosing(Parser& inner, std::string_view name) : parser(inner), outer(inner.enclosing_.size()) {
            if (outer > 0) parser.enclosing_ += '_';
            parser.enclosing_ += name;
        }
        ~Enclosing() { parser.enclosing_.resize(outer); }
        Enclosing(const Enclosing&) = delete;
        Enclosing& operator=(const Enclosing&) = delete;
        Parser& parser;
        std::size_t outer;
    };

    // ---- expressions (parse_expressions.cpp, parse_primary.cpp)
    ExprId add(ast::Expr expr);
    ExprId error_expr();
    ExprId parse_expression();
    ExprId parse_range();
    ExprId parse_conditional();
    ExprId parse_binary(int least_precedence);
    ExprId parse_unary();
    ExprId parse_postfix();
    ExprId parse_primary();
    ExprId parse_name_expression();
    ExprId parse_parenthesized();
    ExprId parse_literal();
    ExprId parse_bad_number();
    ExprId parse_integer(ast::Expr expr);
    ExprId parse_float(ast::Expr expr);
    ExprId parse_string_literal(ast::Expr expr);
    ExprId parse_tuple();
    ExprId parse_call(ExprId callee, std::uint32_t first);
    ExprId parse_index(ExprId base, std::uint32_t first);
    ExprId parse_member(ExprId base, std::uint32_t first);
    ExprId parse_generic_arguments(ExprId base, std::uint32_t first);
    ExprId parse_named_argument();
    void parse_arguments(ast::Expr& expr, TokenKind close);
    ExprId parse_argument();
    bool closes_outer(TokenKind kind) const;
    bool generic_arguments_follow() const;
    std::string decode_string(const Token& token);

    // ---- types (parse_types.cpp; parse_generic_argument: parse_expressions.cpp)
    ExprId parse_type();
    ExprId parse_generic_argument();
    std::vector<ast::GenericParam> parse_generic_params();

    // ---- closures (parse_closures.cpp)
    ExprId parse_closure();
    std::vector<ast::Param> parse_closure_params();
    std::vector<StmtId> parse_closure_body(ast::Expr& closure);
    Name closure_name();

    // ---- statements (parse_statements.cpp)
    StmtId parse_statement();
    StmtId parse_let();
    StmtId parse_shared();
    StmtId parse_temp();
    StmtId parse_if();
    StmtId parse_for();
    StmtId parse_while();
    StmtId parse_switch();
    ast::Stmt parse_branch(ast::Stmt& of);
    ExprId parse_case(ast::Identifier name);
    ExprId compare(ast::BinaryOp op, ExprId left, ExprId right);
    StmtId parse_jump(ast::StmtKind kind);
    StmtId parse_return();
    StmtId parse_block_statement();
    StmtId parse_expression_statement();
    StmtId finish(ast::Stmt statement, std::uint32_t first);
    std::vector<StmtId> parse_block();
    void end_statement();

    // ---- declarations (parse_module.cpp, parse_declarations.cpp, parse_raster.cpp)
    void parse_module_header(ast::Module& module);
    bool parse_path(std::string& path);
    ast::Use parse_use();
    DeclId parse_declaration();
    void parse_declaration_body(ast::Decl& decl);
    void parse_body_after_name(ast::Decl& decl, const Token& keyword);
    bool at_declaration_word() const;  // recovery.cpp
    ast::Alias parse_type_alias();
    std::vector<ast::Attribute> parse_attributes();
    std::vector<ast::MemberPattern> parse_with();
    ast::Function parse_function();
    ast::Struct parse_struct();
    ast::Struct parse_extern_struct();
    ast::Field parse_field();
    ast::Enum parse_enum();
    ast::Interface parse_interface();
    ast::Const parse_const();
    std::vector<ast::ExprId> parse_group();
    ast::KernelInstances parse_kernel_instances();
    ast::Kernel parse_kernel(std::vector<ast::GenericParam>& generics);
    ast::Kernel parse_raster(std::vector<ast::GenericParam>& generics);
    void parse_raster_item(ast::Kernel& kernel);
    void begin_raster_part(Span& first);
    void parse_raster_state(ast::Raster& raster);
    void parse_varying(ast::Raster& raster);
    ast::Pipeline parse_pipeline();
    DeclId parse_method();

    // ---- parameters (parse_parameters.cpp)
    enum class Params : std::uint8_t { plain, of_kernel, of_constructor };
    enum class Bare : bool { refused, allowed };  ///< whether a pattern may stand without a structure: `in each`
    std::vector<ast::Param> parse_params(Params kind = Params::plain);
    void parse_default(ast::Param& param, const std::vector<ast::Param>& earlier, Params kind);
    std::vector<ast::Param> parse_kernel_params(std::vector<ast::GenericParam>& generics);
    ast::Param parse_param(Bare bare);
    ast::Direction parse_direction();
    ast::Pattern pattern_here(Bare bare = Bare::refused) const;
    void parse_pattern(ast::Param& param, Bare bare = Bare::refused);
    void add_unnamed(ast::Param& param, std::vector<ast::GenericParam>& generics);
    void parse_pipeline_result(ast::Pipeline& pipeline);

    // ---- translators and structures (parse_components.cpp, parse_items.cpp)
    void parse_translator(ast::Decl& decl);
    void parse_structure(ast::Decl& decl);
    std::vector<ast::Item> parse_items();
    ast::Item parse_item();
    ast::Item parse_memory();
    ast::Item parse_member_item();
    ast::Item parse_condition();
    ast::Item parse_host();
    ast::Item parse_value_item(ast::ItemKind kind);
    ast::Item parse_nested_declaration();
    void ignore_pub_of_member();
    ast::Item new_item(ast::ItemKind kind) const;

    std::vector<Token>& tokens_;
    const std::vector<Comment>& comments_;
    std::uint32_t file_;
    const Sources& sources_;
    Names& names_;
    ast::Tree& tree_;
    Diagnostics& diagnostics_;

    std::uint32_t cursor_ = 0;
    std::uint32_t previous_end_ = 0;  // end of the last token consumed; of a split `>>` or `??`, of the part consumed
    bool lost_ = false;
    bool has_open_string_;
    int depth_ = 0;
    int open_angles_ = 0;           // how many lists of generic arguments or parameters are open here
    bool is_before_colon_ = false;  // a ':' here ends the middle of `a ? b : c`, or begins the next named argument
    std::string enclosing_;         // the names of the declarations around this place, joined by `_`; "test" in tests
    std::unordered_map<std::string, unsigned> closures_;  // for each text of enclosing_: the number of closures so far
    std::uint32_t first_expr_;                            // index in the tree of this file's first expression
    std::vector<std::uint16_t> heights_;  // height of the tree of each expression from first_expr_ on; limited by add()
    std::uint32_t unclosed_at_ =
        0xffffffffu;  // the token where a missing `}` was reported, so that enclosing braces do not report it again
    std::uint32_t badly_indented_ = 0xffffffffu;  // first `{` whose `}` is indented differently: a `}` may be missing
};

}  // namespace gliftc
