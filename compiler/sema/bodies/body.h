// Checking of bodies: the state of one body, and the result of checking an expression.
#pragma once

#include "sema/bodies/builder.h"
#include "sema/context.h"
#include "sema/types/meta.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace gliftc::sema {

enum class BodyKind : std::uint8_t {
    constant,   // compile-time values
    function,   // functions and methods
    structure,  // expressions in the declaration of a structure, such as extents and arguments
    kernel,
    pipeline,  // tests too
};

/// What a name stands for. The container is the structure whose members are in scope (Body::container).
enum class SymbolKind : std::uint8_t {
    local,       // a variable, or a parameter that is an ir::Local
    structure,   // a nested structure of the container, its base (sema/structures/memory_structure.h), a structure in a
                 // translator's state, or a structure parameter of a function or kernel that is no `iterator`
    state,       // a scalar of a translator's state
    member,      // a constructor parameter of the container that is a value
    memory,      // a buffer or image of the container
    iterator,    // a kernel's parameter such as `each` or `at`: its name means the current element, window or address
    host_state,  // a field of a container that lives on the host
};

/// How code may access a structure through one name. `any`: reads by address. `scatter`: writes to any address, and no
/// reads; `combine` says how writes to one address are merged. `coherent`: reads, writes and atomics at any address.
/// `calls`: reads by address, and calls of functions that write.
struct Writing {
    ir::Pattern pattern = ir::Pattern::any;
    ir::Combine combine = ir::Combine::replace;
    Span span;  ///< where the pattern is declared; empty if none is
    bool is(ir::Pattern wanted) const { return pattern == wanted; }
};

/// The meaning of a name in scope. The comment of a field begins with the kinds for which it is set.
struct Symbol {
    SymbolKind kind = SymbolKind::local;
    Span span;                  ///< all kinds: where the name is declared
    ir::TypeId type;            ///< local, state, member, host_state
    ir::LocalId local;          ///< local
    ir::Place place;            ///< structure, iterator: the path to it; member, memory, host_state: root 0, the
                                ///< container, whose value or memory it is
    ir::StructureId structure;  ///< structure, iterator, memory (the one that has it)
    /// state: index in the scalar fields of the translator (the code that maps addresses) whose function this is.
    /// member: in the structure's constructor values. memory: in its memories. host_state: in its fields that live on
    /// the host. iterator (a parameter such as `each` or `at`, whose name means the current invocation's element or
    /// address): in the kernel's parameters.
    std::uint32_t slot = 0;
    ir::Radius window;  ///< structure: the radius, if it is a `near` parameter of a function; else 0
    Writing writing;    ///< structure: how it may be accessed
    bool used = false;
    bool warn_unused = false;
};

enum class OperandKind : std::uint8_t { error, value, meta, structure, memory, iterator };

/// The result of a pipeline that returns a range (`-> range<N, T>`): a slice of a structure with N-dimensional
/// addresses and elements T.
struct RangeResult {
    ir::TypeId domain, element;  ///< the address type for N, and T; the error type after an error
    ir::TypeId slice;            ///< the type of the returned slices, known from the first return
};

/// A checked expression. The comment of a field begins with the kinds for which it is set.
struct Operand {
    OperandKind kind = OperandKind::error;
    Span span;
    ir::ExprId expr;            ///< value
    ir::TypeId type;            ///< value; structure, where it is a local of a pipeline
    Meta meta;                  ///< meta
    ir::Place place;            ///< structure, memory, iterator
    ir::LocalId local;          ///< structure, memory, in pipelines: the local (a temporary, a parameter, a slice) at
                                ///< which `place` starts; none: it starts at the container that owns the pipeline
    ir::StructureId structure;  ///< structure, iterator, memory (the one that has it)
    std::uint32_t slot = 0;     ///< memory: index in the structure's memories; iterator: in the kernel's parameters
    ir::Radius window;          ///< structure: the radius, if it is a `near` parameter of a kernel or function; else 0
    bool is_slice = false;      ///< structure: it is the slice `local`, not a member of that
    Writing writing;            ///< structure: how it may be accessed
};

