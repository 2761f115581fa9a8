// The header of NumPy's .npy files.
#pragma once

#include "pieces.h"

#include <glift/files/element_type.h>

#include <cstdint>
#include <string>
#include <vector>

namespace glift::files {

struct NpyHeader {
    Scalar scalar = Scalar::float32;  ///< bools are `flag`: a byte each
    bool is_fortran = false;          ///< the first axis is contiguous, not the last one
    std::vector<std::uint64_t> shape;
    std::uint64_t begin = 0;  ///< the byte at which the numbers begin

    std::uint64_t numbers() const;
};

/// Reads a header of version 1.0, 2.0 or 3.0. Throws bad_file where it is none, where its numbers are big-endian or of
/// a type that the language does not have, and where the file does not have as many bytes as the shape says.
NpyHeader parse_npy(const ByteSource& source);

/// The header of version 1.0: its length is a multiple of 64.
std::string npy_header(Scalar scalar, const std::vector<std::uint64_t>& shape);

/// `float32`, `bool`: as NumPy names the type.
std::string numpy_name(Scalar scalar);

}  // namespace glift::files
