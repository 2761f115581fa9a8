// Generic arguments: explicit, inferred or defaulted, and checked against their constraints before instantiation.
#pragma once

#include "sema/meta.h"

namespace gliftc::sema {

/// Binds explicit and inferred arguments, then defaults; checks each against its constraint.
struct Arguments {
    Context& context;
    const ast::Decl& decl;
    Env& env;  ///< receives the bindings
    Span use;  ///< where the arguments are given or inferred
    std::vector<std::optional<Meta>> found;
    std::vector<Span> spans;

    Arguments(Context&, const ast::Decl&, Env&, Span use);

    /// Takes explicit arguments in order. `user` is the environment in which they are evaluated. False after an error.
    bool give(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first = 0);
    bool give(std::vector<Meta> metas);

    /// Unifies a parameter's declared type with a concrete type, binding generic parameters that it names. Never
    /// reports: unbound parameters and contradictions are found later.
    void infer(ast::ExprId pattern, ir::TypeId actual);
    void infer_value(ast::ExprId pattern, const ir::Value& actual);
    void infer_structure(ast::ExprId pattern, std::uint32_t structure);

    /// Fills in defaults, checks constraints, adds bindings to env. `quiet`: returns false without reporting.
    bool finish(bool quiet = false);
};

/// Binds a parameter by the default type of a literal argument. After all other inference.
void infer_from_literal(Arguments&, ast::ExprId pattern, ast::ExprId literal);

/// The declaration's name with its generic arguments: "Array<4, float>".
std::string display_of(const Context&, const ast::Decl&, const Env&);
/// The same with qualified names: unique, and the same in every compilation.
std::string qualified_display_of(const Context&, ast::DeclId, const Env&);

/// The key of an instance in Context::instances.
std::string key_of(const Context&, ast::DeclId, const Env&);

/// Whether the argument satisfies the constraint; `why` is the reason if not.
bool satisfies(Context&, const Env&, ast::ExprId constraint, const Meta&, std::string& why);

}  // namespace gliftc::sema
