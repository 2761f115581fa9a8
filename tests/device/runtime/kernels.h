// Hand-written kernels in the form that gliftc generates: GLSL in shaders/, C++ in kernels.cpp. Braces list parameters.
#pragma once

#include <glift/glift.h>

#include <cstring>
#include <vector>

namespace kernels {

extern const glift::Kernel scale;         ///< g = factor * f, in both forms; {size, factor}
extern const glift::Kernel add_in_place;  ///< g = 2 g + amount; {size, amount}
extern const glift::Kernel store_value;   ///< g = value; {size, value}
extern const glift::Kernel number_lanes;  ///< g = the number of the lane in its subgroup; {size, 0}
extern const glift::Kernel mark_grid;   ///< adds 1 + y at (x, y, z) of a 3-D grid; on Vulkan in the general form only;
                                        ///< {size[3], base[3]}
extern const glift::Kernel image_step;  ///< samples one image and stores to another; {size[2]}
extern const glift::Kernel report;      ///< g[i] = i for i < 10; reports an error if there is an element 10; {size}

/// The direct form takes the first eight bytes.
struct ScaleParameters {
    std::uint32_t size;
    float factor;
    std::uint64_t addresses[2] = {};  ///< filled in by the runtime
};
struct AddParameters {
    std::uint32_t size, amount;
};

template <class T> std::span<const std::byte> bytes_of(const T& value) { return std::as_bytes(std::span(&value, 1)); }

template <class T> std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

template <class T> std::vector<T> values_of(std::span<const std::byte> bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

glift::Memory buffer(const glift::Device& device, const char* name, std::uint64_t bytes);

/// Takes the direct form where Commands::can_be_direct allows it, else the general one, as generated code does for
/// whole structures.
void run_scale(const glift::Commands& commands, const glift::Memory& f, const glift::Memory& g, std::uint32_t size,
               float factor);
void run_add(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size, std::uint32_t amount);
void run_lanes(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size);
void run_store(const glift::Commands& commands, const glift::Memory& g, std::uint32_t size, std::uint32_t value);

template <class T> std::vector<T> read(const glift::Device& device, const glift::Memory& memory, std::size_t count) {
    return values_of<T>(device.commands().download(memory, 0, count * sizeof(T)).get());
}

}  // namespace kernels
