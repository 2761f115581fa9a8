// long: the nodes of the program, which name each other
// The resolved, instantiated program: every name bound, every type concrete. sema makes it; lower/ adds passes
// (ir/pass.h), which are kernels whose operations on structures ("element", "near", "read", "write") have become
// operations on memory ("load", "store", …) of numbered bindings; layout/ adds byte offsets to the passes; emit/ reads
// the program and the passes.
//
// "Instance": sema makes one Function, Struct, Translator, Structure, Kernel or Pipeline for each set of generic
// arguments that is used; of a kernel also one for each set of its value parameters that calls give values on the
// device (Pattern::argument).
//
// Kernels, pipelines and passes share these nodes. ir/levels.h says which operation belongs to which level.
#pragma once

#include "base/arena.h"
#include "base/name.h"
#include "base/rare_vector.h"
#include "base/small_vector.h"
#include "base/table.h"
#include "ir/intrinsics.h"
#include "ir/invocation.h"
#include "ir/radius.h"
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
struct Translator;
struct Module;
struct Kernel;
struct Pipeline;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using LocalId = Id<Local>;
using FunctionId = Id<Function>;
using TranslatorId = Id<Translator>;
using KernelId = Id<Kernel>;
using PipelineId = Id<Pipeline>;
using ModuleId = Id<Module>;
using Operands = SmallVector<ExprId, 4>;

/// A path to a structure: `root` says where the path starts, `members` are indices in Structure::members, one a step.
/// In kernels and functions root is the index of a parameter (of a function: among its structures). In a structure's
/// own expressions (memory sizes, via arguments, …) root 0 is the structure itself; in a translator's functions root i
/// is the i-th of the translator's structure-typed fields. In pipelines and tests `root` is unused: the path starts at
/// the Expr's or Stmt's `local` (a temp, a structure parameter, a slice), or without a local at the container that owns
/// the pipeline. This holds for every operation that has a place (member, domain, host_read, slice, …), but not for the
/// statement `replace`: its place is a path from that container.
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
    not_equal,  // comparisons take scalars; equal and not_equal also take other types, and give one bool
    bit_and,
    bit_xor,
    bit_or,
    logical_and,
    logical_or,
};

/// An expression: an operation and its operands. operations.def says which fields each operation uses. A program has
/// very many of them, so small members are packed, and lists that are rarely used (RareVector) take only a pointer.
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
    RareVector<Place> places;  ///< of a call: the structures passed to it, in the order of Function::structures

    PipelineId pipeline() const { return {slot}; }  ///< of a pipeline_call
};

// ----------------------------------------------------------------------------------------------------- statements

enum class StmtOp : std::uint8_t {
#define STATEMENT(name, level) name,
#include "ir/statements.def"
};

/// Stmt::slot of a StmtOp::report about a view, which has no memory and hence no binding.
inline constexpr std::uint32_t no_binding = 0xffffffffu;

/// The number of components of a vector by which consecutive scalars are loaded or stored; also the length of the rows
/// of elements that `s.load(a, step)` and `s.store(a, step, x)` access.
inline constexpr std::uint32_t row_width = 4;

/// How a value that `scatter` writes is combined with the element that is there. replace: it replaces the element, and
/// no other invocation may write that one.
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
    bool unrolled = false;       ///< of a for_: printed with an unroll hint in shaders
    bool uninitialized = false;  ///< the memory of a temp, or the local of a let without a value, is not zeroed
    Span span;
    LocalId local;
    ExprId target;
    ExprId value;
    ExprId limit;
    std::uint32_t slot = 0;
    RareVector<StmtId> body;
    RareVector<StmtId> otherwise;
    Operands arguments;
    RareVector<LocalId> locals;  ///< of a release: the temporaries
    Place place;
    RareVector<std::uint32_t>
        path;  ///< of a store to a member of an element: the fields that lead to it, outermost first

    KernelId kernel() const { return {slot}; }  ///< of a dispatch
};

enum class Storage : std::uint8_t { value, shared };

struct Local {
    Name name;  ///< as in the source, or as a pass of lower/ calls it; printers make it unique where needed
    TypeId type;
    Span span;
    bool is_mutable = false;
    Storage storage = Storage::value;
    bool is_temporary = false;  ///< introduced by a pass of lower/ for a value that is used more than once
};

// ------------------------------------------------------------------------------------------------------ functions

