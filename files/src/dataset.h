// One field of a memory in HDF5: a chunked dataset, whose chunks are written and read past HDF5's filters. Chunks of
// zeros are left out.
#pragma once

#include "descriptor.h"
#include "direct_writer.h"
#include "hdf5_handle.h"
#include "pieces.h"
#include "tiling.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glift::files {

/// The axes of a chunk or of a dataset in HDF5: those of the grid, then those of the field.
std::vector<hsize_t> with_field(const std::vector<std::uint64_t>& grid, const Field& field);

/// The bytes of a file being written: HDF5's metadata goes to the file at once; chunks are hashed, and written by a
/// DirectWriter. What fails is kept for rethrow(), and HDF5 is not told: it crashes at the program's end after it could
/// not close a file.
class DataMap : public std::enable_shared_from_this<DataMap> {
public:
    explicit DataMap(const Descriptor& file) : file_(file), writer_(std::in_place, file) {}

    /// From now on HDF5 may write and nothing happens: a file that it could not close it closes at the program's end.
    void discard() { is_discarded_ = true, writer_.reset(); }

    /// The next write of exactly these bytes in memory is that of a chunk.
    void expect(std::span<const std::byte> chunk) { expected_ = chunk; }
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void read(std::uint64_t offset, std::span<std::byte> to);
    void resize(std::uint64_t bytes);
    /// Waits until all chunks are in the file. Throws wrong_argument where that failed.
    void finish() { writer_->finish(); }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }
    const std::vector<DataRange>& ranges() const { return ranges_; }
    const KnownHashes& hashes() const { return hasher_.hashes(); }

private:
    template <class Run> void attempt(Run run);

    const Descriptor& file_;
    std::optional<DirectWriter> writer_;
    bool is_discarded_ = false;
    PieceHasher hasher_;
    std::span<const std::byte> expected_;
    std::vector<DataRange> ranges_;
    std::exception_ptr failure_;
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

/// What is to be added to the addresses that HDF5 gives for the place in the file, since its versions differ in whether
/// they count the user block; learned from the first chunk that says it.
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
