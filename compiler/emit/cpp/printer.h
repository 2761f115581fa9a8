// Expressions, statements and functions of the IR as C++: what the printers of host kernels (emit/cpp/host) and of the
// other generated C++ share.
#pragma once

#include "emit/cpp/names.h"
#include "emit/cpp/writer.h"
#include "ir/ir.h"
#include "ir/pass.h"
#include "source/source.h"

#include <functional>
#include <set>
#include <unordered_map>

namespace gliftc::cpp {

/// The precedence of an expression's outermost operator, from the loosest to the tightest of C++.
enum class Level : std::uint8_t {
    ternary,
    logical_or,
    logical_and,
    bit_or,
    bit_xor,
    bit_and,
    equality,
    relation,
    shift,
    sum,
    term,
    unary,
    postfix,
};

struct Text {
    std::string text;
    Level level = Level::postfix;
};

/// The names of a generated class's members; the same wherever they are used.
struct ClassNames {
    /// Names of its functions: for each constructor argument, memory, member structure, host state and pipeline.
    std::vector<std::string> arguments, memories, members, host, pipelines;
    std::vector<std::string> methods, extents;  ///< more functions: the structure's own, and extents of memories
    /// The function for the memory, if that is a structure and no function of `members` gives it by the same name.
    std::string base;
    /// Names of its data members.
    std::vector<std::string> argument_fields, memory_fields, member_fields, host_fields, extent_fields;
    NameSet own;  ///< names that bodies of its functions use: data members, pipelines, the structure's own functions,
                  ///< and fixed names that classes of its kind (ir::StructureKind) use
    NameSet all;  ///< these and its other functions: within the class they hide names of the namespace
};

/// The names of all that a program declares, each in the namespace of its module. A name is made of the source's name
/// and the generic arguments of what it names, so that all files and all runs of gliftc agree. Only where names would
/// be equal do other declarations matter.
struct ProgramNames {
    Table<std::string, ir::Module> spaces;  ///< laplacian, std.array → std_array
    Table<NameSet, ir::Module> types;       ///< names of structs, structures, aliases
    Table<std::string, ir::Struct> structs;
    Table<std::vector<std::string>, ir::Struct> fields;
    Table<std::string, ir::Enum> enums;
    Table<std::string, ir::Structure> structures;            ///< the classes
    Table<std::vector<std::string>, ir::Structure> aliases;  ///< of their aliases
    Table<ClassNames, ir::Structure> classes;
    Table<std::string, ir::Kernel> kernels;  ///< the functions that call them
    Table<std::string, ir::Pipeline> pipelines;
    Table<Scopes, ir::Module> taken;  ///< all names in their namespaces
};

ProgramNames program_names(const ir::Program& program);

/// Whether objects of the class make the member, and hold it: it is neither given to them nor a component.
inline bool is_held(const ir::MemberStructure& member) { return !member.by_reference && !member.is_component; }

/// Whether the class holds the member in a glift::Shared, so that all copies of an object share it: true of the members
/// that a container makes, since these can be replaced.
bool is_held_by_handle(const ir::Structure& structure, std::size_t member);

/// Whether code of a module may use the alias of a structure: one of its own, or a public one of a module that it
/// imports.
bool is_alias_seen(const ir::Program& program, const ir::Alias& alias, ir::ModuleId module);

/// Names that all code in one namespace shares. Names of another namespace are spelled with it: ::grid::Cell.
struct Globals {
    const ir::Program& program;
    const Sources& sources;
    std::string space;       ///< the namespace
    Scopes names;            ///< of the namespace
    NameSet type_names;      ///< of structs, structures, aliases: no other name hides them
    NameSet kernel_symbols;  ///< names of the code and data made for kernels
    Table<std::string, ir::Struct> struct_names;
    Table<std::vector<std::string>, ir::Struct> field_names;
    Table<std::string, ir::Structure> structure_names;
    Table<ClassNames, ir::Structure> class_names;
    Table<std::string, ir::Kernel> kernel_names;  ///< the functions that call them
    Table<std::string, ir::Pipeline> pipeline_names;
    /// By kernel: the beginning of the names of the code and data made for it.
    std::unordered_map<ir::KernelId, std::string> kernel_stems;
    std::unordered_map<const ir::KernelParam*, std::string> param_names;
    std::unordered_map<ir::FunctionId, std::string> function_names;
    std::string functions;  ///< the functions printed so far, callees first

