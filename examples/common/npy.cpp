#include "npy.h"

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace npy {

namespace {

static_assert(std::endian::native == std::endian::little);

struct Header {
    std::string type;  ///< NumPy's type string: "<f4"
    bool fortran_order = false;
    std::vector<std::uint64_t> shape;
    std::size_t data = 0;  ///< byte offset of the elements in the file
};

[[noreturn]] void fail(const std::string& path, const std::string& problem) {
    throw std::runtime_error(path + ": " + problem);
}

/// Reads the header: a Python dictionary with three known keys, "{'descr': '<f4', 'fortran_order': False, 'shape': (2,
/// 3), }".
class HeaderParser {
public:
    HeaderParser(const std::string& path, const std::string& text) : path_(path), text_(text) {}

    Header parse() {
        Header header;
        bool has_type = false, has_order = false, has_shape = false;
        expect('{');
        while (!take('}')) {
            const std::string key = quoted();
            expect(':');
            if (key == "descr") {
                if (peek() == '[') fail(path_, "its elements are records; this program reads plain numbers");
                header.type = quoted();
                has_type = true;
            } else if (key == "fortran_order") {
                header.fortran_order = truth();
                has_order = true;
            } else if (key == "shape") {
                header.shape = tuple();
                has_shape = true;
            } else {
                damaged();
            }
            if (!take(',') && peek() != '}') damaged();
        }
        if (!has_type || !has_order || !has_shape) damaged();
        return header;
    }

private:
    [[noreturn]] void damaged() const {
        fail(path_, "the .npy header is damaged: " + text_.substr(0, text_.find('\n')));
    }

    char peek() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char wanted) {
        if (peek() != wanted) return false;
        ++at_;
        return true;
    }
    void expect(char wanted) {
        if (!take(wanted)) damaged();
    }
    std::string quoted() {
        const char quote = peek();
        if (quote != '\'' && quote != '"') damaged();
        const std::size_t start = ++at_;
        at_ = text_.find(quote, start);
        if (at_ == std::string::npos) damaged();
        return text_.substr(start, at_++ - start);
    }
    bool truth() {
        peek();
        for (const bool value : {true, false}) {
            const std::string word = value ? "True" : "False";
            if (text_.compare(at_, word.size(), word) == 0) {
                at_ += word.size();
                return value;
            }
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
        for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9'; ++at_) {
            value = value * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
            if (value > UINT32_MAX) fail(path_, "an axis is longer than 2^32 - 1");
        }
        return value;
    }

    const std::string& path_;
    const std::string& text_;
    std::size_t at_ = 0;
};

Header read_header(const std::string& path, const std::string& bytes) {
    constexpr std::size_t magic = 6;
    if (bytes.size() < 10 || bytes.compare(0, magic, "\x93NUMPY") != 0) fail(path, "this is not a .npy file");
    const int version = static_cast<unsigned char>(bytes[magic]);
    if (version < 1 || version > 3) fail(path, ".npy version " + std::to_string(version) + " is not known");
    const std::size_t width = version == 1 ? 2 : 4, start = magic + 2 + width;
    std::uint32_t length = 0;
    if (bytes.size() < start) fail(path, "the file ends in its header");
    std::memcpy(&length, bytes.data() + magic + 2, width);
    if (bytes.size() - start < length) fail(path, "the file ends in its header");
    const std::string text = bytes.substr(start, length);
    Header header = HeaderParser(path, text).parse();
    header.data = start + length;
    return header;
}

/// The value of an IEEE half-precision number.
float half_value(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31, fraction = bits & 1023;
    const float sign = bits & 0x8000 ? -1.0f : 1.0f;
    if (exponent == 31) return fraction ? std::nanf("") : sign * HUGE_VALF;
    if (exponent == 0) return sign * std::ldexp(static_cast<float>(fraction), -24);
    return sign * std::ldexp(static_cast<float>(fraction + 1024), exponent - 25);
}

template <class T> float value_at(const char* bytes, bool swapped) {
    char ordered[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) ordered[i] = bytes[swapped ? sizeof(T) - 1 - i : i];
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return static_cast<float>(value);
}

float half_at(const char* bytes, bool swapped) {
    const auto low = static_cast<unsigned char>(bytes[swapped]), high = static_cast<unsigned char>(bytes[!swapped]);
    return half_value(static_cast<std::uint16_t>(high << 8 | low));
}

struct ElementType {
    const char* name;  ///< NumPy's type string without the byte order
    std::size_t bytes;
    float (*value)(const char*, bool);
};

constexpr ElementType element_types[] = {
    {"f2", 2, half_at},
    {"f4", 4, value_at<float>},
    {"f8", 8, value_at<double>},
    {"b1", 1, value_at<std::uint8_t>},
    {"i1", 1, value_at<std::int8_t>},
    {"u1", 1, value_at<std::uint8_t>},
    {"i2", 2, value_at<std::int16_t>},
    {"u2", 2, value_at<std::uint16_t>},
    {"i4", 4, value_at<std::int32_t>},
    {"u4", 4, value_at<std::uint32_t>},
    {"i8", 8, value_at<std::int64_t>},
    {"u8", 8, value_at<std::uint64_t>},
};

const ElementType& element_type(const std::string& path, const std::string& type) {
    if (!type.empty() && (type[0] == '<' || type[0] == '>' || type[0] == '|')) {
        for (const ElementType& each : element_types)
            if (type.compare(1, std::string::npos, each.name) == 0) return each;
    }
    fail(path, "its elements are '" + type + "'; this program reads float16, float32, float64, bool and integers");
}

/// Iterates over the elements in the order of a Fortran file, and gives their row-major (last axis fastest) indices.
class FortranOrder {
public:
    explicit FortranOrder(const std::vector<std::uint64_t>& shape) : shape_(shape), index_(shape.size(), 0) {
        stride_.assign(shape.size(), 1);
        for (std::size_t axis = shape.size(); axis-- > 1;) stride_[axis - 1] = stride_[axis] * shape[axis];
    }
    std::uint64_t next() {
        const std::uint64_t number = number_;
        for (std::size_t axis = 0; axis < shape_.size(); ++axis) {
            number_ += stride_[axis];
            if (++index_[axis] < shape_[axis]) break;
            number_ -= stride_[axis] * shape_[axis];
            index_[axis] = 0;
        }
        return number;
    }

private:
    const std::vector<std::uint64_t>& shape_;
    std::vector<std::uint64_t> index_, stride_;
    std::uint64_t number_ = 0;
};

}  // namespace

