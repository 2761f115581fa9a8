// The syntax tree: made by the parser, read by sema. No names are resolved. Comments of enumerators show the syntax or
// say which fields of the node are used; words after the syntax say where it is allowed, or what it means. The comment
// of a field that only some kinds use begins with these kinds; what it holds there follows after a colon.
//
// Types are expressions: `Array<4, float>`, `float4`, `T[8]`, `vec<N, uint>?` use the same nodes as values, and sema
// interprets an expression as a type or as a value by its context.
#pragma once

#include "base/arena.h"
#include "base/name.h"
#include "source/source.h"
#include "syntax/token.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace gliftc::ast {

struct Expr;
struct Stmt;
struct Decl;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using DeclId = Id<Decl>;

/// An identifier and its location.
struct Identifier {
    Name name;
    Span span;
};

// ---------------------------------------------------------------------------------------------------- expressions

enum class ExprKind : std::uint8_t {
    error,           // a syntax error; reported already
    int_literal,     // value; suffix: u, l (int64), ul (uint64)
    float_literal,   // number; suffix: f, h, d
    bool_literal,    // value 0 or 1
    string_literal,  // text (in `name`)
    none_literal,    // none
    name,            // name
    generic,         // operands[0] < operands[1..] >, `Array<4, float>`
    named,           // name: operands[0], among generic arguments
    member,          // operands[0] . name
    index,           // operands[0] [ operands[1..] ]; as a type: an array; `T[]` has one operand
    call,            // operands[0] ( operands[1..] ); names of arguments in `labels`
    unary,           // op operands[0]
    binary,          // operands[0] op operands[1]; includes ?? and `then`
    conditional,     // operands[0] ? operands[1] : operands[2]
    range,           // operands[0] .. operands[1]
    optional,        // operands[0]?, as a type
    await,           // await operands[0]
    tuple,           // { operands… }, an array, vector or struct literal; labels where written `x: 1`
    closure,         // |parameters| operands[0], or |parameters| { … } without operands; arguments of calls; `decl`
    known_type,      // the type with index `value`: made by sema, for the functions that closures are called by
};

enum class UnaryOp : std::uint8_t { plus, minus, logical_not, bit_not };

enum class BinaryOp : std::uint8_t {
    multiply,
    divide,
    remainder,
    add,
    subtract,
    shift_left,
    shift_right,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    bit_and,
    bit_xor,
    bit_or,
    logical_and,
    logical_or,
    otherwise,  // a ?? b
    then,       // translators: A then B
};

struct Expr {
    ExprKind kind = ExprKind::error;
    Span span;       ///< the whole expression
    Name name;       ///< name, member, string_literal, named
    Span name_span;  ///< member, named: the name alone; operators, `..`, `?`, await: the operator
    UnaryOp unary = {};
    BinaryOp binary = {};
    char suffix[3] = {};      ///< numbers: "u", "ul", "h", …
    std::uint64_t value = 0;  ///< int_literal, bool_literal, known_type
    double number = 0;        ///< float_literal
    std::vector<ExprId> operands;
    std::vector<Identifier> labels;  ///< call, tuple: a name (or none) for each argument; empty if no argument is named
    DeclId decl;                     ///< closure: a Function, whose parameters may be without types
};

// ----------------------------------------------------------------------------------------------------- statements

enum class StmtKind : std::uint8_t {
    error,
    let,         // let/var/const name [: type] [= value]   (`binding`: which word; only `var name: type;` has no value)
    shared,      // shared name: type;                     kernels and functions with a group
    temp,        // [uninitialized] temp name [: type] = value;            pipelines and tests
    assign,      // target op= value; op absent for plain `=`
    expression,  // value;
    if_,         // if value body [else otherwise]; `if let name = value` where `name` is set
    for_,        // for name in value [while condition] body
    while_,      // while value body
    switch_,  // switch value { case, case: { … } else: { … } }: an if_ over a variable `name` with its value in `body`
    break_,
    continue_,
    return_,  // return [value];
    discard,  // discard;                                 fragment parts
    block,    // { body… }
};

enum class Binding : std::uint8_t { let, var, const_ };

struct Stmt {
    StmtKind kind = StmtKind::error;
    Span span;
    Binding binding = Binding::let;
    Identifier name;             ///< let, shared, temp, for_, `if let`; switch_: a name that programs cannot write
    ExprId type;                 ///< let, shared, temp: as written, or absent
    ExprId target;               ///< assign
    std::optional<BinaryOp> op;  ///< assign: the operator of `+=` and the like
    Span op_span;
    ExprId value;
    ExprId condition;               ///< for_: what follows `while`, or absent
    std::vector<StmtId> body;       ///< if_, for_, while_, block, switch_
    std::vector<StmtId> otherwise;  ///< if_: the else part (one if_ statement for `else if`)
    bool has_else = false;          ///< if_, switch_
    std::uint32_t branches = 0;     ///< switch_: how many ifs, each the `else` of the one before, are its branches
    bool is_uninitialized = false;  ///< temp: written with `uninitialized`
};