/// An effect that a function declares, or that a function or kernel inherits from a function that it calls: it writes
/// to elements of the structure at `place` by scatter, or has coherent access to them.
struct Effect {
    Place place;  ///< its root is an index in Function::structures or in Kernel::params
    Pattern pattern = Pattern::scatter;
    Combine combine = Combine::replace;
    Span span;            ///< where the function declares it; if inherited: the call
    Name by;              ///< the function that declares it; if inherited: the function that is called
    bool is_own = false;  ///< the function itself declares it; false: inherited from a call
};

/// What a `print` or a failing `assert` prints.
struct Message {
    std::string text;  ///< with a placeholder for each scalar, as in glift::MessageFormat (glift/message.h)
    bool is_assertion = false;
    Span span;  ///< the statement
};

struct Function {
    Name name;            ///< the declaration's
    std::string display;  ///< name with generic arguments, for comments and messages: linearize<3>
    std::string key;      ///< display with module-qualified names; an instance has the same key in every run of gliftc
    Span span;
    std::vector<LocalId> params;
    std::vector<StructureId> structures;             ///< instances of the structures that calls pass (Expr::places)
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< workgroup size that a calling kernel must have; all 0: any
    std::vector<LocalId> shared;                     ///< its workgroup memory: one allocation for all calls
    TypeId result;
    std::vector<StmtId> body;  ///< a function with a group returns only by its last statement
    bool is_pub = false;
    /// It or a function that it calls has operations of level structure (levels.h): reads, translations, ids, …
    bool reads_memory = false;
    std::vector<Effect> effects;  ///< those that it declares, and those inherited from functions that it calls
    ModuleId module;
    std::string extern_name;  ///< the C++ function to call instead (host only); else empty
    std::string doc;
    Span prints;             ///< where it, or a function that it calls, first prints or asserts; empty: nowhere
    bool is_silent = false;  ///< messages are compiled out, so that it prints nothing
    bool grouped() const { return group[0] != 0; }
    bool has_messages() const { return prints && !is_silent; }
    /// Whether calls are expanded as statements, not within expressions: a barrier, a write or a message must be
    /// executed exactly once, where the call stands.
    bool is_statements() const { return grouped() || !effects.empty() || has_messages(); }
};

// --------------------------------------------------------------------------------------------------- declarations

struct StructField {
    Name name;
    TypeId type;
    std::string doc;
    Name former;  ///< the name that `@was("…")` gives: of the field in files that were saved before; absent: the same
};
struct Struct {
    Name name;
    std::string display;
    std::string key;  ///< display with module-qualified names; the same in every run of gliftc
    ModuleId module;
    bool is_pub = false;
    std::vector<StructField> fields;
    std::string extern_header;  ///< of a struct imported from C++: the header, as written in the source; else empty
    std::string extern_name;    ///< of an imported struct: its name in C++
    std::vector<std::uint32_t> offsets;  ///< of an imported struct: the fields' byte offsets in C++; else empty
    std::uint32_t size = 0;              ///< of an imported struct: its size in C++; else 0
    std::string doc;
    Span span;
};

struct Enum {
    Name name;
    ModuleId module;
    bool is_pub = false;
    std::vector<Name> enumerators;
    std::vector<std::uint32_t> values;
    std::string doc;
    Span span;
};

/// Whether two virtual addresses may have one physical address.
enum class Mapping : std::uint8_t {
    unknown,
    claimed_one_to_one,  ///< declared by `invert` or @one_to_one; `gliftc test` checks it
    many_to_one,         ///< declared by @many_to_one
};

/// Properties of a translator: inferred from the code, or declared by @attributes. It is an error to declare
/// @many_to_one for a translator with `invert` or @one_to_one, or a complexity other than O(1) where O(1) was inferred.
/// sema does not check whether other declarations are true.
struct Properties {
    bool partial = false;     ///< translate gives an optional
    bool invertible = false;  ///< has invert
    Mapping mapping = Mapping::unknown;
    bool affine = false;            ///< physical address is an affine function of the virtual one
    bool uniform = true;            ///< the code has the same control flow for every address, apart from branches that
                                    ///< only return `none`
    std::string memory_complexity;  ///< of the translator's state: "O(1)", "not known", or as declared ("O(n)", …)
    std::string access_complexity;  ///< the time of one translation: "O(1)", "not known", or as declared
    std::string location = "GPU and CPU";
};

