// Words of a SPIR-V module: its instructions in order, and new ones at its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace glift::detail {

constexpr std::size_t spirv_header_words = 5, spirv_bound_word = 3;

using SpirvWords = std::span<const std::uint32_t>;

/// Calls visit(op, words) for each instruction; the first word holds the operation and the number of words.
template <class Visit> void for_each_instruction(SpirvWords spirv, Visit&& visit) {
    for (std::size_t at = spirv_header_words; at < spirv.size(); at += spirv[at] >> 16)
        visit(spirv[at] & 0xffffu, spirv.subspan(at, spirv[at] >> 16));
}

inline std::uint32_t first_word(std::uint32_t op, std::size_t words) {
    return static_cast<std::uint32_t>(words) << 16 | op;
}

inline void append(std::vector<std::uint32_t>& module, std::uint32_t op,
                   std::initializer_list<std::uint32_t> operands) {
    module.push_back(first_word(op, operands.size() + 1));
    module.insert(module.end(), operands);
}

}  // namespace glift::detail
