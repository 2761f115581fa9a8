// Takes arbitrary bytes as a .npy file: there must be no crash, hang or sanitizer report, and no error other than
// bad_file. An array that is read fits into the file, and a header written for it says the same.

#include "npy.h"

#include <glift/error.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace {

using namespace glift::files;

ByteSource source_of(std::span<const std::byte> file) {
    return {"fuzz.npy", file.size(), [file](std::uint64_t offset, std::span<std::byte> to) {
                if (offset >= file.size()) return std::size_t{0};
                const std::size_t count = std::min<std::size_t>(to.size(), file.size() - offset);
                std::memcpy(to.data(), file.data() + offset, count);
                return count;
            }};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> file = std::as_bytes(std::span(data, size));
    try {
        const NpyHeader header = parse_npy(source_of(file));
        if (header.numbers() > size - header.begin) std::abort();
        const std::string text = npy_header(header.scalar, header.shape);
        std::vector<std::byte> again(text.size() + size - header.begin);
        std::memcpy(again.data(), text.data(), text.size());
        const NpyHeader same = parse_npy(source_of(again));
        if (same.shape != header.shape || same.scalar != header.scalar || same.begin != text.size()) std::abort();
    } catch (const glift::Error& error) {
        if (error.code() != glift::ErrorCode::bad_file) std::abort();
    }
    return 0;
}