/// One instance of a translator.
struct Translator {
    Name name;
    std::string display;  ///< Fold<4>
    std::string key;
    Span span;
    ModuleId module;
    TypeId virtual_type;                  ///< uint or a vector of uint
    TypeId physical_type;                 ///< uint or a vector of uint; not the optional that translate may give
    std::vector<StructField> scalars;     ///< state that is values: Op::state reads the one at its slot
    std::vector<StructureId> structures;  ///< state that is structures: the instances; Place root i in its functions
    std::vector<Name> structure_names;
    FunctionId translate;  ///< (virtual address) -> physical address, or an optional of it
    FunctionId invert;     ///< (physical address) -> virtual address; absent if not invertible
    FunctionId domain;     ///< () -> extent of the virtual domain
    Properties properties;
    std::string doc;
};

/// One translator of a structure's `via`: `via A then B` has two stages.
struct Stage {
    TranslatorId translator;
    std::vector<ExprId>
        scalars;  ///< initial values of Translator::scalars: expressions over the structure (place root 0)
    std::vector<Place> structures;  ///< the structures passed as Translator::structures (root 0 is the structure)
    /// Made by lower/widen for scalar physical addresses in a memory of the structure's own: the copy of
    /// Translator::translate that computes them in 64 bits, and takes the address as the stage before gives it;
    /// translate itself if nothing in it needs 64 bits.
    FunctionId wide;
};

/// image2darray, imagecube: the third component of an address is the layer or the face; the third component of an
/// extent is the number of layers or faces.
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

/// The comparison of `s.compare(x, reference)`; less: the reference is less than the texel.
enum class Compare : std::uint8_t { less, less_equal, greater, greater_equal };

/// For an image that is a mip level or a layer of another image and has no memory of its own: which level or layer of
/// which image.
struct ImagePart {
    enum class Kind : std::uint8_t { mip, layer } kind = Kind::mip;
    Place of;                ///< the structure that has the image, as seen from the one that declares the part (root 0)
    std::uint32_t slot = 0;  ///< the image's index among that structure's memories
    ExprId number;           ///< the number of the level or layer
};

struct Memory {
    Name name;
    /// Of a buffer for one field alone of elements that are structs (declared with `apart`): the field, as a path from
    /// the element. The structure's memories are then one such buffer for each field that is no struct, in their order.
    std::vector<std::uint32_t> fields;
    Name declared;  ///< as in the source: `name`, or of such buffers what all names begin with; only the first one has
                    ///< it
    MemoryShape shape = MemoryShape::buffer;
    TypeId element;  ///< the value type that loads give (float for r8, float4 for rgba8)
    Format format = Format::none;
    ExprId extent;  ///< uint, uint2 or uint3, over the structure (root 0); lower/transform/widen.h makes it 64 bits
                    ///< wide for buffers, and for images if its arithmetic may exceed 32 bits
    ExprId mips;    ///< of an image: the number of its mip levels; absent: one
    std::optional<ImagePart> part;  ///< the image is this part of another one; none: it is made with the structure
    bool linear = false;            ///< of an image: declared with `filter linear`
    Compare compare = Compare::less_equal;
    Span span;
};

struct MemberStructure {
    Name name;
    StructureId structure;  ///< instance
    std::vector<ExprId>
        arguments;  ///< values for its constructor, as expressions over the owner (root 0); empty if by_reference
    std::vector<Place> structures;  ///< structures for its constructor, as seen from the owner (root 0)
    bool by_reference = false;      ///< the owner's constructor is given this structure, and does not make it
    /// It is a component of the owner, which is what its own constructor is given (ir/component.h). Objects of the
    /// owner do not hold it: it is made where it is asked for.
    bool is_component = false;
    Span span;
};

enum class StructureKind : std::uint8_t {
    stored,       ///< its elements lie in a memory
    computed,     ///< its elements are computed where they are read, by `at` or because its memory is computed
    no_elements,  ///< it has members, functions and pipelines alone
};

/// A public function of a container that C++ programs call as a method.
struct Method {
    FunctionId function;
    /// Of a function that reads memory: the pipeline that evaluates it on the device. Empty: the host evaluates it.
    PipelineId pipeline;
};

/// A variable of a container's host state.
struct HostField {
    Name name;
    Span span;
    TypeId type;
    ExprId initial;
};

/// The parts of a structure's domain that kernels visit, such as resident pages: blocks of one size, which do not
/// overlap.
struct Blocks {
    FunctionId count;  ///< () -> uint; structures[0] of all three is the structure that declares them
    FunctionId first;  ///< (number) -> the block's first address, or an optional: `none` if the block does not exist
    FunctionId size;   ///< () -> the extent of every block
    ExprId extent;     ///< the value of `size` as the host evaluates it, over the structure (root 0)
    ExprId bound;      ///< an upper bound of `count` that the host evaluates, over the structure; absent: none is known
    bool is_known = false;  ///< `bound` equals `count`, so that the host knows the number of blocks
    /// The pipeline that computes `count` on the device; empty: no kernel needs it.
    PipelineId counter;
};