    Globals(const ir::Program& program, const Sources& sources) : program(program), sources(sources) {}
};

/// Where generated code stands: in the namespace of the module `home`, in a file of the module `root`. If both are
/// the same module, structures have the names that the module gives them (aliases).
struct Surroundings {
    ir::ModuleId root, home;
};

Globals make_globals(const ir::Program& program, const Sources& sources, const ProgramNames& names,
                     Surroundings surroundings);

/// Prints one body, of a function, kernel, pipeline or method, or expressions outside of one.
struct Printer {
    Globals& globals;
    const ir::Program& program;
    Writer out;
    Scopes names;
    const NameSet* class_names = nullptr;  ///< within a class: names that hide those of the namespace
    bool marks_unused = false;  ///< in pipelines: only the excluded branch of a constant `if` may use a local
    std::unordered_map<ir::LocalId, std::string> local_names;
    std::unordered_map<ir::FunctionId, std::string> local_functions;  ///< names of lambdas in the printed body
    /// Spells the operations that depend on what surrounds the body, such as parameters, loads, members, derivatives
    /// and host operations of pipelines.
    std::function<Text(const ir::Expr&)> outer_expression;
    /// The name of what is called, with values only, in place of a function that takes structures; "" for others. May
    /// be empty.
    std::function<std::string(const ir::Expr&)> outer_call;
    std::function<std::string(const ir::Expr&)> outer_place;  ///< the lvalue of a load, for atomic operations
    std::function<void(const ir::Stmt&)> outer_statement;     ///< prints statements that depend on the surroundings
    /// Prints `return value;`; empty: as in C++.
    std::function<void(ir::ExprId)> print_return;
    /// Spells a local that is not simply a name (an element of an array over the workgroup); gives "" for others. May
    /// be empty.
    std::function<std::string(ir::LocalId)> outer_local;
    std::uint32_t marked_file = 0xffffffffu, marked_line = 0;  ///< of the latest mark_line

    explicit Printer(Globals& globals) : globals(globals), program(globals.program) { names.avoid(globals.type_names); }
};

// globals.cpp
/// The members' names in the struct that mirrors the pass's block of parameters.
std::vector<std::string> block_names(const Globals& globals, const ir::Pass& pass);
std::string declare_function(Globals& globals, ir::FunctionId function);

// types.cpp
std::string type_text(const Globals& globals, ir::TypeId type, bool qualified = false);
/// The type as memory holds it: a bool is four bytes.
std::string storage_text(const Globals& globals, ir::TypeId type, bool qualified = false);
std::string_view format_name(ir::Format format);
std::string literal(const ir::Program& program, ir::TypeId type, std::uint64_t bits, double number);
bool is_bool_vector(const ir::Program& program, ir::TypeId type);

// expressions.cpp
Text print(Printer& p, ir::ExprId expr);
std::string print(Printer& p, ir::ExprId expr, Level least);  ///< in parentheses if looser than `least`
std::string print_any(Printer& p, ir::ExprId expr);
std::string join_arguments(Printer& p, const ir::Operands& arguments);
std::string wrap(Text&& text, Level least);

// surroundings.cpp
/// Spells a property of a structure that `object` reaches, `f->` or `table.` (empty: within its own class): the
/// operations member, memory_extent, host_state, domain, structure_value.
Text structure_property(const Globals& globals, const ir::Expr& expr, ir::StructureId root_structure,
                        const std::string& object);
/// A name of the module's namespace as the printed body must spell it: with the namespace where another name hides it.
std::string visible(const Printer& p, const std::string& name);

// statements.cpp
void print_statements(Printer& p, const std::vector<ir::StmtId>& body);
void print_statement(Printer& p, ir::StmtId stmt);
std::string declare_local(Printer& p, ir::LocalId local);
void mark_line(Printer& p, Span span);  ///< prints a comment with the source line, unless the latest one is the same
std::string file_name(const Sources& sources, std::uint32_t file);
std::string place_text(const Sources& sources, Span span);   ///< laplacian.glift:8
std::string source_text(const Sources& sources, Span span);  ///< as it is written, in one line
/// Prints the function to globals.functions if it is not there yet, and enters its name in globals.function_names. Of a
/// function of the runtime (ir::Function::extern_name) only the name is entered.
void require_function(Globals& globals, ir::FunctionId function);
/// Whether the function, with those it calls, uses only its arguments and own locals: no memory, no parameters of the
/// pass, no workgroup memory, nothing that depends on the invocation; and reports nothing.
bool is_pure(const ir::Program& program, ir::FunctionId function);

}  // namespace gliftc::cpp
