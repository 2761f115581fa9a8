#include "messages.h"

#include "environment.h"
#include "message_text.h"
#include "text.h"

#include <glift/error.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace glift {

std::string to_text(const Message& message) {
    if (message.kind == Message::Kind::lost) return message.text;
    std::string address;
    for (std::uint32_t axis = 0; axis < message.rank; ++axis)
        address += (axis ? ", " : "") + std::to_string(message.address[axis]);
    return message.file + ":" + std::to_string(message.line) + ": at (" + address +
           "): " + (message.kind == Message::Kind::assertion ? "assertion failed: " : "") + message.text;
}

namespace detail {

namespace {

/// Whether the address of one message is before that of the other, x fastest.
bool is_before(const Message& one, const Message& other) {
    return std::ranges::lexicographical_compare(one.address.rbegin(), one.address.rend(), other.address.rbegin(),
                                                other.address.rend());
}

Message lost_messages(std::uint64_t count, std::uint64_t bytes) {
    Message lost;
    lost.kind = Message::Kind::lost;
    lost.count = count;
    lost.text = std::to_string(count) + (count == 1 ? " message was" : " messages were") + " lost: the buffer has " +
                size_text(bytes) + "; the environment variable GLIFT_PRINT_BYTES makes it larger";
    return lost;
}

}  // namespace

void write_to_stderr(const Message& message) {
    const std::string line = to_text(message) + "\n";  // one write, so that lines of threads do not interleave
    std::fwrite(line.data(), 1, line.size(), stderr);
}

std::uint64_t message_bytes() {
    constexpr std::uint64_t least = 64, most = std::uint64_t(1) << 30, usual = std::uint64_t(1) << 20;
    const char* const text = std::getenv("GLIFT_PRINT_BYTES");
    if (!text || !*text) return usual;
    const std::uint64_t bytes = bytes_of_text("GLIFT_PRINT_BYTES", text);
    if (bytes < least || bytes > most)
        throw Error(ErrorCode::wrong_argument, "the environment variable GLIFT_PRINT_BYTES has an invalid value",
                    std::string("GLIFT_PRINT_BYTES=") + text, {}, "give at least 64 bytes and at most 1G");
    return bytes / 4 * 4;
}

std::uint32_t PrintingKernels::number_of(std::uint64_t digest, const Kernel& kernel) {
    const auto [found, is_new] = numbers_.try_emplace(digest, static_cast<std::uint32_t>(kernels_.size()));
    if (!is_new) return found->second;
    Printing& printing = kernels_.emplace_back(Printing{kernel_text(kernel), kernel.address_rank, {}});
    for (const MessageFormat& format : kernel.messages)
        printing.formats.push_back(
            {format.text, format.file, format.line, words_of_format(format.text), format.is_assertion});
    return found->second;
}

Message PrintingKernels::read(const Printing& kernel, const Format& format, const std::uint32_t* words) const {
    Message message;
    message.kind = format.is_assertion ? Message::Kind::assertion : Message::Kind::print;
    message.kernel = kernel.kernel;
    message.file = format.file;
    message.line = format.line;
    message.rank = kernel.rank;
    std::copy(words, words + kernel.rank, message.address.begin());
    message.text = filled_format(format.text, {words + kernel.rank, format.words});
    return message;
}

std::vector<Message> PrintingKernels::take(MessageHeader& buffer) const {
    auto* const words = reinterpret_cast<std::uint32_t*>(&buffer + 1);
    const std::uint32_t end = std::min(buffer.used, buffer.capacity);
    std::vector<Message> messages;
    std::size_t pass = 0;  // where the messages of the current pass begin
    const auto sort_pass = [&] {
        std::stable_sort(messages.begin() + static_cast<std::ptrdiff_t>(pass), messages.end(), is_before);
    };
    const Printing* kernel = nullptr;
    for (std::uint32_t at = 0; at < end && words[at] != 0;) {
        const std::uint32_t word = words[at++];
        if ((word & mark_of(0)) != 0) {
            sort_pass();
            pass = messages.size();
            kernel = &kernels_.at(word & ~mark_of(0));
            continue;
        }
        const Format& format = kernel->formats.at(word - 1);
        messages.push_back(read(*kernel, format, words + at));
        at += kernel->rank + format.words;
    }
    sort_pass();
    const std::uint64_t lost = std::uint64_t{buffer.lost_high} << 32 | buffer.lost;
    if (lost != 0) messages.push_back(lost_messages(lost, sizeof buffer + std::uint64_t{buffer.capacity} * 4));
    std::memset(words, 0, std::size_t{end} * 4);
    buffer.used = buffer.lost = buffer.lost_high = 0;
    return messages;
}

MessageSink MessageOutlet::set_sink(MessageSink sink) {
    const std::lock_guard lock(mutex_);
    return std::exchange(sink_, std::move(sink));
}

void MessageOutlet::deliver(const std::vector<Message>& messages) {
    if (messages.empty()) return;
    MessageSink sink;
    {
        const std::lock_guard lock(mutex_);
        for (const Message& message : messages) {
            if (message.kind != Message::Kind::assertion) continue;
            if (failures_++ == 0) failed_ = message;
        }
        sink = sink_;
    }
    if (sink) std::ranges::for_each(messages, sink);
}

void MessageOutlet::throw_failed() {
    const std::lock_guard lock(mutex_);
    const std::uint64_t failures = std::exchange(failures_, 0);
    if (failures == 0) return;
    const Message failed = *std::exchange(failed_, std::nullopt);
    throw Error(ErrorCode::assertion_failed,
                failures == 1 ? "an assertion failed" : std::to_string(failures) + " assertions failed", failed.kernel,
                to_text(failed), "see the other messages: Device::on_message");
}

}  // namespace detail

}  // namespace glift