/// What a module calls an instance of a structure: `pub structure Field = Array<4, float>;`.
struct Alias {
    Name name;
    ModuleId module;
    bool is_pub = false;
};

/// One instance of a structure.
struct Structure {
    StructureKind kind = StructureKind::stored;
    Name name;                   ///< the declaration's: Array
    std::string display;         ///< Array<4, float>
    std::string key;             ///< std.array.Array<4, float>
    std::vector<Alias> aliases;  ///< names in all modules, in the order in which sema finds them, by use or declaration
    Span span;
    ModuleId module;                   ///< the one with the declaration
    TypeId domain_type;                ///< uint or vector of uint; containers: void
    TypeId element;                    ///< type of its elements; containers: void
    std::vector<LocalId> constructor;  ///< constructor parameters that are values; Op::member slot i
    /// For each of `constructor` its default, over the arguments before it, or absent.
    std::vector<ExprId> defaults;
    std::vector<Memory> memories;
    TypeId apart;  ///< the struct whose fields lie in memories of their own (Memory::fields); absent: none is kept so
    std::vector<MemberStructure> members;  ///< Place::members are indices here
    std::vector<Stage> via;        ///< the first stage takes the virtual address; the last gives the physical one
    std::uint32_t via_memory = 0;  ///< the index in `memories` of the memory that `via` addresses, if `base` is empty
    /// The structure that is the memory, as a path of members; empty if the memory is one of `memories`. Without `via`
    /// both have the same addresses. See ir/chain.h.
    RareVector<std::uint32_t> base;
    /// Of a component (ir/component.h): the field of the elements of its memory that its elements are.
    std::optional<std::uint32_t> field;
    Name base_name;  ///< the name that the declaration gives to the memory that `base` leads to
    Span base_span;
    ExprId otherwise;                   ///< value of reads at unmapped addresses; absent: see says_otherwise()
    ExprId domain;                      ///< extent of the virtual domain, over the structure (root 0)
    std::optional<Blocks> blocks;       ///< as declared here; see blocks_of() of ir/chain.h
    FunctionId at;                      ///< of a view: (address) -> element; its only structure is this one
    std::vector<HostField> host;        ///< of a container: its host state
    std::vector<PipelineId> pipelines;  ///< of a container
    /// A bit for each axis of physical addresses: set if it is proved that no address of the domain leads outside the
    /// memory along that axis, so that accesses need no test. Computed by lower/analysis/contained.cpp.
    std::uint8_t contained_axes = 0;
    /// Its public functions without effects, structures as parameters or optionals as results, for GLSL libraries.
    std::vector<FunctionId> functions;
    std::vector<Method> methods;  ///< of a container: those of `functions` that C++ calls
    /// It has pipelines or host state, or no elements: its own members may be replaced, so that copies of it hold them
    /// by a handle.
    bool is_container = false;
    bool copyable = true;  ///< its elements are stored, so that the host can copy them; false: view or container
    std::string doc;
};

struct KernelParam {
    Name name;
    Span span;
    Pattern pattern = Pattern::value;
    Direction direction = Direction::in;
    StructureId structure;  ///< instance; Place root is the index of this parameter among the kernel's params
    Radius radius;          ///< of near: that of its window, whose centre is the current address
    Combine combine = Combine::replace;  ///< of scatter
    LocalId local;                       ///< of value and argument: holds the value in the body
    /// The first parameter that the direct form (ir/pass.h) assumes to have the same state (sizes), which is then
    /// passed once for both; the parameter itself if there is none before it. If the two have_one_whole() (ir/chain.h),
    /// that form also assumes that both are of one structure: what translates their addresses is then bound and read
    /// once.
    std::uint32_t alike = 0;
};

