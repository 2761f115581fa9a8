// The resolved, instantiated program: every name bound, every type concrete. sema makes it, lower/ rewrites it down to
// memory operations, layout/ and emit/ read it.
//
// Two levels share these nodes. High-level operations speak of structures ("element", "near", "read", "write"); lower/
// turns them into memory operations ("load", "store", …) on bindings of a Pass. A node says which level it belongs to.
#pragma once

#include "base/arena.h"
#include "base/name.h"
#include "base/rare_vector.h"
#include "base/small_vector.h"
#include "ir/intrinsics.h"
#include "ir/types.h"
#include "source/source.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
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
    // values: both levels
    constant,   // a scalar: `bits` (integers, bool, enum) or `number` (floating)
    local,      // `local`
    construct,  // type(operands…): vectors, matrices, arrays, structs from as many values as they have parts; vectors
                // also
                // from vectors, and from one scalar (splat)
    convert,    // operands[0] to `type`, explicit conversions: same shape, other scalar; bit casts are intrinsics
    unary,      // `unary` operands[0]
    binary,     // operands[0] `binary` operands[1]; scalar with vector where one side is a scalar of the element type
    select,     // operands[0] ? operands[1] : operands[2]; only the taken side is evaluated
    swizzle,    // operands[0] . lanes[0..components)   (also one lane)
    index,      // operands[0] [ operands[1] ]: vector, matrix column, array
    field,      // operands[0] . fields[slot] of a struct
    call,       // function(operands…) with structures passed at `places`
    intrinsic,  // `intrinsic`(operands…)
    none,       // of an optional type
    some,       // operands[0] as an optional
    has_value,  // bool of optional operands[0]
    value,      // of optional operands[0]; only where has_value is known
    // structures: high level
    element,  // the current element of each-parameter place.root
    address,  // the current virtual address of at- or each-parameter place.root (relative to nothing: a full virtual
              // address)
    near,     // place.root [ operands[0] ]: the element at the current address + a constant offset (ivec)
    read,     // place [ operands[0] ]; of an array type: elements in a row, or in rows of four operands[1] apart
    sample,   // place . sample(operands[0]), texel coordinates as floats, element centres at +0.5
    member,   // constructor argument `slot` of the structure at `place`
    memory_extent,  // extent of memory `slot` of the structure at `place`: uint, uint2 or uint3
    domain,         // the extent of the virtual domain of the structure at `place`
    position,       // the current address, counted from the origin of the ranges that are visited
    state,          // scalar field `slot` of the translator whose function this is
    translate,      // place . translate(operands[0]): optional physical address
    invocation,     // `invocation`: ids of a grouped kernel
    // host: only in pipelines and tests
    host_read,    // await place[ operands[0] ]: a value read back
    device_read,  // place[ operands[0] ] left on the device; slot 1: where it lies, since nothing writes it afterwards
    await_value,  // await operands[0] of a device type
    host_state,   // host state `slot` of the adaptor at `place`
    slice,  // place [ operands[0] .. operands[0] + operands[1] ]: origin and size; either may be of a device type. The
            // local may itself be a slice: the origin is then relative to it
    structure_value,  // the structure at `place` (type: structure), passed or returned; a slice local is passed as
                      // Op::local
    pipeline_call,    // pipeline `slot` of Program::pipelines: operands in parameter order; of an adaptor:
                      // `local`/`place` is the owner
    device_property,  // `slot` is a DeviceProperty of the device that the pipeline runs on
    element_count,    // number of elements of the structure or slice at `place`: product of its size
    // memory: low level, after lower/
    parameter,     // member `slot` of Pass::parameters
    load,          // bindings[slot][ operands[0] ]: a buffer; operand is a uint index in elements
    image_load,    // bindings[slot] at texel operands[0] (int, int2, int3)[, level operands[1]]
    image_sample,  // bindings[slot] at normalised coordinates operands[0], level 0 or operands[1]
    builtin,       // `builtin` input of a shader
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

/// Ids within a grouped kernel; all uint.
enum class Invocation : std::uint8_t {
    local_index,
    group_index,
    group_count,
    group_size,
    subgroup_size,
    subgroup_lane,
    subgroup_index,
    subgroup_count
};

/// What a pipeline can ask of its device, to choose between variants of an algorithm.
enum class DeviceProperty : std::uint8_t {
    is_host,
    is_gpu,
    subgroup_size,
    subgroup_arithmetic,
    int64,
    shared_memory_bytes
};

