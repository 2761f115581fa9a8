// Messages of the language server protocol over two file descriptors: a header with Content-Length, then that many
// bytes of JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gliftc::lsp {

/// The header of a message is not one of the protocol. There is no way to find the next message: the session ends.
struct BadHeader : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Reader {
public:
    explicit Reader(int descriptor) : descriptor_(descriptor) {}

    /// Waits for the next message; its content. Absent at the end of the input, also if that cuts a message off. Throws
    /// BadHeader if the header has no valid Content-Length, a length beyond `longest`, or a line beyond 4 KiB.
    std::optional<std::string> next();
    /// Whether bytes can be read without waiting.
    bool has_input() const;

    static constexpr std::size_t longest = std::size_t{256} << 20;

private:
    bool fill();

    int descriptor_;
    std::string buffer_;  ///< bytes that were read and belong to no message yet
};

/// Writes the content with its header. False if the descriptor is closed.
bool write_message(int descriptor, std::string_view content);

}  // namespace gliftc::lsp
