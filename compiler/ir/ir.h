// long: the nodes of the program, which name each other
// The resolved, instantiated program: every name bound, every type concrete. sema makes it, lower/ rewrites it down to
// memory operations, layout/ and emit/ read it.
//
// Kernels, pipelines and passes share these nodes. Operations of structures ("element", "near", "read", "write") are
// turned by lower/ into operations of memory ("load", "store", …) on bindings of a Pass. ir/levels.h says which
// operation belongs to which level.
#pragma once

#include "base/arena.h"
#include "base/name.h"
#include "base/rare_vector.h"
#include "base/small_vector.h"
#include "ir/intrinsics.h"
#include "ir/invocation.h"
#include "ir/raster.h"
#include "ir/types.h"
#include "source/source.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gliftc::ir {

struct Expr;
struct Stmt;
struct Local;
struct Function;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using LocalId = Id<Local>;
using FunctionId = Id<Function>;
using Operands = SmallVector<ExprId, 4>;

/// A structure seen from a function or kernel: structure parameter `root`, then nested structure members by index.
/// In a structure's own expressions (memory sizes, via arguments, …) root 0 is the structure itself; in a translator's
/// functions root i is the i-th of the translator's structure-typed fields. In pipelines and tests `root` is unused:
/// the Expr's or Stmt's `local` (a temp, a structure parameter, a slice) is where `members` starts; without a local it
/// starts at the adaptor that owns the pipeline. This holds for every operation that has a place (member, domain,
/// host_read, slice, …).
struct Place {
    std::uint32_t root = 0;
    RareVector<std::uint32_t> members;
    bool operator==(const Place&) const = default;
};

// ---------------------------------------------------------------------------------------------------- expressions

enum class Op : std::uint8_t {
#define OPERATION(name, level) name,
#include "ir/operations.def"
};

enum class UnaryOp : std::uint8_t { minus, logical_not, bit_not };
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
    not_equal,  // scalar operands, except equal/not_equal: any, giving one bool
    bit_and,
    bit_xor,
    bit_or,
    logical_and,
    logical_or,
};

/// There are hundreds of them for a line of source: small members are packed, and rare ones take only a pointer.
struct Expr {
    Op op = Op::constant;
    UnaryOp unary = {};
    BinaryOp binary = {};
    Intrinsic intrinsic = {};
    Invocation invocation = {};
    Builtin builtin = {};
    std::array<std::uint8_t, 4> lanes = {};
    TypeId type;
    Span span;
    LocalId local;
    FunctionId function;
    std::uint32_t slot = 0;
    Operands operands;
    std::uint64_t bits = 0;
    double number = 0;
    Place place;
    RareVector<Place> places;  ///< call: one a structure parameter of the function
};

// ----------------------------------------------------------------------------------------------------- statements

enum class StmtOp : std::uint8_t {
#define STATEMENT(name, level) name,
#include "ir/statements.def"
};

/// Slot of StmtOp::report for structures without memory (views).
inline constexpr std::uint32_t no_binding = 0xffffffffu;

/// Consecutive elements that are loaded or stored as one vector.
inline constexpr std::uint32_t row_width = 4;

/// How scatter combines writes to one address.
enum class Combine : std::uint8_t { replace, min, max, add, bit_and, bit_or, bit_xor };

enum class Direction : std::uint8_t { in, out, inout };
enum class Pattern : std::uint8_t {
#define PATTERN(name, reach, course, directions) name,
#include "ir/patterns.def"
#undef PATTERN
};

struct Stmt {
    StmtOp op = StmtOp::block;
    Combine combine = Combine::replace;
    bool unrolled = false;       ///< for_: shaders have an unroll hint
    bool uninitialized = false;  ///< temp: its memory is not zeroed; let: has no value, and is not zeroed either
    Span span;
    LocalId local;
    ExprId target;
    ExprId value;
    ExprId limit;
    std::uint32_t slot = 0;
    RareVector<StmtId> body;
    RareVector<StmtId> otherwise;
    Operands arguments;
    RareVector<LocalId> locals;  ///< release
    Place place;
};

enum class Storage : std::uint8_t { value, shared };

struct Local {
    Name name;  ///< as in the source; printers make it unique where needed
    TypeId type;
    Span span;
    bool is_mutable = false;
    Storage storage = Storage::value;
    bool is_temporary = false;  ///< introduced by a pass for a value that is used more than once
};

// ------------------------------------------------------------------------------------------------------ functions

