// One field of a memory in HDF5: a chunked dataset, whose chunks are written and read past HDF5's filters. Chunks of
// zeros are left out.
#pragma once

#include "descriptor.h"
#include "direct_writer.h"
#include "hdf5_handle.h"
#include "pieces.h"
#include "tiling.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glift::files {

/// The axes of a chunk or of a dataset in HDF5: those of the grid, then those of the field.
std::vector<hsize_t> with_field(const std::vector<std::uint64_t>& grid, const Field& field);

/// The chunks of a file being written: where they lie, and their way to the disk. HDF5 writes a file in memory, from
/// which the chunks are taken; what else it wrote follows at the end. HDF5 versions differ in whether the addresses
/// that they give count the user block; the first chunk that is found in the file says it.
class DataMap {
public:
    /// `from`: what HDF5 writes; `to`: the file on the disk, or the same.
    DataMap(const Descriptor& from, const Descriptor& to) : from_(from), to_(to), writer_(to) {}

    /// Moves bytes that were written where HDF5 says `address`.
    void add(std::uint64_t address, std::span<const std::byte> bytes);
    /// Moves all else; HDF5 has closed its file.
    void finish();
    const std::vector<DataRange>& ranges() const { return ranges_; }
    const KnownHashes& hashes() const { return hasher_.hashes(); }

private:
    bool lies_at(std::uint64_t offset, std::span<const std::byte> bytes) const;
    void move(std::uint64_t begin, std::uint64_t end) const;

    const Descriptor &from_, &to_;
    DirectWriter writer_;
    PieceHasher hasher_;
    std::optional<std::uint64_t> shift_;
    std::vector<DataRange> ranges_;
};

class NewDataset {
public:
    /// `is_shown`: which axes of the tiling's grid the dataset has; the others have length 1.
    NewDataset(hid_t file, const std::string& path, const Field& field, const Tiling& tiling,
               const std::vector<bool>& is_shown);

    /// Writes one chunk from the packed numbers of its elements.
    void write(const Batch& batch, std::span<const std::byte> packed, DataMap& map);

private:
    Field field_;
    std::vector<bool> is_shown_;
    std::size_t chunk_bytes_ = 0;
    Id dataset_;
    std::vector<std::byte> padded_;
};

/// What is to be added to the addresses that HDF5 gives (DataMap) for the place in the file; learned from the first
/// chunk that says it.
struct AddressShift {
    std::optional<std::uint64_t> known;
    /// `chunk`: what HDF5 reads where it says `address`.
    void learn(std::uint64_t address, std::span<const std::byte> chunk, Pieces& pieces);
};

class StoredDataset {
public:
    StoredDataset(hid_t file, const std::string& path, const Field& field, const std::vector<std::uint64_t>& shape,
                  const std::vector<bool>& is_shown, const std::string& file_name);

    /// As it was tiled when it was written.
    const Tiling& tiling() const { return tiling_; }
    /// Verifies and reads the packed numbers of a chunk's elements.
    void read(const Batch& batch, std::span<std::byte> packed, Pieces& pieces, AddressShift& shift);

private:
    Field field_;
    std::vector<bool> is_shown_;
    Tiling tiling_;
    std::size_t chunk_bytes_ = 0;
    Id dataset_;
    std::vector<std::byte> padded_;
};

}  // namespace glift::files
