#include "pieces.h"

#include "error.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace glift::files {

namespace {

static_assert(std::endian::native == std::endian::little);

/// As PNG's: the last bytes show that the file was moved as text.
constexpr std::array<unsigned char, 8> magic = {0x89, 'G', 'L', 'F', '\r', '\n', 0x1a, '\n'};

enum : std::size_t { at_version = 8, at_piece = 12, at_end = 16, at_list_hash = 32, at_own_hash = 496 };

template <class T> void put(std::span<std::byte> block, std::size_t at, T value) {
    std::memcpy(block.data() + at, &value, sizeof value);
}
template <class T> T get(std::span<const std::byte> block, std::size_t at) {
    T value;
    std::memcpy(&value, block.data() + at, sizeof value);
    return value;
}

std::uint64_t pieces_in(std::uint64_t end) { return (end - user_block_bytes + piece_bytes - 1) / piece_bytes; }

std::uint64_t list_bytes(std::uint64_t pieces) { return pieces * sizeof(Hash) + (pieces + 7) / 8; }

DataRange range_of(std::uint64_t piece, std::uint64_t end) {
    const std::uint64_t begin = user_block_bytes + piece * piece_bytes;
    return {begin, std::min(begin + piece_bytes, end)};
}

/// Whether bytes of the piece lie outside of all ranges, which are sorted.
bool has_metadata(const DataRange& piece, const std::vector<DataRange>& data) {
    std::uint64_t at = piece.begin;
    auto range = std::ranges::upper_bound(data, at, {}, &DataRange::begin);
    if (range != data.begin()) --range;
    for (; range != data.end() && range->begin <= at && at < piece.end; ++range) at = std::max(at, range->end);
    return at < piece.end;
}

Hash canonical(XXH128_hash_t number) {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, number);
    Hash hash;
    std::memcpy(hash.data(), canonical.digest, hash.size());
    return hash;
}

}  // namespace

Hash hash_of(std::span<const std::byte> bytes) { return canonical(XXH3_128bits(bytes.data(), bytes.size())); }

Pieces::Pieces(ByteSource source) : source_(std::move(source)) {
    std::array<std::byte, user_block_bytes> block;
    if (source_.read(0, block) != block.size())
        throw_bad(source_.name, "it is shorter than the 512 bytes it begins with");
    if (std::memcmp(block.data(), magic.data(), magic.size()) != 0)
        throw_bad(source_.name, "it does not begin as files of glift::save do");
    const std::span<const std::byte> hashed = std::span(block).first(at_own_hash);
    if (hash_of(hashed) != get<Hash>(block, at_own_hash)) throw_bad(source_.name, "its first 512 bytes are damaged");
    if (const auto version = get<std::uint32_t>(block, at_version); version != format_version)
        throw_bad(source_.name, "its format is version " + std::to_string(version) + ", this library reads version " +
                                    std::to_string(format_version));
    end_ = get<std::uint64_t>(block, at_end);
    if (get<std::uint32_t>(block, at_piece) != piece_bytes || end_ < user_block_bytes || end_ > source_.size)
        throw_bad(source_.name, "it has " + std::to_string(source_.size) + " bytes, of which " + std::to_string(end_) +
                                    " should precede the list of hashes: it is cut off");
    const std::uint64_t pieces = pieces_in(end_);
    if (list_bytes(pieces) != source_.size - end_)
        throw_bad(source_.name, "it has " + std::to_string(source_.size) + " bytes instead of " +
                                    std::to_string(end_ + list_bytes(pieces)) + ": it is cut off, or was appended to");
    std::vector<std::byte> list(source_.size - end_);
    if (source_.read(end_, list) != list.size() || hash_of(list) != get<Hash>(block, at_list_hash))
        throw_bad(source_.name, "its list of hashes is damaged");
    hash_of_list_ = hash_of(list);
    hashes_.resize(pieces);
    if (pieces > 0) std::memcpy(hashes_.data(), list.data(), pieces * sizeof(Hash));
    is_verified_.resize(pieces);
    has_metadata_.resize(pieces);
    for (std::uint64_t i = 0; i < pieces; ++i)
        has_metadata_[i] = (list[pieces * sizeof(Hash) + i / 8] >> (i % 8) & std::byte{1}) != std::byte{0};
}

std::size_t Pieces::read_source(std::uint64_t offset, std::span<std::byte> to, Reading reading) {
    return reading == Reading::once && source_.read_once ? source_.read_once(offset, to) : source_.read(offset, to);
}

void Pieces::fill_buffer(std::uint64_t piece, Reading reading) {
    if (buffered_ == piece) return;
    const DataRange range = range_of(piece, end_);
    buffered_ = UINT64_MAX;
    buffer_.resize(range.end - range.begin);
    if (read_source(range.begin, buffer_, reading) == buffer_.size()) buffered_ = piece;
}

bool Pieces::is_whole(std::uint64_t piece, Reading reading) {
    if (is_verified_[piece]) return true;
    fill_buffer(piece, reading);
    if (buffered_ != piece || hash_of(buffer_) != hashes_[piece]) return false;
    is_verified_[piece] = true;
    return true;
}

void Pieces::verify_piece(std::uint64_t piece, Reading reading) {
    if (!is_whole(piece, reading)) throw_damaged(piece);
}

