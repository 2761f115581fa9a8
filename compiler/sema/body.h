// Checking of bodies: the state of one body, and the result of checking an expression.
#pragma once

#include "sema/build.h"
#include "sema/context.h"
#include "sema/meta.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace gliftc::sema {

enum class BodyKind : std::uint8_t {
    constant,   // compile-time values
    function,   // functions and methods
    structure,  // sizes, arguments and defaults in a structure's declaration: evaluated on the host when one is made
    kernel,
    pipeline,  // tests too
};

enum class SymbolKind : std::uint8_t { local, structure, state, member, memory, iterator, host_state };

/// How the elements of a structure are accessed under a name: read by address, or as its pattern says. `calls`: read
/// by address, and functions that write may be called.
struct Writing {
    ir::Pattern pattern = ir::Pattern::any;
    ir::Combine combine = ir::Combine::replace;
    Span span;  ///< of its declaration
    bool is(ir::Pattern wanted) const { return pattern == wanted; }
};

/// The meaning of a name in scope.
struct Symbol {
    SymbolKind kind = SymbolKind::local;
    Span span;
    ir::TypeId type;
    ir::LocalId local;
    ir::Place place;
    std::uint32_t structure = 0;
    std::uint32_t slot = 0;
    std::uint32_t window = 0;  ///< structure: the radius of a `near` parameter of a function; 0: not a window
    Writing writing;           ///< structure
    bool used = false;
    bool warn_unused = false;
};

enum class OperandKind : std::uint8_t { error, value, meta, structure, memory, iterator };

/// A checked expression.
struct Operand {
    OperandKind kind = OperandKind::error;
    Span span;
    ir::ExprId expr;              ///< value
    ir::TypeId type;              ///< value
    Meta meta;                    ///< meta
    ir::Place place;              ///< structure, memory
    ir::LocalId local;            ///< structure, in pipelines: where `place` starts
    std::uint32_t structure = 0;  ///< structure: its instance
    std::uint32_t slot = 0;       ///< memory: which; iterator: which kernel parameter
    std::uint32_t window = 0;     ///< structure: as in Symbol
    bool is_slice = false;        ///< structure: `local` is a slice
    Writing writing;              ///< structure
};

struct Body {
    Context& context;
    const Env& env;
    BodyKind kind = BodyKind::function;
    std::vector<std::unordered_map<Name, Symbol>> scopes = {{}};
    ir::Definitions lets;                                ///< initialisers of immutable locals
    std::unordered_map<ir::LocalId, ir::Operands> made;  ///< pipelines: what temporaries were made with
    std::vector<ir::StmtId>* block = nullptr;            ///< where statements go; null: expressions only
    ir::TypeId result;                                   ///< of return
    unsigned loops = 0;
    unsigned depth = 0;
    ir::Kernel* kernel = nullptr;
    ir::Part part = ir::Part::whole;  ///< of a draw
    std::optional<std::uint32_t>
        container;  ///< whose function or pipeline this is: its members are in scope, at root 0
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< the workgroup of the kernel or function; all 0: none
    std::vector<ir::LocalId>* shared = nullptr;      ///< its workgroup memory
    Span last;                                       ///< functions with a workgroup: the statement that may return
    std::vector<std::uint32_t> structures;           ///< functions: structure parameters so far (Place roots)
    std::vector<ir::Place> coherent;                 ///< what is accessed as coherent memory
    std::vector<ir::Effect>* effects = nullptr;      ///< of the function or kernel
    enum class Returns : std::uint8_t { nothing, host, device } returns = Returns::nothing;  ///< of a pipeline, so far
    std::optional<ir::TypeId> range_result;  ///< pipelines that return a range: its type, known from the first return
    bool in_test = false;
    bool is_open = false;            ///< pipelines: what is checked is part of an expression that a pass may compute
    std::vector<ir::ExprId> leaves;  ///< of that expression, so far (sema/values.h)
    std::string key;                 ///< pipelines: the same in every compilation
    struct Arm {
        ir::LocalId condition;
        bool where = true;  ///< the arm runs where the condition is this
        Span span;
    };
    std::vector<Arm> arms;                                ///< pipelines: those around what is checked (sema/arms.h)
    std::unordered_map<ir::LocalId, std::size_t> depths;  ///< of variables: how many arms were around them
    std::vector<Span> device_variables;                   ///< names of variables that lie on the device
    Span host_needed;  ///< where the pipeline first waits, or changes what the host knows
    struct Replacement {
        std::uint32_t member;
        ir::LocalId temporary;
        Span span;
        const std::vector<ir::StmtId>* block;
    };
    std::vector<Replacement> replacements;  ///< pipelines: members that get other memory (sema/replace.h)
    unsigned values = 0;                    ///< pipelines: passes that compute values, so far
    bool allow_await = false;

