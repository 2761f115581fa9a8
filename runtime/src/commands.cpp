// The functions of Commands, Recording, Download and Timestamp: they check, then forward.
#include "check.h"
#include "environment.h"
#include "measuring.h"
#include "objects.h"
#include "recording_scope.h"
#include "reload.h"
#include "report.h"
#include "text.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>

namespace glift {

using detail::check_range;

bool Download::ready() const { return object_.in("Download::ready").ready(); }
std::span<const std::byte> Download::get() const {
    detail::DownloadObject& object = object_.in("Download::get");
    detail::poll_reload();
    return object.get();
}
double Timestamp::seconds() const { return object_.in("Timestamp::seconds").seconds(); }

void Recording::submit() const {
    detail::RecordingObject& object = object_.in("Recording::submit");
    detail::require_no_recording(object.device(), "Recording::submit");
    object.submit();
    detail::poll_reload();
}

std::uint64_t Recording::workspace_bytes() const { return object_.in("Recording::workspace_bytes").workspace_bytes(); }

Commands::Commands(const Device& device)
    : stream_(detail::stream_of(detail::shared_device(device, "Device::commands"))) {}

detail::Stream& Commands::stream(const char* call) const {
    detail::Stream& stream = stream_.in(call);
    if (stream.is_closed()) detail::throw_closed(call);
    return stream;
}

detail::Stream& Commands::unconditional_stream(const char* call) const {
    if (conditions_)
        throw Error(ErrorCode::wrong_argument, "a command under a condition of the device", call,
                    "only passes and fills can run over nothing where the condition does not hold",
                    "call it with commands without conditions: Commands::always");
    return stream(call);
}

detail::Stream& Commands::stream(const Kernel& kernel) const {
    detail::Stream& stream = stream_.in("Commands::dispatch");
    if (stream.is_closed()) detail::throw_closed(detail::kernel_text(kernel));
    return stream;
}

Device Commands::device() const { return Device(stream_.in("Commands::device").device()); }
void Commands::note_replaced(std::initializer_list<Memory> memories) const {
    detail::Stream& stream = this->stream("Commands::replace");
    const bool is_measured = dynamic_cast<const detail::MeasuringDevice*>(stream.device().get()) != nullptr;
    if (stream.is_recording() || is_measured) detail::throw_replaced_in_recording();
    for (const Memory& memory : memories)
        if (memory.object()) memory.object()->note_replaced();
}

bool Commands::is_recording() const { return stream_.in("Commands::is_recording").is_recording(); }

bool Commands::can_be_direct(const Kernel& kernel, std::span<const Memory> memories,
                             const std::array<std::uint32_t, 4>& size, Sharing sharing) const {
    return stream(kernel).can_be_direct(kernel, memories, size, sharing);
}

Commands Commands::specialised(std::vector<std::string> parameters) const {
    Commands same = *this;
    same.specialised_ = std::make_shared<const std::vector<std::string>>(std::move(parameters));
    return same;
}

Commands Commands::with(Condition condition) const {
    detail::check_condition(stream("Commands::where").device().get(), condition);
    std::vector<Condition> all = conditions_ ? *conditions_ : std::vector<Condition>();
    all.push_back(std::move(condition));
    Commands same = *this;
    same.conditions_ = std::make_shared<const std::vector<Condition>>(std::move(all));
    return same;
}

Commands Commands::where(DeviceValue condition) const { return with({std::move(condition), true}); }
Commands Commands::where_not(DeviceValue condition) const { return with({std::move(condition), false}); }

Commands Commands::always() const {
    Commands same = *this;
    same.conditions_ = nullptr;
    return same;
}

Commands Commands::uninitialized() const {
    Commands same = *this;
    same.zeroes_ = false;
    return same;
}

namespace {

bool poisons() {
    static const bool on = detail::environment_flag("GLIFT_POISON");
    return on;
}

/// The words of the parameter block that belong to parameters with one of these names or, if there are no names, to any
/// parameter.
std::vector<FixedWord> fixed_words(const Kernel& kernel, const Call& call, const std::vector<std::string>& names) {
    std::vector<FixedWord> words;
    for (const Parameter& parameter : kernel.parameters) {
        if (!names.empty() && std::find(names.begin(), names.end(), parameter.name) == names.end()) continue;
        for (std::uint32_t at = parameter.offset; at + 4 <= parameter.offset + parameter.bytes; at += 4) {
            if (at + 4 > call.parameters.size()) break;
            const auto is_here = [at](const Patch& patch) { return patch.offset == at; };
            if (std::any_of(call.patches.begin(), call.patches.end(), is_here)) continue;  // the device knows its value
            FixedWord word{at, 0};
            std::memcpy(&word.value, call.parameters.data() + at, 4);
            words.push_back(word);
        }
    }
    return words;
}

}  // namespace

void Commands::dispatch(const Kernel& kernel, const Call& call) const {
    detail::Stream& stream = this->stream(kernel);
    const bool is_special = specialised_ && call.form == FormName::direct;
    if (!is_special && !conditions_) return stream.dispatch(kernel, call);
    std::vector<FixedWord> words;
    if (is_special) words = fixed_words(kernel, call, *specialised_);
    Call special = call;
    special.fixed = words;
    if (conditions_) special.conditions = *conditions_;
    stream.dispatch(kernel, special);
}

Memory Commands::allocate(const MemoryDescription& description) const {
    detail::Stream& stream = this->stream("Commands::allocate");
    MemoryDescription whole = detail::whole_description(description);
    whole.zeroed = whole.zeroed && zeroes_;
    // Images are cleared whatever the conditions are: only buffers are filled by a pass, which a condition can skip.
    const bool is_filled_there = conditions_ && whole.zeroed && whole.kind == MemoryKind::buffer;
    if (is_filled_there) whole.zeroed = false;
    const Memory memory = stream.allocate(whole);
    if (whole.zeroed && stream.is_recording()) stream.clear(memory);
    if (is_filled_there) stream.fill_where(memory, 0, (whole.bytes + 3) / 4 * 4, 0, *conditions_);
    if (!zeroes_ && poisons() && whole.kind == MemoryKind::buffer && whole.bytes >= 4)
        stream.fill(memory, 0, whole.bytes / 4 * 4, device().is_host() ? 0x7fa5a5a5u : 0x7fc3c3c3u);
    return memory;
}

Memory Commands::adopt(Memory memory, const MemoryDescription& description) const {
    const std::shared_ptr<detail::DeviceObject> device = stream("Commands::adopt").device();
    detail::check_part(device.get(), memory, detail::whole_description(description));
    return memory;
}

void Commands::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) const {
    detail::Stream& stream = this->stream("Commands::fill");
    check_range(stream.device().get(), memory, offset, bytes, "Commands::fill");
    if (offset % 4 || bytes % 4) {
        throw Error(ErrorCode::wrong_argument, "a fill is not of whole 4-byte words", "Commands::fill",
                    std::to_string(bytes) + " bytes at " + std::to_string(offset),
                    "pass an offset and a number of bytes that are multiples of 4");
    }
    if (bytes && conditions_) stream.fill_where(memory, offset, bytes, value, *conditions_);
    else if (bytes) stream.fill(memory, offset, bytes, value);
}

