// An ordered stream of passes (calls of kernels) and copies.
//
// What is put into a stream happens as if one after the other, in that order. The runtime knows what each pass and copy
// reads and writes, so it places the barriers; independent passes get none and may overlap. Only wait(),
// Download::get() and Timestamp::seconds() wait for results. Other calls wait where the host is far ahead of the
// device, where memory that was freed is needed again, and where a buffer needs several allocations (sparse binding).
// Work is submitted when it is waited for; by flush(); before a recording is submitted; by record_into(), finish() and
// the first objects() of vulkan.h; when a download is followed by another kind of command; and whenever much has been
// put into the stream or no memory is left.
#pragma once

#include <glift/device.h>
#include <glift/handle.h>
#include <glift/memory.h>
#include <glift/pass.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glift {

namespace detail {
class Stream;
class DownloadObject;
class TimestampObject;

/// Throws the error for a call that waits for the device or submits, in a recording.
[[noreturn]] GLIFT_API void throw_not_in_recording(const char* call);
}  // namespace detail

/// Bytes [from, from + bytes) of the source go to the target from `to` on.
struct CopyRegion {
    std::uint64_t from = 0, to = 0, bytes = 0;
};

/// A box of texels of an image, and where these texels lie in a buffer or in host bytes: packed, in row-major order,
/// from byte `offset` on. `offset` is a multiple of 4 and of a texel's bytes. `origin` and `extent` count texels of
/// level `mip`. For a cube or an image2darray the box lies in one face or layer, `face`, and its third extent is 1.
struct ImageRegion {
    std::uint64_t offset = 0;
    std::array<std::uint32_t, 3> origin = {0, 0, 0};
    std::array<std::uint32_t, 3> extent = {1, 1, 1};
    std::uint32_t mip = 0;
    std::uint32_t face = 0;  ///< the face of a cube, the layer of an image2darray; other images: 0
};

/// A box of texels that is copied from one image to another image of the same format. `mip` and `face` are as in
/// ImageRegion.
struct ImageCopyRegion {
    std::array<std::uint32_t, 3> from = {0, 0, 0}, to = {0, 0, 0}, extent = {1, 1, 1};
    std::uint32_t from_mip = 0, to_mip = 0, from_face = 0, to_face = 0;
};

/// Bytes that are being copied from the device to the host.
class GLIFT_API Download {
public:
    Download() = default;
    explicit Download(std::shared_ptr<detail::DownloadObject> object) : object_(std::move(object)) {}
    explicit operator bool() const { return bool(object_); }

    bool ready() const;  ///< whether the bytes are there; neither waits nor submits
    /// Waits for all commands before the download in its stream. The bytes are valid while this handle or a copy of it
    /// lives. Throws what kernels reported (StatusRecord).
    std::span<const std::byte> get() const;

private:
    detail::Held<detail::DownloadObject> object_;
};

/// A moment on the device's clock: when everything before it in the stream was done.
class GLIFT_API Timestamp {
public:
    Timestamp() = default;
    explicit Timestamp(std::shared_ptr<detail::TimestampObject> object) : object_(std::move(object)) {}
    explicit operator bool() const { return bool(object_); }

    /// Waits until the moment is reached; the origin of time is arbitrary. Throws what kernels reported (StatusRecord).
    double seconds() const;

private:
    detail::Held<detail::TimestampObject> object_;
};

/// `later - earlier`, in seconds.
inline double operator-(const Timestamp& later, const Timestamp& earlier) {
    return later.seconds() - earlier.seconds();
}

/// A cheap handle to a stream: a device's own, a recording in progress, or the user's VkCommandBuffer (vulkan.h).
/// Generated functions take `const Commands&`, so that they can be called with a Device too. Commands for a recording
/// are accepted until the body of Device::record has returned, those for a command buffer until vulkan::finish; later
/// ones throw. All calls throw wrong_argument for arguments that cannot be used, such as an empty handle, a memory of
/// another device, or a range or box outside its memory.
class GLIFT_API Commands {
public:
    Commands(const Device& device);  ///< the stream of Device::commands
    explicit Commands(std::shared_ptr<detail::Stream> stream) : stream_(std::move(stream)) {}
    explicit operator bool() const { return bool(stream_); }

    Device device() const;

    /// Whether what is put here runs later, perhaps many times: in a recording, or in the user's command buffer.
    bool is_recording() const;

    /// Whether the device can run the kernel's direct form (kernel.h) for these arguments: it has code for the device,
    /// the memories and the iteration are not too large for it, the device has enough descriptors for the buffers, and
    /// no bindings alias (Sharing::one_place), for which shaders need pointers.
    bool can_be_direct(const Kernel& kernel, std::span<const Memory> memories, const std::array<std::uint32_t, 4>& size,
                       Sharing sharing = Sharing::unknown) const;

    /// Puts one call of a kernel into the stream. Throws wrong_argument where the call does not fit the kernel,
    /// aliased_memory for bindings that may race (Sharing), and missing_form, missing_feature, too_large or loop_limit
    /// where the device cannot run the kernel; on the host device also what the kernel reports (StatusRecord).
    void dispatch(const Kernel& kernel, const Call& call) const;

