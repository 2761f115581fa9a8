#include "content.h"

#include "field_bytes.h"
#include "images.h"
#include "structure_writer.h"

#include <glift/error.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace gliftinfo {

using namespace glift::files;

namespace {

glift::MemoryKind kind_named(const std::string& name) {
    for (const auto kind : {glift::MemoryKind::image1d, glift::MemoryKind::image2d, glift::MemoryKind::image3d,
                            glift::MemoryKind::imagecube, glift::MemoryKind::image2darray})
        if (name == name_of(kind)) return kind;
    return glift::MemoryKind::buffer;
}

glift::Format format_named(const std::string& name) {
    for (int i = 0; i <= static_cast<int>(glift::Format::d32); ++i)
        if (name == name_of(static_cast<glift::Format>(i))) return static_cast<glift::Format>(i);
    return glift::Format::none;
}

std::string without_slash(const std::string& path) {
    return path.substr(path.find_first_not_of('/') == std::string::npos ? 0 : path.find_first_not_of('/'));
}

void add_image(const FiledMemory& memory, std::vector<Content>& to) {
    glift::MemoryDescription image;
    image.kind = kind_named(memory.kind);
    image.format = format_named(memory.format);
    image.extent = memory.texels;
    for (std::uint32_t mip = 0; mip < memory.mips; ++mip)
        to.push_back({without_slash(path_of_level(memory.path, memory.mips, mip)), texel_field(image.format),
                      level_shape(image, mip), shown_axes(image.kind), false});
}

void add(const FiledPart& part, std::vector<Content>& to) {
    for (const FiledMemory& memory : part.memories) {
        if (memory.is_image) add_image(memory, to);
        else
            for (const Field& field : memory.fields)
                to.push_back({without_slash(path_of(memory, field)), field, memory.shape,
                              std::vector<bool>(memory.shape.size(), true), memory.is_by_address});
    }
    for (const FiledPart& inner : part.parts) add(inner, to);
}

}  // namespace

std::vector<std::uint64_t> Content::axes() const {
    std::vector<std::uint64_t> all;
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (is_shown[i]) all.push_back(shape[i]);
    return all;
}

std::uint64_t Content::bytes() const {
    std::uint64_t count = packed_bytes(field);
    for (const std::uint64_t along : shape) count *= along;
    return count;
}

std::vector<Content> contents_of(const FiledPart& part) {
    std::vector<Content> all, each;
    add(part, all);
    std::set<std::string> seen;
    std::ranges::copy_if(all, std::back_inserter(each),
                         [&](const Content& content) { return seen.insert(content.path).second; });
    return each;
}

Content content_at(const VerifiedFile& file, const std::string& path) {
    const std::string wanted = without_slash(path);
    const std::vector<Content> all = contents_of(file.schema(wanted.substr(0, wanted.find('/'))));
    std::string paths;
    for (const Content& content : all) {
        if (content.path == wanted || (all.size() == 1 && content.path.starts_with(wanted + "/"))) return content;
        paths += (paths.empty() ? "" : ", ") + content.path;
    }
    throw glift::Error(glift::ErrorCode::wrong_argument, "the file has no numbers at this path", file.path(),
                       "'" + path + "'", "it has: " + paths);
}

void read(VerifiedFile& file, const Content& content, const std::function<void(std::span<const std::byte>)>& part) {
    const Hdf5Lock lock;
    StoredDataset dataset(file.hdf5(), "/" + content.path, content.field, content.shape, content.is_shown, file.path());
    const Tiling& tiling = dataset.tiling();
    std::vector<std::byte> packed;
    AddressShift shift;
    for (std::uint64_t number = 0; number < tiling.count(); ++number) {
        const Batch batch = tiling.batch(number);
        packed.resize(batch.count * packed_bytes(content.field));
        dataset.read(batch, packed, file.pieces(), shift);
        part(packed);
    }
}

std::uint64_t stored_bytes(const VerifiedFile& file, const Content& content) {
    const Hdf5Lock lock;
    const Id dataset(H5Dopen2(file.hdf5(), ("/" + content.path).c_str(), H5P_DEFAULT), "H5Dopen2");
    return H5Dget_storage_size(dataset);
}

}  // namespace gliftinfo
