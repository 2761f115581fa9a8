// The cases of the bench: a generated pass and its hand-written twin over the same memories.
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
    std::function<std::vector<std::byte>()> result;  ///< what the last pass wrote
    std::function<void()> clear;                     ///< clears it
    std::vector<std::uint32_t> generated_spirv, handwritten_spirv;
};

/// `scale` 1 is for lavapipe; larger devices need more work to be measured.
std::vector<Case> make_cases(const glift::Device& device, std::uint32_t scale);

}  // namespace bench