/// A kernel before lowering. Its body uses Place{root = index in params}.
struct Kernel {
    Name name;
    std::string display;
    std::string key;
    Span span;
    ModuleId module;
    bool is_pub = false;
    bool is_instance = false;  ///< one of several that C++ programs call by one name
    std::vector<KernelParam> params;
    std::array<std::uint32_t, 3> group = {0, 0, 0};  ///< all 0: the compiler chooses
    std::uint32_t items = 1;                         ///< at<S, items>: consecutive elements that one invocation takes
    TypeId domain_type;                              ///< type of the visited addresses: uint or vector of uint
    std::vector<StmtId> body;
    std::vector<LocalId> shared;  ///< workgroup memory
    std::vector<Effect> effects;  ///< those of the functions that it calls through `calls` parameters
    /// Pairs of parameters declared @disjoint(read, written): no element that is read through the first one is written
    /// through the second one in the same pass.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> disjoint;
    bool fast_math = false;  ///< @fast_math: shaders divide and take roots as the device does, and may fuse arithmetic
    bool has_messages = false;  ///< it, or a function that it calls, prints or asserts, and messages are compiled in
    bool accesses_outside = false;  ///< @accesses_outside: checked builds report no accesses outside structures
    std::optional<Raster> raster;   ///< of a kernel that draws: `body` is then the vertex part
    /// The parameter whose blocks the kernel visits (see Blocks); none: it visits a whole range.
    std::optional<std::uint32_t> space;
    std::vector<std::uint32_t> same_space;  ///< other parameters whose blocks must be those of `space` in every call
    std::string doc;
    bool grouped() const { return group[0] != 0; }
};

/// The parameter whose range an `at` parameter takes if its argument is left out: the first `each` of its structure,
/// else the first `near`, else the first `any`, else the first `scatter`.
std::optional<std::size_t> range_giver(const std::vector<KernelParam>& params, std::size_t at);

enum class HostPattern : std::uint8_t { value, structure, range };

struct PipelineParam {
    Name name;
    Span span;
    HostPattern pattern = HostPattern::value;
    Direction direction = Direction::in;
    StructureId structure;  ///< of structure and range: the instance
    LocalId local;          ///< the value, structure or slice: the body uses it as Op::local
};

struct Pipeline {
    Name name;
    std::string display;
    std::string key;
    Span span;
    ModuleId module;
    bool is_pub = false;
    StructureId owner;  ///< of a container's pipeline: the container
    std::vector<PipelineParam> params;
    TypeId result;  ///< void, a value, device value, structure, or slice
    std::vector<StmtId> body;
    /// The first place that waits for the device, changes host state or gives a member other memory; empty: there is
    /// none, so that the pipeline may be called under a condition that is a value on the device.
    Span host_needed;
    bool changes_owner = false;  ///< of a container's pipeline: it, or one that it calls, changes the container's host
                                 ///< state or gives a member other memory (ir/changes.h)
    bool is_value = false;  ///< made by sema/pipelines/values.cpp: it has one pass, of one invocation, which computes a
                            ///< value on the device
    std::string doc;
};

struct Test {
    std::string title;
    Span span;
    ModuleId module;
    PipelineId pipeline;
};

struct Constant {
    Name name;
    TypeId type;
    ExprId value;
    ModuleId module;
    bool is_pub = false;
    std::string doc;
};

struct Module {
    Name name;  ///< "std.array"
    std::uint32_t file = 0;
    bool is_root = false;           ///< named on the command line: outputs are generated for it
    std::vector<ModuleId> imports;  ///< what it imports, also indirectly; sorted
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
    Table<Module> modules;  ///< imported ones before those that import them
    Table<Struct> structs;
    Table<Enum> enums;
    std::vector<Constant> constants;
    Table<Translator> translators;
    Table<Structure> structures;
    Table<Kernel> kernels;
    Table<Pipeline> pipelines;
    std::vector<Test> tests;
    std::vector<Message> messages;  ///< in the order in which sema finds them; Stmt::slot of a `print` is an index
    /// The kernels that copy a box of a structure's elements to or from a linear buffer, which is a structure of the
    /// instance `box_structure`, or fill the box with a value. write_kernel and fill_kernel are empty if C++ may not
    /// write the structure (is_written_in_boxes() of ir/effects.h).
    struct Transfer {
        StructureId structure;
        KernelId read_kernel, write_kernel, fill_kernel;
        StructureId box_structure;
        /// The kernel that lists the resident elements, and the structures that it fills: virtual addresses, physical
        /// addresses (`places`), values, and the number of entries (`counter`). All are empty in `gliftc test`, and for
        /// structures for which has_resident_part() of ir/chain.h is false: views, and structures without blocks all of
        /// whose translators are total and one-to-one.
        KernelId list_kernel;
        StructureId addresses, places, values, counter;
    };
    std::vector<Transfer> transfers;
};

}  // namespace gliftc::ir
