#include "text.h"

#include <glift/inspected_values.h>

#include <array>
#include <charconv>

namespace glift::detail {

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1024) return std::to_string(bytes) + " bytes";
    constexpr std::array units = {"KiB", "MiB", "GiB", "TiB"};
    double value = static_cast<double>(bytes) / 1024;
    std::size_t unit = 0;
    for (; value >= 1024 && unit + 1 < units.size(); ++unit) value /= 1024;
    char text[64];
    char* const end = std::to_chars(text, std::end(text), value, std::chars_format::fixed, 1).ptr;
    return std::string(text, end) + " " + units[unit] + " (" + std::to_string(bytes) + " bytes)";
}

std::string number_text(double value, int digits) {
    char text[64];
    return {text, std::to_chars(text, std::end(text), value, std::chars_format::general, digits).ptr};
}

std::string kernel_text(const Kernel& kernel) {
    return std::string("kernel ") + kernel.name + " (" + kernel.file + ":" + std::to_string(kernel.line) + ")";
}

const char* kind_text(MemoryKind kind) {
    switch (kind) {
    case MemoryKind::buffer: return "buffer";
    case MemoryKind::image1d: return "image1d";
    case MemoryKind::image2d: return "image2d";
    case MemoryKind::image3d: return "image3d";
    case MemoryKind::imagecube: return "imagecube";
    case MemoryKind::image2darray: return "image2darray";
    }
    return "memory";
}

std::string shape_text(const MemoryDescription& description) {
    std::string text = kind_text(description.kind);
    if (description.kind != MemoryKind::buffer) {
        text += " " + std::to_string(description.extent[0]) + " x " + std::to_string(description.extent[1]) + " x " +
                std::to_string(description.extent[2]);
    }
    return text + ", " + size_text(description.bytes);
}

std::string memory_text(const MemoryDescription& description) {
    return std::string("memory ") + (*description.name ? description.name : "without a name") + " (" +
           shape_text(description) + ")";
}

const char* form_text(FormName form) {
    switch (form) {
    case FormName::direct: return "direct";
    case FormName::general: return "general";
    }
    return "";
}

}  // namespace glift::detail