/// A node of the expression being checked for which it matters when it is evaluated (sema/bodies/order.h).
struct Pending {
    ir::ExprId node;
    bool has_effect = false;
};

/// What the check of an operand adds to the body.
struct Steps {
    std::vector<ir::StmtId> statements;
    std::vector<Pending> pending;
};

/// The state of the check of one body. Words before a colon in the comment of a field name the kinds of body that use
/// it.
struct Body {
    Context& context;
    const Env& env;
    BodyKind kind = BodyKind::function;
    std::vector<std::unordered_map<Name, Symbol>> scopes = {{}};
    ir::Definitions lets;  ///< values of the locals of `let` and `const`, except made structures and `if let`
    /// Pipelines: the constructor arguments of each structure that the pipeline makes.
    std::unordered_map<ir::LocalId, ir::Operands> made;
    std::vector<ir::StmtId>* block = nullptr;  ///< the list to which statements are added; null: expressions only
    ir::TypeId result;                         ///< the type that `return` gives
    unsigned loops = 0;  ///< loops around the statement in its innermost arm; 0: `break`, `continue` are errors
    unsigned depth = 0;  ///< how deeply the statement is nested
    ir::Kernel* kernel = nullptr;
    ir::Part part = ir::Part::whole;  ///< the part of a draw that is being checked; whole: the code is in neither part
    /// The structure that declares this function or pipeline, or whose declaration is checked, if any.
    /// Its members are in scope; their Place::root is 0.
    ir::StructureId container;
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< the workgroup size that the declaration gives; all 0: none
    std::vector<ir::LocalId>* shared = nullptr;      ///< the locals in workgroup memory (`shared`) declared so far
    /// Functions with a workgroup: the last statement of the body, or of the branch of a constant `if` that is being
    /// checked and that no other `if` or loop encloses. Only it may be a return, since all invocations must reach every
    /// barrier. Kernels with a workgroup: empty, so that no statement may.
    Span last;
    unsigned enclosing = 0;                   ///< how many blocks and `if`s that are not constant enclose the statement
    std::vector<ir::StructureId> structures;  ///< functions: the structures that calls pass, by Place::root
    std::vector<ir::Place> coherent;          ///< the places that are accessed by the pattern coherent
    /// Functions: what they and called functions write; kernels: what called functions write; null: calls of functions
    /// that write are errors.
    std::vector<ir::Effect>* effects = nullptr;
    /// Pipelines: whether the returned values seen so far lie on the host or on the device.
    enum class Returns : std::uint8_t { nothing, host, device } returns = Returns::nothing;
    Span* prints = nullptr;  ///< where the kernel or function first prints; null: `print` and `assert` are errors here
    std::optional<RangeResult> range_result;  ///< pipelines that return a range
    bool in_test = false;
    /// Pipelines: the expression being checked is part of a larger one that a pass may compute, so that values on the
    /// device may stand in it (sema/pipelines/values.h).
    bool is_open = false;
    std::vector<Pending> pending;  ///< in the order of evaluation
    /// Pipelines: the name of the declaration (of a test, its title), with which the keys (ir::Kernel::key) of the
    /// kernels begin that compute values on the device for it. Each run of gliftc gives the same kernel the same key.
    std::string key;
    /// A branch, or the body of a loop, whose condition lies on the device.
    struct Arm {
        ir::LocalId condition;
        bool where = true;  ///< the value of the condition for which the arm runs
        Span span;
    };
    std::vector<Arm> arms;  ///< pipelines: the arms around the statement being checked (sema/pipelines/predication.h)
    std::unordered_map<ir::LocalId, std::size_t> depths;  ///< pipelines: how many arms are around the declaration of
                                                          ///< each variable
    std::vector<Span>
        device_variables;  ///< declarations of variables that must lie on the device; if checking adds
                           ///< one, the pipeline is checked again (check_variable in sema/pipelines/predication.h)
    Span host_needed;  ///< where the pipeline, or one that it calls, first waits for the device, changes host state or
                       ///< gives a member other memory; empty: nowhere
    /// A statement `member = temporary;`.
    struct Replacement {
        std::uint32_t member;
        ir::LocalId temporary;
        Span span;
        const std::vector<ir::StmtId>* block;  ///< the list that the statement is in
    };
    std::vector<ir::LocalId> constants;     ///< pipelines: the parameters that are containers and declared `in`
    std::vector<ir::LocalId> captured;      ///< functions that call a closure: the values that it captured
    std::vector<Replacement> replacements;  ///< pipelines: all such statements (sema/structures/replace.h)

