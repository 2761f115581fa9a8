// Messages of kernels on their way to the program: read from the buffer of a device, sorted, and delivered.
#pragma once

#include <glift/kernel.h>
#include <glift/message.h>

#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace glift::detail {

/// The size of a device's buffer of messages: GLIFT_PRINT_BYTES, or 1 MiB. Throws wrong_argument for less than 64 bytes
/// or more than 1 GiB.
std::uint64_t message_bytes();

/// The kernels that print on a device. What their messages say is copied, since a kernel's library may be unloaded
/// before its messages are read.
class PrintingKernels {
public:
    /// The number of a kernel with this digest; it is added if it is new.
    std::uint32_t number_of(std::uint64_t digest, const Kernel& kernel);

    /// The word that stands before the messages of a pass of the kernel with this number.
    static constexpr std::uint32_t mark_of(std::uint32_t number) { return 0x80000000u | number; }

    /// The messages in the buffer, in the order of MessageSink, and one of kind `lost` after them if some did not fit.
    /// Empties the buffer.
    std::vector<Message> take(MessageHeader& buffer) const;

private:
    struct Format {
        std::string text, file;
        std::uint32_t line, words;
        bool is_assertion;
    };
    struct Printing {
        std::string kernel;
        std::uint32_t rank;
        std::vector<Format> formats;
    };
    Message read(const Printing& kernel, const Format& format, const std::uint32_t* words) const;

    std::vector<Printing> kernels_;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;  ///< by digest
};

/// Writes the message's text and a line end.
void write_to_stderr(const Message& message);

/// Where the messages of a device go. Thread-safe.
class MessageOutlet {
public:
    /// Returns the previous function.
    MessageSink set_sink(MessageSink sink);
    void deliver(const std::vector<Message>& messages);
    /// Throws assertion_failed if an assertion that was delivered failed since the last call.
    void throw_failed();

private:
    std::mutex mutex_;
    MessageSink sink_ = write_to_stderr;
    std::optional<Message> failed_;  ///< the first one
    std::uint64_t failures_ = 0;
};

}  // namespace glift::detail
