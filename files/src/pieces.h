// The hashes by which a file is verified before HDF5 sees any byte of it.
//
//     bytes 0 to 511        the user block: magic, version, sizes, the hash of the list, its own hash
//     up to `end`           HDF5's file, in pieces of 1 MiB
//     from `end` on         the list: a hash of 16 bytes for each piece, then a bit for each piece, 1 where it holds
//                           more than elements
//
// Numbers are little-endian. Hashes are XXH3-128 in its canonical form. They find damage, not forgery.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glift::files {

inline constexpr std::uint64_t user_block_bytes = 512;
inline constexpr std::uint64_t piece_bytes = 1 << 20;
inline constexpr std::uint32_t format_version = 1;

using Hash = std::array<std::byte, 16>;
Hash hash_of(std::span<const std::byte> bytes);

/// Where the bytes of a file come from.
struct ByteSource {
    std::string name;  ///< for errors
    std::uint64_t size = 0;
    /// Reads from an offset; returns how many bytes there were.
    std::function<std::size_t(std::uint64_t offset, std::span<std::byte> to)> read;
    /// The same for bytes that are read in their order and once, as elements are; may be empty.
    std::function<std::size_t(std::uint64_t offset, std::span<std::byte> to)> read_once{};
};

/// The pieces of a file. All functions throw bad_file where the file is not what was written.
class Pieces {
public:
    /// Reads and verifies the user block and the list.
    explicit Pieces(ByteSource source);

    std::uint64_t count() const { return hashes_.size(); }
    /// Verifies the pieces with more than elements.
    void verify_metadata();
    /// Verifies the pieces in which these bytes lie. Each is read once.
    void verify(std::uint64_t offset, std::uint64_t bytes);
    /// Reads bytes, and verifies all pieces in which they lie.
    void read(std::uint64_t offset, std::span<std::byte> to);
    void verify_all();
    /// The numbers of the pieces that are not what was written. `progress` is called with the bytes of each piece.
    std::vector<std::uint64_t> damaged(const std::function<void(std::uint64_t bytes)>& progress = {});
    std::uint64_t end() const { return end_; }
    /// Files with the same bytes have the same.
    const Hash& hash_of_list() const { return hash_of_list_; }

private:
    enum class Reading : std::uint8_t { again, once };
    void verify_piece(std::uint64_t piece, Reading reading);
    bool is_whole(std::uint64_t piece, Reading reading);
    void fill_buffer(std::uint64_t piece, Reading reading);
    std::size_t read_source(std::uint64_t offset, std::span<std::byte> to, Reading reading);
    void require_inside(std::uint64_t offset, std::uint64_t bytes) const;
    [[noreturn]] void throw_damaged(std::uint64_t piece) const;

    ByteSource source_;
    std::uint64_t end_ = 0;
    Hash hash_of_list_{};
    std::vector<Hash> hashes_;
    std::vector<bool> has_metadata_, is_verified_;
    std::vector<std::byte> buffer_;  ///< the bytes of the piece `buffered_`
    std::uint64_t buffered_ = UINT64_MAX;
};

/// What of a file being written holds elements alone.
struct DataRange {
    std::uint64_t begin, end;
};

/// The hashes of pieces by their number.
using KnownHashes = std::map<std::uint64_t, Hash>;

/// Hashes the pieces of a file as it is written: those that lie in runs of bytes of which each begins where the one
/// before it ends.
class PieceHasher {
public:
    PieceHasher();
    ~PieceHasher();
    PieceHasher(const PieceHasher&) = delete;

    void add(std::uint64_t offset, std::span<const std::byte> bytes);
    const KnownHashes& hashes() const { return hashes_; }

private:
    struct State;
    std::unique_ptr<State> state_;  ///< of the piece whose begin the last run had
    std::uint64_t next_ = 0;        ///< where that run ended; 0: it ended with a piece
    KnownHashes hashes_;
};

/// The list for a file whose HDF5 part ends at `end`: the bytes that follow it, and the user block. Pieces whose hash
/// is not known are read.
struct Seal {
    std::vector<std::byte> list;
    std::array<std::byte, user_block_bytes> user_block;
};
Seal seal_of(const ByteSource& source, std::uint64_t end, std::vector<DataRange> data, const KnownHashes& known);

}  // namespace glift::files
