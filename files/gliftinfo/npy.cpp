#include "output.h"

namespace gliftinfo {

using namespace glift::files;

namespace {

const char* npy_type(Scalar scalar) {
    switch (scalar) {
    case Scalar::boolean:
    case Scalar::flag: return "|b1";
    case Scalar::int8: return "|i1";
    case Scalar::int16: return "<i2";
    case Scalar::int32: return "<i4";
    case Scalar::int64: return "<i8";
    case Scalar::uint8: return "|u1";
    case Scalar::uint16: return "<u2";
    case Scalar::uint32: return "<u4";
    case Scalar::uint64: return "<u8";
    case Scalar::float16: return "<f2";
    case Scalar::float32: return "<f4";
    case Scalar::float64: return "<f8";
    }
    return "";
}

/// The header of version 1.0: its length, with the ten bytes before it, is a multiple of 64.
std::string header(const Content& content) {
    std::string shape;
    for (const hsize_t along : with_field(content.axes(), content.field)) shape += std::to_string(along) + ", ";
    std::string text = "{'descr': '" + std::string(npy_type(content.field.scalar)) +
                       "', 'fortran_order': False, 'shape': (" + shape + "), }";
    text.append((64 - (text.size() + 11) % 64) % 64, ' ');
    text += '\n';
    std::string all("\x93NUMPY\x01\x00", 8);
    all += static_cast<char>(text.size() & 255);
    all += static_cast<char>(text.size() >> 8);
    return all + text;
}

}  // namespace

void write_npy(VerifiedFile& file, const Content& content, const std::string& to) {
    Output output(to);
    output.write(header(content));
    read(file, content, [&](std::span<const std::byte> part) { output.write(part); });
    output.close();
}

}  // namespace gliftinfo
