#include <glift/files/part.h>

#include <cstring>

namespace glift::files {

std::array<std::uint64_t, 3> ExtentField::get() const {
    std::array<std::uint64_t, 3> extent{};
    if (is_wide) std::memcpy(extent.data(), data, 8);
    for (unsigned i = 0; !is_wide && i < axes; ++i) {
        std::uint32_t along;
        std::memcpy(&along, static_cast<const std::byte*>(data) + 4 * i, 4);
        extent[i] = along;
    }
    return extent;
}

void ExtentField::set(const std::array<std::uint64_t, 3>& extent) const {
    if (is_wide) std::memcpy(data, extent.data(), 8);
    for (unsigned i = 0; !is_wide && i < axes; ++i) {
        const auto along = static_cast<std::uint32_t>(extent[i]);
        std::memcpy(static_cast<std::byte*>(data) + 4 * i, &along, 4);
    }
}

}  // namespace glift::files