/// What a function, or what a kernel calls, writes: the elements of the structure at a place, by scatter or coherent.
struct Effect {
    Place place;  ///< root: of Function::structures, of Kernel::params
    Pattern pattern = Pattern::scatter;
    Combine combine = Combine::replace;
    Span span;            ///< where a function declares it, or a kernel calls what does it
    Name by;              ///< the function
    bool is_own = false;  ///< a function declares it
};

struct Function {
    Name name;            ///< as written
    std::string display;  ///< with generic arguments, for comments and messages: linearize<3>
    std::string key;      ///< display with the modules of all it names: the same in every compilation
    Span span;
    std::vector<LocalId> params;
    std::vector<std::uint32_t> structures;           ///< structure instances that calls pass at `places`
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< of the kernels that call it; all 0: any
    std::vector<LocalId> shared;                     ///< workgroup memory, the same at every call
    TypeId result;
    std::vector<StmtId> body;  ///< a function with a group returns only by its last statement
    bool is_pub = false;
    bool reads_memory = false;    ///< elements of structures, itself or by what it calls
    std::vector<Effect> effects;  ///< what it writes, itself or by what it calls
    std::uint32_t module = 0;
    std::string extern_name;  ///< a C++ function (host only), else empty
    std::string doc;
    bool grouped() const { return group[0] != 0; }
    /// Whether calls become statements: what happens in them happens where they stand, once.
    bool is_statements() const { return grouped() || !effects.empty(); }
};

// ----------------------------------------------------------------------------------------------------- components

struct StructField {
    Name name;
    TypeId type;
    ExprId default_value;
    std::string doc;
};
struct Struct {
    Name name;
    std::string display;
    std::string key;  ///< display with qualified names: the same in every compilation, as are all keys below
    std::uint32_t module = 0;
    bool is_pub = false;
    std::vector<StructField> fields;
    std::string extern_header;  ///< imported from C++: its header as written, and its C++ name in extern_name
    std::string extern_name;
    std::vector<std::uint32_t> offsets;  ///< imported: byte offsets that layout must keep; else empty
    std::uint32_t size = 0;
    std::string doc;
    Span span;
};

struct Enum {
    Name name;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::vector<Name> enumerators;
    std::vector<std::uint32_t> values;
    std::string doc;
    Span span;
};

/// Whether two virtual addresses may have one physical address.
enum class Mapping : std::uint8_t {
    unknown,
    one_to_one,          ///< proved
    claimed_one_to_one,  ///< declared by `invert` or @one_to_one; `gliftc test` checks it
    many_to_one,         ///< declared by @many_to_one
};

/// What is inferred of a translator, or declared by @attributes and checked (thesis section 3.2.3).
struct Properties {
    bool partial = false;     ///< translate gives an optional
    bool invertible = false;  ///< has invert
    Mapping mapping = Mapping::unknown;
    bool affine = false;            ///< physical address is an affine function of the virtual one
    bool uniform = true;            ///< the same work for every address, but for early exits with `none`
    std::string memory_complexity;  ///< "O(1)", or as declared: "O(n)", …; "not known"
    std::string access_complexity;  ///< likewise
    std::string location = "GPU and CPU";
};

/// One instance of a translator.
struct Translator {
    Name name;
    std::string display;  ///< Fold<4>
    std::string key;
    Span span;
    std::uint32_t module = 0;
    TypeId virtual_type;                    ///< uint or a vector of uint
    TypeId physical_type;                   ///< without the optional
    std::vector<StructField> scalars;       ///< state: Op::state slot i
    std::vector<std::uint32_t> structures;  ///< state that is structures: instances; Place root i in its functions
    std::vector<Name> structure_names;
    FunctionId translate;     ///< (va) -> physical or physical?
    FunctionId wide;          ///< the same with a 64-bit result, if that is a scalar; set by lower/widen
    FunctionId wide_of_wide;  ///< the same with 64-bit arguments, too
    FunctionId invert;        ///< (pa) -> va; absent if not invertible
    FunctionId ranges;        ///< absent: derived
    FunctionId domain;        ///< () -> extent of the virtual domain
    Properties properties;
    std::string doc;
};

/// A translator within a structure: `via A then B`, one stage.
struct Stage {
    std::uint32_t translator = 0;
    std::vector<ExprId>
        scalars;  ///< a value for each scalar of its state: expressions over the structure (place root 0)
    std::vector<Place> structures;  ///< a nested structure for each structure of its state (root 0 is the structure)
};

/// image2darray: the third component of addresses and extents is the layer.
enum class MemoryShape : std::uint8_t { buffer, image1d, image2d, image3d, imagecube, image2darray };

