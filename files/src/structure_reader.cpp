#include "structure_reader.h"

#include "error.h"
#include "field_bytes.h"
#include "images.h"
#include "structure_writer.h"

#include <algorithm>
#include <future>

namespace glift::files {

namespace {

/// How the datasets of a memory are cut; where the file has none of the fields, any way.
template <class Readers>
Tiling tiling_of(const FiledMemory& filed, const Readers& readers, const std::string& file_name) {
    std::optional<Tiling> tiling;
    for (const auto& reader : readers) {
        if (!reader.dataset) continue;
        if (tiling && tiling->chunk() != reader.dataset->tiling().chunk())
            throw_bad(file_name, "the fields of " + filed.path + " are cut in different ways");
        tiling = reader.dataset->tiling();
    }
    return tiling ? *tiling : Tiling::of(filed.shape, 1 << 20);
}

void zero(const Commands& commands, const Memory& buffer) {
    const std::uint64_t bytes = buffer.description().bytes / 4 * 4;
    if (bytes > 0) commands.fill(buffer, 0, bytes);
}

const FiledPart& part_named(const FiledPart& filed, const std::string& name) {
    return *std::ranges::find(filed.parts, name, &FiledPart::name);
}
const FiledMemory& memory_named(const FiledPart& filed, const std::string& name) {
    return *std::ranges::find(filed.memories, name, &FiledMemory::name);
}

/// A part of a box of elements, row by row.
struct Clip {
    Extent size{1, 1, 1, 1};
    bool is_empty = false;
    Clip(const Extent& origin, const Extent& box, const Extent& domain, unsigned rank) {
        for (unsigned i = 0; i < rank; ++i) {
            if (origin[i] >= domain[i]) is_empty = true;
            else size[i] = std::min(box[i], domain[i] - origin[i]);
        }
    }
};

/// Moves the elements of the clip, which begins where the box does, to the front.
void keep(const Clip& clip, const Extent& box, std::uint32_t element_bytes, std::vector<std::byte>& elements) {
    const std::size_t row = std::size_t{clip.size[0]} * element_bytes;
    std::size_t to = 0;
    for (std::uint64_t w = 0; w < clip.size[3]; ++w)
        for (std::uint64_t z = 0; z < clip.size[2]; ++z)
            for (std::uint64_t y = 0; y < clip.size[1]; ++y, to += row) {
                const std::size_t from = (((w * box[2] + z) * box[1] + y) * box[0]) * element_bytes;
                std::memmove(elements.data() + to, elements.data() + from, row);
            }
    elements.resize(to);
}

}  // namespace

void StructureReader::read_all(const FiledPart& filed, const Part& part) {
    for (const Value& value : part.values)
        if (const FiledValue* const other = find_value(filed, value.name)) set_value(value, *other);
    for (const StoredMemory& memory : part.memories) read_memory(memory_named(filed, memory.name), memory);
    for (const Part& inner : part.parts) read_all(part_named(filed, inner.name), inner);
}

void StructureReader::read_memory(const FiledMemory& filed, const StoredMemory& memory) {
    for (const Plane& plane : memory.planes) resize(filed, plane);
    if (!is_read_.emplace(memory.planes[0].memory->object(), true).second) return;
    if (memory.is_image) read_image(filed, *memory.planes[0].memory);
    else read_buffers(filed, memory);
}

void StructureReader::resize(const FiledMemory& filed, const Plane& plane) {
    if (const auto known = replaced_.find(plane.memory->object()); known != replaced_.end()) {
        *plane.memory = known->second.second;
        plane.extent.set(filed.extent);
        return;
    }
    MemoryDescription wanted = plane.memory->description();
    const bool is_image = wanted.kind != MemoryKind::buffer;
    const bool is_same =
        is_image ? filed.texels == wanted.extent && filed.mips == wanted.mips : plane.extent.get() == filed.extent;
    if (is_same) return;
    if (is_image) wanted.extent = filed.texels, wanted.mips = filed.mips;
    else wanted.bytes = (std::max<std::uint64_t>(filed.extent[0], 1) * plane.type.bytes + 3) / 4 * 4;
    const Memory before = *plane.memory;
    const Memory made = commands_.allocate(wanted);
    commands_.replace(*plane.memory, Memory(made), {before});
    plane.extent.set(filed.extent);
    replaced_.emplace(before.object(), std::pair(before, made));
}

StructureReader::FieldReader StructureReader::open_field(const FiledMemory& filed, const Field& field) {
    FieldReader reader{&field, std::nullopt};
    if (const Field* const other = find_field(filed, field, filed.path))
        reader.dataset.emplace(file_, path_of(filed, *other), field, filed.shape,
                               std::vector<bool>(filed.shape.size(), true), file_name_);
    return reader;
}

void StructureReader::read_field(FieldReader& reader, const Batch& batch, std::uint32_t element_bytes,
                                 std::span<std::byte> elements) {
    if (!reader.dataset) return;
    const std::size_t bytes = packed_bytes(*reader.field);
    if (bytes == element_bytes && reader.field->scalar != Scalar::boolean)
        return reader.dataset->read(batch, elements, pieces_, shift_);
    packed_.resize(batch.count * bytes);
    reader.dataset->read(batch, packed_, pieces_, shift_);
    scatter(*reader.field, element_bytes, packed_, elements);
}

bool StructureReader::is_covered(const ElementType& type, std::span<const FieldReader> readers) {
    return type.fields.size() == 1 && readers[0].dataset && packed_bytes(type.fields[0]) == type.bytes;
}

void StructureReader::read_buffers(const FiledMemory& filed, const StoredMemory& memory) {
    std::vector<FieldReader> readers;
    for (const Plane& plane : memory.planes)
        for (const Field& field : plane.type.fields) readers.push_back(open_field(filed, field));
    const Tiling tiling = tiling_of(filed, readers, file_name_);
    if (tiling.elements() != filed.extent[0]) throw_bad(file_name_, "the schema gives " + filed.path + " two sizes");
    // While the device is given a batch, another thread reads and verifies the next one. HDF5 is used by one at a time:
    // this thread holds its lock, and leaves it alone meanwhile.
    std::vector<std::vector<std::byte>> current(memory.planes.size()), next(memory.planes.size());
    const auto begin = [&](std::uint64_t number) {
        return std::async(std::launch::async,
                          [&, batch = tiling.batch(number)] { read_batch(memory, readers, batch, next); });
    };
    const std::uint64_t count = tiling.count();
    std::future<void> reading;
    if (count > 0) reading = begin(0);
    for (std::uint64_t number = 0; number < count; ++number) {
        reading.get();
        current.swap(next);
        if (number + 1 < count) reading = begin(number + 1);
        const Batch batch = tiling.batch(number);
        for (std::size_t i = 0; i < memory.planes.size(); ++i) {
            const Plane& plane = memory.planes[i];
            commands_.upload(*plane.memory, batch.first * plane.type.bytes, current[i]);
            progress_(current[i].size());
        }
    }
}

void StructureReader::read_batch(const StoredMemory& memory, std::vector<FieldReader>& readers, const Batch& batch,
                                 std::vector<std::vector<std::byte>>& planes) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < memory.planes.size(); ++i) {
        const ElementType& type = memory.planes[i].type;
        planes[i].resize(batch.count * type.bytes);
        if (!is_covered(type, std::span(readers).subspan(at))) std::ranges::fill(planes[i], std::byte{0});
        for (std::size_t k = 0; k < type.fields.size(); ++k) read_field(readers[at++], batch, type.bytes, planes[i]);
    }
}