/// What a shader is given; only made by lower/dispatch.
enum class Builtin : std::uint8_t {
    global_id,
    local_id,
    group_id,
    group_count,
    local_index,
    subgroup_size,
    subgroup_lane,
    subgroup_index,
    subgroup_count
};

/// A program has hundreds of them a line: what is small stands together, and what few have takes no more than a
/// pointer.
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
    let,     // local = value (declares); value may be absent: zero, unless `uninitialized`
    assign,  // target = value; target: local, or index/field/swizzle chain over a local (shared arrays too)
    if_,     // if value body else otherwise
    for_,    // for local in value..limit step 1, body   (int or uint)
    while_,  // while value body
    break_,
    continue_,
    return_,  // value may be absent
    block,
    evaluate,          // value for its effect
    barrier,           // all of the workgroup: execution and memory (grouped kernels)
    subgroup_barrier,  // the same of the subgroup
    // structures: high level
    set_element,  // the current element of each-parameter place.root = value
    write,        // place[target] = value, or combined with `combine` where the parameter is scatter<S, op>; an array
                  // as value: elements in a row, or in rows of four `arguments[0]` apart
    // host
    temp,         // local: a temporary structure, constructor arguments `arguments`
    release,      // temporaries that die here (made by lower/temporaries)
    dispatch,     // kernel `slot` of Program::kernels with `arguments` in parameter order
    expect,       // value must be true                  (tests)
    expect_near,  // arguments[0], [1], tolerance [2]
    expect_same,  // two structures element by element
    host_assign,  // target (host state `slot` of the adaptor that owns the pipeline) = value
    // memory: low level
    store,        // bindings[slot][target] = value
    image_store,  // bindings[slot] at texel target = value
    atomic,       // combine(bindings[slot][target], value)
    report,  // says that virtual address `target` lies outside the structure of bindings[slot]; without a binding: slot
             // is no_binding, the structure is a view
};

/// StmtOp::report: the structure has no memory.
inline constexpr std::uint32_t no_binding = 0xffffffffu;

/// Elements in a row that move as one vector.
inline constexpr std::uint32_t row_width = 4;

/// How scatter combines what is written to one address.
enum class Combine : std::uint8_t { replace, min, max, add, bit_and, bit_or, bit_xor };

struct Stmt {
    StmtOp op = StmtOp::block;
    Combine combine = Combine::replace;
    bool unrolled = false;       ///< for_: shaders ask for it to be unrolled
    bool uninitialized = false;  ///< temp: its memory holds anything; let: without a value, and not zero either
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
    Name name;  ///< as written; printers make it unique where needed
    TypeId type;
    Span span;
    bool is_mutable = false;
    Storage storage = Storage::value;
};

// ------------------------------------------------------------------------------------------------------ functions

