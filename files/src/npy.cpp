#include "npy.h"

#include "hdf5_handle.h"

#include <glift/error.h>

#include <algorithm>
#include <optional>

namespace glift::files {

namespace {

constexpr std::string_view magic = "\x93NUMPY";
/// Headers that NumPy writes are shorter than 256 bytes, and it reads none beyond 10,000.
constexpr std::uint64_t longest_header = 10000;

struct NpyType {
    const char* name;
    Scalar scalar;
};
constexpr NpyType npy_types[] = {
    {"|b1", Scalar::flag},   {"|i1", Scalar::int8},    {"<i2", Scalar::int16},   {"<i4", Scalar::int32},
    {"<i8", Scalar::int64},  {"|u1", Scalar::uint8},   {"<u2", Scalar::uint16},  {"<u4", Scalar::uint32},
    {"<u8", Scalar::uint64}, {"<f2", Scalar::float16}, {"<f4", Scalar::float32}, {"<f8", Scalar::float64},
};

const char* npy_name(Scalar scalar) {
    if (scalar == Scalar::boolean) scalar = Scalar::flag;
    return std::ranges::find(npy_types, scalar, &NpyType::scalar)->name;
}

[[noreturn]] void throw_npy(const std::string& file, const std::string& why, const std::string& remedy) {
    throw Error(ErrorCode::bad_file, "the NumPy array cannot be read", file, why, remedy);
}

/// Parses the header's text, a Python dictionary: {'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }
class HeaderText {
public:
    HeaderText(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    void parse(NpyHeader& header) {
        std::optional<std::string_view> type;
        std::optional<bool> order;
        bool has_shape = false;
        expect('{');
        while (!take('}')) {
            const std::string_view key = quoted();
            expect(':');
            if (key == "descr" && !type) type = type_name();
            else if (key == "fortran_order" && !order) order = truth();
            else if (key == "shape" && !has_shape) header.shape = tuple(), has_shape = true;
            else damaged();
            if (!take(',') && peek() != '}') damaged();
        }
        if (!type || !order || !has_shape || text_[at_] != '\n' || at_ + 1 != text_.size()) damaged();
        header.is_fortran = *order;
        header.scalar = scalar_of_type(*type);
    }

private:
    [[noreturn]] void damaged() const {
        throw_npy(file_, "its header is damaged", "write it again with numpy.save(file, array)");
    }

    /// The next character that is no space. The text ends with a line feed, which is never taken.
    char peek() {
        while (text_[at_] == ' ') ++at_;
        return text_[at_];
    }
    bool take(char wanted) {
        if (peek() != wanted) return false;
        ++at_;
        peek();
        return true;
    }
    void expect(char wanted) {
        if (!take(wanted)) damaged();
    }
    std::string_view quoted() {
        if (peek() != '\'') damaged();
        const std::size_t begin = at_ + 1, end = text_.find('\'', begin);
        if (end == std::string_view::npos) damaged();
        at_ = end + 1;
        return text_.substr(begin, end - begin);
    }
    std::string_view type_name() {
        if (peek() == '[')
            throw_npy(file_, "its elements are records", "save each field as an array of its own: array['field']");
        return quoted();
    }
    bool truth() {
        peek();
        for (const bool value : {true, false}) {
            const std::string_view word = value ? "True" : "False";
            if (!text_.substr(at_).starts_with(word)) continue;
            at_ += word.size();
            return value;
        }
        damaged();
    }
    std::vector<std::uint64_t> tuple() {
        std::vector<std::uint64_t> numbers;
        expect('(');
        while (!take(')')) {
            numbers.push_back(number());
            if (!take(',') && peek() != ')') damaged();
        }
        return numbers;
    }
    std::uint64_t number() {
        if (peek() < '0' || peek() > '9') damaged();
        std::uint64_t value = 0;
        for (; text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
            value = 10 * value + static_cast<std::uint64_t>(text_[at_] - '0');
            if (value > UINT32_MAX)
                throw_npy(file_, "an axis is longer than 2^32 - 1", "cut the array into several files");
        }
        return value;
    }

    Scalar scalar_of_type(std::string_view type) const {
        for (const NpyType& each : npy_types)
            if (type == each.name) return each.scalar;
        const auto is_same_but_order = [&](const NpyType& each) {
            return each.name[0] == '<' && type[0] == '>' && type.substr(1) == std::string_view(each.name).substr(1);
        };
        if (!type.empty() && std::ranges::any_of(npy_types, is_same_but_order))
            throw_npy(file_, "its numbers are big-endian: '" + std::string(type) + "'",
                      "save array.astype(array.dtype.newbyteorder('<'))");
        throw_npy(file_, "its elements are '" + std::string(type) + "'",
                  "save bools, integers of 8 to 64 bits, float16, float32 or float64");
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t at_ = 0;
};

std::string read_text(const ByteSource& source, std::uint64_t begin, std::uint64_t bytes) {
    std::string text(bytes, '\0');
    text.resize(source.read(begin, std::as_writable_bytes(std::span(text))));
    return text;
}

/// Numbers that fit into a file; none: the product is larger.
std::optional<std::uint64_t> product(const std::vector<std::uint64_t>& shape, std::uint64_t bytes) {
    if (std::ranges::find(shape, 0) != shape.end()) return 0;
    for (const std::uint64_t along : shape) {
        if (bytes > UINT64_MAX / along) return std::nullopt;
        bytes *= along;
    }
    return bytes;
}

}  // namespace

std::uint64_t NpyHeader::numbers() const { return *product(shape, 1); }

NpyHeader parse_npy(const ByteSource& source) {
    const std::string begin = read_text(source, 0, 12);
    const auto byte = [&](std::size_t at) { return static_cast<std::uint64_t>(static_cast<unsigned char>(begin[at])); };
    if (begin.size() < 12 || !begin.starts_with(magic))
        throw_npy(source.name, "it does not begin as .npy files do", "write it with numpy.save(file, array)");
    if (byte(6) < 1 || byte(6) > 3 || byte(7) != 0)
        throw_npy(source.name, "its format is version " + std::to_string(byte(6)) + "." + std::to_string(byte(7)),
                  "write it again with numpy.save(file, array), which writes version 1.0 to 3.0");
    NpyHeader header;
    std::uint64_t length = byte(8) | byte(9) << 8;
    header.begin = 10;
    if (byte(6) > 1) length |= byte(10) << 16 | byte(11) << 24, header.begin = 12;
    const std::string text = length <= longest_header ? read_text(source, header.begin, length) : std::string();
    if (text.empty() || text.size() != length || text.back() != '\n')
        throw_npy(source.name, "its header is damaged or cut off", "write it again with numpy.save(file, array)");
    header.begin += length;
    HeaderText(source.name, text).parse(header);
    const std::optional<std::uint64_t> bytes = product(header.shape, file_bytes(header.scalar));
    if (!bytes || *bytes != source.size - header.begin)
        throw_npy(source.name,
                  "its shape needs " + (bytes ? std::to_string(*bytes) : "more than 2^64") + " bytes, and it has " +
                      std::to_string(source.size - header.begin) + ": it is cut off, or was appended to",
                  "write it again with numpy.save(file, array)");
    return header;
}

std::string npy_header(Scalar scalar, const std::vector<std::uint64_t>& shape) {
    std::string axes;
    for (const std::uint64_t along : shape) axes += std::to_string(along) + ", ";
    std::string text =
        "{'descr': '" + std::string(npy_name(scalar)) + "', 'fortran_order': False, 'shape': (" + axes + "), }";
    text.append((64 - (text.size() + 11) % 64) % 64, ' ');
    text += '\n';
    std::string all = std::string(magic) + std::string("\x01\x00", 2);
    all += static_cast<char>(text.size() & 255);
    all += static_cast<char>(text.size() >> 8);
    return all + text;
}

std::string numpy_name(Scalar scalar) {
    switch (scalar) {
    case Scalar::boolean:
    case Scalar::flag: return "bool";
    case Scalar::int8: return "int8";
    case Scalar::int16: return "int16";
    case Scalar::int32: return "int32";
    case Scalar::int64: return "int64";
    case Scalar::uint8: return "uint8";
    case Scalar::uint16: return "uint16";
    case Scalar::uint32: return "uint32";
    case Scalar::uint64: return "uint64";
    case Scalar::float16: return "float16";
    case Scalar::float32: return "float32";
    case Scalar::float64: return "float64";
    }
    return "";
}

}  // namespace glift::files
