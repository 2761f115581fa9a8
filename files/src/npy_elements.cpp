// Elements of structures out of .npy files, and into them.
#include "descriptor.h"
#include "error.h"
#include "field_bytes.h"
#include "npy.h"
#include "structure_writer.h"
#include "verified_file.h"

#include <glift/error.h>
#include <glift/files/npy.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace glift::files {

namespace {

std::string shape_text(const std::vector<std::uint64_t>& shape) {
    std::string text;
    for (const std::uint64_t along : shape) text += std::to_string(along) + ", ";
    if (shape.size() > 1) text.resize(text.size() - 2);
    else if (!text.empty()) text.pop_back();
    return "(" + text + ")";
}

[[noreturn]] void throw_other(const std::string& path, const std::string& what, const std::string& filed,
                              const std::string& here, const std::string& remedy) {
    throw Error(ErrorCode::wrong_argument, "the NumPy array has another " + what + " than the structure", path,
                "the file has " + filed + ", the structure " + here, remedy);
}

/// The array's shape: the axes of addresses, the slowest first, then those of the element.
std::vector<std::uint64_t> shape_of(const Extent& extent, unsigned rank, const Field& field) {
    std::vector<std::uint64_t> shape;
    for (unsigned i = rank; i-- > 0;) shape.push_back(extent[i]);
    shape.insert(shape.end(), field.shape.begin(), field.shape.end());
    return shape;
}

void require_type(const std::string& path, const NpyHeader& header, const Field& field) {
    const std::string wanted = numpy_name(field.scalar);
    if (numpy_name(header.scalar) != wanted)
        throw_other(path, "type", numpy_name(header.scalar), wanted, "save array.astype(numpy." + wanted + ")");
}

/// The extent of the structure; the last axes of the array must be those of an element.
Extent extent_of(const std::string& path, const NpyHeader& header, unsigned rank, const Field& field) {
    Extent extent{1, 1, 1, 1};
    const auto& shape = header.shape;
    if (shape.size() == rank + field.shape.size() &&
        std::equal(field.shape.begin(), field.shape.end(), shape.begin() + rank)) {
        for (unsigned i = 0; i < rank; ++i) extent[i] = static_cast<std::uint32_t>(shape[rank - 1 - i]);
        return extent;
    }
    std::string axes = std::to_string(rank) + (rank == 1 ? " axis" : " axes");
    if (!field.shape.empty())
        axes += ", then those of an element, " + shape_text({field.shape.begin(), field.shape.end()});
    throw_other(path, "shape", shape_text(shape), axes,
                "save array.reshape(…) with the structure's axes, the slowest first");
}

/// Reads elements of an array in the order of their addresses.
class NpyReader {
public:
    NpyReader(const ByteSource& source, NpyHeader header) : source_(source), header_(std::move(header)) {
        if (!header_.is_fortran) return;
        all_.resize(header_.numbers() * file_bytes(header_.scalar));
        read_bytes(0, all_);
    }

    void read(std::uint64_t first_number, std::span<std::byte> to) {
        const std::size_t bytes = file_bytes(header_.scalar);
        if (!header_.is_fortran) return read_bytes(first_number * bytes, to);
        FortranPlace place(header_.shape, first_number);
        for (std::size_t at = 0; at < to.size(); at += bytes, place.advance())
            std::memcpy(to.data() + at, all_.data() + place.number() * bytes, bytes);
    }

private:
    /// Walks through an array in C order, and says where each number lies in Fortran order.
    class FortranPlace {
    public:
        FortranPlace(const std::vector<std::uint64_t>& shape, std::uint64_t number)
            : shape_(shape), index_(shape.size()), stride_(shape.size()) {
            std::uint64_t stride = 1;
            for (std::size_t axis = 0; axis < shape.size(); stride *= shape[axis++]) stride_[axis] = stride;
            for (std::size_t axis = shape.size(); axis-- > 0; number /= shape[axis])
                index_[axis] = number % shape[axis], number_ += index_[axis] * stride_[axis];
        }
        std::uint64_t number() const { return number_; }
        void advance() {
            for (std::size_t axis = shape_.size(); axis-- > 0;) {
                number_ += stride_[axis];
                if (++index_[axis] < shape_[axis]) return;
                number_ -= shape_[axis] * stride_[axis];
                index_[axis] = 0;
            }
        }

