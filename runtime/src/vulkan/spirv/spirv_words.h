// Copies a kernel's SPIR-V, which programs may store as a char32_t literal, to words.
#pragma once

#include <glift/kernel.h>

#include <cstring>
#include <vector>

namespace glift::detail {

inline std::vector<std::uint32_t> words_of(const Spirv& spirv) {
    std::vector<std::uint32_t> words(spirv.count());
    if (!words.empty()) std::memcpy(words.data(), spirv.words(), words.size() * sizeof(std::uint32_t));
    return words;
}

}  // namespace glift::detail