/// Texel formats; same names as the language's. `none` for buffers.
enum class Format : std::uint8_t {
    none,
    r8,
    rg8,
    rgba8,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r8ui,
    r16ui,
    r32ui,
    rg32ui,
    rgba32ui,
    r32i,
    rg32i,
    rgba32i,
    rgba8ui,
    d32,
};

/// A reference is compared so with a texel.
enum class Compare : std::uint8_t { less, less_equal, greater, greater_equal };

/// What an image that is not made anew is a part of.
struct ImagePart {
    enum class Kind : std::uint8_t { mip, layer } kind = Kind::mip;
    Place of;                ///< the structure that has the image, over the structure that has the part (root 0)
    std::uint32_t slot = 0;  ///< which of its memories
    ExprId number;           ///< of the level or the layer
};

struct Memory {
    Name name;
    MemoryShape shape = MemoryShape::buffer;
    TypeId element;  ///< the value type that loads give (float for r8, float4 for rgba8)
    Format format = Format::none;
    ExprId extent;  ///< uint, uint2, uint3, over the structure (root 0); in 64 bits after lower/widen
    ExprId mips;    ///< or absent
    std::optional<ImagePart> part;
    bool linear = false;  ///< filter linear
    Compare compare = Compare::less_equal;
    Span span;
};

struct MemberStructure {
    Name name;
    std::uint32_t structure = 0;  ///< instance
    std::vector<ExprId>
        arguments;  ///< of its constructor, over the owner (root 0); empty where passed by reference (views)
    std::vector<Place> structures;  ///< those that its constructor is given, over the owner (root 0)
    bool by_reference = false;      ///< the member is a constructor argument that is itself a structure
    Span span;
};

enum class StructureKind : std::uint8_t { stored, view, adaptor };

/// A function of an adaptor that programs call: on the host, or by a pipeline that gives the result on the device.
struct Method {
    FunctionId function;
    std::optional<std::uint32_t> pipeline;  ///< Program::pipelines: the function reads memory
};

/// Host state of an adaptor.
struct HostField {
    Name name;
    TypeId type;
    ExprId initial;
};

/// What of a structure's domain is there: blocks of one size, which do not overlap.
struct Blocks {
    FunctionId count;  ///< () -> uint; structures[0] of all three is the structure that declares them
    FunctionId first;  ///< (number) -> the first address, or an optional: none, the block is not there
    FunctionId size;   ///< () -> the extent of every block
    ExprId extent;     ///< what `size` gives, over the structure (root 0): the host knows it
    ExprId bound;      ///< a number that the host knows and `count` does not exceed, over the structure; absent: none
    bool is_known = false;  ///< `count` is the bound itself
    /// Program::pipelines: gives `count` on the device, where a kernel needs it.
    std::optional<std::uint32_t> counter;
};

/// What a module calls an instance of a structure: `pub structure Field = Array<4, float>;`.
struct Alias {
    Name name;
    std::uint32_t module = 0;
    bool is_pub = false;
};

/// One instance of a structure, view or adaptor.
struct Structure {
    StructureKind kind = StructureKind::stored;
    Name name;                   ///< of the declaration: Array
    std::string display;         ///< Array<4, float>
    std::string key;             ///< std.array.Array<4, float>
    std::vector<Alias> aliases;  ///< of all modules, each module's in its order
    Span span;
    std::uint32_t module = 0;          ///< of the declaration
    TypeId domain_type;                ///< uint or vector of uint; adaptors: void
    TypeId element;                    ///< adaptors: void
    std::vector<LocalId> constructor;  ///< scalar constructor parameters; Op::member slot i
    std::vector<Memory> memories;
    std::vector<MemberStructure> members;  ///< Place members index these
    std::vector<Stage> via;        ///< first stage takes the virtual address; the last gives the address in memory 0
    std::uint32_t via_memory = 0;  ///< the memory that `via` addresses, where it is not a structure
    /// The structure that is the memory: a path of members, empty where the memory is one of `memories`. Without `via`
    /// its addresses are the structure's own. See ir/chain.h.
    RareVector<std::uint32_t> base;
    Name base_name;  ///< as declared
    Span base_span;
    ExprId otherwise;              ///< value of an unmapped read; absent: zero
    ExprId domain;                 ///< extent of the virtual domain, over the structure (root 0)
    std::optional<Blocks> blocks;  ///< as declared here; see blocks_of() of ir/chain.h
    FunctionId at;                 ///< views: (address) -> element; structures[] of the function are [this structure]
    std::vector<FunctionId> functions;     ///< other fns: structures[0] is this structure
    std::vector<HostField> host;           ///< adaptors
    std::vector<std::uint32_t> pipelines;  ///< adaptors: Program::pipelines
    /// The axes along which no address leads beyond its own memory, a bit each: set by lower/contained.cpp.
    std::uint8_t contained_axes = 0;
    std::vector<Method> methods;  ///< adaptors: public functions
    bool copyable = true;         ///< elements can be read and written from the host (not views)
    std::string doc;
};

