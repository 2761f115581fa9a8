// A kernel as data, as generated code defines it. The header is kept small, since each kernel source includes it.
//
// A kernel has two compiled forms. They compute the same thing and differ in what they may assume:
//   direct    Vulkan devices only. Every range is a whole structure; structures of one type that the kernel visits
//             together, or declares with one type name, have equal state (extents, strides), which is passed once; the
//             host knows all sizes, except for a number of blocks; buffers have descriptors; parameters are push
//             constants where they fit (over blocks never);
//   general   ranges with origins, a state for each structure, sizes that may live on the device; on Vulkan devices
//             buffers are accessed by device address, without descriptors, and iterations may be split into several
//             dispatches; parameters in a uniform buffer at binding 0, or a storage buffer (too large, with halves,
//             with images); parameters of a direct form that are not push constants lie there, too.
//
// Generated code chooses the form. Where the ranges allow the direct form, it asks Commands::can_be_direct(kernel,
// memories, size, sharing) before it packs the parameters. The answer is false where the direct form has no code for
// the device; for a buffer larger than a descriptor can cover; for more buffers than the device has descriptors; for an
// iteration in several axes of more workgroups than one dispatch may have (not over blocks, not of draws); and for
// elements that are reached by two bindings (Sharing::one_place). On Vulkan devices the runtime writes the address of
// each buffer into the general form's parameters, at Binding::address_offset (8-byte aligned). A buffer of 2^32
// elements or more is refused (ErrorCode::too_large) by kernels that compute physical addresses in 32 bits.
#pragma once

#include <glift/host/memory.h>
#include <glift/message_format.h>
#include <glift/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

// Embeds the SPIR-V file at `path`, a literal, as `const std::uint32_t symbol[count]`. The directive's name is split
// because ccache does not cache sources that contain it. Caching sources that use this macro is safe, since the
// symbol's name contains a hash of the file's contents. The symbol is weak and hidden: several sources may define it,
// and other libraries do not see it.
#define GLIFT_SPIRV_FILE(symbol, count, path)                                                                          \
    asm(".pushsection .rodata.glift,\"a\"\n.balign 4\n.weak " #symbol "\n.hidden " #symbol "\n" #symbol ":\n.inc"      \
        "bin \"" path "\"\n.popsection\n");                                                                            \
    extern "C" __attribute__((visibility("hidden"))) const std::uint32_t symbol[count]

namespace glift {

struct Drawing;

/// How a pass touches a memory. Writes that combine with the stored value (`scatter` with an operation, atomics) are
/// read_write.
enum class Access : std::uint8_t { read, write, read_write };

/// Which elements of a parameter's range one invocation accesses. `element`: its own; `window`: those around its own,
/// up to Binding::radius away; `range`: any; `memory`: anything in the memory, even outside the range.
enum class Reach : std::uint8_t { memory, range, window, element };

/// How writes of several invocations to one element combine; two bindings whose writes combine alike, in another way
/// than `none`, may alias. `coherent`: workgroups share the memory within the pass.
enum class Combine : std::uint8_t { none, min, max, add, bit_and, bit_or, bit_xor, coherent };

/// What a pass does to the elements of a memory, if it is always the same and the pass loads none of them: `store`
/// gives them a value, `assign` gives one to every element that it visits; the others combine one with theirs. `other`:
/// anything else.
enum class Update : std::uint8_t { other, store, assign, min, max, add, bit_and, bit_or, bit_xor };

/// The kind of the numbers that an update combines.
enum class Number : std::uint8_t { unsigned_integer, signed_integer, real };

/// How a sampled image is filtered between texels.
enum class Filter : std::uint8_t { nearest, linear };
/// What a sampled image has beyond its edges (clamp_to_border: zeros).
enum class AddressMode : std::uint8_t { clamp_to_edge, repeat, mirrored_repeat, clamp_to_border };

struct Sampler {
    Filter filter = Filter::nearest;
    AddressMode address = AddressMode::clamp_to_edge;
    Compare compare = Compare::none;
};

/// One memory that a kernel accesses. Memory k is descriptor binding k + 1 of set 0 (general form: images only,
/// buffers have no descriptor). Two bindings may alias where the call's Sharing allows it.
struct Binding {
    const char* name;  ///< as in the source, `f.data`
    MemoryKind kind = MemoryKind::buffer;
    Access access = Access::read;
    bool sampled = false;  ///< a combined image sampler over all mips, else a storage image of mip 0; buffers: false
    Sampler sampler = {};
    bool as_bits = false;              ///< a storage image of floats whose bits are accessed as ints
    std::uint32_t address_offset = 0;  ///< general form, buffers: byte offset of the 64-bit address in the parameters
    std::uint32_t element_bytes = 4;   ///< buffers: bytes of an element
    std::uint32_t field_offset = 0;    ///< buffers: where the part of each element that alone is accessed begins,
    std::uint32_t field_bytes = 0;     ///< and its bytes; 0: the whole
    /// Number of the binding's parameter among those that are structures or values on the device.
    std::uint32_t parameter = 0;
    Reach reach = Reach::memory;
    std::uint32_t radius = 0;  ///< of Reach::window
    Combine combine = Combine::none;
    /// The parameters of which the kernel promises (@disjoint) that they access other elements than this binding's
    /// parameter does: bit i stands for the parameter with number i (as in `parameter`), i up to 31.
    std::uint32_t apart_from = 0;
    Update update = Update::other;
    Number number = Number::unsigned_integer;  ///< of `update`

