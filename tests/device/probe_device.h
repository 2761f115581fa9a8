// The least Vulkan that runs one compute shader over three input buffers and one output buffer.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace probe {

/// Opens the first Vulkan device whose name contains `name` (any device where it is empty), says which, and what it declares
/// about float arithmetic. Ends the program with a message where that fails.
class Machine {
public:
    explicit Machine(const std::string& name);
    ~Machine();

    /// What `shader` (specialisation constant 0 = operation) makes of the inputs.
    std::vector<std::uint32_t> run(const std::vector<std::uint32_t>& spirv, std::uint32_t operation,
                                   const std::vector<std::vector<std::uint32_t>>& inputs);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace probe
