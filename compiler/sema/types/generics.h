// Generic arguments: explicit, inferred or defaulted, and checked against their constraints before instantiation.
#pragma once

#include "sema/types/meta.h"

namespace gliftc::sema {

/// The generic arguments in one use of a declaration. give() takes explicit ones, then infer(), infer_value() and
/// infer_structure() find others; finish() adds defaults, and checks each argument against its constraint.
struct Arguments {
    Context& context;
    const ast::Decl& decl;
    Env& env;                                ///< receives the bindings
    Span use;                                ///< where the arguments are given or inferred
    std::vector<std::optional<Meta>> found;  ///< for each generic parameter its argument, if there is one yet
    std::vector<Span> spans;                 ///< for each generic parameter where errors in its argument are reported
    struct Named {
        const Env* user = nullptr;
        ast::ExprId argument;
    };
    /// For each generic parameter its argument if that is written with its name. finish() evaluates it, since its type
    /// may depend on arguments that are inferred.
    std::vector<Named> named;

    Arguments(Context&, const ast::Decl&, Env&, Span use);

    /// Takes explicit arguments, from written[first] on: those without a name in order. `user` is the environment in
    /// which they are evaluated. False after an error, and if a type is given for a value; that is reported unless
    /// `quiet`.
    bool give(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first = 0, bool quiet = false);
    bool give(std::vector<Meta> metas);
    /// As give(), for unnamed parameters, too: they come after those with names.
    bool give_all(const Env& user, const std::vector<ast::ExprId>& written);

    /// Unifies a parameter's declared type with a concrete type, binding generic parameters that it names. Never
    /// reports: unbound parameters and contradictions are found later.
    void infer(ast::ExprId pattern, ir::TypeId actual);
    void infer_value(ast::ExprId pattern, const ir::Value& actual);
    void infer_structure(ast::ExprId pattern, ir::StructureId structure);

    /// Fills in defaults, checks constraints, adds bindings to env. False if an argument is missing or violates its
    /// constraint, which is reported unless `quiet`, and after an error in a default.
    bool finish(bool quiet = false);

    /// The index of the generic parameter that the type is; absent if it is none.
    std::optional<std::size_t> index_of(ast::ExprId type) const;
    /// Sets where errors are reported in the argument of a generic parameter, if the type is one: at the argument of a
    /// call by which it is inferred, for unnamed parameters and closures.
    void locate(ast::ExprId type, ast::ExprId argument);

private:
    bool take_all(const Env& user, const std::vector<ast::ExprId>& written, std::size_t first, bool quiet);
    bool report_count(std::size_t most, std::size_t found) const;
    bool finish_unnamed(std::size_t index, bool quiet);
    bool take(std::size_t i, const Env& user, ast::ExprId argument, const Env& known, bool quiet);
    bool is_default(std::size_t i);
    bool is_known(ast::ExprId expr) const;
    void infer_from_result(ast::ExprId constraint, ir::TypeId closure);
    bool take_named(const Env& user, const ast::Expr& argument, bool quiet);
};

/// Binds a generic parameter by the default type of a literal argument. To be called after all other inference, since
/// an argument that has a type of its own decides before a literal.
void infer_from_literal(Arguments&, ast::ExprId pattern, ast::ExprId literal);

/// The declaration's name with its generic arguments: "Array<4, float>".
std::string display_of(const Context&, const ast::Decl&, const Env&);
/// As display_of(), with module-qualified names: "std.array.Array<4, float>". Each run of gliftc gives the same text.
std::string qualified_display_of(const Context&, ast::DeclId, const Env&);

/// The key of an instance in Context::instances. Callers append what else distinguishes it, such as the structures
/// passed to a function.
std::string key_of(const Context&, ast::DeclId, const Env&);

/// Whether the argument satisfies the constraint; if not, `why` is the reason. Errors in the constraint itself are
/// reported.
bool satisfies(Context&, const Env&, ast::ExprId constraint, const Meta&, std::string& why);

}  // namespace gliftc::sema