    bool is_apart_from(std::uint32_t other) const { return other < 32 && (apart_from >> other & 1) != 0; }
    /// Whether both access elements of one size, and different fields of them.
    bool has_other_fields(const Binding& other) const {
        if (field_bytes == 0 || other.field_bytes == 0 || element_bytes != other.element_bytes) return false;
        return field_offset + field_bytes <= other.field_offset ||
               other.field_offset + other.field_bytes <= field_offset;
    }
};

/// A location in the source.
struct SourceLine {
    const char* file = "";
    std::uint32_t line = 0;  ///< 0: none
};

/// A kernel's report of an error. The first invocation to change `code` from 0 (atomicCompSwap) fills in the rest. The
/// runtime supplies the record, and throws an Error that names the kernel, the line and, if there is one, the address:
/// on the host device as soon as the pass has run, else when the host next waits (Commands::wait, Download::get,
/// Timestamp::seconds).
struct StatusRecord {
    enum Code : std::uint32_t { fine = 0, loop_limit = 1, out_of_range = 2 };
    std::uint32_t code = fine;
    std::uint32_t line = 0;                   ///< in the file that `file` names
    std::uint32_t rank = 0;                   ///< out_of_range: number of axes of the virtual address
    std::uint32_t binding = 0;                ///< out_of_range: index of the memory's binding; UINT32_MAX: none
    std::uint32_t address[4] = {0, 0, 0, 0};  ///< out_of_range: the virtual address
    std::uint32_t file = 0;                   ///< 0: Kernel::file, k: Kernel::other_files[k - 1]
};

/// The targets of a draw on the host device: each target's texels from the viewport's first pixel on.
struct HostTargets {
    struct Texels {
        std::byte* first = nullptr;
        std::size_t row = 0;  ///< bytes from one row to the next
    };
    std::span<const Texels> colours;
    Texels depth;
    uint2 origin, extent;
};

/// The elements that one call on the host device visits: along each axis from 0 to before the size; along the last of
/// the kernel's `rank` axes from `first` on.
struct HostSize : std::array<std::uint32_t, 4> {
    HostSize() = default;
    constexpr HostSize(const std::array<std::uint32_t, 4>& size) : std::array<std::uint32_t, 4>(size) {}
    constexpr HostSize(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t w)
        : std::array<std::uint32_t, 4>{x, y, z, w} {}

    std::uint32_t rank = 1, first = 0;

