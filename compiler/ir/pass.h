// A kernel lowered to one form: memory operations on numbered bindings, uniform values as numbered parameters. lower/
// makes it, layout/ fills in offsets, every target prints it.
#pragma once

#include "ir/ir.h"
#include "ir/variants.h"

#include <string>
#include <vector>

namespace gliftc::ir {

/// Which assumptions a lowered kernel may make; see runtime/include/glift/pass.h.
enum class Form : std::uint8_t { direct, general, wide };

inline constexpr std::uint32_t no_kernel = 0xffffffffu;

enum class Access : std::uint8_t { read, write, read_write };

/// One memory that the kernel accesses.
struct PassBinding {
    std::string name;          ///< unique in the pass and readable: f_data, f_table_data
    Place place;               ///< root: kernel parameter
    std::uint32_t memory = 0;  ///< of the structure at `place`
    MemoryShape shape = MemoryShape::buffer;
    TypeId element;  ///< of a buffer: any type; of an image: what a load gives
    Format format = Format::none;
    Access access = Access::read;
    bool sampled = false;  ///< images: a combined image sampler (read only), else a storage image
    bool linear = false;
    std::optional<Compare> compare;  ///< images: a sampler that compares; what else is read has another binding
    bool atomic = false;             ///< some access is atomic
    bool ordered = false;            ///< floats, combined by min or max: kept as the integers that have their bits
    bool coherent =
        false;  ///< workgroups see each other's writes within the pass: accesses are neither moved nor merged
    std::uint32_t one_place = 0;  ///< the first binding that may alias this one in a call: itself if there is none,
                                  ///< and in the direct form, which aliasing calls do not take
    bool in_rows = false;  ///< some load or store is of a vector of row_width scalars, whose index counts vectors
    std::uint32_t address_parameter = no_parameter;  ///< wide form, buffers: the parameter that holds the address
};

/// Whether a load or store of this type accesses a vector of four scalars, whatever the element type is.
inline bool is_row(const Types& types, const PassBinding& binding, TypeId type) {
    return binding.in_rows && types.is_vector(type) && types.components(type) == row_width && type != binding.element;
}

enum class ParameterSource : std::uint8_t {
    uniform,  // `value`: an expression over the kernel's structures and value parameters, evaluated on the host for
              // each call: constants, arithmetic, calls, and member / memory_extent / domain with Place roots = kernel
              // parameters, and locals that are the kernel's value parameters
    origin,   // first virtual address of the range of kernel parameter `param`
    size,     // the iteration size (uint or vector of uint)
    range_size,  // size of the range of kernel parameter `param`
    address,     // uint64: device address of binding `param`
    index,       // of the value on the device that kernel parameter `param` is, in its memory
    base,        // uint3: added to the invocation's id, wide form: the origin of a part of the dispatch
};

struct PassParameter {
    std::string name;  ///< unique in the pass and readable: f_extent, g_origin, size, dt
    TypeId type;       ///< bool is stored as uint
    ParameterSource source = ParameterSource::uniform;
    ExprId value;              ///< uniform
    std::uint32_t param = 0;   ///< origin, range_size, index: kernel parameter; address: binding
    std::uint32_t offset = 0;  ///< bytes, scalar layout; set by layout/
};

struct Pass {
    std::uint32_t kernel = 0;  ///< Program::kernels; no_kernel: a function of a library
    Form form = Form::direct;
    bool exists = true;  ///< false: the form is not available (a structure has no memory, say)
    std::array<std::uint32_t, 3> group = {64, 1, 1};
    std::uint32_t rank = 1;
    bool of_blocks = false;   ///< it visits blocks: `address` is {position in the block, number of the block}
    std::uint32_t items = 1;  ///< consecutive elements that the kernel visits at once; `address` is the first of them
    std::vector<PassBinding> bindings;
    std::vector<PassParameter> parameters;
    std::uint32_t parameter_bytes = 0;  ///< set by layout/
    bool push_constants = false;        ///< set by layout/
    bool uniform_buffer = false;        ///< of the parameters, else a storage buffer; set by layout/

    /// The invocation's address relative to the range (uint or vector of uint). Shaders compute it in `prologue`; host
    /// code makes it a loop nest, x innermost.
    LocalId address;
    std::vector<StmtId> prologue;  ///< shaders only: declares `address` from builtins, and `in_range`
    LocalId in_range;  ///< bool. Kernels without a group return where it is false; grouped ones guard with it
    /// The kernel's bodies, ordered from the fewest assumptions to the most. The first one is valid on every device and
    /// at every address.
    std::vector<Variant> variants = std::vector<Variant>(1);
    std::vector<FunctionId> functions;  ///< called by the bodies, callees first, all low level
    std::vector<LocalId> shared;
    std::vector<std::vector<LocalId>>
        shared_places;               ///< set by layout/: which of them share memory, one after the other
    std::uint32_t shared_bytes = 0;  ///< set by layout/
    std::vector<LocalId> params;     ///< of a library's function
    std::uint64_t loop_rounds = 0;   ///< bound on the iterations of one invocation's loops, their last tests included;
                                     ///< UINT64_MAX: not known at compile time. The same in all forms
    Span longest_loop;
    bool has_reports = false;          ///< some statement is a `report`. The same in all forms
    std::vector<std::uint32_t> files;  ///< that reports name: the kernel's, then others. The same in all forms
    bool exact = true;                 ///< calls no inexact intrinsic: devices agree bit for bit

    Variant& plain() { return variants.front(); }
    const Variant& plain() const { return variants.front(); }

    /// Whether an iteration larger than one dispatch may be is split into parts, whose origin shaders add to their ids.
    bool has_base() const { return form == Form::wide && rank > 1 && splits; }
    bool splits = false;  ///< the body does not depend on the workgroup, so that the dispatch can be split

    /// Whether shaders count the iterations of every loop, for devices that limit them.
    bool counts_rounds() const { return loop_rounds == UINT64_MAX; }
    /// Whether there is a binding for the status record, after the others.
    bool has_status() const { return has_reports || counts_rounds(); }
};

/// A function for the user's own shaders. Its body ends in `evaluate result`, or it returns nothing.
struct LibraryFunction {
    std::string name;
    TypeId result;
    Pass pass;  ///< parameters are the structure's state, nothing computed from it
};

/// The functions of a structure that a module makes public.
struct Library {
    std::uint32_t structure = 0;
    std::uint32_t module = 0;
    std::string name;
    std::vector<LibraryFunction> functions;
};

/// A program with its kernels lowered. passes[k] are the forms of Program::kernels[k].
struct Lowered {
    struct Forms {
        Pass direct, general, wide;
    };
    std::vector<Forms> passes;
    std::vector<Library> libraries;
};

}  // namespace gliftc::ir
