#include "commands.h"
#include "content.h"

#include <cstdio>

namespace gliftinfo {

using namespace glift::files;

namespace {

std::string bytes_text(std::uint64_t bytes) {
    const char* const units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
    double amount = static_cast<double>(bytes);
    unsigned unit = 0;
    while (amount >= 1024 && unit + 1 < std::size(units)) amount /= 1024, ++unit;
    char text[40];
    std::snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.1f %s", amount, units[unit]);
    return text;
}

std::string shape_text(const std::vector<std::uint64_t>& axes) {
    std::string text;
    for (const std::uint64_t along : axes) text += (text.empty() ? "" : " x ") + std::to_string(along);
    return text;
}

/// The values of a structure and of its parts, indented by depth.
void print_part(const FiledPart& part, int depth) {
    std::printf("%*s%s  %s%s\n", 2 * depth, "", part.name.c_str(), part.type.c_str(),
                part.role == "given" ? "  (given)" : "");
    for (const FiledValue& value : part.values)
        std::printf("%*s%s%s = %s\n", 2 * depth + 4, "", value.name.c_str(), value.is_argument ? "" : " (host)",
                    value_text(value).c_str());
    for (const FiledPart& inner : part.parts) print_part(inner, depth + 1);
}

}  // namespace

int print(const std::string& name) {
    VerifiedFile file(name);
    for (const std::string& structure : file.names()) {
        const FiledPart part = file.schema(structure);
        print_part(part, 0);
        std::uint64_t bytes = 0, stored = 0;
        for (const Content& content : contents_of(part)) {
            const std::uint64_t in_file = stored_bytes(file, content);
            std::printf("  %-40s %-14s %-24s %s, %s in the file\n", content.path.c_str(),
                        type_text(content.field).c_str(), shape_text(content.axes()).c_str(),
                        bytes_text(content.bytes()).c_str(), bytes_text(in_file).c_str());
            bytes += content.bytes(), stored += in_file;
        }
        std::printf("  all: %s, %s in the file\n", bytes_text(bytes).c_str(), bytes_text(stored).c_str());
    }
    return 0;
}

}  // namespace gliftinfo