    bool grouped() const { return group[0] != 0; }
    bool is_coherent(const ir::Place& place) const { return std::ranges::find(coherent, place) != coherent.end(); }
    ir::Program& program() { return context.program; }
    ir::Types& types() { return context.program.types; }
};

// scopes
void open_scope(Body&);
void close_scope(Body&);                       ///< warns about unused variables
void declare(Body&, ast::Identifier, Symbol);  ///< reports duplicates in the same scope
Symbol* find_symbol(Body&, Name);
ir::LocalId declare_local(Body&, ast::Identifier, ir::TypeId, bool is_mutable, bool warn_unused = true);
/// Emits the declaration of a new local, one that the source does not name, with this value; returns the local. Other
/// pending nodes are settled (sema/bodies/order.h).
ir::LocalId emit_temporary(Body&, std::string_view name, ir::ExprId value, Span);
void emit(Body&, ir::StmtId);
/// The value of an expression if it is known at compile time; locals in Body::lets have the values given there.
std::optional<ir::Value> known_value(Body&, ir::ExprId);
/// The environment for a compile-time expression in the body, with bindings for the names in scope that it uses.
const Env& env_for(Body&, ast::ExprId);
const Env& env_for(Body&, const std::vector<ast::ExprId>&);

// expressions
/// `hint` is the type that the context prefers (bidirectional typing): literals, `none`, braced lists, generic calls
/// and `s.load(a)` take it where nothing else determines their types. It is not enforced: use check_value or coerce for
/// that.
Operand check(Body&, ast::ExprId, ir::TypeId hint = {});
ir::ExprId check_hinted(Body&, ast::ExprId, ir::TypeId hint);  ///< check(), then to_value()
/// The expression as a value. If `wanted` is given, coerced to that type.
ir::ExprId check_value(Body&, ast::ExprId, ir::TypeId wanted = {});
ir::ExprId to_value(Body&, const Operand&);
/// Coerces `expr` to the wanted type: itself, or wrapped into an optional; reports a mismatch.
ir::ExprId coerce(Body&, ir::ExprId expr, ir::TypeId wanted, Span);
/// If the type found where a value is needed is an optional, adds a note that says how to unwrap it.
void note_optional(Body&, Diagnostic&, Span, ir::TypeId found);
Operand value_operand(Body&, ir::ExprId, Span);
/// Whether the meaning is the declaration of a constant; and its value.
bool is_constant(const Context&, const Meta&);
Operand constant_operand(Body&, const Meta& constant, Span);
Operand error_operand(Span);
/// Pipelines: if the operand constructs a structure (such as a view) within an expression, declares a temporary, and
/// gives that. Any other operand is returned as it is.
Operand declared(Body&, const Operand&);
ir::ExprId error_value(Body&, Span);
bool is_error(const Body&, ir::ExprId);

