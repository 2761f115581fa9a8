#include "wide.h"

#include <cstdlib>

namespace glift::detail {

namespace {

std::uint64_t first_wide_count() {
    static const char* const text = std::getenv("GLIFT_WIDE_ELEMENTS");
    static const std::uint64_t count = text && *text ? std::strtoull(text, nullptr, 10) : std::uint64_t{1} << 32;
    return count;
}

}  // namespace

bool counts_in_64_bits(const Kernel& kernel, std::span<const Memory> memories) {
    for (std::size_t k = 0; k < memories.size(); ++k) {
        const Binding& binding = kernel.bindings[k];
        if (binding.kind != MemoryKind::buffer) continue;
        if (memories[k].description().bytes / binding.element_bytes >= first_wide_count()) return true;
    }
    return false;
}

}  // namespace glift::detail
