#include "match.h"

#include "hdf5_handle.h"

#include <glift/error.h>

#include <algorithm>
#include <cstring>

namespace glift::files {

namespace {

std::size_t bytes_in_memory(const Field& field) {
    return field.numbers() * (field.scalar == Scalar::boolean ? 4 : file_bytes(field.scalar));
}

FiledValue filed_value(const Value& value) {
    FiledValue filed{value.name, value.is_argument, value.type.fields, {}};
    const auto* data = static_cast<const std::byte*>(value.data);
    for (const Field& field : value.type.fields)
        filed.bytes.emplace_back(data + field.offset, data + field.offset + bytes_in_memory(field));
    return filed;
}

/// Whether the fields that both have are of one type and have the same bytes.
bool has_equal_fields(const FiledValue& a, const FiledValue& b) {
    for (std::size_t i = 0; i < a.fields.size(); ++i)
        for (std::size_t k = 0; k < b.fields.size(); ++k)
            if (a.fields[i].name == b.fields[k].name && a.bytes[i] != b.bytes[k]) return false;
    return true;
}

/// `Sparse<2, float, uint2(8, 8)>(extent {64, 64}, capacity 5)`
std::string call_text(const std::string& type, const std::vector<FiledValue>& values) {
    std::string text;
    for (const FiledValue& value : values)
        if (value.is_argument) text += (text.empty() ? "" : ", ") + value.name + " " + value_text(value);
    return type + "(" + text + ")";
}
std::string call_text(const FiledPart& part) { return call_text(part.type, part.values); }
std::string call_text(const Part& part) {
    std::vector<FiledValue> values;
    for (const Value& value : part.values) values.push_back(filed_value(value));
    return call_text(part.type, values);
}

[[noreturn]] void throw_other(const std::string& problem, const std::string& where, const std::string& filed,
                              const std::string& here, const std::string& remedy) {
    throw Error(ErrorCode::wrong_argument, problem, where, "the file has " + filed + ", the program " + here, remedy);
}

constexpr const char* keep_declaration =
    "keep the old declaration under another name, load a structure of it, and move its elements by a pipeline: "
    "docs/how-to/files.md, After the declaration changed";

const FiledPart* find_part(const FiledPart& filed, const std::string& name) {
    const auto found = std::ranges::find(filed.parts, name, &FiledPart::name);
    return found == filed.parts.end() ? nullptr : &*found;
}
const FiledMemory* find_memory(const FiledPart& filed, const std::string& name) {
    const auto found = std::ranges::find(filed.memories, name, &FiledMemory::name);
    return found == filed.memories.end() ? nullptr : &*found;
}

void require_same_image(const FiledMemory& filed, const Plane& plane, const std::string& what) {
    const MemoryDescription& made = plane.memory->description();
    if (filed.kind != name_of(made.kind) || filed.format != name_of(made.format))
        throw_other("an image has another kind or format in the file", what, filed.kind + "<" + filed.format + ">",
                    std::string(name_of(made.kind)) + "<" + name_of(made.format) + ">", keep_declaration);
}

void report_fields(const FiledMemory& filed, const std::vector<Field>& fields, const std::string& what,
                   LoadReport& report) {
    const auto note = [](std::vector<std::string>& list, const std::string& name) {
        if (std::ranges::find(list, name) == list.end()) list.push_back(name);
    };
    for (const Field& field : fields)
        if (!find_field(filed, field, what)) note(report.added, what + "." + field.name);
    for (const Field& field : filed.fields)
        if (std::ranges::none_of(fields, [&](const Field& own) { return find_field(filed, own, what) == &field; }))
            note(report.removed, what + "." + field.name);
}

std::vector<Field> fields_of(const StoredMemory& memory) {
    std::vector<Field> fields;
    for (const Plane& plane : memory.planes)
        fields.insert(fields.end(), plane.type.fields.begin(), plane.type.fields.end());
    return fields;
}

/// Whether states of the two mean the same: they differ at most in the types of elements and in their layout.
bool means_same(const FiledPart& filed, const Part& part) { return filed.type == part.type || filed.key == part.key; }

/// Checks a structure and all of its parts, each against the one of its name.
void require_same(const FiledPart& filed, const Part& part, const std::string& what, LoadReport& report) {
    if (!means_same(filed, part))
        throw_other("a structure has another type in the file", what, filed.type, part.type, keep_declaration);
    for (const Value& value : part.values) {
        const FiledValue* const other = find_value(filed, value.name);
        if (!other)
            throw_other("a structure keeps other values", what, "no value " + value.name, "one", keep_declaration);
        for (const Field& field : value.type.fields) {
            const auto same = std::ranges::find(other->fields, field.name, &Field::name);
            if (same != other->fields.end() && type_text(*same) != type_text(field))
                throw_other("a value has another type in the file", what + "." + value.name, type_text(*same),
                            type_text(field), keep_declaration);
        }
    }
    for (const StoredMemory& memory : part.memories) {
        const std::string path = what + "." + memory.name;
        const FiledMemory* const other = find_memory(filed, memory.name);
        if (!other || other->is_image != memory.is_image)
            throw_other("a structure has other memories", path, other ? "one of another kind" : "none of this name",
                        "it", keep_declaration);
        if (memory.is_image) require_same_image(*other, memory.planes[0], path);
        else report_fields(*other, fields_of(memory), path, report);
    }
    for (const Part& inner : part.parts) {
        const FiledPart* const other = find_part(filed, inner.name);
        if (!other)
            throw_other("a structure has other members", what + "." + inner.name, "none of this name", "it",
                        keep_declaration);
        require_same(*other, inner, what + "." + inner.name, report);
    }
}

bool has_equal_arguments(const FiledPart& filed, const Part& part) {
    return std::ranges::all_of(part.values, [&](const Value& value) {
        const FiledValue* const other = find_value(filed, value.name);
        return !value.is_argument || (other && has_equal_fields(*other, filed_value(value)));
    });
}

/// Whether all that the structure has are elements that lie by address, in the file and in the program.
bool is_by_address(const FiledPart& filed, const Part& part) {
    return part.elements && part.parts.empty() && part.memories.size() == 1 && filed.parts.empty() &&
           filed.memories.size() == 1 && filed.memories[0].is_by_address &&
           filed.memories[0].shape.size() == part.elements->rank;
}

}  // namespace

const Field* find_field(const FiledMemory& memory, const Field& field, const std::string& what) {
    auto found = std::ranges::find(memory.fields, field.name, &Field::name);
    if (found == memory.fields.end()) found = std::ranges::find(memory.fields, field.former, &Field::name);
    if (found == memory.fields.end()) return nullptr;
    if (found->scalar != field.scalar || found->shape != field.shape)
        throw_other("a field has another type in the file", what + (field.name.empty() ? "" : "." + field.name),
                    type_text(*found), type_text(field),
                    "give the field another name, load, and convert the numbers of a structure with the old type");
    return &*found;
}

const FiledValue* find_value(const FiledPart& part, const std::string& name) {
    const auto found = std::ranges::find(part.values, name, &FiledValue::name);
    return found == part.values.end() ? nullptr : &*found;
}

void set_value(const Value& value, const FiledValue& filed) {
    for (const Field& field : value.type.fields)
        for (std::size_t i = 0; i < filed.fields.size(); ++i)
            if (filed.fields[i].name == field.name && filed.bytes[i].size() == bytes_in_memory(field))
                std::memcpy(static_cast<std::byte*>(value.data) + field.offset, filed.bytes[i].data(),
                            filed.bytes[i].size());
}

LoadWay match(const FiledPart& filed, const Part& part, const std::string& file, LoadReport& report) {
    const std::string where = file + ", " + part.name;
    const bool is_same = means_same(filed, part) && has_equal_arguments(filed, part);
    if (is_by_address(filed, part)) {
        report_fields(filed.memories[0], part.elements->type.fields, part.name, report);
        report.is_by_address = !is_same;
        return is_same && part.elements->is_row_major ? LoadWay::as_it_was : LoadWay::by_address;
    }
    if (!means_same(filed, part))
        throw_other("the file has a structure of another type", where, call_text(filed), call_text(part),
                    keep_declaration);
    if (!is_same)
        throw_other("the structure was saved with other arguments", where, call_text(filed), call_text(part),
                    "make the structure with the file's arguments, as glift::load<S>(path, name, device) does");
    require_same(filed, part, part.name, report);
    return LoadWay::as_it_was;
}

}  // namespace glift::files
