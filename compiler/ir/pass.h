// A pass: a kernel lowered to one of its forms. Its bodies are memory operations on numbered bindings; uniform values,
// the same for all invocations, are numbered parameters. lower/ makes it, layout/ fills in offsets, every target prints
// it.
#pragma once

#include "ir/ir.h"
#include "ir/variants.h"

#include <string>
#include <vector>

namespace gliftc::ir {

/// The form says what a lowered kernel may assume of a call. direct: every range is a whole structure, and structures
/// of one type that are visited together or declared by one type name have equal sizes; buffers have descriptors. Only
/// shaders have this form. general: ranges may have origins, their sizes may be computed on the device, and dispatches
/// may have any size; shaders access buffers by device address.
enum class Form : std::uint8_t { direct, general };

enum class Access : std::uint8_t { read, write, read_write };

/// One memory that the kernel accesses.
struct PassBinding {
    std::string name;          ///< unique in the pass and readable: f_data, f_table_data
    Place place;               ///< path from a kernel parameter (Place::root) to the structure that has the memory
    std::uint32_t memory = 0;  ///< index among that structure's memories
    MemoryShape shape = MemoryShape::buffer;
    TypeId element;                     ///< type that a load gives
    std::vector<std::uint32_t> fields;  ///< the path of fields to the part of each element that alone is accessed
    Format format = Format::none;
    Access access = Access::read;
    bool sampled = false;  ///< images: a combined image sampler (read only), else a storage image
    bool linear = false;
    std::optional<Compare> compare;  ///< images: what its comparison sampler does; absent: it has none. Plain reads of
                                     ///< such an image go through another binding
    bool atomic = false;             ///< some access is atomic
    bool ordered = false;            ///< floats that are combined by min or max: shaders access their bits as ints
    bool coherent =
        false;  ///< workgroups see each other's writes within the pass: accesses are neither moved nor merged
    std::uint32_t one_place = 0;  ///< index of the first binding that may alias this one; its own index if there is
                                  ///< none, and in the direct form, which calls with aliases do not use
    bool is_workspace =
        false;             ///< no parameter has it: the runtime gives it for the call (lower/transform/ordered_sums.h)
    bool in_rows = false;  ///< some load or store is of a vector of row_width scalars; its index then counts vectors
    std::uint32_t address_parameter = no_parameter;  ///< general form, buffers: the parameter that holds the address
};

/// Whether a load or store of this type accesses a vector of row_width scalars, not an element.
inline bool is_row(const Types& types, const PassBinding& binding, TypeId type) {
    return binding.in_rows && types.is_vector(type) && types.components(type) == row_width && type != binding.element;
}

/// Whether a thread of the host device may combine its updates of the binding before it updates memory
/// (glift/host/updates.h): ints, uints and floats in a buffer whose indices have 32 bits.
inline bool is_combined_by_threads(const Types& types, const PassBinding& binding, bool is_wide) {
    const TypeKind kind = types.kind(binding.element);
    const bool is_number = kind == TypeKind::int_ || kind == TypeKind::uint || kind == TypeKind::float_;
    return is_number && !binding.coherent && binding.shape == MemoryShape::buffer && !is_wide;
}

enum class ParameterSource : std::uint8_t {
    uniform,  // `value`, an expression that the host evaluates for each call: constants, arithmetic, calls, locals that
              // are the kernel's value parameters, and member / memory_extent / host_state / domain of its structure
              // parameters and of structures nested in them
    origin,   // first virtual address of the range of kernel parameter `param`; of a `near`: the address around which
              // the first invocation's window lies
    size,     // extent of the range of Pass::address (uint or vector of uint); kernels over blocks: {elements of a
              // block, number of blocks}; draws: {corners, instances}
    range_size,  // size of the range of kernel parameter `param`
    address,     // uint64: device address of binding `param`
    index,       // uint: the element index, in its buffer, of kernel parameter `param`, a value on the device
    base,        // uint3, general form: origin of a dispatch that is part of a larger one; added to invocation ids
};

struct PassParameter {
    std::string name;  ///< unique in the pass and readable: f_extent, g_origin, size, dt
    TypeId type;       ///< bool is stored as uint
    ParameterSource source = ParameterSource::uniform;
    ExprId value;  ///< for uniform: what the host evaluates; for size in kernels over blocks: the size, or an upper
                   ///< bound of it where only the device knows the number of blocks
    std::uint32_t param = 0;   ///< for origin, range_size, index: a kernel parameter; for address: a binding
    std::uint32_t offset = 0;  ///< byte offset in the parameter block; set by layout/
};

/// How shaders make an update (`scatter` with an operation): each element updates memory, or elements are combined
/// before (lower/transform/privatise.h).
enum class UpdateWay : std::uint8_t { plain, tree, column, run, copies };

/// The order in which an update adds floats, the same on every device (lower/transform/ordered_sums.h). The elements of
/// a sum are those that differ along `axes`.
struct SumOrder {
    std::uint8_t axes = 0;         ///< bit i: the address is the same for all elements along axis i
    std::uint32_t axis = 0;        ///< one of them, along which parts of the sum are cut
    std::uint32_t part = 1;        ///< the number of elements of a part
    std::uint32_t most_parts = 1;  ///< sums of more parts have no order
    bool operator==(const SumOrder&) const = default;
};

struct PassUpdate {
    std::uint32_t binding = 0;
    UpdateWay way = UpdateWay::plain;
    std::uint32_t axis = 0,
                  elements = 1;     ///< of tree, column and run: how many elements an invocation combines, and where
    std::uint32_t copied = 0;       ///< of copies: a buffer of fewer elements has copies
    std::optional<SumOrder> order;  ///< of sums of floats; absent: in any order
    bool is_exact = false;          ///< of ordered sums: different ones are of different elements of memory
};

/// Loads that the invocations of a workgroup share through workgroup memory (lower/transform/stage.h).
struct PassStaged {
    std::uint32_t binding = 0;
    std::uint32_t rounds = 0;   ///< of the kernel's loop, whose elements are loaded together
    std::uint32_t entries = 0;  ///< elements that a workgroup loads for them
};

/// An access whose address exchanges x and `axis`, the same for all tiles of a pass. Shaders make it through a tile in
/// workgroup memory (lower/transform/tile.h); the host device visits the elements tile by tile.
struct PassTile {
    std::uint32_t binding = 0;
    std::uint32_t axis = 1;
    bool is_store = false;
    bool operator==(const PassTile&) const = default;
};

struct Pass {
    KernelId kernel;  ///< empty: a function of a library
    Form form = Form::direct;
    bool is_wide = false;                             ///< physical addresses have 64 bits
    std::array<std::uint32_t, 3> group = {64, 1, 1};  ///< workgroup size
    std::uint32_t rank = 1;                           ///< number of components of `address`
    bool of_blocks = false;  ///< it visits blocks: `address` is {position in the block, number of the block}
    std::uint32_t items =
        1;  ///< at<S, items>: the number of consecutive elements of each invocation; `address` is the first's
    std::vector<PassBinding> bindings;
    std::vector<PassParameter> parameters;
    std::uint32_t parameter_bytes = 0;  ///< set by layout/
    bool push_constants = false;        ///< set by layout/
    bool uniform_buffer = false;  ///< parameters are in a uniform buffer, else in a storage buffer; set by layout/