// --------------------------------------------------------------------------------------------------- declarations

/// One of the parameters in `<N: uint, T: type = float, S: Structure<uint3, float>>`, or an unnamed one: the structure
/// of a kernel's parameter whose pattern names none, as in `from: in each` and `volume: in any<Structure<uint3,
/// float>>`.
struct GenericParam {
    Identifier name;    ///< unnamed: what no source can write
    ExprId constraint;  ///< `uint`, `type`, `Structure<…>`, an enum, an interface, …; absent after an error, and of
                        ///< an unnamed one that takes any structure
    ExprId default_value;  ///< or absent; unnamed: the structure of `at` if its argument is left out
    Name parameter;        ///< unnamed: the kernel's parameter; else absent

    bool is_unnamed() const { return static_cast<bool>(parameter); }
};

/// Whether a parameter is read, written or both. `none`: the source does not say.
enum class Direction : std::uint8_t { none, in, out, inout };

/// The access pattern of a parameter: how it may be accessed, and which elements (docs/reference/language.md, "Kernels
/// and iterators" and "Draws"). `none`: no pattern is written. `range` is for pipelines, not for kernels: a parameter
/// `range<N, T>` takes any structure or slice with N-dimensional addresses and elements T, and a result may be one.
enum class Pattern : std::uint8_t { none, each, near, any, at, scatter, coherent, calls, target, instance, range };

/// `name: [in|out|inout] (each|near|any|at|scatter|coherent|calls|target|instance|range)<type, extra…>`,
/// `name: [in|out|inout] type`, or in some methods (Parser::parse_param) `name`. Where a kernel's pattern names no
/// structure, `type` names an unnamed generic parameter of the kernel.
/// In constructors all but structures may be followed by `= default`.
struct Param {
    Identifier name;
    Direction direction = Direction::none;
    Span direction_span;
    Pattern pattern = Pattern::none;
    Span pattern_span;
    ExprId type;
    /// What follows the type. near: the radius; scatter: the operation that combines writes; target: how colours are
    /// blended, or the depth test; at: how many elements an invocation takes; range<N, T>: `type` is N, extra[0] is T.
    std::vector<ExprId> extra;
    ExprId default_value;  ///< of a constructor's argument, or absent
};

/// `@name(arguments)` before a declaration or method.
struct Attribute {
    Identifier name;
    std::vector<ExprId> arguments;
    Span span;
};

/// One pattern after a function's `with`, such as `scatter<member, op>`. It names a member of the structure
/// that the function belongs to, and says that the function writes the member (scatter), reads and writes it
/// (coherent), or calls functions of the member that have a `with` themselves (calls).
struct MemberPattern {
    Pattern pattern = Pattern::none;
    Span pattern_span;
    Identifier member;
    std::vector<ExprId> extra;  ///< scatter: the operation's name
};

/// `fn name<…>(…) [group(…)] [with …] [-> type] { … }`; methods, before which `fn` may be left out (translate, invert,
/// domain, at, …), are functions too.
struct Function {
    std::vector<Param> params;
    std::vector<ExprId> group;  ///< extents of the workgroup that kernels must have to call it; empty: any kernel may
    std::vector<MemberPattern> with;
    ExprId result;  ///< or absent
    std::vector<StmtId> body;
    bool has_body = false;  ///< false: a `;` stands in place of the body, as in interfaces
};

struct Field {
    std::vector<Attribute> attributes;
    Identifier name;
    ExprId type;
    std::string doc;
};

struct Struct {
    std::vector<Field> fields;
    std::string extern_header;  ///< "file.hpp" of `extern struct X from "file.hpp";`, else empty
    Span extern_span;
    // Of an `extern struct`, these and `fields` are filled from the C++ header before sema:
    std::string extern_name;             ///< as C++ writes it: "sim::Particle"
    std::vector<std::uint32_t> offsets;  ///< in bytes, one per field
    std::uint32_t size = 0;              ///< bytes
};

struct Enumerator {
    Identifier name;
    ExprId value;  ///< or absent
};
struct Enum {
    std::vector<Enumerator> enumerators;
};

/// Members are functions. Their bodies, if written, are parsed, but sema ignores them.
struct Interface {
    std::vector<DeclId> members;
};

/// `const name [: type] = value;`
struct Const {
    ExprId type;
    ExprId value;
};

/// `type Name<…> = expr;`, `structure Name<…> = expr;`, `translator Name<…> = A<…> then B<…>;`
struct Alias {
    ExprId target;
};

