#include "messenger.h"

#include "page_kernels.h"

#include <glift/iteration.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>

namespace glift::detail {

namespace {

using Clock = std::chrono::steady_clock;
using Message = Messenger::Message;

constexpr std::uint64_t alignment = 16, page = 4096;
constexpr std::uint64_t most_invocations = std::uint64_t{1} << 18;

std::uint32_t words(std::uint64_t bytes) { return static_cast<std::uint32_t>(bytes / 4); }

std::uint64_t aligned(std::uint64_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }

/// Whole pages, with room for more.
std::uint64_t grown(std::uint64_t bytes) { return (bytes + bytes / 4) / page * page + page; }

/// The bytes that each rank sends and receives at most.
struct Totals {
    explicit Totals(unsigned ranks) : sent(ranks), received(ranks) {}

    std::vector<std::uint64_t> sent, received;
};

/// The pieces as messages; adds them to the totals.
std::vector<Message> messages_of(const std::vector<Piece>& pieces, Totals& totals) {
    std::vector<Message> messages;
    for (const Piece& piece : pieces) {
        messages.push_back({piece, totals.sent[piece.from], totals.received[piece.to]});
        totals.sent[piece.from] += aligned(piece.most_bytes());
        totals.received[piece.to] += aligned(piece.most_bytes());
    }
    return messages;
}

}  // namespace

Messenger::Messenger(std::shared_ptr<ranks::Transport> transport, std::shared_ptr<DeviceObject> local, double limit)
    : transport_(std::move(transport)), local_(std::move(local)), link_(local_->link()), limit_(limit),
      holds_back_(transport_->allows_threads() && local_->has_gates()), areas_(transport_->size()) {}

const Messenger::Staging& Messenger::staging(Staging& staging, std::uint64_t bytes) {
    if (staging.memory && staging.memory.description().bytes >= bytes) return staging;
    const MemoryDescription description = {.name = "messages of ranks", .bytes = grown(bytes), .zeroed = false};
    if (link_) {
        staging.memory = link_->allocate(description);
    } else {
        const VisibleMemory made = local_->allocate_visible(description);
        staging = {made.memory, made.bytes};
    }
    return staging;
}

const Messenger::HostRoom& Messenger::room(HostRoom& room, std::uint64_t bytes) {
    if (room.own && room.bytes.size() >= bytes) return room;
    HostRoom larger;
    const std::uint64_t size = grown(bytes);
    larger.own.reset(static_cast<std::byte*>(std::aligned_alloc(page, size)), std::free);
    if (!larger.own) throw std::bad_alloc();
    larger.bytes = {larger.own.get(), size};
    larger.attached = link_->attach(larger.bytes);
    std::swap(room, larger);
    return room;
}

/// The beginning of a rank's area.
const Messenger::HostRoom& Messenger::area(unsigned rank, std::uint64_t bytes) {
    HostRoom& room = areas_[rank];
    if (room.attached && room.bytes.size() >= bytes) return room;
    const std::span<std::byte> all = transport_->area(rank);
    room.bytes = all.first(std::min<std::uint64_t>(grown(bytes), all.size()));
    room.attached = link_->attach(room.bytes);
    return room;
}

void Messenger::move_pieces(const Message& message, const Memory& staging, bool packs) {
    const Piece& piece = message.piece;
    const std::uint64_t at = packs ? message.sent_at : message.received_at;
    if (!piece.paging) {
        const CopyWords parameters = {words(piece.run), 0, packs ? piece.offset : at, packs ? at : piece.offset, {}};
        const Memory memories[] = {packs ? piece.memory : staging, packs ? staging : piece.memory};
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
                                  words(at),
                                  0,
                                  {}};
    const Memory memories[] = {piece.paging->list, piece.paging->table, piece.paging->planes, piece.memory, staging};
    stream().dispatch(packs ? pack_pages_kernel : unpack_pages_kernel, {.form = FormName::general,
                                                                        .memories = memories,
                                                                        .parameters = glift::bytes_of(parameters),
                                                                        .size = {parameters.size, 1, 1, 1}});
}

Messenger::Started Messenger::start(const std::vector<Piece>& pieces, Traffic& traffic) {
    Started started;
    started.traffic = &traffic;
    Totals totals(size());
    std::set<unsigned> others, senders;
    for (const Message& message : messages_of(pieces, totals)) {
        if (message.piece.from == rank()) {
            started.sent.push_back(message);
            others.insert(message.piece.to);
        }
        if (message.piece.to == rank()) {
            started.received.push_back(message);
            others.insert(message.piece.from);
            senders.insert(message.piece.from);
        }
    }
    if (started.is_empty()) return started;
    const std::uint64_t out = totals.sent[rank()], in = totals.received[rank()];
    started.others.assign(others.begin(), others.end());
    const Staging packed = staging(packed_, out), arrived = staging(arrived_, in);
    started.packed = packed.memory;
    started.arrived = arrived.memory;
    if (link_ && std::ranges::max(totals.sent) <= transport_->area(rank()).size()) {
        senders.insert(rank());
        for (const unsigned sender : senders) started.areas.emplace_back(sender, area(sender, totals.sent[sender]));
    } else if (link_) {
        started.to = room(to_, out);
        started.from = room(from_, in);
        started.outgoing = started.to.bytes;
        started.incoming = started.from.bytes;
    } else {
        started.outgoing = packed.bytes;
        started.incoming = arrived.bytes;
    }
    for (const Message& message : started.sent) move_pieces(message, started.packed, true);
    started.packing = local_->point();
    if (transport_->allows_threads() && !holds_back_) thread_.add([this, started] { deliver(started, nullptr); });
    return started;
}

/// Sends and receives, when the device has packed what this rank sends; then opens the gate.
void Messenger::deliver(const Started& started, GateObject* gate) {
    if (started.packing) started.packing->wait();
    const auto begin = Clock::now();
    const bool is_profiled = local_->profiler().is_on();
    const std::optional<Nanoseconds> first = is_profiled ? local_->now() : std::nullopt;
    std::uint64_t bytes = 0;
    for (const Message& message : started.sent) bytes += message.piece.bytes();
    if (started.areas.empty()) deliver_by_messages(started, gate);
    else deliver_by_areas(started, gate);
    started.traffic->bytes += bytes;
    started.traffic->seconds += std::chrono::duration<double>(Clock::now() - begin).count();
    if (!first) return;
    const Tag tag = local_->profiler().tag({.name = "exchange", .bytes = bytes});
    local_->profiler().add(tag, Profiler::run_of_thread(), *first, local_->now().value_or(*first));
}

void Messenger::deliver_by_areas(const Started& started, GateObject* gate) {
    std::vector<CopyRegion> out;
    for (const Message& message : started.sent)
        if (const std::uint64_t bytes = message.piece.bytes()) out.push_back({message.sent_at, message.sent_at, bytes});
    for (const auto& [sender, room] : started.areas)
        if (sender == rank()) link_->fetch(started.packed, *room.attached, out);
    shake_hands(started);
    for (const auto& [sender, room] : started.areas) {
        std::vector<CopyRegion> in;
        for (const Message& message : started.received)
            if (message.piece.from == sender && message.piece.bytes() != 0)
                in.push_back({message.sent_at, message.received_at, message.piece.bytes()});
        link_->put(*room.attached, started.arrived, in);
    }
    if (gate) gate->open();
    shake_hands(started);  // no rank writes to its area before the others have read it
}

/// Returns when the ranks with which this one has messages in common have come as far.
void Messenger::shake_hands(const Started& started) {
    std::byte given[1] = {};
    std::vector<std::byte> taken(started.others.size());
    std::vector<ranks::Send> sends;
    std::vector<ranks::Receive> receives;
    for (std::size_t k = 0; k < started.others.size(); ++k) {
        sends.push_back({started.others[k], given});
        receives.push_back({started.others[k], std::span(taken).subspan(k, 1)});
    }
    transport_->exchange(sends, receives, limit_);
}

void Messenger::deliver_by_messages(const Started& started, GateObject* gate) {
    std::vector<ranks::Send> sends;
    std::vector<ranks::Receive> receives;
    std::vector<CopyRegion> out, in;
    for (const Message& message : started.sent) {
        const std::uint64_t at = message.sent_at, bytes = message.piece.bytes();
        if (bytes == 0) continue;
        sends.push_back({message.piece.to, started.outgoing.subspan(at, bytes)});
        out.push_back({at, at, bytes});
    }
    for (const Message& message : started.received) {
        const std::uint64_t at = message.received_at, bytes = message.piece.bytes();
        if (bytes == 0) continue;
        receives.push_back({message.piece.from, started.incoming.subspan(at, bytes)});
        in.push_back({at, at, bytes});
    }
    if (link_) link_->fetch(started.packed, *started.to.attached, out);
    if (!sends.empty() || !receives.empty()) transport_->exchange(sends, receives, limit_);
    if (link_) link_->put(*started.from.attached, started.arrived, in);
    if (gate) gate->open();
}

void Messenger::receive(const Started& started) {
    if (started.is_empty()) return;
    stream().flush();
    if (holds_back_)
        // Even a rank that receives nothing is held back: later commands pack the next messages over these.
        thread_.add([this, started, gate = local_->gate()] { deliver(started, gate.get()); });
    else if (transport_->allows_threads()) thread_.finish();
    else deliver(started, nullptr);
    for (const Message& message : started.received) move_pieces(message, started.arrived, false);
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