struct KernelParam {
    Name name;
    Span span;
    Pattern pattern = Pattern::value;
    Direction direction = Direction::in;
    std::uint32_t structure = 0;  ///< instance; Place root is the index of this parameter among the kernel's params
    std::uint32_t radius = 0;     ///< near
    Combine combine = Combine::replace;  ///< scatter
    LocalId local;                       ///< value, argument
    std::uint32_t alike =
        0;  ///< the first parameter assumed to have the same state: the direct form passes that state once
};

/// A kernel before lowering. Its body uses Place{root = index in params}.
struct Kernel {
    Name name;
    std::string display;
    std::string key;
    Span span;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::vector<KernelParam> params;
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< all 0: the compiler chooses
    std::uint32_t items = 1;                         ///< at<S, items>: consecutive elements that one invocation takes
    TypeId domain_type;                              ///< of the iteration: uint or vector of uint
    std::vector<StmtId> body;
    std::vector<LocalId> shared;  ///< workgroup memory
    std::vector<Effect> effects;  ///< what functions write through `calls` parameters
    /// @disjoint(read, written): what is read through the first parameter is not written in this pass by the second.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> disjoint;
    std::optional<Raster> raster;  ///< of a draw, whose body is the vertex part
    /// The parameter whose blocks are visited; none: the whole range is.
    std::optional<std::uint32_t> space;
    std::vector<std::uint32_t> same_space;  ///< parameters whose blocks must be the same ones in every call
    std::string doc;
    bool grouped() const { return group[0] != 0; }
};

/// The parameter whose range an `at` parameter takes if its argument is left out: the first `each` of its structure,
/// else the first `any`, else the first `scatter`.
std::optional<std::size_t> range_giver(const std::vector<KernelParam>& params, std::size_t at);

enum class HostPattern : std::uint8_t { value, structure, range };

struct PipelineParam {
    Name name;
    Span span;
    HostPattern pattern = HostPattern::value;
    Direction direction = Direction::in;
    std::uint32_t structure = 0;  ///< structure, range
    LocalId local;                ///< always: value, structure or slice, used by the body as Op::local
};

struct Pipeline {
    Name name;
    std::string display;
    std::string key;
    Span span;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::optional<std::uint32_t> owner;  ///< an adaptor's pipeline: its structure instance; its members by Place root 0
    std::vector<PipelineParam> params;
    TypeId result;  ///< void, a value, device value, or slice
    std::vector<StmtId> body;
    Span host_needed;  ///< where it first waits, or changes what the host knows
    bool is_value =
        false;  ///< one pass of one invocation, without effects: a value of the device that another one computes
    std::string doc;
};

struct Test {
    std::string title;
    Span span;
    std::uint32_t module = 0;
    std::uint32_t pipeline = 0;  ///< Program::pipelines
};

struct Constant {
    Name name;
    TypeId type;
    ExprId value;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::string doc;
};

struct Module {
    Name name;  ///< "std.array"
    std::uint32_t file = 0;
    bool is_root = false;                ///< named on the command line: outputs are generated for it
    std::vector<std::uint32_t> imports;  ///< Program::modules that it uses, transitively; sorted
    std::string doc;
};

/// The whole program.
struct Program {
    Names* names = nullptr;
    Types types;
    Arena<Expr> exprs;
    Arena<Stmt> stmts;
    Arena<Local> locals;
    Arena<Function> functions;
    std::vector<Module> modules;  ///< in dependency order
    std::vector<Struct> structs;
    std::vector<Enum> enums;
    std::vector<Constant> constants;
    std::vector<Translator> translators;
    std::vector<Structure> structures;
    std::vector<Kernel> kernels;
    std::vector<Pipeline> pipelines;
    std::vector<Test> tests;
    /// The kernel that copies elements of structure i to (out) or from (in) a linear buffer: Program::kernels, or none.
    struct Transfer {
        std::uint32_t structure, read_kernel, write_kernel, fill_kernel;
        std::uint32_t box_structure;
        /// What lists the elements that are there, where that is not all of the domain; the lists of addresses, places
        /// and values, and the number of their entries.
        std::uint32_t list_kernel;
        std::uint32_t addresses, places, values, counter;
    };
    std::vector<Transfer> transfers;
};

}  // namespace gliftc::ir