    constexpr std::uint32_t first_along(std::uint32_t axis) const { return axis + 1 == rank ? first : 0; }
    /// How many rows (elements along x) are left out: those before `first`.
    constexpr std::size_t rows_before() const {
        std::size_t rows = rank > 1 ? first : 0;
        for (std::uint32_t axis = 1; axis + 1 < rank; ++axis) rows *= (*this)[axis];
        return rows;
    }
};

/// The arguments of one call on the host device.
struct HostCall {
    const void* parameters;                ///< the parameter block of the form that is called, with the values that
                                           ///< come from the device (Call::patches, pass.h) already written into it
    std::span<const HostMemory> memories;  ///< in binding order
    HostSize size;                         ///< elements to iterate over along each axis; unused axes are 1
    StatusRecord* status = nullptr;        ///< kernels that report: never null
    const HostTargets* targets = nullptr;  ///< draws: never null
    MessageHeader* messages = nullptr;     ///< kernels that print: never null
};

/// The order in which a kernel's update adds floats, the same on every device: docs/reference/language.md, Updates. The
/// elements of a sum are those that differ along `axes`.
struct SumOrder {
    std::uint8_t axes;         ///< a bit for each axis of the iteration
    std::uint8_t axis;         ///< one of them, along which a sum is cut into parts; else each element is a part
    std::uint32_t part;        ///< elements of a part
    std::uint32_t most_parts;  ///< sums of more parts than this have no order
};

/// How many sums an update adds, and how many parts each has.
struct SumCount {
    std::uint64_t sums = 1, parts = 1;

    /// Of the memory in which the parts meet: two for each sum and one for each part.
    constexpr std::uint64_t words() const { return sums * (2 + parts); }
};

constexpr SumCount count_of(const SumOrder& order, const std::array<std::uint32_t, 4>& size) {
    SumCount count;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::uint32_t cut = axis == order.axis ? order.part : 1;
        if ((order.axes >> axis & 1) != 0) count.parts *= (std::uint64_t{size[axis]} + cut - 1) / cut;
        else count.sums *= size[axis];
    }
    return count;
}

/// A module of SPIR-V in static memory: 32-bit words, or a char32_t literal, which compilers parse faster.
class Spirv {
public:
    constexpr Spirv() = default;
    constexpr Spirv(const std::uint32_t* words, std::size_t count) : words_(words), count_(count) {}
    constexpr Spirv(std::span<const std::uint32_t> words) : words_(words.data()), count_(words.size()) {}
    template <std::size_t N> constexpr Spirv(const std::uint32_t (&words)[N]) : words_(words), count_(N) {}
    template <std::size_t N> constexpr Spirv(const char32_t (&words)[N]) : words_(words), count_(N - 1) {}

    constexpr bool empty() const { return count_ == 0; }
    constexpr const void* words() const { return words_; }
    constexpr std::size_t count() const { return count_; }

private:
    const void* words_ = nullptr;
    std::size_t count_ = 0;
};

/// One compiled form of a kernel.
struct Form {
    Spirv spirv = {};  ///< empty: this form does not exist on Vulkan devices
    /// Draws: the fragment shader, beside the vertex shader in `spirv`; empty: only depth is drawn.
    Spirv fragment = {};
    void (*host)(const HostCall&) = nullptr;  ///< null: this form does not exist on the host device
    std::uint32_t parameter_bytes = 0;
    bool push_constants = false;  ///< parameters are push constants, else the buffer at binding 0
    bool uniform_buffer = false;  ///< that buffer is a uniform buffer, else a storage buffer
    /// Byte offset, in the parameters, of the iteration size: `rank` uints. Used only where a call has patches
    /// (Call::patches); most direct forms have no such parameter.
    std::uint32_t size_offset = 0;
    /// General, rank 2 to 4: byte offset, in the parameters, of three uints that the shader adds to
    /// gl_GlobalInvocationID. The caller sets them to zero; where the runtime splits the iteration, it sets them to
    /// each part's first invocation. UINT32_MAX: there are none, and the runtime does not split the iteration; one that
    /// is beyond the device's limits after folding (see Kernel) is refused (too_large).
    std::uint32_t base_offset = UINT32_MAX;
};

