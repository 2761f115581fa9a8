#include "output.h"

#include <glift/error.h>

#include <cstring>

namespace gliftinfo {

using namespace glift::files;

namespace {

/// VTK has no half numbers: they are written as floats.
const char* vtk_type(Scalar scalar) {
    switch (scalar) {
    case Scalar::boolean:
    case Scalar::flag:
    case Scalar::uint8: return "UInt8";
    case Scalar::int8: return "Int8";
    case Scalar::int16: return "Int16";
    case Scalar::int32: return "Int32";
    case Scalar::int64: return "Int64";
    case Scalar::uint16: return "UInt16";
    case Scalar::uint32: return "UInt32";
    case Scalar::uint64: return "UInt64";
    case Scalar::float16:
    case Scalar::float32: return "Float32";
    case Scalar::float64: return "Float64";
    }
    return "";
}

std::vector<std::byte> as_floats(std::span<const std::byte> halves) {
    std::vector<std::byte> floats(2 * halves.size());
    for (std::size_t i = 0; i < halves.size() / 2; ++i) {
        glift::half number;
        std::memcpy(&number.bits, halves.data() + 2 * i, 2);
        const float value = number;
        std::memcpy(floats.data() + 4 * i, &value, 4);
    }
    return floats;
}

}  // namespace

void write_vti(VerifiedFile& file, const Content& content, const std::string& to, const Progress& progress) {
    const std::vector<std::uint64_t> axes = content.axes();
    const bool is_half = content.field.scalar == Scalar::float16;
    if (axes.size() > 3 || (!content.is_by_address && axes.size() < 2))
        throw glift::Error(glift::ErrorCode::wrong_argument, "only grids of up to three axes can be VTK image data",
                           file.path() + ", " + content.path,
                           "it is memory of " + std::to_string(axes.size()) + " axes", "write it as .npy");
    std::string extent;
    for (std::size_t i = 0; i < 3; ++i)
        extent += (i ? " 0 " : "0 ") + std::to_string(i < axes.size() ? axes[axes.size() - 1 - i] - 1 : 0);
    Output output(to);
    output.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                 "header_type=\"UInt64\">\n<ImageData WholeExtent=\"" +
                 extent + "\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n<Piece Extent=\"" + extent +
                 "\">\n<PointData>\n<DataArray type=\"" + vtk_type(content.field.scalar) + "\" Name=\"" +
                 content.path.substr(content.path.rfind('/') + 1) + "\" NumberOfComponents=\"" +
                 std::to_string(content.field.numbers()) +
                 "\" format=\"appended\" offset=\"0\"/>\n</PointData>\n</Piece>\n</ImageData>\n"
                 "<AppendedData encoding=\"raw\">\n_");
    const std::uint64_t bytes = content.bytes() * (is_half ? 2 : 1);
    output.write(std::as_bytes(std::span(&bytes, 1)));
    read(file, content, [&](std::span<const std::byte> part) {
        if (is_half) output.write(as_floats(part));
        else output.write(part);
        progress(part.size());
    });
    output.write("\n</AppendedData>\n</VTKFile>\n");
    output.close();
}

}  // namespace gliftinfo
