// NumPy arrays as saved structures.
#include "commands.h"
#include "descriptor.h"
#include "field_bytes.h"
#include "npy.h"
#include "progress_line.h"
#include "structure_writer.h"
#include "verified_file.h"

#include <glift/error.h>
#include <glift/files.h>

#include <algorithm>
#include <fcntl.h>

namespace gliftinfo {

using namespace glift::files;

namespace {

std::string language_name(Scalar scalar) {
    switch (scalar) {
    case Scalar::boolean: return "bool";
    case Scalar::int32: return "int";
    case Scalar::uint32: return "uint";
    case Scalar::float16: return "half";
    case Scalar::float32: return "float";
    case Scalar::float64: return "double";
    default: return numpy_name(scalar);
    }
}

/// `float3`, `half[7]`
std::string type_name(const Field& field) {
    const std::string name = language_name(field.scalar);
    if (field.shape.size() == 1 && field.shape[0] >= 2 && field.shape[0] <= 4)
        return name + std::to_string(field.shape[0]);
    std::string text = name;
    for (const std::uint32_t along : field.shape) text += "[" + std::to_string(along) + "]";
    return text;
}

/// An array in a file, described as a structure all of whose elements are resident.
class NpyStructure {
public:
    NpyStructure(const ByteSource& source, unsigned element_axes)
        : source_(source), header_(parse_npy(source)), device_(glift::Device::open("host")),
          placeholder_(glift::Commands(device_).allocate(glift::MemoryDescription{.bytes = 4})) {
        const std::size_t axes = header_.shape.size();
        if (header_.is_fortran && axes > 1)
            throw glift::Error(glift::ErrorCode::wrong_argument, "gliftinfo does not read arrays in Fortran order",
                               source.name, "", "save numpy.ascontiguousarray(array)");
        if (axes <= element_axes || axes - element_axes > 4)
            throw glift::Error(glift::ErrorCode::wrong_argument, "the array does not have the axes of a structure",
                               source.name,
                               "it has " + std::to_string(axes) + ", of which " + std::to_string(element_axes) +
                                   " are those of an element; structures have 1 to 4",
                               "give --element-axes, or reshape the array");
        rank_ = static_cast<unsigned>(axes - element_axes);
        field_.scalar = header_.scalar == Scalar::flag ? Scalar::boolean : header_.scalar;
        for (std::size_t i = rank_; i < axes; ++i) field_.shape.push_back(static_cast<std::uint32_t>(header_.shape[i]));
        for (unsigned i = 0; i < rank_; ++i)
            extent_[i] = static_cast<std::uint32_t>(header_.shape[rank_ - 1 - i]), count_ *= extent_[i];
    }
    NpyStructure(const NpyStructure&) = delete;

    const glift::Device& device() const { return device_; }

    Part part(const std::string& name) {
        Part part;
        part.name = name;
        part.type = "Array<" + std::to_string(rank_) + ", " + type_name(field_) + ">";
        Field axes{"", Scalar::uint32, 0, {}, {}};
        if (rank_ > 1) axes.shape = {rank_};
        part.values.push_back({"extent", true, extent_.data(), {4 * rank_, {axes}}});
        part.memories.push_back({"data", false, {{&placeholder_, {&count_, 1, true}, type()}}});
        part.elements.emplace();
        part.elements->rank = rank_;
        part.elements->type = type();
        part.elements->domain = [this] { return extent_; };
        part.elements->read = [this](const glift::Extent& origin, const glift::Extent& size,
                                     std::vector<std::byte>& to) { read(origin, size, to); };
        return part;
    }

    /// As elements lie in memory.
    std::uint64_t bytes() const { return count_ * type().bytes; }

private:
    ElementType type() const {
        const std::size_t number = field_.scalar == Scalar::boolean ? 4 : file_bytes(field_.scalar);
        return {static_cast<std::uint32_t>(field_.numbers() * number), {field_}};
    }

    /// The box is a batch of a Tiling: its elements follow each other in the file.
    void read(const glift::Extent& origin, const glift::Extent& size, std::vector<std::byte>& to) {
        std::uint64_t first = 0, count = 1;
        for (unsigned i = rank_; i-- > 0;) first = first * extent_[i] + origin[i], count *= size[i];
        packed_.resize(count * packed_bytes(field_));
        if (source_.read(header_.begin + first * packed_bytes(field_), packed_) != packed_.size())
            throw glift::Error(glift::ErrorCode::bad_file, "the NumPy array cannot be read", source_.name,
                               "it became shorter while it was read", "write it again with numpy.save(file, array)");
        to.assign(count * type().bytes, std::byte{0});
        scatter(field_, type().bytes, packed_, to);
    }

    const ByteSource& source_;
    NpyHeader header_;
    glift::Device device_;
    glift::Memory placeholder_;  // elements come from the file
    unsigned rank_ = 1;
    Field field_;
    glift::Extent extent_{};
    std::uint64_t count_ = 1;
    std::vector<std::byte> packed_;
};

}  // namespace

int convert_npy(const std::string& array, const std::string& name, const std::string& to, unsigned element_axes) {
    if (!to.ends_with(".h5"))
        throw glift::Error(glift::ErrorCode::wrong_argument, "gliftinfo converts .npy files to files of glift::save",
                           to, "", "give it a name that ends with .h5");
    const Descriptor descriptor(array, O_RDONLY);
    const ByteSource source = source_of(descriptor);
    NpyStructure structure(source, element_axes);
    glift::NewFile file(to);
    ProgressLine line("convert", structure.bytes());
    file.write(structure.part(name), structure.device(), [&](std::uint64_t done, std::uint64_t) { line.show(done); });
    file.commit();
    return 0;
}

}  // namespace gliftinfo
