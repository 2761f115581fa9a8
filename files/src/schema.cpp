#include "schema.h"

#include "error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace glift::files {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* scalar_names[] = {"bool",   "flag",   "int8",   "int16",   "int32",   "int64",  "uint8",
                                        "uint16", "uint32", "uint64", "float16", "float32", "float64"};

Scalar scalar_named(const std::string& name) {
    for (std::size_t i = 0; i < std::size(scalar_names); ++i)
        if (name == scalar_names[i]) return static_cast<Scalar>(i);
    throw std::invalid_argument("there is no type " + name);
}

/// A number that must be whole, not negative, and fit: nlohmann_json would convert any.
template <class T> T number_of(const Json& json) {
    const std::uint64_t number = json.is_number_unsigned() ? json.get<std::uint64_t>() : UINT64_MAX;
    if (!json.is_number_unsigned() || number > std::numeric_limits<T>::max())
        throw std::invalid_argument(json.dump() + " is no number that fits");
    return static_cast<T>(number);
}

template <class T> std::vector<T> numbers_of(const Json& json, std::size_t most) {
    if (!json.is_array() || json.size() > most) throw std::invalid_argument("a list of numbers is too long, or none");
    std::vector<T> numbers;
    for (const Json& number : json) numbers.push_back(number_of<T>(number));
    return numbers;
}

template <class T> std::array<T, 3> three_of(const Json& json) {
    const std::vector<T> numbers = numbers_of<T>(json, 3);
    if (numbers.size() != 3) throw std::invalid_argument("an extent does not have three numbers");
    return {numbers[0], numbers[1], numbers[2]};
}

std::string hex_of(const std::vector<std::byte>& bytes) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (std::byte byte : bytes) {
        text += digits[std::to_integer<unsigned>(byte) >> 4];
        text += digits[std::to_integer<unsigned>(byte) & 15];
    }
    return text;
}

std::vector<std::byte> bytes_of(const std::string& hex) {
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

Json json_of(const Field& field) {
    return {{"name", field.name}, {"type", name_of(field.scalar)}, {"shape", field.shape}};
}

/// The most numbers in a field, and the most parts within parts: more than any element or structure has.
constexpr std::uint64_t most_numbers = 1 << 24;
constexpr int most_depth = 100;

Field field_of(const Json& json) {
    Field field{json.at("name"), scalar_named(json.at("type")), 0, numbers_of<std::uint32_t>(json.at("shape"), 16), {}};
    std::uint64_t numbers = 1;
    for (const std::uint32_t along : field.shape) {
        numbers *= along;
        if (numbers > most_numbers) throw std::invalid_argument("a field has too many numbers");
    }
    return field;
}

Json json_of(const FiledValue& value) {
    Json fields = Json::array();
    for (std::size_t i = 0; i < value.fields.size(); ++i) {
        Json field = json_of(value.fields[i]);
        field["bytes"] = hex_of(value.bytes[i]);
        fields.push_back(std::move(field));
    }
    return {{"name", value.name}, {"argument", value.is_argument}, {"fields", std::move(fields)}};
}

std::size_t memory_bytes(const Field& field) {
    static constexpr std::size_t sizes[] = {4, 1, 1, 2, 4, 8, 1, 2, 4, 8, 2, 4, 8};
    return field.numbers() * sizes[static_cast<std::size_t>(field.scalar)];
}

FiledValue value_of(const Json& json) {
    FiledValue value{json.at("name"), json.at("argument"), {}, {}};
    for (const Json& field : json.at("fields")) {
        value.fields.push_back(field_of(field));
        value.bytes.push_back(bytes_of(field.at("bytes")));
        if (value.bytes.back().size() != memory_bytes(value.fields.back()))
            throw std::invalid_argument("the value " + value.name + " has another size than its type");
    }
    return value;
}

Json json_of(const FiledMemory& memory) {
    Json json = {{"name", memory.name}, {"path", memory.path}, {"image", memory.is_image}, {"extent", memory.extent}};
    if (memory.is_image) {
        json["kind"] = memory.kind;
        json["format"] = memory.format;
        json["texels"] = memory.texels;
        json["mips"] = memory.mips;
    } else {
        json["by_address"] = memory.is_by_address;
        json["shape"] = memory.shape;
        json["fields"] = Json::array();
        for (const Field& field : memory.fields) json["fields"].push_back(json_of(field));
    }
    return json;
}

FiledMemory memory_of(const Json& json) {
    FiledMemory memory;
    memory.name = json.at("name");
    memory.path = json.at("path");
    memory.is_image = json.at("image");
    memory.extent = three_of<std::uint64_t>(json.at("extent"));
    if (memory.is_image) {
        memory.kind = json.at("kind");
        memory.format = json.at("format");
        memory.texels = three_of<std::uint32_t>(json.at("texels"));
        memory.mips = number_of<std::uint32_t>(json.at("mips"));
    } else {
        memory.is_by_address = json.at("by_address");
        memory.shape = numbers_of<std::uint64_t>(json.at("shape"), 4);
        if (memory.shape.empty()) throw std::invalid_argument("a memory has no shape");
        for (const Json& field : json.at("fields")) memory.fields.push_back(field_of(field));
    }
    return memory;
}

Json json_of(const FiledPart& part) {
    Json json = {{"name", part.name}, {"type", part.type}, {"role", part.role}, {"key", part.key}};
    for (const char* list : {"values", "memories", "parts"}) json[list] = Json::array();
    for (const FiledValue& value : part.values) json["values"].push_back(json_of(value));
    for (const FiledMemory& memory : part.memories) json["memories"].push_back(json_of(memory));
    for (const FiledPart& inner : part.parts) json["parts"].push_back(json_of(inner));
    return json;
}

FiledPart part_of_json(const Json& json, int depth = 0) {
    if (depth > most_depth) throw std::invalid_argument("parts lie too deep in each other");
    FiledPart part{
        json.at("name"), json.at("type"), json.at("role"), number_of<std::uint64_t>(json.at("key")), {}, {}, {}};
    for (const Json& value : json.at("values")) part.values.push_back(value_of(value));
    for (const Json& memory : json.at("memories")) part.memories.push_back(memory_of(memory));
    for (const Json& inner : json.at("parts")) part.parts.push_back(part_of_json(inner, depth + 1));
    return part;
}

template <class T> T number_at(const std::vector<std::byte>& bytes, std::size_t at) {
    T value{};
    std::memcpy(&value, bytes.data() + at * sizeof(T), sizeof(T));
    return value;
}

std::string number_text(Scalar scalar, const std::vector<std::byte>& bytes, std::size_t at) {
    switch (scalar) {
    case Scalar::boolean: return number_at<std::uint32_t>(bytes, at) ? "true" : "false";
    case Scalar::flag: return number_at<std::uint8_t>(bytes, at) ? "true" : "false";
    case Scalar::int8: return std::to_string(number_at<std::int8_t>(bytes, at));
    case Scalar::int16: return std::to_string(number_at<std::int16_t>(bytes, at));
    case Scalar::int32: return std::to_string(number_at<std::int32_t>(bytes, at));
    case Scalar::int64: return std::to_string(number_at<std::int64_t>(bytes, at));
    case Scalar::uint8: return std::to_string(number_at<std::uint8_t>(bytes, at));
    case Scalar::uint16: return std::to_string(number_at<std::uint16_t>(bytes, at));
    case Scalar::uint32: return std::to_string(number_at<std::uint32_t>(bytes, at));
    case Scalar::uint64: return std::to_string(number_at<std::uint64_t>(bytes, at));
    case Scalar::float16:
        return detail::number_text(static_cast<double>(static_cast<float>(number_at<half>(bytes, at))), 5);
    case Scalar::float32: return detail::number_text(static_cast<double>(number_at<float>(bytes, at)), 9);
    case Scalar::float64: return detail::number_text(number_at<double>(bytes, at), 17);
    }
    return "";
}

}  // namespace

