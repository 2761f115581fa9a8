// The numbers in a file, by their paths.
#pragma once

#include "dataset.h"
#include "verified_file.h"

#include <functional>
#include <string>
#include <vector>

namespace gliftinfo {

/// A dataset: one field of a memory, or a level of an image.
struct Content {
    std::string path;  ///< `grid/data/velocity`
    glift::files::Field field;
    std::vector<std::uint64_t> shape;  ///< as tiled; of images four axes
    std::vector<bool> is_shown;        ///< which of these the dataset has
    bool is_by_address = false;        ///< axes are those of addresses, the slowest first

    /// The axes of the dataset, the slowest first, without those of the field.
    std::vector<std::uint64_t> axes() const;
    std::uint64_t bytes() const;
};

/// All datasets of a structure, each once.
std::vector<Content> contents_of(const glift::files::FiledPart& part);
/// Throws wrong_argument where there is none at the path.
Content content_at(const glift::files::VerifiedFile& file, const std::string& path);

/// Reads the numbers, in row-major order, in parts: each part follows the one before it.
void read(glift::files::VerifiedFile& file, const Content& content,
          const std::function<void(std::span<const std::byte>)>& part);
/// The bytes of the chunks that the file has of it.
std::uint64_t stored_bytes(const glift::files::VerifiedFile& file, const Content& content);

}  // namespace gliftinfo
