// Paint in a file: header, table of pages, pages, with checksums.
//
// Little-endian words of 32 bits. Header (64 bytes): "GLIFT3DP", version 1, levels, cells of a page, number of pages,
// the ground's colour (three floats), reserved zeros, the checksum of the header's words before it. Then the numbers of
// the pages, ascending, and their checksum; then for each page its texels (17^3, RGBA8, x fastest) and their checksum.
// Checksums are CRC-32 (zlib's).
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

/// Writes a new file beside it, which takes its name when it is whole: whatever happens, `path` is the old file or the
/// new one. Throws std::runtime_error, which names the file and what is wrong.
void save(const std::string& path, const glift::Device& device, journal::Octree& octree, const glift::float3& ground);

/// What it was made with. Throws as `load`.
Header read_header(const std::string& path);

/// Whether these are the words of a file of so many bytes that `load` reads. Throws as it, naming `path`.
Header check(const std::string& path, std::span<const glift::uint> words, std::size_t bytes);

/// Into an octree of as many levels, whose pages are gone then. The file is read and checked whole before anything is
/// changed: throws std::runtime_error where it is truncated, altered, of another version, or larger than the octree.
Header load(const std::string& path, const glift::Device& device, journal::Octree& octree);

}  // namespace paint_file