std::uint64_t FiledMemory::elements() const {
    std::uint64_t count = 1;
    for (std::uint64_t along : shape) count *= along;
    return count;
}

std::string text_of(const FiledPart& part) { return json_of(part).dump(); }

FiledPart parse_schema(const std::string& text, const std::string& file) {
    try {
        return part_of_json(Json::parse(text));
    } catch (const std::exception& error) {
        throw_bad(file, std::string("the schema of a structure cannot be read: ") + error.what());
    }
}

const char* name_of(Scalar scalar) { return scalar_names[static_cast<std::size_t>(scalar)]; }

const char* name_of(Role role) {
    static constexpr const char* names[] = {"root", "member", "base", "given"};
    return names[static_cast<std::size_t>(role)];
}

const char* name_of(MemoryKind kind) {
    static constexpr const char* names[] = {"buffer", "image1d", "image2d", "image3d", "imagecube", "image2darray"};
    return names[static_cast<std::size_t>(kind)];
}

const char* name_of(Format format) {
    static constexpr const char* names[] = {"none",     "r8",    "rg8",     "rgba8",   "r16f",    "rg16f", "rgba16f",
                                            "r32f",     "rg32f", "rgba32f", "r8ui",    "r16ui",   "r32ui", "rg32ui",
                                            "rgba32ui", "r32i",  "rg32i",   "rgba32i", "rgba8ui", "d32"};
    return names[static_cast<std::size_t>(format)];
}

std::string type_text(const Field& field) {
    std::string text = name_of(field.scalar);
    for (std::uint32_t along : field.shape) text += "[" + std::to_string(along) + "]";
    return text;
}

std::string value_text(const FiledValue& value) {
    std::string text;
    for (std::size_t i = 0; i < value.fields.size(); ++i) {
        const Field& field = value.fields[i];
        text += (text.empty() ? "" : ", ") + (field.name.empty() ? "" : field.name + " ");
        const std::uint32_t count = field.numbers();
        if (!field.shape.empty()) text += "{";
        for (std::uint32_t k = 0; k < count; ++k)
            text += (k ? ", " : "") + number_text(field.scalar, value.bytes[i], k);
        if (!field.shape.empty()) text += "}";
    }
    return text;
}

}  // namespace glift::files