void Commands::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) const {
    detail::Stream& stream = unconditional_stream("Commands::copy");
    const auto device = stream.device();
    check_range(device.get(), from, 0, 0, "Commands::copy");
    check_range(device.get(), to, 0, 0, "Commands::copy");
    for (const CopyRegion& region : regions) {
        check_range(device.get(), from, region.from, region.bytes, "Commands::copy");
        check_range(device.get(), to, region.to, region.bytes, "Commands::copy");
    }
    if (from == to) {
        for (const CopyRegion& a : regions) {
            for (const CopyRegion& b : regions) {
                if (a.bytes && b.bytes && a.from < b.to + b.bytes && b.to < a.from + a.bytes) {
                    throw Error(ErrorCode::aliased_memory, "a copy's source and target overlap", "Commands::copy",
                                detail::memory_text(from.description()), "copy through another memory");
                }
            }
        }
    }
    if (!regions.empty()) stream.copy(from, to, regions);
}

void Commands::copy(const Memory& from, std::uint64_t from_offset, const Memory& to, std::uint64_t to_offset,
                    std::uint64_t bytes) const {
    const CopyRegion region = {from_offset, to_offset, bytes};
    copy(from, to, std::span(&region, 1));
}

void Commands::copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) const {
    detail::Stream& stream = unconditional_stream("Commands::copy_to_image");
    const auto device = stream.device();
    check_range(device.get(), buffer, 0, 0, "Commands::copy_to_image");
    check_image_regions(device.get(), image, regions, buffer.description().bytes, "Commands::copy_to_image");
    if (!regions.empty()) stream.copy_to_image(buffer, image, regions);
}

