// What generated code hands to the runtime: a kernel as data, and one call of it.
//
// A kernel has up to three compiled forms. They compute the same thing and differ in what they may assume:
//   direct    every range is a whole structure, structures of one type share their state (extents, strides),
//             all sizes are known to the host; parameters are push constants where they fit;
//   general   ranges with origins, a state for each structure, sizes that may live on the device;
//             parameters in a storage buffer at binding 0;
//   wide      like general, for what is too large for it: physical addresses are computed in 64 bits, buffers are
//   reached
//             by 64-bit address (without descriptors), and iterations may be split into several dispatches.
//
// Who chooses. Generated code asks Commands::needs_wide(kernel, memories, size) before it packs the parameters, and
// packs the wide block where the answer is true. On Vulkan devices it is true of a buffer that no descriptor covers and
// of an iteration of more workgroups than one dispatch may have, on every device of a memory of 2^32 elements or more.
// At Binding::address_offset (8-byte aligned) the runtime writes the address of each buffer.
#pragma once

#include <glift/memory.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace glift {

/// How a pass touches a memory. Combined writes (scatter, atomics) are read_write.
enum class Access : std::uint8_t { read, write, read_write };

/// Which elements of a parameter's range one invocation touches: its own; a window around that; any. `memory`: anything
/// of the memory, whatever the range is.
enum class Reach : std::uint8_t { memory, range, window, element };

/// How writes of several invocations to one place combine; two bindings of one kind may be one memory. `coherent`:
/// workgroups share the memory within the pass.
enum class Combine : std::uint8_t { none, min, max, add, bit_and, bit_or, bit_xor, coherent };

/// How a sampled image is filtered between texels and beyond its edge (clamp_to_border: zeros).
enum class Filter : std::uint8_t { nearest, linear };
enum class AddressMode : std::uint8_t { clamp_to_edge, repeat, mirrored_repeat, clamp_to_border };

struct Sampler {
    Filter filter = Filter::nearest;
    AddressMode address = AddressMode::clamp_to_edge;
};

/// One memory that a kernel touches. Memory k is descriptor binding k + 1 of set 0 (wide form: images only, buffers
/// have no descriptor). What Sharing says of a call allows one memory for two bindings.
struct Binding {
    const char* name;  ///< as in the source, `f.data`
    MemoryKind kind;
    Access access;
    bool sampled = false;  ///< a combined image sampler over all mips, else a storage image of mip 0; buffers: false
    Sampler sampler = {};
    std::uint32_t address_offset = 0;  ///< wide form, buffers: byte offset of the 64-bit address in the parameters
    std::uint32_t element_bytes = 4;   ///< buffers
    std::uint32_t parameter = 0;       ///< that the memory comes with, among those that are structures
    Reach reach = Reach::memory;
    std::uint32_t radius = 0;  ///< window
    Combine combine = Combine::none;
};

/// A place in the source.
struct SourceLine {
    const char* file = "";
    std::uint32_t line = 0;  ///< 0: none
};

/// Where a kernel reports what it could not do. The first invocation to change code from 0 (atomicCompSwap) fills in
/// the rest. The runtime supplies the record, and throws an Error that names the kernel, the line and the address when
/// the host next waits for the device (Commands::wait, Download::get).
struct StatusRecord {
    enum Code : std::uint32_t { fine = 0, loop_limit = 1, out_of_range = 2 };
    std::uint32_t code = fine;
    std::uint32_t line = 0;                   ///< of the file that `file` says
    std::uint32_t rank = 0;                   ///< out_of_range: axes of the virtual address
    std::uint32_t binding = 0;                ///< out_of_range: index of the memory's binding
    std::uint32_t address[4] = {0, 0, 0, 0};  ///< out_of_range: the virtual address
    std::uint32_t file = 0;                   ///< 0: Kernel::file, k: Kernel::other_files[k - 1]
};

/// One call as the host device sees it.
struct HostCall {
    const void* parameters;                ///< the parameter block, laid out as the form says, patches applied
    std::span<const HostMemory> memories;  ///< in binding order
    std::array<std::uint32_t, 4> size;     ///< elements to iterate over along each axis; unused axes are 1
    StatusRecord* status = nullptr;        ///< kernels that report: never null
};

/// A module of SPIR-V in static memory: 32-bit words, or as many characters of a literal, which compilers read faster.
class Spirv {
public:
    constexpr Spirv() = default;
    template <std::size_t N> constexpr Spirv(const std::uint32_t (&words)[N]) : words_(words), count_(N) {}
    constexpr Spirv(std::span<const std::uint32_t> words) : words_(words.data()), count_(words.size()) {}
    constexpr Spirv(std::u32string_view words) : words_(words.data()), count_(words.size()) {}
    constexpr bool empty() const { return count_ == 0; }
    std::vector<std::uint32_t> words() const {
        std::vector<std::uint32_t> copy(count_);
        if (count_ != 0) std::memcpy(copy.data(), words_, count_ * sizeof(std::uint32_t));
        return copy;
    }

private:
    const void* words_ = nullptr;
    std::size_t count_ = 0;
};

