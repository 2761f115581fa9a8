#include "snapshot.h"

#include <algorithm>
#include <cstring>
#include <set>

namespace snapshot {

using glift::files::Field;
using glift::files::Part;
using glift::files::Plane;
using glift::files::Scalar;

namespace {

std::size_t bytes_of(const Field& field) {
    static constexpr std::size_t sizes[] = {4, 1, 1, 2, 4, 8, 1, 2, 4, 8, 2, 4, 8};
    return field.numbers() * sizes[static_cast<std::size_t>(field.scalar)];
}

/// One region for each level and face, with offsets that are multiples of 16.
std::vector<glift::ImageRegion> regions_of(const glift::MemoryDescription& image, std::uint64_t& bytes) {
    std::vector<glift::ImageRegion> regions;
    const bool has_layers = image.kind == glift::MemoryKind::image2darray;
    const std::uint32_t faces = image.kind == glift::MemoryKind::imagecube ? 6 : has_layers ? image.extent[2] : 1;
    bytes = 0;
    for (std::uint32_t mip = 0; mip < image.mips; ++mip)
        for (std::uint32_t face = 0; face < faces; ++face) {
            glift::ImageRegion region{.offset = bytes, .mip = mip, .face = face};
            for (unsigned i = 0; i < 3; ++i) region.extent[i] = std::max(image.extent[i] >> mip, 1u);
            if (faces > 1 || has_layers) region.extent[2] = 1;
            const std::uint64_t texels = std::uint64_t{region.extent[0]} * region.extent[1] * region.extent[2];
            bytes += (texels * glift::texel_bytes(image.format) + 15) / 16 * 16;
            regions.push_back(region);
        }
    return regions;
}

void add_buffer(const Plane& plane, const glift::Commands& commands, const std::string& path, Snapshot& to) {
    const std::uint64_t count = plane.type.bytes ? *static_cast<const std::uint64_t*>(plane.extent.data) : 0;
    const glift::Download download = commands.download(*plane.memory, 0, count * plane.type.bytes);
    const std::span<const std::byte> all = download.get();
    for (const Field& field : plane.type.fields) {
        std::vector<std::byte>& bytes = to[path + "." + field.name];
        if (bytes_of(field) == plane.type.bytes) {
            bytes.assign(all.begin(), all.end());
            continue;
        }
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto element = all.subspan(i * plane.type.bytes + field.offset, bytes_of(field));
            bytes.insert(bytes.end(), element.begin(), element.end());
        }
    }
}

void add_image(const glift::Memory& image, const glift::Commands& commands, const std::string& path, Snapshot& to) {
    std::uint64_t bytes = 0;
    const auto regions = regions_of(image.description(), bytes);
    const glift::Download download = commands.download_image(image, regions, bytes);
    const std::span<const std::byte> all = download.get();
    std::vector<std::byte>& texels = to[path];
    for (const glift::ImageRegion& region : regions) {
        const std::uint64_t count = std::uint64_t{region.extent[0]} * region.extent[1] * region.extent[2];
        const auto part = all.subspan(region.offset, count * glift::texel_bytes(image.description().format));
        texels.insert(texels.end(), part.begin(), part.end());
    }
}

void add(const Part& part, const glift::Commands& commands, const std::string& path, Snapshot& to) {
    for (const auto& value : part.values)
        for (const Field& field : value.type.fields) {
            const auto* data = static_cast<const std::byte*>(value.data) + field.offset;
            to[path + value.name + "." + field.name].assign(data, data + bytes_of(field));
        }
    for (const auto& memory : part.memories)
        for (const Plane& plane : memory.planes) {
            if (memory.is_image) add_image(*plane.memory, commands, path + memory.name, to);
            else add_buffer(plane, commands, path + memory.name, to);
        }
    for (const Part& inner : part.parts) add(inner, commands, path + inner.name + "/", to);
}

class Filler {
public:
    Filler(const glift::Commands& commands, std::uint32_t seed) : commands_(commands), random_(seed) {}

    void fill(const Part& part) {
        for (const auto& memory : part.memories)
            for (const Plane& plane : memory.planes)
                if (seen_.insert(plane.memory->object()).second) {
                    if (memory.is_image) fill_image(*plane.memory);
                    else fill_buffer(plane);
                }
        for (const Part& inner : part.parts) fill(inner);
    }

private:
    std::vector<std::byte> noise(std::uint64_t bytes) {
        std::vector<std::byte> all(bytes);
        for (std::byte& byte : all) byte = static_cast<std::byte>(random_());
        return all;
    }
    void fill_buffer(const Plane& plane) {
        const std::uint64_t count = *static_cast<const std::uint64_t*>(plane.extent.data);
        std::vector<std::byte> all = noise(count * plane.type.bytes);
        for (const Field& field : plane.type.fields) {
            if (field.scalar != Scalar::boolean) continue;
            for (std::uint64_t i = 0; i < count * field.numbers(); ++i) {
                const std::uint64_t at =
                    i / field.numbers() * plane.type.bytes + field.offset + i % field.numbers() * 4;
                const std::uint32_t bit = std::to_integer<std::uint32_t>(all[at]) & 1u;
                std::memcpy(all.data() + at, &bit, 4);
            }
        }
        if (!all.empty()) commands_.upload(*plane.memory, 0, all);
    }
    void fill_image(const glift::Memory& image) {
        std::uint64_t bytes = 0;
        const auto regions = regions_of(image.description(), bytes);
        std::vector<std::byte> all = noise(bytes);
        if (image.description().format == glift::Format::d32)
            for (std::uint64_t i = 0; i + 4 <= bytes; i += 4) {
                const float depth = static_cast<float>(random_() % 1000) / 1000.0f;
                std::memcpy(all.data() + i, &depth, 4);
            }
        commands_.upload_image(image, regions, all);
    }

    const glift::Commands& commands_;
    std::mt19937 random_;
    std::set<const void*> seen_;
};

}  // namespace

Snapshot of(const Part& part, const glift::Device& device) {
    Snapshot made;
    add(part, glift::Commands(device), "", made);
    return made;
}

void fill_at_random(const Part& part, const glift::Device& device, std::uint32_t seed) {
    const glift::Commands commands(device);
    Filler(commands, seed).fill(part);
}

std::string difference(const Snapshot& a, const Snapshot& b) {
    for (const auto& [path, bytes] : a) {
        const auto other = b.find(path);
        if (other == b.end()) return path + " is only in the first";
        if (other->second == bytes) continue;
        if (other->second.size() != bytes.size())
            return path + " has " + std::to_string(bytes.size()) + " and " + std::to_string(other->second.size()) +
                   " bytes";
        const auto at = std::ranges::mismatch(bytes, other->second).in1 - bytes.begin();
        return path + " differs from byte " + std::to_string(at) + " on";
    }
    for (const auto& [path, bytes] : b)
        if (!a.contains(path)) return path + " is only in the second";
    return "";
}

}  // namespace snapshot