void Commands::copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) const {
    detail::Stream& stream = unconditional_stream("Commands::copy_from_image");
    const auto device = stream.device();
    check_range(device.get(), buffer, 0, 0, "Commands::copy_from_image");
    check_image_regions(device.get(), image, regions, buffer.description().bytes, "Commands::copy_from_image");
    if (!regions.empty()) stream.copy_from_image(image, buffer, regions);
}

void Commands::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) const {
    detail::Stream& stream = unconditional_stream("Commands::copy_images");
    detail::check_image_copies(stream.device().get(), from, to, regions);
    if (!regions.empty()) stream.copy_images(from, to, regions);
}

void Commands::upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) const {
    detail::Stream& stream = unconditional_stream("Commands::upload");
    const auto device = stream.device();
    check_range(device.get(), to, 0, 0, "Commands::upload");
    for (const CopyRegion& region : regions) {
        check_range(device.get(), to, region.to, region.bytes, "Commands::upload");
    }
    detail::check_host_regions(regions, bytes.size(), true, "Commands::upload");
    stream.upload(to, regions, bytes);
}

void Commands::upload(const Memory& to, std::uint64_t offset, std::span<const std::byte> bytes) const {
    const CopyRegion region = {0, offset, bytes.size()};
    upload(to, std::span(&region, 1), bytes);
}

void Commands::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                            std::span<const std::byte> bytes) const {
    detail::Stream& stream = unconditional_stream("Commands::upload_image");
    detail::check_image_regions(stream.device().get(), image, regions, bytes.size(), "Commands::upload_image");
    stream.upload_image(image, regions, bytes);
}

Download Commands::download(const Memory& from, std::span<const CopyRegion> regions, std::uint64_t bytes) const {
    detail::Stream& stream = unconditional_stream("Commands::download");
    const auto device = stream.device();
    check_range(device.get(), from, 0, 0, "Commands::download");
    for (const CopyRegion& region : regions) {
        check_range(device.get(), from, region.from, region.bytes, "Commands::download");
    }
    detail::check_host_regions(regions, bytes, false, "Commands::download");
    return Download(stream.download(from, regions, bytes));
}

Download Commands::download(const Memory& from, std::uint64_t offset, std::uint64_t bytes) const {
    const CopyRegion region = {offset, 0, bytes};
    return download(from, std::span(&region, 1), bytes);
}

Download Commands::download_image(const Memory& image, std::span<const ImageRegion> regions,
                                  std::uint64_t bytes) const {
    detail::Stream& stream = unconditional_stream("Commands::download_image");
    detail::check_image_regions(stream.device().get(), image, regions, bytes, "Commands::download_image");
    return Download(stream.download_image(image, regions, bytes));
}

Timestamp Commands::timestamp() const { return Timestamp(unconditional_stream("Commands::timestamp").timestamp()); }
void Commands::flush() const {
    stream("Commands::flush").flush();
    detail::poll_reload();
}
void Commands::wait() const {
    stream("Commands::wait").wait();
    detail::poll_reload();
}

namespace detail {

void Stream::upload_filled(const Memory& to, std::uint64_t bytes, const Fill& fill) {
    std::vector<std::byte> values(bytes);
    fill(values);
    const CopyRegion region = {0, 0, bytes};
    upload(to, {&region, 1}, values);
}

Memory Stream::allocate(const MemoryDescription& description) { return Memory(device()->allocate(description)); }

Commands begin_recording(const Device& device) {
    return Commands(shared_device(device, "Device::record")->begin_recording());
}

Device begin_measuring(const Device& device) {
    return Device(std::make_shared<MeasuringDevice>(shared_device(device, "Device::workspace_bytes")));
}

std::uint64_t measured_bytes(const Device& measuring) {
    return static_cast<const MeasuringDevice&>(*measuring.share()).workspace_bytes();
}

Recording end_recording(const Commands& commands) {
    return Recording(commands.share()->device()->end_recording(*commands.share()));
}

}  // namespace detail

}  // namespace glift
