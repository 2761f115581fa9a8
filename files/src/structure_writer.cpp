#include "structure_writer.h"

#include "field_bytes.h"
#include "images.h"

#include <algorithm>
#include <cstring>
#include <deque>

namespace glift::files {

namespace {

constexpr std::uint64_t chunk_bytes = 4 << 20;

FiledValue filed(const Value& value) {
    FiledValue result{value.name, value.is_argument, value.type.fields, {}};
    const auto* bytes = static_cast<const std::byte*>(value.data);
    for (const Field& field : value.type.fields) {
        const std::size_t number = field.scalar == Scalar::boolean ? 4 : file_bytes(field.scalar);
        result.bytes.emplace_back(bytes + field.offset, bytes + field.offset + field.numbers() * number);
    }
    return result;
}

void write_value(hid_t group, const Value& value) {
    const FiledValue values = filed(value);
    for (std::size_t i = 0; i < values.fields.size(); ++i) {
        const Field& field = values.fields[i];
        std::vector<std::byte> packed(packed_bytes(field));
        Field alone = field;
        alone.offset = 0;
        gather(alone, static_cast<std::uint32_t>(values.bytes[i].size()), values.bytes[i], packed);
        write_attribute(group, value.name + (field.name.empty() ? "" : "." + field.name), field.scalar,
                        {field.shape.begin(), field.shape.end()}, packed.data());
    }
}

bool is_written(const Part& part, const std::map<const void*, std::string>& paths) {
    for (const StoredMemory& memory : part.memories)
        if (!paths.contains(memory.planes[0].memory->object())) return false;
    return std::ranges::all_of(part.parts, [&](const Part& inner) { return is_written(inner, paths); });
}

std::vector<std::uint64_t> shape_of(const Extent& domain, unsigned rank) {
    std::vector<std::uint64_t> shape;
    for (unsigned i = rank; i-- > 0;) shape.push_back(domain[i]);
    return shape;
}

/// Downloads of a batch of elements from each buffer of a memory.
std::vector<Download> begin_downloads(const Commands& commands, const StoredMemory& memory, const Batch& batch) {
    std::vector<Download> downloads;
    for (const Plane& plane : memory.planes)
        downloads.push_back(
            commands.download(*plane.memory, batch.first * plane.type.bytes, batch.count * plane.type.bytes));
    return downloads;
}

}  // namespace

std::uint64_t elements_at_a_time(const std::vector<Field>& fields) {
    std::size_t largest = 1, all = 1;
    for (const Field& field : fields) {
        largest = std::max(largest, packed_bytes(field));
        all += packed_bytes(field);
    }
    return std::max<std::uint64_t>(std::min(chunk_bytes / largest, 4 * chunk_bytes / all), 1);
}

std::string path_of(const FiledMemory& memory, const Field& field) {
    return field.name.empty() ? memory.path : memory.path + "/" + field.name;
}

std::string path_of_level(const std::string& path, std::uint32_t mips, std::uint32_t mip) {
    return mips == 1 ? path : path + "/level" + std::to_string(mip);
}

std::vector<bool> shown_axes(MemoryKind kind) {
    const bool has_faces = kind == MemoryKind::imagecube || kind == MemoryKind::image2darray;
    return {has_faces, kind == MemoryKind::image3d, kind != MemoryKind::image1d, true};
}

Extent address_extent(const std::vector<std::uint64_t>& lengths) {
    Extent extent{};
    for (std::size_t i = 0; i < lengths.size(); ++i)
        extent[static_cast<unsigned>(lengths.size() - 1 - i)] = static_cast<std::uint32_t>(lengths[i]);
    return extent;
}

void StructureWriter::write(const Part& root) {
    const std::string path = "/" + root.name;
    const std::string schema = text_of(write_part(root, path, true));
    on_file([&] {
        const Id group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), "H5Gopen2");
        write_attribute(group, "glift.schema", schema);
    });
}

FiledPart StructureWriter::write_part(const Part& part, const std::string& path, bool has_group) {
    FiledPart result{part.name, part.type, name_of(part.role), part.key, {}, {}, {}};
    for (const Value& value : part.values) result.values.push_back(filed(value));
    // A structure that was given has no group if all of its memories were written already.
    has_group = has_group && (part.role != Role::given || !is_written(part, paths_));
    if (has_group)
        on_file([&] {
            const Id group(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "H5Gcreate2");
            write_attribute(group, "glift.type", part.type);
            for (const Value& value : part.values) write_value(group, value);
        });
    for (const StoredMemory& memory : part.memories)
        result.memories.push_back(write_memory(part, memory, path + "/" + memory.name));
    for (const Part& inner : part.parts) result.parts.push_back(write_part(inner, path + "/" + inner.name, has_group));
    return result;
}