void Pieces::throw_damaged(std::uint64_t piece) const {
    const DataRange range = range_of(piece, end_);
    throw_bad(source_.name, "bytes " + std::to_string(range.begin) + " to " + std::to_string(range.end - 1) +
                                " are not those that were written: their hash differs");
}

void Pieces::verify_metadata() {
    for (std::uint64_t i = 0; i < count(); ++i)
        if (has_metadata_[i]) verify_piece(i, Reading::again);
}

void Pieces::verify(std::uint64_t offset, std::uint64_t bytes) {
    if (bytes == 0) return;
    require_inside(offset, bytes);
    for (std::uint64_t i = (offset - user_block_bytes) / piece_bytes;
         i <= (offset + bytes - 1 - user_block_bytes) / piece_bytes; ++i)
        verify_piece(i, Reading::again);
}

void Pieces::require_inside(std::uint64_t offset, std::uint64_t bytes) const {
    if (offset < user_block_bytes || offset >= end_ || bytes > end_ - offset)
        throw_bad(source_.name, "it refers to bytes beyond its end");
}

void Pieces::read(std::uint64_t offset, std::span<std::byte> to) {
    if (to.empty()) return;
    require_inside(offset, to.size());
    while (!to.empty()) {
        const std::uint64_t piece = (offset - user_block_bytes) / piece_bytes;
        const DataRange range = range_of(piece, end_);
        const std::span<std::byte> part = to.first(std::min<std::uint64_t>(to.size(), range.end - offset));
        if (part.size() == range.end - range.begin) {
            // A whole piece is read to where it is wanted, and verified there.
            if (read_source(offset, part, Reading::once) != part.size()) throw_damaged(piece);
            if (!is_verified_[piece] && hash_of(part) != hashes_[piece]) throw_damaged(piece);
            is_verified_[piece] = true;
        } else {
            // The rest of the piece is mostly what is read next: it stays in the buffer.
            verify_piece(piece, Reading::once);
            fill_buffer(piece, Reading::once);
            if (buffered_ != piece) throw_damaged(piece);
            std::memcpy(part.data(), buffer_.data() + (offset - range.begin), part.size());
        }
        offset += part.size();
        to = to.subspan(part.size());
    }
}

void Pieces::verify_all() {
    for (std::uint64_t i = 0; i < count(); ++i) verify_piece(i, Reading::once);
}

std::vector<std::uint64_t> Pieces::damaged(const std::function<void(std::uint64_t bytes)>& progress) {
    std::vector<std::uint64_t> found;
    for (std::uint64_t i = 0; i < count(); ++i) {
        if (!is_whole(i, Reading::once)) found.push_back(i);
        if (progress) progress(piece_bytes);
    }
    return found;
}

struct PieceHasher::State {
    XXH3_state_t* hash = XXH3_createState();
    State() = default;
    State(const State&) = delete;
    ~State() { XXH3_freeState(hash); }
};

PieceHasher::PieceHasher() : state_(std::make_unique<State>()) {}
PieceHasher::~PieceHasher() = default;

void PieceHasher::add(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::uint64_t piece = (offset - user_block_bytes) / piece_bytes;
        const std::uint64_t begin = user_block_bytes + piece * piece_bytes, end = begin + piece_bytes;
        const std::span<const std::byte> part = bytes.first(std::min<std::uint64_t>(bytes.size(), end - offset));
        if (part.size() == piece_bytes) {
            hashes_[piece] = hash_of(part);
        } else if (offset == begin || offset == next_) {
            if (offset == begin) XXH3_128bits_reset(state_->hash);
            XXH3_128bits_update(state_->hash, part.data(), part.size());
            next_ = offset + part.size();
            if (next_ == end) hashes_[piece] = canonical(XXH3_128bits_digest(state_->hash)), next_ = 0;
        }
        offset += part.size();
        bytes = bytes.subspan(part.size());
    }
}

Seal seal_of(const ByteSource& source, std::uint64_t end, std::vector<DataRange> data, const KnownHashes& known) {
    std::ranges::sort(data, {}, &DataRange::begin);
    const std::uint64_t pieces = pieces_in(end);
    Seal seal;
    seal.list.resize(list_bytes(pieces));
    std::vector<std::byte> buffer;
    for (std::uint64_t i = 0; i < pieces; ++i) {
        const DataRange range = range_of(i, end);
        if (const auto hash = known.find(i); hash != known.end()) {
            put(seal.list, i * sizeof(Hash), hash->second);
        } else {
            buffer.resize(range.end - range.begin);
            if (source.read(range.begin, buffer) != buffer.size()) throw_system("read", source.name);
            put(seal.list, i * sizeof(Hash), hash_of(buffer));
        }
        if (has_metadata(range, data)) seal.list[pieces * sizeof(Hash) + i / 8] |= std::byte{1} << (i % 8);
    }
    seal.user_block = {};
    std::memcpy(seal.user_block.data(), magic.data(), magic.size());
    put(seal.user_block, at_version, format_version);
    put(seal.user_block, at_piece, static_cast<std::uint32_t>(piece_bytes));
    put(seal.user_block, at_end, end);
    put(seal.user_block, at_list_hash, hash_of(seal.list));
    put(seal.user_block, at_own_hash, hash_of(std::span<const std::byte>(seal.user_block).first(at_own_hash)));
    return seal;
}

}  // namespace glift::files