Array read(const std::string& path) {
    if (std::filesystem::is_directory(path)) fail(path, "is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, std::string("cannot be opened: ") + std::strerror(errno));
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (file.bad()) fail(path, "cannot be read");
    const Header header = read_header(path, bytes);
    const ElementType& type = element_type(path, header.type);

    Array array;
    array.extent.assign(header.shape.rbegin(), header.shape.rend());
    const std::uint64_t held = (bytes.size() - header.data) / type.bytes;
    std::uint64_t count = 1;
    for (const std::uint64_t length : header.shape) {
        if (length != 0 && count > UINT64_MAX / length) fail(path, "its shape is too large");
        count *= length;
    }
    if (count > held) {
        fail(path, "the file is cut short: " + text_of(array.extent) + " elements need " + std::to_string(count) +
                       ", it holds " + std::to_string(held));
    }

    array.values.resize(count);
    const bool swapped = header.type[0] == '>';
    FortranOrder order(header.shape);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t to = header.fortran_order ? order.next() : i;
        array.values[to] = type.value(bytes.data() + header.data + i * type.bytes, swapped);
    }
    return array;
}

void write(const std::string& path, const Array& array) {
    std::string shape;
    for (std::size_t axis = array.extent.size(); axis-- > 0;) shape += std::to_string(array.extent[axis]) + ", ";
    if (array.extent.size() > 1) shape.resize(shape.size() - 2);
    std::string text = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + shape + "), }";
    // The elements start at a multiple of 64 bytes, after a line feed.
    constexpr std::size_t before = 10, alignment = 64;
    text.append((alignment - (before + text.size() + 1) % alignment) % alignment, ' ');
    text += '\n';
    const auto length = static_cast<std::uint16_t>(text.size());

    std::ofstream file(path, std::ios::binary);
    file.write("\x93NUMPY\x01\x00", 8);
    file.write(reinterpret_cast<const char*>(&length), sizeof length);
    file << text;
    file.write(reinterpret_cast<const char*>(array.values.data()),
               static_cast<std::streamsize>(array.values.size() * sizeof(float)));
    file.flush();
    if (!file) fail(path, "cannot be written");
}

std::string text_of(const std::vector<std::uint32_t>& extent) {
    std::string text;
    for (const std::uint32_t length : extent) text += (text.empty() ? "" : " x ") + std::to_string(length);
    return text.empty() ? "one number" : text;
}

}  // namespace npy
