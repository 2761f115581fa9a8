// What a file says of a structure: the schema, JSON in an attribute of the structure's group.
#pragma once

#include <glift/files/part.h>

#include <cstdint>
#include <string>
#include <vector>

namespace glift::files {

/// A value's fields, each with its bytes as they lay in memory.
struct FiledValue {
    std::string name;
    bool is_argument = true;
    std::vector<Field> fields;
    std::vector<std::vector<std::byte>> bytes;
};

struct FiledMemory {
    std::string name;
    std::string path;  ///< of its dataset, or of the group of its datasets
    bool is_image = false;
    bool is_by_address = false;        ///< elements lie in row-major order of their addresses, in a grid of `shape`
    std::vector<std::uint64_t> shape;  ///< of buffers, slowest axis first
    std::vector<Field> fields;         ///< of buffers; offsets have no meaning
    std::array<std::uint64_t, 3> extent{};  ///< that the structure keeps; of buffers the number of elements
    std::string kind, format;               ///< of images
    std::array<std::uint32_t, 3> texels{};
    std::uint32_t mips = 1;

    std::uint64_t elements() const;
};

struct FiledPart {
    std::string name, type, role;
    std::uint64_t key = 0;  ///< state_key of its class
    std::vector<FiledValue> values;
    std::vector<FiledMemory> memories;
    std::vector<FiledPart> parts;
};

std::string text_of(const FiledPart& part);
/// Throws bad_file, with the file's name.
FiledPart parse_schema(const std::string& text, const std::string& file);

const char* name_of(Scalar scalar);
const char* name_of(Role role);
const char* name_of(MemoryKind kind);
const char* name_of(Format format);

/// `float32[3]`
std::string type_text(const Field& field);
/// A value as people write it: `{64, 64, 64}`.
std::string value_text(const FiledValue& value);

}  // namespace glift::files
