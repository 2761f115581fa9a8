// Takes arbitrary bytes as a file of glift::save: there must be no crash, hang or sanitizer report, and no error other
// than bad_file. Random bytes would stop at the first hash. So the fuzzer makes the hashes of the user block and of the
// list fit if the first byte of the input says so.

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

/// The places are those of pieces.cpp.
void make_fit(std::vector<std::byte>& file, bool has_list) {
    static constexpr unsigned char begin[] = {0x89, 'G', 'L', 'F', '\r', '\n', 0x1a, '\n', 1, 0, 0, 0, 0, 0, 0x10, 0};
    if (file.size() < user_block_bytes) return;
    std::memcpy(file.data(), begin, sizeof begin);
    std::uint64_t end;
    std::memcpy(&end, file.data() + 16, 8);
    if (has_list && end <= file.size()) put_hash(file, 32, std::span<const std::byte>(file).subspan(end));
    put_hash(file, 496, std::span<const std::byte>(file).first(496));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::vector<std::byte> file(size - 1);
    if (!file.empty()) std::memcpy(file.data(), data + 1, file.size());
    if (data[0] & 1) make_fit(file, data[0] & 2);
    try {
        Pieces pieces(source_of(file));
        pieces.damaged();
        pieces.verify(user_block_bytes + data[0], size);
        pieces.verify_metadata();
    } catch (const glift::Error& error) {
        if (error.code() != glift::ErrorCode::bad_file) std::abort();
    }
    return 0;
}
