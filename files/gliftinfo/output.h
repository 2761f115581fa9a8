// Files that gliftinfo writes.
#pragma once

#include "content.h"

#include <cstdio>
#include <span>
#include <string>

namespace gliftinfo {

/// A file that is written from its begin to its end. Functions throw wrong_argument where that fails.
class Output {
public:
    explicit Output(const std::string& path);
    Output(const Output&) = delete;
    ~Output();
    void write(std::span<const std::byte> bytes);
    void write(const std::string& text);
    void close();

private:
    std::string path_;
    std::FILE* file_;
};

/// Called with the bytes that were read since its last call.
using Progress = std::function<void(std::uint64_t bytes)>;

/// A NumPy array: the axes of the dataset, then those of the field.
void write_npy(glift::files::VerifiedFile& file, const Content& content, const std::string& to,
               const Progress& progress);
/// VTK image data: elements by address, on up to three axes, as point data. Throws wrong_argument for other content.
void write_vti(glift::files::VerifiedFile& file, const Content& content, const std::string& to,
               const Progress& progress);
/// A NanoVDB grid of floats: the elements of a dense grid of three axes, or those of the resident pages of a sparse
/// one, as active voxels. Holds the grid in the host's memory. Throws wrong_argument for other content, and where
/// gliftinfo was built without NanoVDB.
void write_nvdb(glift::files::VerifiedFile& file, const Content& content, const std::string& to,
                const Progress& progress);

}  // namespace gliftinfo
