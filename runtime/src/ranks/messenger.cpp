#include "messenger.h"

#include "page_kernels.h"

#include <glift/iteration.h>

#include <algorithm>
#include <chrono>

namespace glift::detail {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t alignment = 16;
constexpr std::uint64_t most_invocations = std::uint64_t{1} << 18;

std::uint32_t words(std::uint64_t bytes) { return static_cast<std::uint32_t>(bytes / 4); }

/// The bytes that messages take at most; says where each begins.
std::uint64_t lay_out(std::vector<Messenger::Message>& messages) {
    std::uint64_t at = 0;
    for (Messenger::Message& message : messages) {
        message.at = at;
        at += (message.piece.most_bytes() + alignment - 1) / alignment * alignment;
    }
    return at;
}

}  // namespace

Messenger::Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit)
    : transport_(std::move(transport)), local_(std::move(local)), limit_(limit),
      holds_back_(transport_->allows_threads() && local_->has_gates()) {}

const VisibleMemory& Messenger::room(VisibleMemory& memory, std::uint64_t bytes) {
    if (memory.bytes.size() < bytes)
        memory = local_->allocate_visible(
            {.name = "messages of ranks", .bytes = (bytes + bytes / 4 + 255) / 4 * 4, .zeroed = false});
    return memory;
}

void Messenger::move(const Message& message, const Memory& packed, bool packs) {
    const Piece& piece = message.piece;
    if (!piece.paging) {
        const CopyWords parameters = {
            words(piece.run), 0, packs ? piece.offset : message.at, packs ? message.at : piece.offset, {}};
        const Memory memories[] = {packs ? piece.memory : packed, packs ? packed : piece.memory};
        stream().dispatch(copy_words_kernel, {.form = FormName::general,
                                              .memories = memories,
                                              .parameters = glift::bytes_of(parameters),
                                              .size = {parameters.size, 1, 1, 1}});
        return;
    }
    const MovePages parameters = {words(std::min(piece.most_bytes(), 4 * most_invocations)),
                                  piece.planes.first,
                                  piece.planes.end,
                                  words(piece.run),
                                  words(piece.offset),
                                  piece.frame_bytes,
                                  words(message.at),
                                  0,
                                  {}};
    const Memory memories[] = {piece.paging->list, piece.paging->table, piece.paging->planes, piece.memory, packed};
    stream().dispatch(packs ? pack_pages_kernel : unpack_pages_kernel, {.form = FormName::general,
                                                                        .memories = memories,
                                                                        .parameters = glift::bytes_of(parameters),
                                                                        .size = {parameters.size, 1, 1, 1}});
}

Messenger::Started Messenger::start(const std::vector<Piece>& pieces, Traffic& traffic) {
    Started started;
    started.traffic = &traffic;
    for (const Piece& piece : pieces) {
        if (piece.from == rank()) started.sent.push_back({piece, 0});
        if (piece.to == rank()) started.received.push_back({piece, 0});
    }
    if (started.is_empty()) return started;
    const std::uint64_t out = lay_out(started.sent), in = lay_out(started.received);
    started.outgoing = room(outgoing_, out);
    started.incoming = room(incoming_, in);
    for (const Message& message : started.sent) move(message, started.outgoing.memory, true);
    started.packed = local_->point();
    if (transport_->allows_threads() && !holds_back_) thread_.add([this, started] { deliver(started); });
    return started;
}

/// Sends and receives, when the device has packed what this rank sends.
void Messenger::deliver(const Started& started) {
    if (started.packed) started.packed->wait();
    const auto begin = Clock::now();
    std::vector<ranks::Send> sends;
    std::vector<ranks::Receive> receives;
    for (const auto& [piece, at] : started.sent) {
        const std::uint64_t bytes = piece.bytes();
        if (bytes != 0) sends.push_back({piece.to, started.outgoing.bytes.subspan(at, bytes)});
        started.traffic->bytes += bytes;
    }
    for (const auto& [piece, at] : started.received)
        if (const std::uint64_t bytes = piece.bytes())
            receives.push_back({piece.from, started.incoming.bytes.subspan(at, bytes)});
    if (!sends.empty() || !receives.empty()) transport_->exchange(sends, receives, limit_);
    started.traffic->seconds += std::chrono::duration<double>(Clock::now() - begin).count();
}

void Messenger::receive(const Started& started) {
    if (started.is_empty()) return;
    stream().flush();
    if (holds_back_)
        // Even a rank that receives nothing is held back: later commands pack the next messages over these.
        thread_.add([this, started, gate = local_->gate()] {
            deliver(started);
            gate->open();
        });
    else if (transport_->allows_threads()) thread_.finish();
    else deliver(started);
    for (const Message& message : started.received) move(message, started.incoming.memory, false);
}

std::vector<std::vector<std::byte>> Messenger::all_gather(std::span<const std::byte> mine) {
    finish();
    std::vector<std::vector<std::byte>> all(size(), std::vector<std::byte>(mine.size()));
    std::vector<ranks::Send> sends;
    std::vector<ranks::Receive> receives;
    for (unsigned other = 0; other < size(); ++other) {
        if (other == rank()) continue;
        sends.push_back({other, mine});
        receives.push_back({other, all[other]});
    }
    all[rank()].assign(mine.begin(), mine.end());
    if (size() > 1 && !mine.empty()) transport_->exchange(sends, receives, limit_);
    return all;
}

void Messenger::barrier() {
    const std::byte nothing[1] = {};
    all_gather(nothing);
}

}  // namespace glift::detail
