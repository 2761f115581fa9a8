// One call of a kernel, as generated code hands it to the runtime.
#pragma once

#include <glift/drawing.h>
#include <glift/kernel.h>
#include <glift/memory.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace glift {

/// Where a 4-byte value lies on the device, such as a count that a kernel wrote.
struct DeviceValue {
    Memory memory;             ///< a buffer
    std::uint64_t offset = 0;  ///< in bytes, a multiple of 4
};

/// Writes min(device value - before, limit), or 0 where the device value is less than `before`, over four bytes of the
/// parameters before the pass runs. A patch of the iteration size makes the dispatch indirect: the size along that axis
/// becomes the lesser of that number and the one in Call::size, in the parameters too.
struct Patch {
    DeviceValue value;
    std::uint32_t offset;  ///< byte offset in the parameters, a multiple of 4
    std::uint32_t limit = UINT32_MAX;
    std::uint32_t before = 0;
    bool joins = false;  ///< has the offset of the patch before it: the minimum of their values is written
};

/// A bool on the device, four bytes, and what it must be for a pass to run. If the bool differs from that, the pass
/// runs over nothing.
struct Condition {
    DeviceValue value;
    bool wanted = true;
};

/// Four bytes of the direct form's parameters that are constants of the pipeline. Each set of values is a pipeline of
/// its own.
struct FixedWord {
    std::uint32_t offset;  ///< in bytes, a multiple of 4
    std::uint32_t value;   ///< what the call's parameters hold there
    bool operator==(const FixedWord&) const = default;
};

enum class FormName : std::uint8_t { direct, general };

inline const Form& form_of(const Kernel& kernel, FormName name) {
    switch (name) {
    case FormName::direct: return kernel.direct;
    case FormName::general: return kernel.general;
    }
    return kernel.direct;
}

/// What is known of memories that a call binds several times and writes through at least one binding. `apart` and
/// `one_place` say nothing of pairs of bindings whose writes combine alike (Binding::combine), or which the kernel
/// promises to be apart (Binding::apart_from).
enum class Sharing : std::uint8_t {
    unknown,    ///< nothing: refused (ErrorCode::aliased_memory), unless all these bindings are read_write
    apart,      ///< no element that an invocation writes is accessed by another invocation, or by the same one through
                ///< another binding
    one_place,  ///< no element that an invocation writes is accessed by another invocation, but some elements are
                ///< accessed by their own invocation through two bindings: the form must not be direct
};

/// The elements of an iteration that a call visits: those from `first` to before `end` along the kernel's last axis. A
/// Vulkan device visits whole workgroups, and so perhaps elements beside the part.
struct Part {
    std::uint32_t first, end;
};

namespace detail {

/// A range that a call visits element by element, or around its elements, with its type erased.
struct VisitedRange {
    const char* name;  ///< the kernel's parameter: the names of its bindings (Binding::name) begin with it and a point
    const void* range;
    struct RangeShape (*shape)(const void* range);
};

}  // namespace detail

/// One call of a kernel. Spans need to live only until Commands::dispatch returns.
struct Call {
    FormName form;
    std::span<const Memory> memories;       ///< in binding order
    std::span<const std::byte> parameters;  ///< the parameter block of this form, iteration size included
    std::array<std::uint32_t, 4> size;      ///< host-known iteration size; where patches set it, an upper bound
    std::span<const Patch> patches = {};    ///< if any: the form must not be direct, unless of_blocks
    std::span<const FixedWord> fixed = {};  ///< of the direct form; ignored on the host device
    Sharing sharing = Sharing::unknown;
    std::span<const Condition> conditions = {};  ///< all must hold
    const DrawTargets* targets = nullptr;        ///< of a kernel that draws
    /// Not with patches, conditions, blocks or a declared workgroup size.
    std::optional<Part> part = std::nullopt;
    /// The ranges of Iteration::each and Iteration::near, in the order of these calls; empty: not known.
    std::span<const detail::VisitedRange> visited = {};
};

}  // namespace glift
