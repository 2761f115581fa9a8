// NumPy's .npy files as arrays of float.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace npy {

/// An N-D array in Glift's order: the first axis is contiguous. The extent is NumPy's shape reversed, whether the file
/// has C or Fortran order: element [k, j, i] of a NumPy array of shape (nz, ny, nx) has the address (i, j, k).
struct Array {
    std::vector<std::uint32_t> extent;
    std::vector<float> values;
};

/// Reads a file of format version 1 to 3, in C or Fortran order and either byte order. Elements may be float16,
/// float32, float64, bool and integers of 8 to 64 bits; they are converted to float. Throws std::runtime_error, which
/// names the file and what is wrong.
Array read(const std::string& path);

/// Writes a float32 file in C order. Throws std::runtime_error.
void write(const std::string& path, const Array& array);

/// The extent as text, first axis first: "64 x 64 x 32".
std::string text_of(const std::vector<std::uint32_t>& extent);

}  // namespace npy
