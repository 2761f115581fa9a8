#include "host_stream.h"

#include "../check.h"
#include "../image_layout.h"
#include "../report.h"
#include "../text.h"
#include "host_targets.h"
#include "promises.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <optional>

namespace glift::detail {

namespace {

/// Zero bytes may come with a null pointer, which memcpy does not allow.
void copy_bytes(std::byte* to, const std::byte* from, std::uint64_t bytes) {
    if (bytes) std::memcpy(to, from, bytes);
}

class HostDownload final : public DownloadObject {
public:
    explicit HostDownload(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}
    bool ready() override { return true; }
    std::span<const std::byte> get() override { return bytes_; }

private:
    std::vector<std::byte> bytes_;
};

class HostTimestamp final : public TimestampObject {
public:
    double seconds() override { return std::chrono::duration<double>(moment_.time_since_epoch()).count(); }

private:
    std::chrono::steady_clock::time_point moment_ = std::chrono::steady_clock::now();
};

std::byte* texel_address(const Memory& image, std::array<std::uint32_t, 3> at, std::uint32_t mip, std::uint32_t face) {
    const MemoryDescription& d = image.description();
    const auto extent = mip_extent(d, mip);
    const std::uint64_t texel = (std::uint64_t(at[2]) * extent[1] + at[1]) * extent[0] + at[0];
    return host_memory(image).data() + mip_offset(d, mip) + face * face_bytes(d, mip) + texel * texel_bytes(d.format);
}

// Calls row(address in the image, offset in the packed bytes, length in bytes) for each row of each box.
template <class Row> void each_row(const Memory& image, std::span<const ImageRegion> regions, Row row) {
    const std::uint64_t texel = texel_bytes(image.description().format);
    for (const ImageRegion& r : regions) {
        const std::uint64_t length = r.extent[0] * texel;
        std::uint64_t packed = r.offset;
        for (std::uint32_t z = 0; z < r.extent[2]; ++z) {
            for (std::uint32_t y = 0; y < r.extent[1]; ++y, packed += length) {
                row(texel_address(image, {r.origin[0], r.origin[1] + y, r.origin[2] + z}, r.mip, r.face), packed,
                    length);
            }
        }
    }
}

// Returns a copy of the parameters with the patches of the call applied. Those of the iteration size also change
// `size`.
std::vector<std::byte> patched(const Kernel& kernel, const Call& call, HostSize& size) {
    const std::uint32_t first = form_of(kernel, call.form).size_offset;
    std::vector<std::byte> parameters(call.parameters.begin(), call.parameters.end());
    std::uint32_t last = 0;
    for (const Patch& patch : call.patches) {
        std::uint32_t value;
        std::memcpy(&value, host_memory(patch.value.memory).data() + patch.value.offset, 4);
        value = std::min(value - std::min(value, patch.before), patch.limit);
        if (patch.joins) value = std::min(value, last);
        if (patch.offset >= first && patch.offset < first + 4 * kernel.rank) {
            const std::uint32_t axis = (patch.offset - first) / 4;
            value = size[axis] = std::min(value, call.size[axis]);
        }
        std::memcpy(parameters.data() + patch.offset, &value, 4);
        last = value;
    }
    return parameters;
}

bool hold(std::span<const Condition> conditions) {
    return std::all_of(conditions.begin(), conditions.end(), [](const Condition& condition) {
        std::uint32_t value;
        std::memcpy(&value, host_memory(condition.value.memory).data() + condition.value.offset, 4);
        return (value != 0) == condition.wanted;
    });
}

Nanoseconds now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

constexpr std::size_t small_count = 16;

bool tests_promises() {
    static const bool on = environment_flag("GLIFT_POISON");
    return on;
}

}  // namespace

template <class MakeWork, class Body> void HostStream::timed(MakeWork&& work, Body&& body) {
    Profiler& profiler = device_.profiler();
    if (!profiler.is_on()) return body();
    const Nanoseconds begin = now();
    body();
    const Nanoseconds end = now();
    Tag tag = profiler.tag(work());
    if (replayed_ != nullptr) tag.path = replayed_->path;
    profiler.add(tag, replayed_ != nullptr ? replayed_->run : Profiler::run_of_thread(), begin, end);
}

void HostStream::replay(const std::function<void(HostStream&)>& command, const std::vector<PathStep>& path, Run run) {
    const auto held = lock();
    const Replayed replayed{path, run};
    replayed_ = &replayed;
    try {
        command(*this);
    } catch (...) {
        replayed_ = nullptr;
        throw;
    }
    replayed_ = nullptr;
}

bool HostStream::can_be_direct(const Kernel& kernel, std::span<const Memory> memories,
                               const std::array<std::uint32_t, 4>&, Sharing) {
    check_memories(&device_, kernel, memories);
    return kernel.direct.host != nullptr;
}

void HostStream::dispatch(const Kernel& kernel, const Call& call) {
    const auto held = lock();
    check_call(&device_, kernel, call);
    const Form& form = form_of(kernel, call.form);
    if (!form.host) throw_missing_form(kernel, form_text(call.form), "the host device");
    if (!hold(call.conditions)) return;
    std::array<HostMemory, small_count> few;
    std::vector<HostMemory> many;
    HostMemory* views = few.data();
    if (call.memories.size() > small_count) {
        many.resize(call.memories.size());
        views = many.data();
    }
    for (std::size_t k = 0; k < call.memories.size(); ++k) views[k] = host_memory(call.memories[k]).view();
    HostCall host = {call.parameters.data(), {views, call.memories.size()}, call.size, nullptr};
    host.size.rank = kernel.rank;
    if (call.part) {
        host.size.first = call.part->first;
        host.size[kernel.rank - 1] = std::min(host.size[kernel.rank - 1], call.part->end);
    }
    std::vector<std::byte> parameters;
    if (!call.patches.empty()) {
        parameters = patched(kernel, call, host.size);
        host.parameters = parameters.data();
    }
    StatusRecord record;
    host.status = &record;
    std::optional<HostTargetViews> targets;
    if (call.targets) host.targets = &targets.emplace(kernel, *call.targets).targets();
    ++counters_.passes;
    const bool runs = host.size[0] && host.size[1] && host.size[2] && host.size[3];
    const bool is_promised = runs && tests_promises() && !call.targets && relies_on_promise(kernel, call.memories);
    if (is_promised) check_promises(kernel, form, call.memories, host);
    timed([&] { return work_of(kernel, call); },
          [&] {
              if (runs) run(kernel, form, host);
          });
    if (kernel.reports && record.code != StatusRecord::fine) throw_report(Reporter(kernel), record);
}

/// Runs the kernel, and delivers what it prints.
void HostStream::run(const Kernel& kernel, const Form& form, HostCall& call) {
    if (kernel.messages.empty()) return form.host(call);
    if (messages_.empty()) {
        messages_.resize(message_bytes() / sizeof(MessageHeader));
        messages_[0].capacity = static_cast<std::uint32_t>((messages_.size() - 1) * sizeof(MessageHeader) / 4);
    }
    MessageHeader& header = messages_[0];
    call.messages = &header;
    PrintingKernels kernels;
    const std::uint32_t number = kernels.number_of(kernel.digest, kernel);
    reinterpret_cast<std::uint32_t*>(&header + 1)[header.used++] = PrintingKernels::mark_of(number);
    form.host(call);
    device_.messages().deliver(kernels.take(header));
}

void HostStream::fill(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value) {
    const auto held = lock();
    timed([&] { return Work{.name = "fill", .bytes = bytes}; },
          [&] {
              auto* words = reinterpret_cast<std::uint32_t*>(host_memory(memory).data() + offset);
              std::fill(words, words + bytes / 4, value);
          });
}

void HostStream::fill_where(const Memory& memory, std::uint64_t offset, std::uint64_t bytes, std::uint32_t value,
                            std::span<const Condition> conditions) {
    const auto held = lock();
    if (hold(conditions)) fill(memory, offset, bytes, value);
}

void HostStream::clear(const Memory& memory) {
    const auto held = lock();
    timed([&] { return Work{.name = "clear", .bytes = memory.description().bytes}; },
          [&] { std::memset(host_memory(memory).data(), 0, memory.object()->description().bytes); });
}

void HostStream::copy(const Memory& from, const Memory& to, std::span<const CopyRegion> regions) {
    const auto held = lock();
    timed([&] { return work_of("copy", regions); },
          [&] {
              for (const CopyRegion& r : regions) {
                  std::memcpy(host_memory(to).data() + r.to, host_memory(from).data() + r.from, r.bytes);
              }
          });
}

void HostStream::copy_to_image(const Memory& buffer, const Memory& image, std::span<const ImageRegion> regions) {
    const auto held = lock();
    timed([&] { return work_of("copy", image, regions); },
          [&] {
              const std::byte* packed = host_memory(buffer).data();
              each_row(image, regions, [&](std::byte* texels, std::uint64_t offset, std::uint64_t length) {
                  std::memcpy(texels, packed + offset, length);
              });
          });
}

void HostStream::copy_from_image(const Memory& image, const Memory& buffer, std::span<const ImageRegion> regions) {
    const auto held = lock();
    timed([&] { return work_of("copy", image, regions); },
          [&] {
              std::byte* packed = host_memory(buffer).data();
              each_row(image, regions, [&](std::byte* texels, std::uint64_t offset, std::uint64_t length) {
                  std::memcpy(packed + offset, texels, length);
              });
          });
}

void HostStream::copy_images(const Memory& from, const Memory& to, std::span<const ImageCopyRegion> regions) {
    const auto held = lock();
    timed([&] { return work_of("copy", from, regions); },
          [&] {
              const std::uint64_t texel = texel_bytes(from.description().format);
              for (const ImageCopyRegion& r : regions) {
                  for (std::uint32_t z = 0; z < r.extent[2]; ++z) {
                      for (std::uint32_t y = 0; y < r.extent[1]; ++y) {
                          std::memcpy(
                              texel_address(to, {r.to[0], r.to[1] + y, r.to[2] + z}, r.to_mip, r.to_face),
                              texel_address(from, {r.from[0], r.from[1] + y, r.from[2] + z}, r.from_mip, r.from_face),
                              r.extent[0] * texel);
                      }
                  }
              }
          });
}

void HostStream::upload(const Memory& to, std::span<const CopyRegion> regions, std::span<const std::byte> bytes) {
    const auto held = lock();
    timed([&] { return work_of("upload", regions); },
          [&] {
              for (const CopyRegion& r : regions)
                  copy_bytes(host_memory(to).data() + r.to, bytes.data() + r.from, r.bytes);
          });
}

void HostStream::upload_image(const Memory& image, std::span<const ImageRegion> regions,
                              std::span<const std::byte> bytes) {
    const auto held = lock();
    timed([&] { return work_of("upload", image, regions); },
          [&] {
              each_row(image, regions, [&](std::byte* texels, std::uint64_t offset, std::uint64_t length) {
                  std::memcpy(texels, bytes.data() + offset, length);
              });
          });
}

std::shared_ptr<DownloadObject> HostStream::download(const Memory& from, std::span<const CopyRegion> regions,
                                                     std::uint64_t count) {
    device_.messages().throw_failed();
    const auto held = lock();
    std::vector<std::byte> bytes(count);
    timed([&] { return work_of("download", regions); },
          [&] {
              for (const CopyRegion& r : regions)
                  copy_bytes(bytes.data() + r.to, host_memory(from).data() + r.from, r.bytes);
          });
    return std::make_shared<HostDownload>(std::move(bytes));
}

std::shared_ptr<DownloadObject> HostStream::download_image(const Memory& image, std::span<const ImageRegion> regions,
                                                           std::uint64_t count) {
    device_.messages().throw_failed();
    const auto held = lock();
    std::vector<std::byte> bytes(count);
    timed([&] { return work_of("download", image, regions); },
          [&] {
              each_row(image, regions, [&](std::byte* texels, std::uint64_t offset, std::uint64_t length) {
                  std::memcpy(bytes.data() + offset, texels, length);
              });
          });
    return std::make_shared<HostDownload>(std::move(bytes));
}

std::shared_ptr<TimestampObject> HostStream::timestamp() { return std::make_shared<HostTimestamp>(); }

}  // namespace glift::detail
