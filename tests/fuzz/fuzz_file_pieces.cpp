// Takes arbitrary bytes as a file of glift::save: there must be no crash, hang or sanitizer report, and no error other
// than bad_file. Random bytes would stop at the first hash. So the fuzzer makes hashes fit if bits of the first byte of
// the input say so: 1, that of the user block; 2, that of the list; 4, those of the pieces. Bits 3 to 5 of the byte are
// how many pieces of zeros the file has between its user block and the rest of the input: libFuzzer's inputs are
// shorter than a piece.

#include "pieces.h"

#include <glift/error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

using namespace glift::files;

glift::files::ByteSource source_of(const std::vector<std::byte>& file) {
    return {"fuzz.h5", file.size(), [&file](std::uint64_t offset, std::span<std::byte> to) {
                if (offset >= file.size()) return std::size_t{0};
                const std::size_t count = std::min<std::size_t>(to.size(), file.size() - offset);
                std::memcpy(to.data(), file.data() + offset, count);
                return count;
            }};
}

void put_hash(std::vector<std::byte>& file, std::size_t at, std::span<const std::byte> of) {
    const Hash hash = hash_of(of);
    std::memcpy(file.data() + at, hash.data(), hash.size());
}

enum Fits : unsigned { fits_block = 1, fits_list = 2, fits_pieces = 4 };

/// The places are those of pieces.cpp.
void make_fit(std::vector<std::byte>& file, unsigned fits) {
    static constexpr unsigned char begin[] = {0x89, 'G', 'L', 'F', '\r', '\n', 0x1a, '\n', 1, 0, 0, 0, 0, 0, 0x10, 0};
    if (file.size() < user_block_bytes) return;
    std::memcpy(file.data(), begin, sizeof begin);
    std::uint64_t end;
    std::memcpy(&end, file.data() + 16, 8);
    if (end >= user_block_bytes && end <= file.size()) {
        const std::span<const std::byte> all = file;
        if (fits & fits_pieces)
            for (std::uint64_t at = user_block_bytes, list = end; at < end && list + sizeof(Hash) <= file.size();
                 at += piece_bytes, list += sizeof(Hash))
                put_hash(file, list, all.subspan(at, std::min(piece_bytes, end - at)));
        if (fits & fits_list) put_hash(file, 32, all.subspan(end));
    }
    put_hash(file, 496, std::span<const std::byte>(file).first(496));
}

/// The last bytes of the input say which bytes are read.
template <class T> T number_at_end(const std::uint8_t* data, std::size_t size, std::size_t before) {
    T number = 0;
    if (size >= before + sizeof number) std::memcpy(&number, data + size - before - sizeof number, sizeof number);
    return number;
}

/// Calls see(); no error but bad_file may come out.
template <class See> void try_to(See see) {
    try {
        see();
    } catch (const glift::Error& error) {
        if (error.code() != glift::ErrorCode::bad_file) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::vector<std::byte> file(size - 1);
    if (!file.empty()) std::memcpy(file.data(), data + 1, file.size());
    if (file.size() >= user_block_bytes)
        file.insert(file.begin() + user_block_bytes, (data[0] >> 3 & 7) * piece_bytes, std::byte{0});
    if (data[0] & fits_block) make_fit(file, data[0]);
    try_to([&] {
        const glift::files::ByteSource source = source_of(file);
        const auto offset = number_at_end<std::uint64_t>(data, size, 4);
        std::vector<std::byte> bytes(number_at_end<std::uint32_t>(data, size, 0) % (2 * piece_bytes));
        Pieces pieces(source);
        try_to([&] { pieces.read(offset, bytes); });
        try_to([&] { pieces.verify(offset, bytes.size()); });
        try_to([&] { pieces.verify_metadata(); });
        const std::vector<std::uint64_t> damaged = pieces.damaged();
        // Once all pieces are whole, no byte is refused.
        if (damaged.empty() && pieces.end() > user_block_bytes) {
            bytes.resize(std::min<std::uint64_t>(pieces.end() - user_block_bytes, 2 * piece_bytes));
            pieces.read(user_block_bytes, bytes);
        }
        Pieces(source).verify_metadata();
    });
    return 0;
}