/// One compiled form of a kernel.
struct Form {
    Spirv spirv = {};                         ///< empty: this form does not exist on Vulkan devices
    void (*host)(const HostCall&) = nullptr;  ///< null: this form does not exist on the host device
    std::uint32_t parameter_bytes = 0;
    bool push_constants = false;             ///< parameters are push constants, else the storage buffer at binding 0
    std::uint32_t size_offset = 0;           ///< byte offset in the parameters of the iteration size (`rank` uints)
    std::uint32_t base_offset = UINT32_MAX;  ///< wide, rank 2 to 4: byte offset in the parameters of three uints,
                                             ///< packed as zeros, that the shader adds to gl_GlobalInvocationID.
                                             ///< UINT32_MAX: none, iterations beyond the device's limits are refused
};

/// A parameter of a kernel's direct form, by the name it has in the generated GLSL.
struct Parameter {
    const char* name;
    std::uint32_t offset, bytes;
};

/// A kernel is static data of the program or of a library that it loads. The runtime keeps pipelines by what the kernel
/// holds, so that a library may be unloaded and another one take its place; a recording on the host device calls the
/// kernel's code, which has to stay loaded as long as the recording. The entry point is `main`.
///
/// How the iteration size maps to workgroups:
///   groups.x = ceil(size.x / (group.x * items.x)), groups.y = ceil(size.y / (group.y * items.y)),
///   groups.z = ceil(size.z * size.w / (group.z * items.z)).
/// Which of its group's elements an invocation takes is the shader's matter. No groups along an axis: nothing runs. A
/// one-dimensional iteration of more groups than the device allows along x is folded: the runtime dispatches (x, y, 1)
/// groups with x * y >= groups.x, of which gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x is the number;
/// invocations beyond the size do nothing. In more dimensions an iteration beyond the device's limits (65535 groups
/// along y and z on most) takes the wide form, split by the runtime into several dispatches through Form::base_offset;
/// indirect ones are refused (ErrorCode::too_large).
struct Kernel {
    const char* name;
    const char* file;
    std::uint32_t line;
    std::uint32_t rank;                  ///< axes of the iteration, 1 to 4
    std::array<std::uint32_t, 3> group;  ///< workgroup size
    std::uint64_t loop_rounds;           ///< bound on the rounds of one invocation's loops, in all, the tests that
                                         ///< end them included; UINT64_MAX if unknown. A bound beyond the device's
                                         ///< loop_round_limit is refused (ErrorCode::loop_limit); an unknown one
                                         ///< runs, and such a kernel counts its rounds where specialisation constant
                                         ///< 101 (a uint) is not 0 but the device's limit, and reports (below)
    std::span<const Binding> bindings;
    Form direct, general, wide;
    std::span<const Parameter> parameters = {};      ///< what Commands::specialised can fix
    std::array<std::uint32_t, 3> items = {1, 1, 1};  ///< elements that one invocation takes along each axis
    bool reports = false;                           ///< has a StatusRecord: a storage buffer (scalar layout) at binding
                                                    ///< bindings.size() + 1 in every form
    std::uint32_t shared_bytes = 0;                 ///< workgroup memory
    SourceLine longest_loop = {};                   ///< of its loops, the one of most rounds
    std::span<const char* const> other_files = {};  ///< that reports may name, beside `file`
    std::uint64_t digest = 0;  ///< of all of the above: kernels with one digest are one kernel. 0: the runtime makes
                               ///< one at each call, which takes microseconds
};

/// A 4-byte value that lives on the device: a count that a kernel wrote.
struct DeviceValue {
    Memory memory;             ///< a buffer
    std::uint64_t offset = 0;  ///< in bytes, a multiple of 4
};

/// Copies min(device value - before, limit) over four bytes of the parameters before the pass runs; 0 where the value
/// is less than `before`. A patch within the iteration size makes the dispatch indirect: the size becomes min(value,
/// Call::size) along that axis, in the parameters too.
struct Patch {
    DeviceValue value;
    std::uint32_t offset;  ///< byte offset in the parameters, a multiple of 4
    std::uint32_t limit = UINT32_MAX;
    std::uint32_t before = 0;
    bool joins = false;  ///< the patch before it has the same offset: the smaller of the two counts
};

/// Four bytes of the direct form's parameters that are constants of the pipeline. Each set of values is a pipeline of
/// its own.
struct FixedWord {
    std::uint32_t offset;  ///< in bytes, a multiple of 4
    std::uint32_t value;   ///< what the call's parameters hold there
    bool operator==(const FixedWord&) const = default;
};

enum class FormName : std::uint8_t { direct, general, wide };

inline const Form& form_of(const Kernel& kernel, FormName name) {
    switch (name) {
    case FormName::direct: return kernel.direct;
    case FormName::general: return kernel.general;
    case FormName::wide: return kernel.wide;
    }
    return kernel.direct;
}

/// What the maker of a call knows of memories that it passes for several bindings, of which one writes.
enum class Sharing : std::uint8_t {
    unknown,    ///< nothing: refused (ErrorCode::aliased_memory), unless all these bindings are read_write
    apart,      ///< no invocation touches what another one writes, and none a place by two names
    one_place,  ///< no invocation touches what another one writes; some touch one place by two names: not the direct
                ///< form
};

/// One call of a kernel. Spans need to live only until Commands::dispatch returns.
struct Call {
    FormName form;
    std::span<const Memory> memories;       ///< in binding order
    std::span<const std::byte> parameters;  ///< the block of the named form, size included
    std::array<std::uint32_t, 4> size;      ///< host-known iteration size; where patches set it, an upper bound
    std::span<const Patch> patches = {};    ///< non-empty: the general or the wide form
    std::span<const FixedWord> fixed = {};  ///< of the direct form; ignored on the host device
    Sharing sharing = Sharing::unknown;
};

}  // namespace glift
