// Paint in a file: a header, the numbers of the octree's resident pages, and their texels, all with checksums.
//
// Little-endian words of 32 bits. Header (64 bytes): "GLIFT3DP", version 2, levels, cells along a page's side, pages,
// the ground's colour (three floats, 0 to 1), reserved zeros, a checksum of these. Then the pages' numbers (level by
// level, coarsest first, x fastest), ascending, none without the coarser pages that it lies in, and their checksum;
// then for each page its texels (17^3, RGBA8, x fastest) and the checksum of its number and texels. Checksums are
// CRC-32 (zlib's). Files of version 1, in which pages could change places unnoticed, are refused.
#pragma once

#include "journal.glift.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace paint_file {

struct Header {
    glift::uint levels = 0, pages = 0;
    glift::float3 ground;
};

/// Saves the octree's resident pages. Writes a new file beside `path`, which takes that name when it is whole: whatever
/// happens, `path` is the old file or the new one. Throws std::runtime_error, which names the file and what is wrong.
void save(const std::string& path, const glift::Device& device, journal::Octree& octree, const glift::float3& ground);

/// Makes the checks of `load` that need no octree, on the words of a file of `bytes` bytes, and returns its header.
/// Throws std::runtime_error, as `load` does for a file of the name `path`.
Header check(const std::string& path, std::span<const glift::uint> words, std::size_t bytes);

/// Loads the pages of a file into an octree, in place of those that it has. The file is read and checked whole before
/// anything is changed, its header before the rest is read: throws std::runtime_error if it cannot be read, is
/// truncated, altered or of another version, has another number of levels than the octree, or too many pages for it.
Header load(const std::string& path, const glift::Device& device, journal::Octree& octree);

}  // namespace paint_file