    /// The invocation's address relative to the range (uint or vector of uint). Shaders compute it in `prologue`; on
    /// the host device it is the variable of a loop nest, x innermost, in kernels without a group. Absent for draws.
    LocalId address;
    /// Declares `address` from builtins, and `in_range`. For shaders; the host device's variants of kernels with a
    /// group have a copy in their bodies (lower/host/split_at_barriers.h).
    std::vector<StmtId> prologue;
    LocalId in_range;  ///< bool: the address is in the range. If not, shaders of kernels without a group return; in
                       ///< kernels with a group, accesses to the current element and its neighbours depend on it
    /// The kernel's bodies. The first one is valid on every device and at every address. Of a draw the first one is the
    /// vertex part; the fragment part, if there is one, is another variant. All other variants are for some devices
    /// only, or are valid under assumptions only.
    std::vector<Variant> variants = std::vector<Variant>(1);
    std::vector<PassUpdate> updates;  ///< if shaders combine any before they reach memory: all, in the body's order
    std::vector<PassStaged> staged;
    std::vector<PassTile> tiles;        ///< the same in all forms
    std::vector<FunctionId> functions;  ///< lowered functions that the bodies call, callees before callers
    std::vector<LocalId> shared;        ///< arrays in workgroup memory
    std::vector<std::vector<LocalId>>
        shared_places;  ///< set by layout/: each list has arrays that use the same memory at different times
    std::uint32_t shared_bytes = 0;  ///< set by layout/
    std::vector<LocalId> params;     ///< of a library's function: its parameters
    std::uint64_t loop_rounds = 0;   ///< upper bound on how often one invocation tests the conditions of its loops;
                                     ///< UINT64_MAX: not known at compile time. The same in all forms
    Span longest_loop;
    bool has_reports = false;          ///< some statement is a `report`. The same in all forms
    std::vector<std::uint32_t> files;  ///< source files that errors reported by shaders (has_status()) name, the
                                       ///< kernel's first. The same in all forms
    std::vector<std::uint32_t>
        messages;       ///< indices in Program::messages of those that it prints. The same in all forms
    bool exact = true;  ///< devices agree bit for bit: no intrinsic that is inexact for its operands, no
                        ///< sum of floats by atomic operations, no sampler that filters or compares, no
                        ///< image of format r8, rg8 or rgba8, no rasterisation. The same in all forms

