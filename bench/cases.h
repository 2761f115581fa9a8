// The cases of a bench: a generated pass and its hand-written "twin", which does the same over the same memories.
#pragma once

#include <glift/glift.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bench {

struct Case {
    std::string name;
    std::uint64_t elements = 0;
    std::function<void(const glift::Commands&)> generated, handwritten;
    std::function<std::vector<std::byte>()> result;                 ///< reads the output of the last pass
    std::function<void()> clear;                                    ///< overwrites the output
    std::vector<std::uint32_t> generated_spirv, handwritten_spirv;  ///< empty in bench_lookups
};

/// All cases of glift_bench. The work grows with `scale`: 1 suits lavapipe; faster devices need more to be measured.
std::vector<Case> make_cases(const glift::Device& device, std::uint32_t scale);

}  // namespace bench
