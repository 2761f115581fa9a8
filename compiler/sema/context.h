// The state that all of sema shares: syntax trees, the program being made, and tables of instances.
#pragma once

#include "ir/evaluate.h"
#include "sema/check.h"

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace gliftc::sema {

struct Env;

enum class MetaKind : std::uint8_t {
    none,
    type,          // a concrete type; structures too
    value,         // a value known at compile time
    translator,    // one or more translator instances; the first takes the virtual address
    declarations,  // what modules declare by the name, not instantiated yet: overloads, a type, a constant, …
    module,        // a module's name
    format,        // a texel format
    memory_shape,  // buffer, image2d, …
    constraint,    // a built-in constraint
    running,       // a name whose value is known only at run time: a local, a parameter, a member
};

enum class Constraint : std::uint8_t { type, texel, number, integer, floating, structure, translator };

/// The compile-time meaning of a name or a type expression.
struct Meta {
    MetaKind kind = MetaKind::none;
    ir::TypeId type;
    ir::Value value;
    std::vector<ir::TranslatorId> translators;
    std::vector<ast::DeclId> declarations;
    ir::ModuleId module;
    ir::Format format = ir::Format::none;
    ir::MemoryShape shape = ir::MemoryShape::buffer;
    Constraint constraint = Constraint::type;
};

/// An environment, in which names are looked up: those bound here, then what is visible in a module (find_meta).
struct Env {
    ir::ModuleId module;
    std::vector<std::pair<Name, Meta>> bindings;  ///< generic arguments of an instance; names in scope in a body
    ir::TypeId self;                              ///< in interfaces: the type `Self`
    std::size_t shown = SIZE_MAX;  ///< of an instance: the arguments in its name; the others are the defaults

    const Meta* find(Name name) const {
        for (const auto& [bound, meta] : bindings)
            if (bound == name) return &meta;
        return nullptr;
    }
};

struct ModuleScope {
    std::unordered_map<Name, std::vector<ast::DeclId>> names;
    std::vector<ir::ModuleId> imports;
    std::vector<ir::ModuleId> prelude;
};

/// An instance of a declaration, or a kernel or pipeline that sema generates: complete, in progress or failed. `index`
/// is that of its id in the Program's table of structs, translators, functions, kernels or pipelines; none: it has no
/// id yet, or failed. `type`: the type, if the declaration is one.
struct Instance {
    enum class State : std::uint8_t { in_progress, done, failed } state = State::in_progress;
    std::uint32_t index = Id<Instance>::none;
    ir::TypeId type;
};

/// The type of closures that have one text and capture values of the same types: a struct, whose fields are the
/// captured values (sema/bodies/closures.h).
struct ClosureType {
    ast::DeclId written;       ///< the first closure of the type
    const Env* env = nullptr;  ///< the generic arguments that its text names
    /// A function that is the closure's call, under the name by which an interface requires it.
    struct Call {
        Name name;
        std::vector<ir::TypeId> types;  ///< of the parameters, the closure first, and of the result
        ast::DeclId decl;
    };
    std::vector<Call> calls;
};

/// The use that requires an instantiation, for notes.
struct Request {
    std::string display;
    Span span;
};

struct Context {
    const ModuleTable& modules;
    ast::Tree& tree;  ///< grows by the functions that call closures
    Names& names;
    Diagnostics& diagnostics;
    const Settings& settings;
    ir::Program& program;

    Table<ModuleScope, ir::Module> scopes;
    std::unordered_map<ast::DeclId, ir::ModuleId> module_of;  ///< the module of every declaration, also of members
    std::unordered_map<std::string, Instance> instances;
    std::unordered_map<ast::DeclId, ir::ExprId> constants;  ///< values of the `const`s checked so far
    std::vector<ast::DeclId> constants_under_way;           ///< being checked, to detect cycles
    std::vector<std::string> interfaces_under_way;          ///< keys of interface checks in progress, to detect cycles
    std::vector<Request> requests;                          ///< the stack of instantiations, outermost first
    std::vector<std::unique_ptr<Env>> environments;
    /// The declaration and the generic arguments of each structure, translator and struct; of structures and
    /// translators also the environment.
    std::unordered_map<ir::StructureId, const Env*> structure_env;
    std::unordered_map<ir::StructureId, ast::DeclId> structure_decl;
    std::unordered_map<ir::TranslatorId, const Env*> translator_env;
    std::unordered_map<ir::TranslatorId, ast::DeclId> translator_decl;
    std::unordered_map<ir::StructureId, std::vector<Meta>> arguments_of;  ///< of structures
    std::unordered_map<ir::StructId, std::vector<Meta>> struct_arguments;
    std::unordered_map<ir::TranslatorId, std::vector<Meta>> translator_arguments;
    std::unordered_map<ir::StructId, ast::DeclId> struct_decl;
    std::unordered_map<ir::StructId, ClosureType> closures;
    std::unordered_map<ast::ExprId, ast::ExprId> applied_calls;    ///< sema/bodies/applied.h: the calls made for calls
    std::unordered_map<std::string, ir::StructId> closure_types;   ///< by text, captured types and generic arguments
    std::unordered_map<ast::DeclId, ir::StructId> closure_called;  ///< for each ClosureType::Call::decl, the type

    ir::Types& types() { return program.types; }
    const std::string& text(Name name) const { return names[name]; }
    std::string text(ir::TypeId type) const { return ir::to_text(program, type); }
    const ast::Expr& operator[](ast::ExprId id) const { return tree.exprs[id]; }
    const ast::Stmt& operator[](ast::StmtId id) const { return tree.stmts[id]; }
    const ast::Decl& operator[](ast::DeclId id) const { return tree.decls[id]; }

    /// Reports an error or warning, with a note for each instantiation in progress that has generic arguments,
    /// innermost first. A note is left out if it would stand at the place of the error or note before it.
    Diagnostic& error(Diag id, Span span, std::initializer_list<std::string_view> arguments = {});
    /// A new environment, without bindings, that lives as long as the context.
    Env& new_env(ir::ModuleId module);
};

/// Adds a note to a diagnostic.
inline void note(Diagnostic& diagnostic, Span span, std::string text) {
    diagnostic.notes.push_back({span, std::move(text)});
}

}  // namespace gliftc::sema