// kinds of expressions
Operand check_member(Body&, ast::ExprId);
std::optional<Operand> check_device_member(Body&, const ast::Expr&);
Operand unknown_member(Body&, std::string_view what, ast::Identifier, const std::vector<std::string_view>& known);
Operand check_index(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_call(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_unary(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_binary(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_conditional(Body&, const ast::Expr&, ir::TypeId wanted);
Operand check_otherwise(Body&, const ast::Expr&, ir::TypeId wanted);  ///< `a ?? b`
bool has_equality(const ir::Program&, ir::TypeId);                    ///< whether values of the type have `==`, `!=`
ir::ExprId make_struct_equality(Body&, bool negated, ir::ExprId left, ir::ExprId right, Span);
/// The value that `target op= value` assigns. The target is evaluated once.
ir::ExprId check_compound(Body&, const ast::Stmt&, ir::ExprId target);
/// A swizzle such as `.x` or `.yz` of a value, or an error.
Operand make_swizzle_of(Body&, ir::ExprId, ast::Identifier);

// calls
/// Calls a structure's function with checked values. Gives an Op::call node. In a pipeline it does so only if the host
/// can evaluate the call; if an argument is on the device, the function reads elements or the structure is a slice, it
/// gives a call of a generated pipeline that computes the value on the device.
Operand call_of(Body&, ir::FunctionId, const Operand& self, ir::Operands values, Span);

Operand call_function(Body&, const std::vector<ast::DeclId>& overloads, const Env* owner,
                      const std::vector<ast::ExprId>& explicit_generics, const std::vector<ast::ExprId>& arguments,
                      const ast::Expr& call, ir::TypeId wanted, const Operand* self = nullptr);
/// A call by plain name of one of the `visible` functions, or of one found by argument-dependent lookup. Absent if
/// there is none of that name.
std::optional<Operand> call_by_name(Body&, ast::Identifier name, std::vector<ast::DeclId> visible,
                                    const std::vector<ast::ExprId>& explicit_generics, const ast::Expr& call,
                                    ir::TypeId wanted);
Operand call_intrinsic(Body&, ir::Intrinsic, const std::vector<ast::ExprId>& arguments, const ast::Expr& call,
                       ir::TypeId wanted);
Operand call_select(Body&, const ast::Expr& call, ir::TypeId wanted);
Operand construct_value(Body&, ir::TypeId, const ast::Expr& call);
Operand call_method(Body&, const Operand& self, ast::Identifier method, const std::vector<ast::ExprId>& generics,
                    const ast::Expr& call, ir::TypeId wanted);
std::optional<ir::Intrinsic> find_intrinsic(std::string_view name);

// structures in code
Operand structure_member(Body&, const Operand& structure, ast::Identifier member);
ir::ExprId make_read(Body&, const Operand& structure, ir::ExprId address, Span);
ir::ExprId structure_operation(Body&, ir::Op, ir::TypeId, const Operand& structure, Span, ir::Operands operands = {});
ir::TypeId signed_address(ir::Types&, ir::TypeId domain);  ///< int, int2 … for uint, uint2 …

// statements
void check_block(Body&, const std::vector<ast::StmtId>&);
void check_statement(Body&, ast::StmtId);
void check_for(Body&, const ast::Stmt&);
void check_while(Body&, const ast::Stmt&);
void check_switch(Body&, const ast::Stmt&);
/// Checks `statements` in a new scope; returns the statements of the IR that they emit.
std::vector<ir::StmtId> check_nested(Body&, const std::vector<ast::StmtId>&);
/// Whether every path through the list ends in a return. Conditions and loops count as unknown: a return inside a loop,
/// or on one side of an `if` alone, does not suffice.
bool always_returns(const ir::Program&, const std::vector<ir::StmtId>&);

// kernels
bool check_iterator_assignment(Body&, const ast::Stmt&);
Operand iterator_value(Body&, const Operand&);

// pipelines
void check_range_return(Body&, const ast::Stmt&);        ///< `return` in a pipeline that returns a range
bool check_pipeline_statement(Body&, const ast::Stmt&);  ///< false: check it as in functions
std::optional<Operand> check_pipeline_call(Body&, const std::vector<ast::DeclId>&,
                                           const std::vector<ast::ExprId>& generics, const ast::Expr& call,
                                           const Operand* owner = nullptr);
std::optional<Operand> check_pipeline_builtin(Body&, std::string_view name, const ast::Expr& call);
/// The operand as one of kind `structure`. A structure constructed in the expression, or a slice made in it or returned
/// by a pipeline, is first put into a new local; one that has a name is returned as it is. Absent for any other
/// operand.
std::optional<Operand> as_structure(Body&, const Operand&);
Operand check_pipeline_index(Body&, const Operand& structure, const ast::Expr& index);
Operand construct_structure(Body&, ir::TypeId, const ast::Expr& call);

}  // namespace gliftc::sema