    private:
        const std::vector<std::uint64_t>& shape_;
        std::vector<std::uint64_t> index_, stride_;
        std::uint64_t number_ = 0;
    };

    void read_bytes(std::uint64_t offset, std::span<std::byte> to) {
        if (source_.read(header_.begin + offset, to) != to.size())
            throw Error(ErrorCode::bad_file, "the NumPy array cannot be read", source_.name,
                        "it became shorter while it was read", "write it again with numpy.save(file, array)");
    }

    const ByteSource& source_;
    NpyHeader header_;
    std::vector<std::byte> all_;
};

Tiling tiling_of(const Extent& extent, unsigned rank, const std::vector<Field>& fields) {
    return Tiling::of(shape_of(extent, rank, {}), elements_at_a_time(fields));
}

/// A file that gets its name once it is written, and vanishes if it is not.
class Unnamed {
public:
    explicit Unnamed(const std::string& path)
        : path_(path), temporary_(path + ".saving"), file_(temporary_, O_WRONLY | O_CREAT | O_TRUNC) {}
    ~Unnamed() {
        if (!is_named_) ::unlink(temporary_.c_str());
    }
    void append(std::span<const std::byte> bytes) {
        file_.write(end_, bytes);
        end_ += bytes.size();
    }
    void give_name() {
        file_.sync();
        if (::rename(temporary_.c_str(), path_.c_str()) != 0) throw_system("rename", path_);
        is_named_ = true;
    }

private:
    std::string path_, temporary_;
    Descriptor file_;
    std::uint64_t end_ = 0;
    bool is_named_ = false;
};

}  // namespace

Extent npy_extent(const std::string& path, unsigned rank, const ElementType& type) {
    const Descriptor file(path, O_RDONLY);
    const NpyHeader header = parse_npy(source_of(file));
    require_type(path, header, type.fields[0]);
    return extent_of(path, header, rank, type.fields[0]);
}

void read_npy(const std::string& path, const Elements& elements) {
    const Descriptor file(path, O_RDONLY);
    const ByteSource source = source_of(file);
    const NpyHeader header = parse_npy(source);
    const Field& field = elements.type.fields[0];
    require_type(path, header, field);
    extent_of(path, header, elements.rank, field);
    const Extent domain = elements.domain();
    const std::vector<std::uint64_t> shape = shape_of(domain, elements.rank, field);
    if (header.shape != shape)
        throw_other(path, "shape", shape_text(header.shape), shape_text(shape),
                    "make the structure with the array's extent, as glift::load_npy<S>(path, device) does");
    NpyReader reader(source, header);
    const Tiling tiling = tiling_of(domain, elements.rank, elements.type.fields);
    std::vector<std::byte> packed, values;
    for (std::uint64_t number = 0; number < tiling.count(); ++number) {
        const Batch batch = tiling.batch(number);
        packed.resize(batch.count * packed_bytes(field));
        reader.read(batch.first * field.numbers(), packed);
        values.assign(batch.count * elements.type.bytes, std::byte{0});
        scatter(field, elements.type.bytes, packed, values);
        elements.write(address_extent(batch.origin), address_extent(batch.size), values);
    }
}

void write_npy(const std::string& path, const Elements& elements) {
    const Field& field = elements.type.fields[0];
    const Extent domain = elements.domain();
    const std::string header = npy_header(field.scalar, shape_of(domain, elements.rank, field));
    Unnamed file(path);
    file.append(std::as_bytes(std::span(header)));
    const Tiling tiling = tiling_of(domain, elements.rank, elements.type.fields);
    std::vector<std::byte> packed, values;
    for (std::uint64_t number = 0; number < tiling.count(); ++number) {
        const Batch batch = tiling.batch(number);
        elements.read(address_extent(batch.origin), address_extent(batch.size), values);
        packed.resize(batch.count * packed_bytes(field));
        gather(field, elements.type.bytes, values, packed);
        file.append(packed);
    }
    file.give_name();
}

}  // namespace glift::files