/// A parameter of a kernel's direct form, by the name it has in the generated GLSL.
struct Parameter {
    const char* name;
    std::uint32_t offset, bytes;
};

/// A kernel is static data of the program or of a library that it loads. The runtime caches pipelines by the kernel's
/// content, not its address, so that a library may be unloaded and another one loaded at its place; a recording on the
/// host device calls the kernel's code, which has to stay loaded as long as the recording. The entry point is `main`.
///
/// How the iteration size maps to workgroups, except in draws:
///   groups.x = ceil(size.x / (group.x * items.x)), groups.y = ceil(size.y / (group.y * items.y)),
///   groups.z = ceil(size.z * size.w / (group.z * items.z)).
/// The shader decides which of its group's elements an invocation takes. No groups along an axis: nothing runs. A
/// one-dimensional iteration of more groups than the device allows along x, or of 2^31 invocations or more, is folded:
/// the runtime dispatches (x, y, 1) groups with x * y >= groups.x, and a group's index is
/// gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; invocations beyond the size do nothing. If of_blocks,
/// groups along y beyond the device's limit are folded into z in the same way, and a group's index along y is
/// gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y. Other iterations in several dimensions may exceed the
/// device's limits, too (65535 groups along y and z on most). If the kernel's source declares no workgroup size, they
/// take the general form, and the runtime splits them into several dispatches through Form::base_offset. They are
/// refused (ErrorCode::too_large) if the source declares a workgroup size, or if the iteration size is patched
/// (Call::patches).
struct Kernel {
    const char* name;
    const char* file;
    std::uint32_t line;
    std::uint32_t rank;                  ///< axes of the iteration, 1 to 4
    std::array<std::uint32_t, 3> group;  ///< workgroup size
    std::uint64_t loop_rounds;  ///< bound on the iterations of one invocation's loops in total, their last tests
                                ///< included; UINT64_MAX if unknown. A bound beyond the device's loop_round_limit is
                                ///< refused (ErrorCode::loop_limit). A shader of a kernel without a bound counts the
                                ///< iterations of each subgroup (in draws of each invocation) and reports when they
                                ///< reach the device's limit, which is specialisation constant 101 (a uint); where that
                                ///< is 0 there is no limit, and nothing is counted
    std::span<const Binding> bindings;
    Form direct, general;
    std::uint32_t address_bits = 32;                 ///< of physical addresses in the general form: 32 or 64
    std::span<const Parameter> parameters = {};      ///< what Commands::specialised can fix
    std::array<std::uint32_t, 3> items = {1, 1, 1};  ///< elements that one invocation takes along each axis
    bool of_blocks = false;                          ///< runs over {elements of a block, blocks}: rank 2
    bool declares_group = false;                     ///< the source declares the workgroup size
    bool reports = false;            ///< has a StatusRecord: a storage buffer (scalar layout) at binding
                                     ///< bindings.size() + 1 in every form
    std::uint32_t shared_bytes = 0;  ///< workgroup memory
    /// Of updates that add floats in one order; a binding is the memory in which their parts meet
    /// (Iteration::partial_sums).
    std::span<const SumOrder> sums = {};
    SourceLine longest_loop = {};                   ///< the loop with the most iterations, for errors
    std::span<const char* const> other_files = {};  ///< files that reports may name, beside `file`
    /// What the kernel may print; if anything, it has the device's buffer of messages (MessageHeader, then words) at
    /// binding bindings.size() + 2 in every form.
    std::span<const MessageFormat> messages = {};
    std::uint32_t address_rank = 0;    ///< axes of the address that a message begins with
    const Drawing* drawing = nullptr;  ///< of a kernel that draws (drawing.h); its rank is 2: corners, instances
    std::uint64_t digest = 0;  ///< hash of all that pipelines and reports depend on, and perhaps of more: kernels of
                               ///< equal digest share both. 0: the runtime computes a hash of these members at each
                               ///< call, which takes microseconds
};

}  // namespace glift