    /// The update of the binding that adds in order; null: there is none.
    const PassUpdate* ordered_sum(std::uint32_t binding) const;
    /// The orders of all such updates, in the order of `updates`.
    std::vector<SumOrder> sum_orders() const;

    Variant& plain() { return variants.front(); }
    const Variant& plain() const { return variants.front(); }

    /// Whether a range that exceeds the device's largest dispatch is run as several dispatches: shaders then add the
    /// origin of their dispatch (ParameterSource::base) to invocation ids. False for ranges with one axis, whose
    /// workgroups continue in rows along y within one dispatch.
    bool has_base() const { return form == Form::general && rank > 1 && splits; }
    bool splits = false;  ///< several dispatches can run the range: the kernel declares no group, visits no blocks and
                          ///< does not draw

    /// Whether shaders count the iterations of every loop, for devices that limit them (lavapipe).
    bool counts_rounds() const { return loop_rounds == UINT64_MAX; }
    /// Whether there is a binding after the others for the status record, in which shaders report errors: accesses
    /// outside a structure, and loops that reach the device's limit.
    bool has_status() const { return has_reports || counts_rounds(); }
    /// The number, among the pass's own, of the message that a `print` prints.
    std::uint32_t message_of(const Stmt& print) const;
};

/// Calls visit(slot, struct) for each field of a store's path, outermost first. Returns the type of what the store
/// changes: an element, or the member to which the path leads.
template <class Visit>
TypeId for_each_step(const Program& program, const Pass& pass, const Stmt& store, Visit&& visit) {
    TypeId type = pass.bindings[store.slot].element;
    for (std::uint32_t slot : store.path) {
        const StructId of = program.types[type].struct_;
        visit(slot, of);
        type = program.structs[of].fields[slot].type;
    }
    return type;
}

/// A function of a structure, lowered for the user's own shaders. Its body ends with an `evaluate` of the result, or it
/// returns nothing.
struct LibraryFunction {
    std::string name;
    TypeId result;
    Pass pass;  ///< Pass::parameters are the structure's state: constructor arguments, extents of memories, also those
                ///< of its members; Pass::params are the function's parameters
};

/// A structure that a module makes public under `name`, with its functions for users' own shaders: read and, where it
/// has them, write, translate and is_mapped.
struct Library {
    StructureId structure;
    ModuleId module;
    std::string name;
    std::vector<LibraryFunction> functions;
};

/// What lowering makes of a program: passes[k] are the forms of Program::kernels[k]; libraries are the functions for
/// users' own shaders, made only if GLSL is wanted.
struct Lowered {
    struct Forms {
        Pass direct, general;

        std::array<Pass*, 2> all() { return {&direct, &general}; }
        std::array<const Pass*, 2> all() const { return {&direct, &general}; }
    };
    Table<Forms, Kernel> passes;
    std::vector<Library> libraries;
};

}  // namespace gliftc::ir