    bool grouped() const { return group[0] != 0; }
    bool is_coherent(const ir::Place& place) const { return std::ranges::find(coherent, place) != coherent.end(); }
    ir::Program& program() { return context.program; }
    ir::Types& types() { return context.program.types; }
};

// scopes
void open_scope(Body&);
void close_scope(Body&);                       ///< warns of unused variables
void declare(Body&, ast::Identifier, Symbol);  ///< reports duplicates in the same scope
Symbol* find_symbol(Body&, Name);
ir::LocalId declare_local(Body&, ast::Identifier, ir::TypeId, bool is_mutable, bool warn_unused = true);
/// A compiler-made local with this value.
ir::LocalId emit_temporary(Body&, std::string_view name, ir::ExprId value, Span);
void emit(Body&, ir::StmtId);
/// The value of an expression if it is known at compile time, by the definitions of locals, too.
std::optional<ir::Value> known_value(Body&, ir::ExprId);
/// The environment for a compile-time expression in the body, with bindings for the names in scope that it uses.
const Env& env_for(Body&, ast::ExprId);
const Env& env_for(Body&, const std::vector<ast::ExprId>&);

// expressions
/// `hint` is the type that the context prefers (bidirectional typing): literals, `none`, tuples and generic calls take
/// it where nothing else determines theirs. It is not enforced: use check_value or coerce for that.
Operand check(Body&, ast::ExprId, ir::TypeId hint = {});
ir::ExprId check_hinted(Body&, ast::ExprId, ir::TypeId hint);  ///< the same, as a value
/// The expression as a value, of exactly the wanted type if given; else reports and returns an error node.
ir::ExprId check_value(Body&, ast::ExprId, ir::TypeId wanted = {});
ir::ExprId to_value(Body&, const Operand&);
/// Coerces `expr` to the wanted type: itself, or wrapped into an optional; reports a mismatch.
ir::ExprId coerce(Body&, ir::ExprId expr, ir::TypeId wanted, Span);
/// Notes how to unwrap an optional that was found where a value is needed.
void note_optional(Body&, Diagnostic&, Span, ir::TypeId found);
Operand value_operand(Body&, ir::ExprId, Span);
Operand error_operand(Span);
ir::ExprId error_value(Body&, Span);
bool is_error(const Body&, ir::ExprId);

// parts of expressions, a file each
Operand check_member(Body&, ast::ExprId);
std::optional<Operand> check_device_member(Body&, const ast::Expr&);
Operand unknown_member(Body&, std::string_view what, ast::Identifier, const std::vector<std::string_view>& known);
Operand check_index(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_call(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_unary(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_binary(Body&, ast::ExprId, ir::TypeId wanted);
Operand check_conditional(Body&, const ast::Expr&, ir::TypeId wanted);
Operand check_otherwise(Body&, const ast::Expr&, ir::TypeId wanted);  ///< `a ?? b`
bool has_equality(const ir::Program&, ir::TypeId);                    ///< `==` and `!=` apply to two of the type
ir::ExprId make_struct_equality(Body&, bool negated, ir::ExprId left, ir::ExprId right, Span);
/// The value that `target op= value` assigns; `before` is the target's old value.
ir::ExprId check_compound(Body&, const ast::Stmt&, ir::ExprId before);
/// A swizzle such as `.x` or `.yz` of a value, or an error.
Operand make_swizzle_of(Body&, ir::ExprId, ast::Identifier);

// calls
/// A call of a structure's function with values: a node, or the pass that it is.
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
/// Checks `statements` in a scope of their own; returns them.
std::vector<ir::StmtId> check_nested(Body&, const std::vector<ast::StmtId>&);
/// Does every path through the list end in return?
bool always_returns(const ir::Program&, const std::vector<ir::StmtId>&);

// kernels
bool check_iterator_assignment(Body&, const ast::Stmt&);
Operand iterator_value(Body&, const Operand&);

// pipelines
void check_range_return(Body&, const ast::Stmt&);        ///< of a pipeline that returns a range
bool check_pipeline_statement(Body&, const ast::Stmt&);  ///< false: not one of theirs
std::optional<Operand> check_pipeline_call(Body&, const std::vector<ast::DeclId>&,
                                           const std::vector<ast::ExprId>& generics, const ast::Expr& call,
                                           const Operand* owner = nullptr);
std::optional<Operand> check_pipeline_builtin(Body&, std::string_view name, const ast::Expr& call);
/// A slice or a temporary structure as an operand of kind `structure`, from which places can start.
std::optional<Operand> as_structure(Body&, const Operand&);
Operand check_pipeline_index(Body&, const Operand& structure, const ast::Expr& index);
Operand construct_structure(Body&, ir::TypeId, const ast::Expr& call);

}  // namespace gliftc::sema
