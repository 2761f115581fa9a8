// What a profile says of one pass or copy, apart from its time.
#pragma once

#include <glift/commands.h>
#include <glift/pass.h>

#include <cstdint>
#include <span>

namespace glift::detail {

struct Work {
    const char* name;
    const char* file = "";
    std::uint32_t line = 0;
    std::uint64_t bytes = 0;
    bool has_uncounted_bytes = false;
};

/// Bytes: of the elements that the call visits (PassProfile::bytes).
Work work_of(const Kernel& kernel, const Call& call);
Work work_of(const char* kind, std::span<const CopyRegion> regions);
/// `image`: of whose texels the regions consist.
Work work_of(const char* kind, const Memory& image, std::span<const ImageRegion> regions);
Work work_of(const char* kind, const Memory& image, std::span<const ImageCopyRegion> regions);

}  // namespace glift::detail