FiledMemory StructureWriter::write_memory(const Part& part, const StoredMemory& memory, const std::string& path) {
    FiledMemory result;
    result.name = memory.name;
    result.is_image = memory.is_image;
    result.extent = memory.planes[0].extent.get();
    const MemoryDescription& made = memory.planes[0].memory->description();
    const auto [known, is_new] = paths_.emplace(memory.planes[0].memory->object(), path);
    result.path = known->second;
    if (memory.is_image) {
        result.kind = name_of(made.kind);
        result.format = name_of(made.format);
        result.texels = made.extent;
        result.mips = made.mips;
        if (is_new) write_image(*memory.planes[0].memory, result.path);
        return result;
    }
    const bool is_root = part.role == Role::root && part.elements && part.memories.size() == 1;
    result.shape = {result.extent[0]};
    if (part.elements && part.memories.size() == 1 && (is_root || part.elements->is_row_major)) {
        const Extent domain = part.elements->domain();
        if (is_root || detail::volume_of(domain) == result.extent[0]) {
            result.shape = shape_of(domain, part.elements->rank);
            result.is_by_address = true;
        }
    }
    if (is_root && !part.elements->is_row_major) {
        result.fields = part.elements->type.fields;
        if (is_new) write_elements(*part.elements, result);
    } else {
        for (const Plane& plane : memory.planes)
            result.fields.insert(result.fields.end(), plane.type.fields.begin(), plane.type.fields.end());
        if (is_new) write_buffers(memory, result);
    }
    return result;
}

std::vector<NewDataset> StructureWriter::make_datasets(const FiledMemory& filed, const Tiling& tiling) {
    const std::vector<bool> is_shown(filed.shape.size(), true);
    std::vector<NewDataset> datasets;
    on_file([&] {
        for (const Field& field : filed.fields)
            datasets.emplace_back(file_, path_of(filed, field), field, tiling, is_shown);
    });
    return datasets;
}

void StructureWriter::write_buffers(const StoredMemory& memory, const FiledMemory& filed) {
    const Tiling tiling = Tiling::of(filed.shape, elements_at_a_time(filed.fields));
    std::vector<NewDataset> datasets = make_datasets(filed, tiling);
    const std::uint64_t count = tiling.count();
    std::vector<Download> next;
    std::vector<std::byte> packed;
    for (std::uint64_t number = 0; number < count; ++number) {
        const Batch batch = tiling.batch(number);
        const std::vector<Download> current = number == 0 ? begin_downloads(commands_, memory, batch) : std::move(next);
        std::vector<std::span<const std::byte>> elements;
        for (const Download& download : current) elements.push_back(download.get());
        if (number + 1 < count) next = begin_downloads(commands_, memory, tiling.batch(number + 1));
        std::size_t at = 0;
        for (std::size_t i = 0; i < memory.planes.size(); ++i) {
            const ElementType& type = memory.planes[i].type;
            for (const Field& field : type.fields)
                on_file([&, number_of_dataset = at++] {
                    NewDataset& dataset = datasets[number_of_dataset];
                    if (packed_bytes(field) == type.bytes && field.scalar != Scalar::boolean)
                        return dataset.write(batch, elements[i], *data_);
                    packed.resize(batch.count * packed_bytes(field));
                    gather(field, type.bytes, elements[i], packed);
                    dataset.write(batch, packed, *data_);
                });
            progress_(elements[i].size());
        }
    }
}

void StructureWriter::write_elements(const Elements& elements, const FiledMemory& filed) {
    const Tiling tiling = Tiling::of(filed.shape, elements_at_a_time(filed.fields));
    std::vector<NewDataset> datasets = make_datasets(filed, tiling);
    std::vector<std::byte> values, packed;
    for (std::uint64_t number = 0; number < tiling.count(); ++number) {
        const Batch batch = tiling.batch(number);
        Extent size = address_extent(batch.size);
        elements.read(address_extent(batch.origin), size, values);
        on_file([&] {
            for (std::size_t i = 0; i < filed.fields.size(); ++i) {
                packed.resize(batch.count * packed_bytes(filed.fields[i]));
                gather(filed.fields[i], elements.type.bytes, values, packed);
                datasets[i].write(batch, packed, *data_);
            }
        });
        progress_(values.size());
    }
}

void StructureWriter::write_image(const Memory& image, const std::string& path) {
    const MemoryDescription& made = image.description();
    const Field field = texel_field(made.format);
    const std::uint64_t bytes = texel_bytes(made.format);
    for (std::uint32_t mip = 0; mip < made.mips; ++mip) {
        const Tiling tiling = Tiling::of(level_shape(made, mip), chunk_bytes / bytes, 1);
        std::optional<NewDataset> dataset;
        on_file(
            [&] { dataset.emplace(file_, path_of_level(path, made.mips, mip), field, tiling, shown_axes(made.kind)); });
        for (std::uint64_t number = 0; number < tiling.count(); ++number) {
            const Batch batch = tiling.batch(number);
            const ImageRegion region = region_of(batch, mip);
            const Download download = commands_.download_image(image, std::span(&region, 1), batch.count * bytes);
            const std::span<const std::byte> texels = download.get().first(batch.count * bytes);
            on_file([&] { dataset->write(batch, texels, *data_); });
            progress_(batch.count * bytes);
        }
    }
}

}  // namespace glift::files
