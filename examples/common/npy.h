// NumPy's .npy files as arrays of float.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace npy {

/// An N-D array in Glift's order: the first axis is contiguous, so the extent is NumPy's shape reversed, whatever the
/// order of the file. Element [k, j, i] of a NumPy array of shape (nz, ny, nx) has the address (i, j, k).
struct Array {
    std::vector<std::uint32_t> extent;
    std::vector<float> values;
};

/// Reads a file of format version 1 to 3, C or Fortran order, either byte order: float16, float32, float64, bool and
/// the integers of 8 to 64 bits, converted to float. Throws std::runtime_error, which names the file and what is wrong.
Array read(const std::string& path);

/// Writes float32 in C order. Throws std::runtime_error.
void write(const std::string& path, const Array& array);

/// "64 x 64 x 32", first axis first.
std::string text_of(const std::vector<std::uint32_t>& extent);

}  // namespace npy