/// `translator Name<…> : virtual -> physical { fields; methods }`
struct Translator {
    ExprId virtual_type;
    ExprId physical_type;
    std::vector<Field> fields;
    std::vector<DeclId> methods;  ///< translate, invert, domain; sema reports others
};

enum class ItemKind : std::uint8_t {
    memory,  // memory name = buffer<T>[n] | image2d<F>(extent) | … [mips(n)] [filter linear] [compare less] [apart(b)];
    member,     // structure name = Type(arguments…);
    via,        // via A<…>(…) then B<…>(…);
    otherwise,  // otherwise value;         the value of reads at unmapped addresses
    host,       // host name: type = value;
    condition,  // if constant { items } [else { items }]
    function,   // a fn, or a method without the word `fn` (domain, at, blocks, …): `decl`
    pipeline,   // a pipeline: `decl`
};

/// One item in the body of a structure.
struct Item {
    ItemKind kind;
    Span span;
    Identifier name;
    ExprId type;           ///< host
    ExprId value;          ///< memory, member, via, otherwise, host, condition
    ExprId mips;           ///< memory: the number in `mips(n)`, or absent
    ExprId apart;          ///< memory: the condition in `apart(condition)`, or absent
    Name filter, compare;  ///< memory: the words after `filter` and `compare`; empty: not written
    Span filter_span, compare_span;
    std::vector<Item> body, alternative;  ///< condition
    DeclId decl;                          ///< function, pipeline
    std::string doc;
};

/// `structure Name<…>(constructor parameters) [: virtual -> element] { items }`. The types are those of a structure
/// that computes its elements.
struct Structure {
    std::vector<Param> constructor;
    ExprId virtual_type, element_type;
    std::vector<Item> items;
};

/// `cull back;` or `draw lines;`
struct RasterState {
    Word word;
    Span span;
    Identifier value;
};

/// `smooth name: type;`
struct Varying {
    Word interpolation = Word::smooth;  ///< smooth, linear, flat
    Identifier name;
    ExprId type;
};

/// The parts of a raster that other kernels do not have. Its vertex part is Kernel::body.
struct Raster {
    std::vector<RasterState> states;
    std::vector<Varying> varyings;
    std::vector<StmtId> fragment;
    Span vertex_span;    ///< the word `vertex`
    Span fragment_span;  ///< the word `fragment`; absent if there is no fragment part
};

/// `kernel name<…>(params) [group(x[, y[, z]])] { … }`, or `raster name<…>(params) { … vertex { … } fragment { … } }`
struct Kernel {
    std::vector<Param> params;
    std::vector<ExprId> group;  ///< empty: the compiler chooses
    std::vector<StmtId> body;
    std::optional<Raster> raster;
};

/// `kernel name = generic<…>, generic<…>;`: instances of generic kernels, which C++ programs call by the name.
struct KernelInstances {
    std::vector<ExprId> targets;
};

/// `pipeline name<…>(params) [-> type] { … }`
struct Pipeline {
    std::vector<Param> params;
    Pattern result_pattern = Pattern::none;  ///< range for `-> range<N, T>`, where result is N and result_extra is T
    ExprId result;
    ExprId result_extra;
    std::vector<StmtId> body;
};

/// `test "what is expected" { … }`
struct Test {
    std::string title;
    std::vector<StmtId> body;
};

struct Decl {
    Identifier name;  ///< tests: empty
    Span span;        ///< the whole declaration
    bool is_pub = false;
    bool is_extern = false;
    std::string doc;  ///< the `///` lines before it, joined by '\n', without the slashes
    std::vector<Attribute> attributes;
    std::vector<GenericParam> generics;  ///< the unnamed ones last
    std::variant<std::monostate, Function, Struct, Enum, Interface, Const, Alias, Translator, Structure, Kernel,
                 KernelInstances, Pipeline, Test>
        body;

    std::span<const GenericParam> named_generics() const {
        const auto unnamed = std::ranges::find_if(generics, &GenericParam::is_unnamed);
        return {generics.begin(), unnamed};
    }
};

/// `use std.array;` (a name: driver/load.h says where it is looked for) or `use ./mesh;` (relative to this file)
struct Use {
    std::string path;  ///< "std.array" or "./mesh"
    Span span;
};

/// One file.
struct Module {
    Identifier name;  ///< a dotted name is one Name: "std.array"
    std::string doc;
    std::vector<Use> uses;
    std::vector<DeclId> decls;
    std::uint32_t file = 0;
};

/// All files of one compilation share one tree, so that an id means one thing everywhere.
struct Tree {
    Arena<Expr> exprs;
    Arena<Stmt> stmts;
    Arena<Decl> decls;
};

}  // namespace gliftc::ast
