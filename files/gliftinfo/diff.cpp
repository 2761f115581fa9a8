#include "commands.h"
#include "content.h"
#include "progress_line.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace gliftinfo {

using namespace glift::files;

namespace {

class Difference {
public:
    void note(const std::string& text) {
        std::printf("%s\n", text.c_str());
        is_found = true;
    }
    bool is_found = false;
};

void compare_values(const std::string& path, const FiledPart& a, const FiledPart& b, Difference& difference) {
    if (a.type != b.type) difference.note(path + ": " + a.type + " and " + b.type);
    for (const FiledValue& value : a.values) {
        const auto other = std::ranges::find(b.values, value.name, &FiledValue::name);
        if (other == b.values.end()) difference.note(path + "." + value.name + ": only in the first");
        else if (value.bytes != other->bytes)
            difference.note(path + "." + value.name + ": " + value_text(value) + " and " + value_text(*other));
    }
    for (const FiledPart& inner : a.parts) {
        const auto other = std::ranges::find(b.parts, inner.name, &FiledPart::name);
        if (other == b.parts.end()) difference.note(path + "/" + inner.name + ": only in the first");
        else compare_values(path + "/" + inner.name, inner, *other, difference);
    }
}

std::vector<std::byte> all_of(VerifiedFile& file, const Content& content, ProgressLine& line) {
    std::vector<std::byte> bytes;
    bytes.reserve(content.bytes());
    read(file, content, [&](std::span<const std::byte> part) {
        bytes.insert(bytes.end(), part.begin(), part.end());
        line.add(part.size());
    });
    return bytes;
}

void compare_numbers(VerifiedFile& first, VerifiedFile& second, const Content& a, const Content& b,
                     Difference& difference) {
    if (a.axes() != b.axes() || type_text(a.field) != type_text(b.field))
        return difference.note(a.path + ": other extent or type");
    std::vector<std::byte> x, y;
    {
        ProgressLine line("diff " + a.path, a.bytes() + b.bytes());
        x = all_of(first, a, line);
        y = all_of(second, b, line);
    }
    std::size_t differing = 0, first_at = 0;
    const std::size_t number = file_bytes(a.field.scalar);
    for (std::size_t i = 0; i + number <= x.size(); i += number)
        if (std::memcmp(x.data() + i, y.data() + i, number) != 0 && differing++ == 0) first_at = i / number;
    if (differing > 0)
        difference.note(a.path + ": " + std::to_string(differing) + " of " + std::to_string(x.size() / number) +
                        " numbers differ, the first one is number " + std::to_string(first_at));
}

void compare(VerifiedFile& first, VerifiedFile& second, const std::string& name, Difference& difference) {
    const FiledPart a = first.schema(name), b = second.schema(name);
    compare_values(name, a, b, difference);
    const std::vector<Content> others = contents_of(b);
    for (const Content& content : contents_of(a)) {
        const auto other = std::ranges::find(others, content.path, &Content::path);
        if (other == others.end()) difference.note(content.path + ": only in the first");
        else compare_numbers(first, second, content, *other, difference);
    }
    const std::vector<Content> own = contents_of(a);
    for (const Content& content : others)
        if (std::ranges::find(own, content.path, &Content::path) == own.end())
            difference.note(content.path + ": only in the second");
}

}  // namespace

int diff(const std::string& first_name, const std::string& second_name) {
    VerifiedFile first(first_name), second(second_name);
    Difference difference;
    const std::vector<std::string> names = first.names(), others = second.names();
    for (const std::string& name : names) {
        if (std::ranges::find(others, name) == others.end()) difference.note(name + ": only in the first");
        else compare(first, second, name, difference);
    }
    for (const std::string& name : others)
        if (std::ranges::find(names, name) == names.end()) difference.note(name + ": only in the second");
    return difference.is_found ? 1 : 0;
}

}  // namespace gliftinfo
