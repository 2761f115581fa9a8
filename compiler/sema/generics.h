// Generic arguments: given, inferred, defaulted, and checked against their constraints before anything is instantiated.
#pragma once

#include "sema/meta.h"

namespace gliftc::sema {

/// Binds what is given explicitly and what is inferred, then defaults; checks each against its constraint.
struct Arguments {
    Context& context;
    const ast::Decl& decl;
    Env& env;  ///< receives the bindings
    Span use;  ///< where the arguments are given or inferred
    std::vector<std::optional<Meta>> found;
    std::vector<Span> spans;

    Arguments(Context&, const ast::Decl&, Env&, Span use);

    /// Takes written arguments in order. `user` is the environment they are written in. False after an error.
    bool give(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first = 0);
    bool give(std::vector<Meta> metas);

    /// Matches a parameter's type as written against a concrete type, binding generic parameters that it names.
    /// Never reports: what stays unbound or contradicts is seen later.
    void infer(ast::ExprId pattern, ir::TypeId actual);
    void infer_value(ast::ExprId pattern, const ir::Value& actual);
    void infer_structure(ast::ExprId pattern, std::uint32_t structure);

    /// Fills in defaults, checks constraints, adds bindings to env. `quiet`: gives false instead of reporting.
    bool finish(bool quiet = false);
};

/// What only a literal can tell: the type that the literal has on its own. After all other inference.
void infer_from_literal(Arguments&, ast::ExprId pattern, ast::ExprId literal);

/// "Array<4, float>" for a declaration and its environment.
std::string display_of(const Context&, const ast::Decl&, const Env&);
/// The same with the modules of all that it names: unique, and the same in every compilation.
std::string qualified_display_of(const Context&, ast::DeclId, const Env&);

/// The key of an instance in Context::instances.
std::string key_of(const Context&, ast::DeclId, const Env&);

/// Does the type satisfy the constraint as written? `why` says what is missing.
bool satisfies(Context&, const Env&, ast::ExprId constraint, const Meta&, std::string& why);

}  // namespace gliftc::sema
