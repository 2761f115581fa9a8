#include "emit/spirv/strip.h"

#include <glslang/SPIRV/spirv.hpp>

#include <cstddef>

namespace gliftc::spirv {

namespace {

bool is_debug_info(std::uint32_t op) {
    switch (op) {
    case spv::OpSource:
    case spv::OpSourceContinued:
    case spv::OpSourceExtension:
    case spv::OpModuleProcessed:
    case spv::OpName:
    case spv::OpMemberName:
    case spv::OpString:
    case spv::OpLine:
    case spv::OpNoLine: return true;
    }
    return false;
}

}  // namespace

std::vector<std::uint32_t> without_debug_info(const std::vector<std::uint32_t>& words) {
    constexpr std::size_t header_words = 5;
    std::vector<std::uint32_t> result;
    result.reserve(words.size());
    for (std::size_t at = 0, count = header_words; at < words.size(); at += count) {
        if (at != 0) count = words[at] >> 16;
        if (at != 0 && is_debug_info(words[at] & 0xffffu)) continue;
        result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
                      words.begin() + static_cast<std::ptrdiff_t>(at + count));
    }
    return result;
}

}  // namespace gliftc::spirv