void StructureReader::read_image(const FiledMemory& filed, const Memory& image) {
    const MemoryDescription& made = image.description();
    const Field field = texel_field(made.format);
    std::vector<std::byte> texels;
    for (std::uint32_t mip = 0; mip < made.mips; ++mip) {
        StoredDataset dataset(file_, path_of_level(filed.path, made.mips, mip), field, level_shape(made, mip),
                              shown_axes(made.kind), file_name_);
        const Tiling& tiling = dataset.tiling();
        for (std::uint64_t number = 0; number < tiling.count(); ++number) {
            const Batch batch = tiling.batch(number);
            texels.resize(batch.count * texel_bytes(made.format));
            dataset.read(batch, texels, pieces_, shift_);
            const ImageRegion region = region_of(batch, mip);
            commands_.upload_image(image, std::span(&region, 1), texels);
            progress_(texels.size());
        }
    }
}

void StructureReader::read_by_address(const FiledPart& filed, const Part& part) {
    const FiledMemory& memory = filed.memories[0];
    const Elements& elements = *part.elements;
    std::vector<FieldReader> readers;
    for (const Field& field : elements.type.fields) readers.push_back(open_field(memory, field));
    const Tiling tiling = tiling_of(memory, readers, file_name_);
    for (const Plane& plane : part.memories[0].planes) zero(commands_, *plane.memory);
    const Extent domain = elements.domain();
    std::vector<std::byte> values;
    for (std::uint64_t number = 0; number < tiling.count(); ++number) {
        const Batch batch = tiling.batch(number);
        values.assign(batch.count * elements.type.bytes, std::byte{0});
        for (FieldReader& reader : readers) read_field(reader, batch, elements.type.bytes, values);
        Extent box{1, 1, 1, 1};
        for (unsigned i = 0; i < elements.rank; ++i) box[i] = address_extent(batch.size)[i];
        const Extent origin = address_extent(batch.origin);
        const Clip clip(origin, box, domain, elements.rank);
        if (clip.is_empty) continue;
        keep(clip, box, elements.type.bytes, values);
        elements.write(origin, clip.size, values);
        progress_(values.size());
    }
}

}  // namespace glift::files