struct Function {
    Name name;            ///< as written
    std::string display;  ///< with generic arguments, for comments and messages: linearize<3>
    Span span;
    std::vector<LocalId> params;
    std::vector<std::uint32_t> structures;           ///< structure instances that calls pass at `places`
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< of the kernels that call it; all 0: any
    std::vector<LocalId> shared;                     ///< workgroup memory, the same at every call
    TypeId result;
    std::vector<StmtId> body;  ///< of a function with a group: a return is its last statement
    bool is_pub = false;
    std::uint32_t module = 0;
    std::string extern_name;  ///< a C++ function (host only), else empty
    std::string doc;
    bool grouped() const { return group[0] != 0; }
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

/// What is inferred of a translator, or declared by @attributes and checked (thesis section 3.3).
struct Properties {
    bool partial = false;           ///< translate gives an optional
    bool invertible = false;        ///< has invert
    bool one_to_one = true;         ///< declared by @many_to_one otherwise
    bool affine = false;            ///< physical address is an affine function of the virtual one
    bool uniform = true;            ///< the same work for every address
    std::string memory_complexity;  ///< "O(1)", "O(n)", …
    std::string access_complexity;
    std::string location = "GPU and CPU";
};

/// One instance of a translator.
struct Translator {
    Name name;
    std::string display;  ///< Fold<4>
    Span span;
    std::uint32_t module = 0;
    TypeId virtual_type;                    ///< uint or a vector of uint
    TypeId physical_type;                   ///< without the optional
    std::vector<StructField> scalars;       ///< state: Op::state slot i
    std::vector<std::uint32_t> structures;  ///< state that is structures: instances; Place root i in its functions
    std::vector<Name> structure_names;
    FunctionId translate;  ///< (va) -> physical or physical?
    FunctionId invert;     ///< (pa) -> va; absent if not invertible
    FunctionId ranges;     ///< absent: derived
    FunctionId domain;     ///< () -> extent of the virtual domain
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

enum class MemoryShape : std::uint8_t { buffer, image1d, image2d, image3d, imagecube };

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

struct Memory {
    Name name;
    MemoryShape shape = MemoryShape::buffer;
    TypeId element;  ///< the value type that loads give (float for r8, float4 for rgba8)
    Format format = Format::none;
    ExprId extent;        ///< uint, uint2, uint3, over the structure (root 0)
    ExprId mips;          ///< or absent
    bool linear = false;  ///< filter linear
    Name compare;         ///< or empty
    Span span;
};

struct MemberStructure {
    Name name;
    std::uint32_t structure = 0;  ///< instance
    std::vector<ExprId>
        arguments;  ///< of its constructor, over the owner (root 0); empty where passed by reference (views)
    bool by_reference = false;  ///< the member is a constructor argument that is itself a structure
    Span span;
};

enum class StructureKind : std::uint8_t { stored, view, adaptor };

/// Host state of an adaptor.
struct HostField {
    Name name;
    TypeId type;
    ExprId initial;
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
    std::vector<Alias> aliases;  ///< of all modules, each module's in its order
    Span span;
    std::uint32_t module = 0;          ///< of the declaration
    TypeId domain_type;                ///< uint or vector of uint; adaptors: void
    TypeId element;                    ///< adaptors: void
    std::vector<LocalId> constructor;  ///< scalar constructor parameters; Op::member slot i
    std::vector<Memory> memories;
    std::vector<MemberStructure> members;  ///< Place members index these
    std::vector<Stage> via;        ///< first stage takes the virtual address; the last gives the address in memory 0
    std::uint32_t via_memory = 0;  ///< the memory that `via` addresses
    ExprId otherwise;              ///< value of an unmapped read; absent: zero
    ExprId domain;                 ///< extent of the virtual domain, over the structure (root 0)
    FunctionId at;                 ///< views: (address) -> element; structures[] of the function are [this structure]
    std::vector<FunctionId> functions;     ///< other fns: structures[0] is this structure
    std::vector<HostField> host;           ///< adaptors
    std::vector<std::uint32_t> pipelines;  ///< adaptors: Program::pipelines
    bool copyable = true;                  ///< elements can be read and written from the host (not views)
    std::string doc;
};

enum class Direction : std::uint8_t { in, out, inout };
enum class Pattern : std::uint8_t { value, each, near, any, at, scatter, coherent };

struct KernelParam {
    Name name;
    Span span;
    Pattern pattern = Pattern::value;
    Direction direction = Direction::in;
    std::uint32_t structure = 0;  ///< instance; Place root is the index of this parameter among the kernel's params
    std::uint32_t radius = 0;     ///< near
    Combine combine = Combine::replace;  ///< scatter
    LocalId local;                       ///< value
    std::uint32_t alike =
        0;  ///< the first parameter that is taken to be made alike: in the direct form one state stands for both
};

/// As written and checked. Kernel bodies use Place{root = index in params}.
struct Kernel {
    Name name;
    std::string display;
    Span span;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::vector<KernelParam> params;
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< all 0: the compiler chooses
    std::uint32_t items = 1;                         ///< at<S, items>: consecutive elements that one invocation takes
    TypeId domain_type;                              ///< of the iteration: uint or vector of uint
    std::vector<StmtId> body;
    std::vector<LocalId> shared;  ///< workgroup memory
    std::string doc;
    bool grouped() const { return group[0] != 0; }
};

/// The parameter whose range an `at` parameter takes where it is left out: the first each, else any, of its structure.
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
    Span span;
    std::uint32_t module = 0;
    bool is_pub = false;
    std::optional<std::uint32_t> owner;  ///< an adaptor's pipeline: its structure instance; its members by Place root 0
    std::vector<PipelineParam> params;
    TypeId result;  ///< void, a value, device value, or slice
    std::vector<StmtId> body;
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
    bool is_root = false;                ///< named on the command line: outputs are made for it
    std::vector<std::uint32_t> imports;  ///< Program::modules that it uses, and that these use: sorted
    std::string doc;
};

/// Everything.
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
    };
    std::vector<Transfer> transfers;
};

}  // namespace gliftc::ir
