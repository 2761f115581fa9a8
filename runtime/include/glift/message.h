// Messages of `print` and `assert` in kernels, as programs receive them (Device::on_message).
#pragma once

#include <glift/api.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace glift {

struct Message {
    enum class Kind : std::uint8_t {
        print,
        assertion,  ///< an assertion that failed
        lost,       ///< the buffer of messages was full: so many are missing
    };
    Kind kind = Kind::print;
    std::string text;    ///< `v = 1.5`; of an assertion: its condition, and what else the program says
    std::string kernel;  ///< `kernel blur (blur.glift:12)`; lost: empty
    std::string file;    ///< of the statement; lost: empty
    std::uint32_t line = 0;
    std::uint32_t rank = 0;                               ///< number of axes of the address; lost: 0
    std::array<std::uint32_t, 4> address = {0, 0, 0, 0};  ///< of the element that the kernel visited
    std::uint64_t count = 1;                              ///< lost: how many messages

    bool operator==(const Message&) const = default;
};

/// The message in one line: `blur.glift:14: at (3, 4): v = 1.5`.
GLIFT_API std::string to_text(const Message& message);

/// Receives messages in the order of passes; those of a pass in the order of addresses, x fastest; those of one element
/// in the order in which it printed them. Called by the call that waits for the device, from whatever thread makes that
/// call; it must not use the device.
using MessageSink = std::function<void(const Message& message)>;

}  // namespace glift
