// The public handles: check, then forward.
#include "check.h"
#include "measuring.h"
#include "objects.h"
#include "text.h"

#include <glift/error.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace glift {

using detail::check_range;

bool Download::ready() const { return object_->ready(); }
std::span<const std::byte> Download::get() const { return object_->get(); }
double Timestamp::seconds() const { return object_->seconds(); }
void Recording::submit() const { object_->submit(); }
std::uint64_t Recording::workspace_bytes() const { return object_->workspace_bytes(); }

Commands::Commands(const Device& device) : stream_(device.share(), &device.share()->stream()) {}

Device Commands::device() const { return Device(stream_->device()); }
bool Commands::needs_general(const Kernel& kernel, std::span<const Memory> memories,
                             const std::array<std::uint32_t, 4>& size) const {
    return stream_->needs_general(kernel, memories, size);
}

Commands Commands::specialised(std::vector<std::string> parameters) const {
    Commands same = *this;
    same.specialised_ = std::make_shared<const std::vector<std::string>>(std::move(parameters));
    return same;
}

Commands Commands::uninitialized() const {
    Commands same = *this;
    same.zeroes_ = false;
    return same;
}

namespace {

bool poisons() {
    static const char* const text = std::getenv("GLIFT_POISON");
    return text && *text && std::string_view(text) != "0";
}

/// The words of the call's parameters that the names ask for.
std::vector<FixedWord> fixed_words(const Kernel& kernel, const Call& call, const std::vector<std::string>& names) {
    std::vector<FixedWord> words;
    for (const Parameter& parameter : kernel.parameters) {
        if (!names.empty() && std::find(names.begin(), names.end(), parameter.name) == names.end()) continue;
        for (std::uint32_t at = parameter.offset; at + 4 <= parameter.offset + parameter.bytes; at += 4) {
            if (at + 4 > call.parameters.size()) break;
            FixedWord word{at, 0};
            std::memcpy(&word.value, call.parameters.data() + at, 4);
            words.push_back(word);
        }
    }
    return words;
}

}  // namespace

void Commands::dispatch(const Kernel& kernel, const Call& call) const {
    if (!specialised_ || call.form != FormName::direct) return stream_->dispatch(kernel, call);
    const std::vector<FixedWord> words = fixed_words(kernel, call, *specialised_);
    Call special = call;
    special.fixed = words;
    stream_->dispatch(kernel, special);
}

Memory Commands::allocate(const MemoryDescription& description) const {
    MemoryDescription whole = detail::whole_description(description);
    whole.zeroed = whole.zeroed && zeroes_;
    const Memory memory = stream_->allocate(whole);
    if (whole.zeroed && stream_->is_recording()) stream_->clear(memory);
    if (!zeroes_ && poisons() && whole.kind == MemoryKind::buffer && whole.bytes >= 4)
        stream_->fill(memory, 0, whole.bytes / 4 * 4, device().is_host() ? 0x7fa5a5a5u : 0x7fc3c3c3u);
    return memory;
}

void Commands::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) const {
    check_range(stream_->device().get(), memory, offset, bytes, "Commands::fill");
    if (offset % 4 || bytes % 4) {
        throw Error(ErrorCode::wrong_argument, "a fill is not of whole 4-byte words", "Commands::fill");
    }
    if (bytes) stream_->fill(memory, offset, bytes, value);
}

void Commands::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) const {
    const auto device = stream_->device();
    for (const CopyRegion& region : regions) {
        check_range(device.get(), from, region.from, region.bytes, "Commands::copy");
        check_range(device.get(), to, region.to, region.bytes, "Commands::copy");
    }
    if (from == to) {
        for (const CopyRegion& a : regions) {
            for (const CopyRegion& b : regions) {
                if (a.from < b.to + b.bytes && b.to < a.from + a.bytes) {
                    throw Error(ErrorCode::aliased_memory, "a copy's source and target overlap", "Commands::copy",
                                detail::memory_text(from.description()), "copy through another memory");
                }
            }
        }
    }
    if (!regions.empty()) stream_->copy(from, to, regions);
}

void Commands::copy(const Memory& from, std::uint64_t from_offset, const Memory& to, std::uint64_t to_offset,
                    std::uint64_t bytes) const {
    const CopyRegion region = {from_offset, to_offset, bytes};
    copy(from, to, std::span(&region, 1));
}

void Commands::copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) const {
    const auto device = stream_->device();
    check_range(device.get(), buffer, 0, 0, "Commands::copy_to_image");
    check_image_regions(device.get(), image, regions, buffer.description().bytes, "Commands::copy_to_image");
    if (!regions.empty()) stream_->copy_to_image(buffer, image, regions);
}

void Commands::copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) const {
    const auto device = stream_->device();
    check_range(device.get(), buffer, 0, 0, "Commands::copy_from_image");
    check_image_regions(device.get(), image, regions, buffer.description().bytes, "Commands::copy_from_image");
    if (!regions.empty()) stream_->copy_from_image(image, buffer, regions);
}

void Commands::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) const {
    detail::check_image_copies(stream_->device().get(), from, to, regions);
    if (!regions.empty()) stream_->copy_images(from, to, regions);
}

void Commands::upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) const {
    const auto device = stream_->device();
    for (const CopyRegion& region : regions) {
        check_range(device.get(), to, region.to, region.bytes, "Commands::upload");
    }
    detail::check_host_regions(regions, bytes.size(), true, "Commands::upload");
    stream_->upload(to, regions, bytes);
}

void Commands::upload(const Memory& to, std::uint64_t offset, std::span<const std::byte> bytes) const {
    const CopyRegion region = {0, offset, bytes.size()};
    upload(to, std::span(&region, 1), bytes);
}

void Commands::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                            std::span<const std::byte> bytes) const {
    detail::check_image_regions(stream_->device().get(), image, regions, bytes.size(), "Commands::upload_image");
    stream_->upload_image(image, regions, bytes);
}

Download Commands::download(const Memory& from, std::span<const CopyRegion> regions, std::uint64_t bytes) const {
    const auto device = stream_->device();
    for (const CopyRegion& region : regions) {
        check_range(device.get(), from, region.from, region.bytes, "Commands::download");
    }
    detail::check_host_regions(regions, bytes, false, "Commands::download");
    return Download(stream_->download(from, regions, bytes));
}

Download Commands::download(const Memory& from, std::uint64_t offset, std::uint64_t bytes) const {
    const CopyRegion region = {offset, 0, bytes};
    return download(from, std::span(&region, 1), bytes);
}

Download Commands::download_image(const Memory& image, std::span<const ImageRegion> regions,
                                  std::uint64_t bytes) const {
    detail::check_image_regions(stream_->device().get(), image, regions, bytes, "Commands::download_image");
    return Download(stream_->download_image(image, regions, bytes));
}

Timestamp Commands::timestamp() const { return Timestamp(stream_->timestamp()); }
void Commands::flush() const { stream_->flush(); }
void Commands::wait() const { stream_->wait(); }

namespace detail {

Memory Stream::allocate(const MemoryDescription& description) { return Memory(device()->allocate(description)); }

Commands begin_recording(const Device& device) { return Commands(device.share()->begin_recording()); }

Device begin_measuring(const Device& device) { return Device(std::make_shared<MeasuringDevice>(device.share())); }

std::uint64_t measured_bytes(const Device& measuring) {
    return static_cast<const MeasuringDevice&>(*measuring.share()).workspace_bytes();
}

Recording end_recording(const Commands& commands) {
    return Recording(commands.share()->device()->end_recording(*commands.share()));
}

}  // namespace detail

}  // namespace glift
