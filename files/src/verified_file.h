// A file that is verified before HDF5 opens it.
#pragma once

#include "descriptor.h"
#include "hdf5_handle.h"
#include "pieces.h"
#include "schema.h"

#include <string>
#include <vector>

namespace glift::files {

class VerifiedFile {
public:
    /// Verifies the user block, the list of hashes and all metadata. Throws bad_file.
    explicit VerifiedFile(std::string path);
    VerifiedFile(const VerifiedFile&) = delete;
    ~VerifiedFile();

    const std::string& path() const { return path_; }
    hid_t hdf5() const { return hdf5_; }
    Pieces& pieces() { return pieces_; }
    /// Of the structures, in alphabetical order.
    std::vector<std::string> names() const;
    /// Throws wrong_argument where the file has no structure of this name.
    FiledPart schema(const std::string& name) const;

private:
    std::string path_;
    Descriptor descriptor_;
    Pieces pieces_;
    Id hdf5_;
};

/// A file as a source of bytes; the descriptor must outlive it.
ByteSource source_of(const Descriptor& file);

}  // namespace glift::files