    /// The same stream, whose kernels have the values of these parameters (named as in the generated GLSL, `f_extent`;
    /// an empty list: all parameters) compiled in as constants: what Vulkan calls specialisation. Each set of values
    /// makes a pipeline, which costs milliseconds the first time: use it for values that rarely change. Results are the
    /// same. Calls that do not take the direct form, and the host device, read the parameters as usual.
    Commands specialised(std::vector<std::string> parameters = {}) const;

    /// The same stream, but what it allocates is not zeroed: it holds whatever that storage held before. With
    /// GLIFT_POISON=1, which `gliftc test` sets, buffers begin with a pattern instead, another one on the host device
    /// than on Vulkan devices, so that results which depend on it differ.
    Commands uninitialized() const;

    /// The same stream, whose passes and fills run only if `condition`, a bool on the device, is true (`where_not`:
    /// false) when they are reached, and all conditions of `*this` hold. Else they run over nothing, and buffers that
    /// these commands allocate are not zeroed. Copies, uploads, downloads and timestamps through these commands throw
    /// wrong_argument.
    Commands where(DeviceValue condition) const;
    Commands where_not(DeviceValue condition) const;
    /// The same stream without conditions.
    Commands always() const;

    /// Like Device::allocate. In a recording the memory counts in the recording's workspace and, unless it is to be
    /// left uninitialised, each replay zeroes it where this was called; once its last handle is gone, later allocations
    /// of the recording may reuse its storage (on Vulkan devices not that of images, each of which has its own).
    Memory allocate(const MemoryDescription& description) const;

    /// Returns `memory`, to be used in place of `allocate(description)`. Throws wrong_argument unless it is of this
    /// device and of the kind and format described: a buffer of at least as many bytes, an image of the same extent
    /// with at least as many mips.
    Memory adopt(Memory memory, const MemoryDescription& description) const;

    /// Replaces a container's member by `made`, a structure of the same type with other memories. All copies of the
    /// container share the member. `memories` are the old member's: recordings that use them can no longer be
    /// submitted, and calls that are given them throw. Throws wrong_argument in a recording and in a body of
    /// Device::workspace_bytes.
    template <class S> void replace(S& member, S&& made, std::initializer_list<Memory> memories) const {
        note_replaced(memories);
        member = std::move(made);
    }

    /// Writes `value` to each 4-byte word of a part of a buffer. Offset and bytes are multiples of 4.
    void fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value = 0) const;

    /// Copies between buffers. Source and target may be one memory if no region's source overlaps any region's target;
    /// otherwise the call throws aliased_memory.
    void copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) const;
    void copy(const Memory& from, std::uint64_t from_offset, const Memory& to, std::uint64_t to_offset,
              std::uint64_t bytes) const;

    /// Copies of texels without conversion. copy_images needs two different images of one format.
    void copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) const;
    void copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) const;
    void copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) const;

    /// Copies from host bytes, which are read before the call returns. `from` of a region is an offset in `bytes`.
    void upload(const Memory& to, std::uint64_t offset, std::span<const std::byte> bytes) const;
    void upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) const;
    void upload_image(const Memory& image, std::span<const ImageRegion> regions,
                      std::span<const std::byte> bytes) const;

    /// Copies to host memory of `bytes` bytes. `to` of a region is an offset in it; bytes that no region covers are
    /// unspecified. Throws wrong_argument in a recording.
    Download download(const Memory& from, std::uint64_t offset, std::uint64_t bytes) const;
    Download download(const Memory& from, std::span<const CopyRegion> regions, std::uint64_t bytes) const;
    Download download_image(const Memory& image, std::span<const ImageRegion> regions, std::uint64_t bytes) const;

    /// Throws wrong_argument in a recording, missing_feature where the device's queue has no timestamps.
    Timestamp timestamp() const;

    void flush() const;  ///< submits what was put into the stream; throws wrong_argument in a recording
    void wait() const;   ///< like flush, then waits until all is done; throws what kernels reported (StatusRecord)

    const std::shared_ptr<detail::Stream>& share() const { return stream_.share(); }

private:
    void note_replaced(std::initializer_list<Memory> memories) const;
    /// Throws wrong_argument for an empty handle, and where recording has ended.
    detail::Stream& stream(const char* call) const;
    detail::Stream& stream(const Kernel& kernel) const;
    /// Like `stream`, and throws where these commands have conditions.
    detail::Stream& unconditional_stream(const char* call) const;
    Commands with(Condition condition) const;

    detail::Held<detail::Stream> stream_;
    std::shared_ptr<const std::vector<std::string>> specialised_;  ///< null: none; empty: all parameters
    std::shared_ptr<const std::vector<Condition>> conditions_;     ///< null: none
    bool zeroes_ = true;                                           ///< whether memories that it allocates are zeroed
};

}  // namespace glift
