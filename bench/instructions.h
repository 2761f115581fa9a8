// Counts the instructions of a shader.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bench {

std::vector<std::uint32_t> read_spirv(const std::string& path);

/// Instructions inside functions after spirv-opt -O, without the line numbers of debug information.
std::size_t instructions_of(const std::vector<std::uint32_t>& spirv);

struct Shader {
    std::vector<std::uint32_t> words;
    std::map<std::uint32_t, std::uint32_t> constants;  ///< values of specialisation constants
};

/// The same, after replacing the shader's specialisation constants by their values.
std::size_t instructions_of(const Shader& shader);

}  // namespace bench
